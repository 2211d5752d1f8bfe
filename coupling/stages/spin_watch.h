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

/// The part of a spin's energy that a second of Newmark's steps (1/2, 1) takes from a body that turns freely and whose
/// rotation comes out of the steps: (w h)^2 a step.   @param rate w [rad/s]   @param dt h [s]
/// @source docs/theory/time-integration.md, "Numerical damping"
[[nodiscard]] double spin_lost(double rate, double dt);

inline constexpr double kSpinLost = 0.05;   // of the energy, in a second: what is told
inline constexpr double kSpinTurned = 0.5;  // [rad]: blocks that have turned less rock, or shake

/// A line for every block in implicit steps that has turned by kSpinTurned and loses more than kSpinLost of its spin.
/// @pre the stage damps_motion()
/// @param told  blocks that have had theirs are left out; new ones are added
[[nodiscard]] std::vector<std::string> damped_spins(const Model& model, const Setup& setup, const State& state,
                                                    Told& told);

}  // namespace scree::coupling
