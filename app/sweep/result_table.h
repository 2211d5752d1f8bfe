// The table of a sweep: one row per run, with parameters, outcome and results. The same runs give the same bytes.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep/run_outcome.h"
#include "app/sweep/run_results.h"
#include "app/sweep/sweep_folder.h"

namespace scree::app {

/// A parameter as a column.
struct ParameterColumn {
  std::string key, units;       // units: of the schema where the values are numbers; empty for texts
  std::vector<double> numbers;  // per run; empty where some value is no number
  std::vector<std::string> texts;

  [[nodiscard]] bool is_number() const { return !numbers.empty(); }
};

/// A result as a column; not a number where a run has none.
struct ResultColumn {
  std::string name, units, meaning;
  std::vector<double> values;
};

struct ResultTable {
  std::string title, case_sha256;
  std::vector<ParameterColumn> parameters;
  std::vector<RunOutcome> outcomes;
  std::vector<std::string> state_hashes, farthest_blocks;
  std::vector<ResultColumn> results;  // in the order of RunResults; results that only later runs have come last

  [[nodiscard]] std::size_t runs() const { return outcomes.size(); }
};

/// Reads all runs of a sweep.   @param blocks  whose displacement is to be in the table
[[nodiscard]] ResultTable collect(const SweepFolder& folder, const SweepRecord& record, const std::string& title,
                                  const std::vector<std::string>& blocks);

/// Unit of a key that the user wrote, by the schema; empty where it has none or is not known.
[[nodiscard]] std::string unit_of_key(std::string_view key);
/// The parameters of all runs as columns.
[[nodiscard]] std::vector<ParameterColumn> parameter_columns(const Parameters& parameters);

/// run, every parameter, outcome, reason, every result, farthest_block, state_hash, with units in the heading.
[[nodiscard]] std::string csv_text(const ResultTable& table);
/// /run, /parameters/<key>, /outcome, /reason, /results/<name>, /farthest_block, /state_hash; '/' in names becomes '_'.
/// @throws FileError
void write_h5(const ResultTable& table, const std::filesystem::path& to);
/// run, wall_seconds, cpu_seconds, peak_memory, threads of the runs that ended: differs from one machine to another.
[[nodiscard]] std::string costs_text(const SweepFolder& folder, const ResultTable& table);

}  // namespace scree::app
