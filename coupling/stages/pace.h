// Cost of the steps of a partitioned stage, and whether it is too slow.
#pragma once

#include <optional>
#include <string>

#include "coupling/integrate/time_integrator.h"
#include "coupling/sink.h"

namespace scree::coupling {

/// Effort of a partitioned step, in explicit updates of one element with its contacts: explicit steps including their
/// repetitions, and iterations of the implicit side. It is counted, not timed, to be the same on every machine.
/// @param elements  of the explicit side
[[nodiscard]] double effort(const StepReport& report, const RunStats& stats, double elements);

/// True where two steps of half the length have less effort than this one: its iteration was long, and repeated
/// explicit steps are most of its effort. Half a step repeats half of them, in about two thirds of the iterations.
[[nodiscard]] bool shorter_is_cheaper(const StepReport& report, const RunStats& stats, double elements);

/// Effort of one step in which all blocks are implicit.
[[nodiscard]] double implicit_effort(const RunStats& stats);

/// Message about a stage whose effort exceeds `allowed` times that of implicit steps for the same time; empty: none. A
/// few steps at its beginning are not counted.
/// @param steps  implicit ones as long as `dt` for the time that has passed in the stage   @param allowed  0: never
[[nodiscard]] std::optional<std::string> too_slow(const RunStats& stats, double steps, double allowed);

}  // namespace scree::coupling
