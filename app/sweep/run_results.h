// The results of one run in the table of a sweep.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::app {

/// A number of a run.
struct Result {
  std::string name, units, meaning;  // "toe.u", "m", ...
  double value = 0.0;                // finite, or not a number where the run has none
};

/// None of these depends on the machine, the clock or the number of threads.
struct RunResults {
  std::string state_hash;      // 16 hexadecimal digits
  std::string farthest_block;  // with the largest displacement
  std::vector<Result> numbers;
};

/// Numbers of a run that ended, well or not, in this order:
///   final_time, steps, cuts, contacts; kinetic, friction_work, energy_moved, relative_closure, passed_closure, gain,
///   friction_worst_ratio; largest_displacement; displacement.NAME of the requested blocks;
///   stage.NAME.farthest_displacement of each stage that ended;
///   of each monitor its last displacement .ux, .uy, .u and speed .v, the peaks .u_peak and .v_peak, and the time of
///   the peak speed .v_peak_time
/// @param blocks  names; a run that lacks one has no such number
/// @throws FileError where the summary cannot be read
[[nodiscard]] RunResults run_results(const std::filesystem::path& folder, const std::vector<std::string>& blocks);

/// Time and memory of a run, which depend on the machine.
struct RunCosts {
  double wall_seconds = 0.0, cpu_seconds = 0.0, peak_memory_bytes = 0.0;
  int threads = 0;
};
[[nodiscard]] RunCosts run_costs(const std::filesystem::path& folder);

}  // namespace scree::app
