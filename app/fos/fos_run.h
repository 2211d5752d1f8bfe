// The search for a factor of safety: runs to rest, runs at factors, and the answer.
#pragma once

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "app/fos/fos_folder.h"
#include "app/fos/fos_search.h"
#include "app/fos/trial_verdict.h"
#include "io/results/rock_use.h"

namespace scree::app {

/// How a search is carried out; no setting changes the answer.
struct FosSettings {
  std::size_t jobs = 1;                          // runs at a time
  int threads = 1;                               // per run
  std::function<void(const std::string&)> note;  // lines for people; empty: none
  std::function<bool()> stop;                    // true: end
};

struct FosAnswer {
  enum class Status {
    found,           // between stands and fails
    undecided,       // runs between the two have no verdict
    fails_at_least,  // no rest is reached with the largest strength: strength does not govern
    stable_at_most,  // the slope stands with the smallest strength
    interrupted
  };
  Status status = Status::interrupted;
  double stands = 0.0, fails = 0.0;    // the bracket; fails infinite: no run failed
  std::map<double, TrialResult> runs;  // by factor; the run to rest is not among them
  double start = 1.0;                  // factor of the run to rest
  bool explicit_rest = false;          // implicit steps found no rest below the displacement limit: explicit ones did
  bool inconsistent = false;           // the slope stood at a factor above one at which it failed
  /// If the slope fails at the least factor: horizontal acceleration, in g, positive along x, at which it stands, and
  /// the largest at which it fails (by absolute value); empty: not searched for, or none up to 1.6.
  std::optional<double> k_h, k_h_fails;
  std::string why;                      // reason of a run to rest that failed
  std::optional<TrialResult> at_least;  // how it fails at the least factor
  /// Where the stress is above the strength of the rock: at rest, and in the run that stands at the largest factor;
  /// empty where no material has a strength.
  std::vector<io::RockUse> rock_at_rest, rock_at_limit;
  double cpu = 0.0;  // of all processes [s]

  [[nodiscard]] double factor() const { return 0.5 * (stands + fails); }
  /// The run that failed at the smallest factor; a run to rest at the least factor counts too. Null: none.
  [[nodiscard]] const TrialResult* failure() const;
};
[[nodiscard]] std::string_view name(FosAnswer::Status status);

/// Carries out, or continues, the search of a folder.
/// @param limit    displacement limit of the verdict [m]   @param gravity [m/s2]
/// @param implicit_rest  stages to rest use implicit steps: if these find no balance although no block moves as far as
///                       the limit, explicit steps are tried before a smaller factor
/// @throws FileError
[[nodiscard]] FosAnswer search_factor(const FosFolder& folder, const FosRecord& record, double limit,
                                      const Vec2& gravity, bool implicit_rest, const FosSettings& settings);

}  // namespace scree::app
