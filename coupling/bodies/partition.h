// Which blocks of a partitioned stage take explicit steps.
#pragma once

#include <span>
#include <vector>

#include "coupling/plan.h"
#include "coupling/state.h"

namespace scree::coupling {

class Setup;
struct Ghosts;

/// Sides fixed by lists, a region or areas, as State::explicit_side; -1 where none of them applies. Absent blocks take
/// no steps, like held ones.
[[nodiscard]] std::vector<char> settled_sides(const Model& model, const Partition& partition,
                                              const Construction& construction = {});

/// Sides at the start of a stage, as State::explicit_side: 1 for explicit. Blocks that only rules of motion could move
/// start implicit.
[[nodiscard]] std::vector<char> first_sides(const Model& model, const Partition& partition,
                                            const Construction& construction = {});

/// Bodies of a stage whose internal force is evaluated at long steps only, for a setup of the whole model.
/// @param sides  State::explicit_side; empty: as the stage begins
[[nodiscard]] Ghosts slow_bodies(const Model& model, const Stage& stage, std::span<const char> sides = {});

/// Changes the sides by the motion at an instant.   @pre partition.changes()
/// @param fixed  settled_sides(): those stay
/// @param sides  present ones, changed in place   @return true if any changed
bool change_sides(const Setup& setup, const State& state, const Partition& partition, std::span<const char> fixed,
                  std::vector<char>& sides);

}  // namespace scree::coupling
