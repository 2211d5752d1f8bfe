// The results required of a case: expected.toml.
//
//   title = "..."                 needed where there is no case.toml
//   study = "sdof"                numbers computed by a function (app/studies) in place of runs of case.toml
//   minutes = 30                  approximate time of the full tier; of several cases at a time long ones come first
//   cores = 2                     that its timings need exclusively: it does not run beside other cases
//
//   [[variant]]                   a run; without any there is one, "case", of case.toml as it is
//   name = "fine"
//   case = "case.toml"            default
//   set = ["stage.0.dt=1e-6"]     as --set
//   tier = "quick"                or "full", "exhaustive": only with --full, --exhaustive
//   repeats = 1                   runs for timing; variants with repeats take turns
//   needs = "SCREE_RECORDS"       environment variable without which its quantities are skipped
//
//   [[quantity]]                  a row of the table
//   name, reason                  its name for people; why this bound
//   measure                       one of measures.h, with its own keys
//   variant = "fine"              default: the first
//   over = "coarse"               the value is divided by that of another variant
//   variants, sizes, exact        the value is the observed order: the slope of log |measure - exact| over log size
//   at_least, at_most             bounds; or reference with tolerance (relative) or absolute
//   tier = "quick"
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/studies/tier.h"
#include "io/case/case_error.h"

namespace scree::app {

struct Variant {
  std::string name, case_file = "case.toml";
  std::vector<std::string> set;
  std::string needs;  // environment variable; empty: none
  Tier tier = Tier::quick;
  int repeats = 1;

  /// Whether the environment variable that it needs is missing or empty.
  [[nodiscard]] bool lacking() const;
};

struct Quantity {
  std::string name, reason, measure;
  std::vector<std::string> variants;           // runs that it is measured on; several for an order
  std::string over;                            // variant of the divisor; empty: none
  std::vector<double> sizes;                   // of an order, as many as variants
  double exact = 0.0;                          // of an order
  std::map<std::string, std::string> texts;    // keys of the measure
  std::map<std::string, double> numbers;       // keys of the measure
  double low = 0.0, high = 0.0;                // bounds; infinite where open
  std::optional<double> reference, tolerance;  // tolerance in the quantity's unit
  Tier tier = Tier::quick;                     // its own tier, or that of a variant if that is later

  [[nodiscard]] bool is_order() const { return !sizes.empty(); }
  [[nodiscard]] const std::string& text(const std::string& key) const { return texts.at(key); }
  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  /// Every variant of which it needs a run.
  [[nodiscard]] std::vector<std::string> runs() const;
  /// The bounds as people write them.
  [[nodiscard]] std::string wanted() const;
  /// An error at a key of the quantity, or at the quantity where it has no such key.
  [[nodiscard]] io::CaseError error(const std::string& key, std::string problem, std::string allowed,
                                    std::string hint = {}) const;

  std::string file;  // where it stands
  std::map<std::string, io::Place> places;
  io::Place place;
};

struct Expected {
  std::string title, study;
  double minutes = 0.0;  // of the full tier
  int cores = 1;         // that it needs exclusively
  std::vector<Variant> variants;
  std::vector<Quantity> quantities;

  [[nodiscard]] const Variant& variant(const std::string& name) const;
};

/// @throws io::CaseError with the place: no TOML, a key that is unknown, missing or of the wrong kind, an unknown
///         measure, variant or tier, no bound
[[nodiscard]] Expected read_expected(const std::filesystem::path& file);
[[nodiscard]] Expected read_expected_text(const std::string& text, const std::filesystem::path& file);

}  // namespace scree::app
