// Closure error of the ledger of a run that is due to round-off.
#pragma once

#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// Energy that round-off of the state and of its sums may generate or lose [J]. With u the last place of the farthest
/// position, k the largest stiffness of a block or a contact [N/m for unit thickness], N the steps made and t the time:
///   (a) 1e-13 of the largest column: energies of blocks in flight, or at rest, far larger than those of other motion;
///   (b) forces with an error k u, over a path of t sqrt(2 B/m), B the energy passed and m the lightest block;
///   (c) forces F = M |g| + sqrt(2 k U), of weights and of springs with the energy U, over paths with an error u;
///   (d) k u^2, of springs that are stretched by round-off only.
/// Errors of steps have either sign with the same probability: those of (b) and (c) in N steps are sqrt(N) times those
/// of one step. Those of (d) excite vibration, which grows as N.   @pre the ledger is up to date
[[nodiscard]] double energy_of_last_places(const Model& model, const State& state);

}  // namespace scree::coupling
