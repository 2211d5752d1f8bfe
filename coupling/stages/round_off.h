// What the ledger of a run may be open by because its numbers end somewhere.
#pragma once

#include "coupling/state.h"
#include "model/model.h"

namespace scree::coupling {

/// Energy that the last places of the state and of its sums may make or lose [J]. With u the last place of the farthest
/// position, k the largest stiffness of a block or a contact [N/m for unit thickness], N the steps made and t the time:
///   (a) 1e-13 of the largest column: energies of blocks that fly, or rest, far above all that moves;
///   (b) forces known to k u, on a way of t sqrt(2 B/m), B the energy passed and m the lightest block;
///   (c) forces F = M |g| + sqrt(2 k U), of weights and of springs that hold the energy U, on ways known to u;
///   (d) k u^2, of springs that only round-off stretches.
/// Errors of steps are as likely to be of one sign as of the other: N of (b) grow as sqrt(N) of a step's, N of (c)
/// too. Those of (d) pump vibration, which grows as N.   @pre the ledger is up to date
[[nodiscard]] double energy_of_last_places(const Model& model, const State& state);

}  // namespace scree::coupling
