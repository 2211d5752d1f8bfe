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
  std::string why;                   // reason of the verdict, as it is printed
  double displacement = 0.0;         // largest of a block since the reduction of strength began [m]
  double acceleration = 0.0;         // gain in speed of the fastest block over the time of the dynamic stage [m/s2]
  double time = 0.0;                 // simulated, of the dynamic stage [s]
  double needed = 0.0;               // undecided: time to the displacement limit, extrapolated [s]; 0: unknown
  double cpu = 0.0;                  // of the process [s]
  std::string fastest;               // name of the fastest block
  std::vector<BlockMotion> motions;  // in the dynamic stage
  [[nodiscard]] Mode mode() const { return leading_mode(motions); }
};

/// Criteria of the verdict.
struct Decision {
  double limit = 0.0;      // displacement [m]
  double tolerance = 0.0;  // of the factor of safety
  double factor = 1.0;     // by which the strengths of the run are divided
  Vec2 gravity{0.0, -9.81};
};

/// Verdict on a run. Stable: the dynamic stage ended by its rule of balance. Failed: the fastest block keeps
/// accelerating and has gained more than 2 % of its initial speed, and either a block has moved as far as the limit, or
/// the acceleration v/t is above 0.3 (1 - F_s) g, with F_s = 1/(1 + tolerance/factor) the margin that the search
/// resolves. A block keeps accelerating if v t >= 1.5 d, with its gain in speed v, the time t of the stage, and its
/// displacement d less the initial speed times t; constant acceleration gives 2 d. A run that could not continue counts
/// as failed if a block has moved as far as the limit or has no path of closed contacts to a support. All other runs
/// are undecided.
/// @param folder  of an ended run of [reduction] with a factor   @throws FileError
[[nodiscard]] TrialResult trial_result(const std::filesystem::path& folder, const Decision& decision);

/// Failure of a run that does not come to rest: the motion until a block has moved by four times the limit, or until
/// the run ended.
/// @throws FileError
[[nodiscard]] TrialResult failure_to_rest(const std::filesystem::path& folder, double limit, const Vec2& gravity);

}  // namespace scree::app
