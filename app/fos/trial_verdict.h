// The verdict on a run with reduced strength, read from its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/fos/block_modes.h"
#include "app/fos/fos_search.h"
#include "model/geometry.h"

namespace scree::app {

struct TrialResult {
  Verdict verdict = Verdict::undecided;
  std::string why;                   // for people
  double displacement = 0.0;         // largest displacement of a block since the strengths began to fall [m]
  double acceleration = 0.0;         // of the fastest block in the dynamic stage, gain in speed over time [m/s2]
  double time = 0.0;                 // simulated, of the dynamic stage [s]
  double needed = 0.0;               // time that an undecided run would need at its motion so far [s]; 0: unknown
  double cpu = 0.0;                  // of the process [s]
  std::string fastest;               // block
  std::vector<BlockMotion> motions;  // in the dynamic stage
  [[nodiscard]] Mode mode() const { return leading_mode(motions); }
};

/// Criteria of the verdict.
struct Decision {
  double limit = 0.0;      // displacement [m]
  double tolerance = 0.0;  // of the factor
  double factor = 1.0;     // of the run
  Vec2 gravity{0.0, -9.81};
};

/// Stable: the dynamic stage ended by its rule of balance. Failed: the fastest block keeps accelerating (v t >= 1.5 d,
/// where constant acceleration gives 2 d; v and d without the part of the speed with which the stage began), has gained
/// more than 2 % of the first speed, and either
/// a block has moved as far as the limit, or the time is over and the acceleration is above 0.3 (1 - F_s) g,
/// F_s = 1/(1 + tolerance/factor) being the margin that the search resolves. A run that could not continue counts as
/// failed if a block has moved as far as the limit or has no path of closed contacts to a support, else as undecided.
/// @param folder  of an ended run of [reduction] with a factor   @throws FileError
[[nodiscard]] TrialResult trial_result(const std::filesystem::path& folder, const Decision& decision);

/// Failure of a run that does not come to rest: its motion until a block has moved four times the limit, or to its end.
/// @throws FileError
[[nodiscard]] TrialResult failure_to_rest(const std::filesystem::path& folder, double limit, const Vec2& gravity);

}  // namespace scree::app
