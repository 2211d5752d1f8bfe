// The parameters of a sweep: keys of the case, and the value of each key in each run.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

/// Place of a key or a value: an option of the command line ("--param", whose lines are the options) or a file.
struct Origin {
  std::string file;
  int line = 0, column = 0;  // from 1
};

struct ParameterKey {
  std::string name;  // dotted, as `scree run --set` takes it
  Origin origin;
};

struct ParameterValue {
  std::string toml;  // right-hand side of key = VALUE
  Origin origin;
};

/// The parameters of all runs: runs[i][k] is the value of keys[k] in run i + 1.
struct Parameters {
  std::vector<ParameterKey> keys;
  std::vector<std::vector<ParameterValue>> runs;

  /// The parameters of a run (counted from 1) as options of --set.
  [[nodiscard]] std::vector<std::string> overrides(std::size_t run) const;
};

inline constexpr std::size_t kMostRuns = 100'000;

/// All combinations of the values of several options KEY=A:B:N (N numbers from A to B, evenly spaced, rounded to 15
/// significant digits) or KEY=V1,V2,... The first key varies slowest.
/// @throws CaseError in the file "--param": no key, no value, no range, a key given twice, more than kMostRuns runs
[[nodiscard]] Parameters parameter_grid(std::span<const std::string> options);

/// A value as TOML: the text itself where it is TOML, else the text in quotation marks, so that words and numbers with
/// a unit need none.
[[nodiscard]] std::string toml_of(std::string_view text);

/// @throws CaseError where a key is given twice
void require_distinct(std::span<const ParameterKey> keys);

/// "0012": name of the folder of a run; at least four digits, as many as the last run needs.
[[nodiscard]] std::string run_name(std::size_t run, std::size_t runs);

}  // namespace scree::app
