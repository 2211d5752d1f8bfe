// Forces that replace removed rock or supports while these forces are released.
#pragma once

#include <cstdint>
#include <vector>

#include "model/ids.h"

namespace scree::coupling {

/// A force at a point of a block's outline, independent of mesh and method of the block. Its direction is constant.
struct SupportForce {
  BlockId block;
  std::int32_t ring = 0, edge = 0;
  double s = 0.0;                 // along the edge, 0 to 1
  double x = 0.0, y = 0.0;        // the whole force, at the removal [N]
  double left = 1.0, last = 1.0;  // fraction that acts as the release begins, and after it
};

/// All such forces, with their release: the fraction that acts decreases linearly from `left` to `last`.
///   p(t) = last + (left - last) r,  r = (end - t)/(end - begin), 0 <= r <= 1
/// @source docs/theory/construction.md, "Release"
struct SupportForces {
  std::vector<SupportForce> forces;
  Tick begin = 0, end = 0;  // of the release; equal: at once

  /// r at time t.
  [[nodiscard]] double remaining(Tick t) const {
    if (t >= end) return 0.0;
    return t <= begin ? 1.0 : static_cast<double>(end - t) / static_cast<double>(end - begin);
  }
  /// A release is under way.
  [[nodiscard]] bool releasing(Tick t) const { return !forces.empty() && t < end; }

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see.size("support.forces", forces);
    for (const SupportForce& f : forces) {
      see("support.block", f.block.value);
      see("support.ring", f.ring);
      see("support.edge", f.edge);
      see("support.s", f.s);
      see("support.x", f.x);
      see("support.y", f.y);
      see("support.left", f.left);
      see("support.last", f.last);
    }
    see("support.begin", begin);
    see("support.end", end);
  }
};

}  // namespace scree::coupling
