// Whether a subcycled stage makes energy of its own.
#pragma once

#include <optional>
#include <string>

#include "coupling/state.h"

namespace scree::coupling {

inline constexpr double kEnergyMade = 0.05;  // of what there was and was done: what a stage may make untold

/// Remembers in State::rules what energy there is as a stage begins.   @pre the ledger is up to date
void begin_energy_watch(State& state);

/// What kicks in resonance would give: once the trapezoid term of elastic energy has grown by more than kEnergyMade of
/// the energy held as the stage began plus all work done on it since. Once a stage.
/// @return what to tell
/// @source docs/theory/explicit-implicit-coupling.md, "Explicit steps of two sizes"
[[nodiscard]] std::optional<std::string> watch_energy(State& state);

}  // namespace scree::coupling
