// Whether a partitioned stage gets on.
#pragma once

#include <optional>
#include <string>

#include "coupling/integrate/time_integrator.h"
#include "coupling/sink.h"

namespace scree::coupling {

/// What a partitioned step took, in explicit updates of one element with its contacts: explicit steps as often as they
/// were repeated, and iterations of the implicit side. Counted, so that it is the same on every machine.
/// @param elements  of the explicit side
[[nodiscard]] double effort(const StepReport& report, const RunStats& stats, double elements);

/// True where two steps of half the length take less than this one: its iteration was long, and repeated explicit steps
/// are most of its effort. Half a step has half of them to repeat, and about two thirds of the iterations.
[[nodiscard]] bool shorter_is_cheaper(const StepReport& report, const RunStats& stats, double elements);

/// What implicit steps of all blocks take, a step.
[[nodiscard]] double implicit_effort(const RunStats& stats);

/// What to tell of a stage that takes more than `allowed` times what implicit steps would have taken for the way it has
/// come; a few steps at its beginning are free.
/// @param steps  implicit ones as long as `dt` for the time that has passed in the stage   @param allowed  0: never
[[nodiscard]] std::optional<std::string> too_slow(const RunStats& stats, double steps, double allowed);

}  // namespace scree::coupling
