#include "coupling/stages/pace.h"

#include <fmt/format.h>

namespace scree::coupling {

namespace {

// Measured with jointed rock of 6 to 30 blocks, DDA and NMM: an implicit step takes 30 to 80 us an unknown in about six
// passes, an explicit update of an element with its contacts a third of a microsecond.
constexpr double kStepOfUnknown = 100.0, kPasses = 6.0;
constexpr double kFree = 20.0;  // implicit steps, as a stage begins
// A stack of three blocks of 156 elements, 100 explicit steps in one of 1 ms: 30, 20, 10, 7 and 6 iterations at 1, 0.5,
// 0.2, 0.1 and 0.05 ms, and 22, 16, 10, 8 and 8 s of processor time.
constexpr std::int32_t kLongIteration = 12;

}  // namespace

double effort(const StepReport& report, const RunStats& stats, double elements) {
  return static_cast<double>(report.explicit_steps) * elements +
         static_cast<double>(report.iterations) / kPasses * implicit_effort(stats);
}

bool shorter_is_cheaper(const StepReport& report, const RunStats& stats, double elements) {
  return report.iterations > kLongIteration &&
         static_cast<double>(report.explicit_steps) * elements > 0.5 * effort(report, stats, elements);
}

double implicit_effort(const RunStats& stats) { return kStepOfUnknown * static_cast<double>(stats.unknowns); }

std::optional<std::string> too_slow(const RunStats& stats, double steps, double allowed) {
  const double taken = stats.effort - stats.effort_before, of_implicit = implicit_effort(stats);
  if (!(allowed > 0.0) || !(taken > allowed * (steps + kFree) * of_implicit)) return {};
  return fmt::format(
      "the stage has taken the effort of {:.3g} implicit steps for the time of {:.3g}, more than {:g} times as "
      "much (run.max_slowdown, with an allowance of {:g} steps). Make fewer blocks explicit, or all of them "
      "(integrator = \"implicit\" or \"explicit\"), or use a shorter dt, which contains fewer explicit steps",
      taken / of_implicit, steps, allowed, kFree);
}

}  // namespace scree::coupling
