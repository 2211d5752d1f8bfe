// Combinations of bodies and time scheme that a stage cannot have.
#pragma once

#include <span>

#include "coupling/bodies/setup.h"
#include "coupling/plan.h"

namespace scree::coupling {

/// @param sides  of the blocks: kDivided where one lies across the border
/// @throws PlanError where a stage cannot have steps of two sizes
void check_subcycled(const Stage& stage, const Setup& setup, std::span<const char> sides);

/// @param explicit_side  of the blocks of a partitioned stage: not 0 where they take explicit steps
/// @throws PlanError where a body, or the scheme, cannot take the stage's implicit steps
void check_implicit(const Stage& stage, const Setup& setup, std::span<const char> explicit_side);

}  // namespace scree::coupling
