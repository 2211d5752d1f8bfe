// Blocks of a model that touch at their initial positions, and the stretches along which they touch.
#pragma once

#include <vector>

#include "model/model.h"

namespace scree {

/// A stretch along which edges of two blocks lie against each other.
struct Stretch {
  Vec2 normal{0.0, 0.0};  // unit normal, outward of block a
  double length = 0.0;    // [m]
  JointId law;            // invalid: the model has no joints
};

/// Two blocks that touch.
struct Touch {
  BlockId a, b;                 // a < b
  std::vector<Stretch> facing;  // empty: they touch at points only
};

/// Law between two edges whose own laws may be given or not (invalid): the one that is given; if both are, the one with
/// less friction, and for equal friction the one defined first; if neither is, the default joint of the model.
[[nodiscard]] JointId law_between(const Model& model, JointId a, JointId b);

/// Gap below which two blocks count as touching: a thousandth of the root area of the smaller one [m].
inline constexpr double kTouchingGap = 1e-3;

/// Pairs of blocks that touch, ordered by a and b.
[[nodiscard]] std::vector<Touch> touching_blocks(const Model& model);

/// The nearest block outside a given set of blocks, and its distance from the set.
struct Neighbour {
  BlockId block;     // invalid: there is no other block
  double gap = 0.0;  // [m]
};
[[nodiscard]] Neighbour nearest_other(const Model& model, const std::vector<BlockId>& blocks);

}  // namespace scree
