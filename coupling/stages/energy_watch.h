// Detects spurious energy generation in a subcycled stage.
#pragma once

#include <optional>
#include <string>

#include "coupling/state.h"

namespace scree::coupling {

inline constexpr double kEnergyMade = 0.05;  // threshold of the warning: fraction of initial energy plus work

/// Records the energies at the beginning of a stage in State::rules.   @pre the ledger is up to date
void begin_energy_watch(State& state);

/// Detects resonance of the impulses of slow forces: the trapezoid term of elastic energy has grown by more than
/// kEnergyMade of the energy held as the stage began plus all work done since. Reported once per stage.
/// @return the warning
/// @source docs/theory/explicit-implicit-coupling.md, "Explicit steps of two sizes"
[[nodiscard]] std::optional<std::string> watch_energy(State& state);

}  // namespace scree::coupling
