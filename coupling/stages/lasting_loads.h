// Loads that do not end: gravity, and what grows or stays.
#pragma once

#include "model/model.h"

namespace scree::coupling {

/// True where a load's factor does not return to zero for good, or to a mean of zero.
[[nodiscard]] bool lasts(const Model& model, FunctionId function);
/// Gravity, with body accelerations that last and act on all blocks: those stand for it where it grows with time
/// [m/s2].
[[nodiscard]] Vec2 weight_direction(const Model& model);
/// Force per mass on a block that lasts: gravity and body accelerations [m/s2].
[[nodiscard]] Vec2 lasting_acceleration(const Model& model, BlockId block);

/// Sum of what lasts on some blocks, and of its absolute values, by axis [N].
struct LastingForce {
  Vec2 sum{0.0, 0.0}, absolute{0.0, 0.0};
  /// True along an axis where it does not cancel.
  [[nodiscard]] bool acts(int axis) const;
};
void add_lasting_loads(const Model& model, const std::vector<std::int32_t>& group_of,
                       std::vector<LastingForce>& groups);

}  // namespace scree::coupling
