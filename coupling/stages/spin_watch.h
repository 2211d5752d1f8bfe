// Spins that implicit steps damp.
#pragma once

#include <string>
#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/plan.h"
#include "coupling/stages/run_watch.h"
#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// The part of a spin's energy that Newmark's steps (1/2, 1) remove per second from a body that turns freely and whose
/// rotation is a result of the steps: (w h)^2 per step.   @param rate w [rad/s]   @param dt h [s]
/// @source docs/theory/time-integration.md, "Numerical damping"
[[nodiscard]] double spin_lost(double rate, double dt);

inline constexpr double kSpinLost = 0.05;   // part of the energy per second: threshold of the warning
inline constexpr double kSpinTurned = 0.5;  // [rad]: blocks that have turned by less are rocking, or vibrating

/// A line for every block in implicit steps that has turned by kSpinTurned and loses more than kSpinLost of its spin.
/// @pre the stage damps_motion()
/// @param reported  blocks already reported are left out; new ones are added
[[nodiscard]] std::vector<std::string> damped_spins(const Model& model, const Setup& setup, const State& state,
                                                    ReportedWarnings& reported);

}  // namespace scree::coupling
