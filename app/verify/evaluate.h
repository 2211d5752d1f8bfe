// Runs what a case needs, and fills its rows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/verify/expected.h"
#include "io/pictures/line_plot.h"

namespace scree::app {

struct Row {
  std::string name, reason, wanted;
  double found = 0.0;
  bool pass = false;
  std::string trouble;   // why there is no number; empty where there is one
  bool skipped = false;  // skipped for the reason in `trouble`; neither passed nor failed
};

struct CaseReport {
  std::string name, title;
  std::vector<Row> rows;
  std::vector<io::LinePlot> plots;
  std::vector<std::string> notes;  // one line per run: what was run, how long, state hash
  double wall = 0.0;               // [s]
  [[nodiscard]] int failed() const;
  [[nodiscard]] int skipped() const;
};

/// A case of the library: a folder with expected.toml, and case.toml or the name of a study.
/// @param tier  its quantities and those of the tiers before it are evaluated
/// @throws io::CaseError for what is wrong in the files; a run that does not end fails its rows
[[nodiscard]] CaseReport evaluate_case(const std::filesystem::path& folder, Tier tier);

/// Title of a case.      @throws as evaluate_case
[[nodiscard]] std::string case_title(const std::filesystem::path& folder);

}  // namespace scree::app
