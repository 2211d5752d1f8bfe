// The measures that expected.toml may name, each a number from a finished run.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "app/verify/expected.h"
#include "app/verify/run_record.h"
#include "io/pictures/line_plot.h"

namespace scree::app {

struct MeasureKey {
  enum class Kind { text, number } kind;
  const char* name;
  bool needed;
  const char* standard;  // default of a text that is not needed
};
struct MeasureInfo {
  const char* name;
  const char* meaning;
  std::vector<MeasureKey> keys;
};
/// All measures with their keys.
[[nodiscard]] const std::vector<MeasureInfo>& measures();

using RunRecords = std::map<std::string, RunRecord>;  // by variant

/// The value of a quantity. Where it compares curves, their picture is appended.
/// @pre every variant it names is among the runs and done (measure "refused": or refused); it is not of a study
/// @throws io::CaseError at the key of expected.toml or the place in the reference file that is wrong
[[nodiscard]] double measure(const Quantity& quantity, const RunRecords& runs, std::vector<io::LinePlot>& plots);

/// Checks the monitors, stages and components that a quantity names.
/// @throws io::CaseError at the key
void check_names(const Quantity& quantity, const Model& model, const coupling::Plan& plan);

}  // namespace scree::app
