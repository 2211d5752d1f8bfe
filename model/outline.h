// The outline of a body that is one affine piece: every vertex is a node, every edge a segment.
#pragma once

#include "model/pool.h"

namespace scree {

/// Interior angle at a vertex of a ring whose solid lies to the left [rad], 0 to 2 pi.
[[nodiscard]] double interior_angle(const Vec2& before, const Vec2& vertex, const Vec2& after);

/// @param row   gives the row of a point in material coordinates
/// @param cell  the one cell of the body
template <class RowOf>
[[nodiscard]] Boundary affine_boundary(const Polygon& outline, std::int32_t cell, RowOf&& row) {
  Boundary out;
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const Ring& ring = outline.ring(r);
    const auto start = static_cast<std::int32_t>(out.nodes.size()), count = static_cast<std::int32_t>(ring.size());
    for (std::int32_t i = 0; i < count; ++i) {
      const auto k = static_cast<std::size_t>(i);
      out.nodes.push_back(row(ring[k]));
      out.segments.push_back({start + i, start + (i + 1) % count, {static_cast<std::int32_t>(r), i}, 0.0, 1.0, cell});
      out.corners.push_back(
          {start + i, static_cast<std::int32_t>(r), i,
           interior_angle(ring[(k + ring.size() - 1) % ring.size()], ring[k], ring[(k + 1) % ring.size()])});
    }
  }
  return out;
}

}  // namespace scree
