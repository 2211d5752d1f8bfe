// Loads that last: gravity, and loads that grow or stay.
#pragma once

#include "model/model.h"

namespace scree::coupling {

/// True where a load's factor does not return to zero for good, or to a mean of zero.
[[nodiscard]] bool lasts(const Model& model, FunctionId function);
/// Gravity plus lasting body accelerations of all blocks, which are used in place of gravity where it grows with time
/// [m/s2].
[[nodiscard]] Vec2 weight_direction(const Model& model);
/// Lasting force per mass on a block: gravity and body accelerations [m/s2].
[[nodiscard]] Vec2 lasting_acceleration(const Model& model, BlockId block);

/// Sum of the lasting loads on some blocks, and of their absolute values, by axis [N].
struct LastingForce {
  Vec2 sum{0.0, 0.0}, absolute{0.0, 0.0};
  /// True along an axis where the loads do not cancel.
  [[nodiscard]] bool acts(int axis) const;
};
void add_lasting_loads(const Model& model, const std::vector<std::int32_t>& group_of,
                       std::vector<LastingForce>& groups);

}  // namespace scree::coupling
