// Rules shared by what decides which contact carries, and what is a contact at all.
#pragma once

#include <cstdint>
#include <utility>

#include "coupling/contact/table/contact_pairs.h"

namespace scree::coupling {

inline constexpr double kInLine = 0.5;  // of a corner's depth: above it the depth is that of the joint beside it

/// How far nodes may move while a side of a corner leans into an edge by more than kWedgeTolerance, so that the corner
/// cannot touch the edge [m]; 0: it does not lean so far. If the ends of a line move by d, it turns by at most
/// pi d/length.
/// @param side  from the corner to the next node of its outline [m]   @param at  of the corner over the edge's segment
[[nodiscard]] inline double averted_room(const Vec2& side, const ContactGeometry& at) {
  const double length = side.norm(), lean = -at.n.dot(side) - kWedgeTolerance * length;
  return lean > 0.0 ? 0.25 * lean * at.length / (length + at.length) : 0.0;
}

/// Which vertex of an edge a vertex is, 0 to `segments`.   @pre it is one
[[nodiscard]] inline std::int32_t part_of(const Outlines& o, VertexIndex vertex, EdgeIndex edge) {
  const Outlines::Segment& next = o.segments[leaving(vertex)];
  return next.edge == edge ? next.part : o.edges[edge].segments;
}

/// The first and last vertex of an edge, counted within it, between which lies all of it that is within `reach` of a
/// place, along the edge.
/// @param x  of the outline's nodes   @param along  direction of the edge   @param part  a segment near the place
[[nodiscard]] inline std::pair<std::int32_t, std::int32_t> part_near(const Outlines& o, OutlinePositions x,
                                                                     const Outlines::Edge& edge, const Vec2& along,
                                                                     std::int32_t part, const Vec2& at, double reach) {
  const auto ahead = [&](std::int32_t k) { return along.dot(x[o.vertices[edge.vertex(k)].node] - at); };
  std::pair out(part, part);
  while (out.first > 0 && ahead(out.first) > -reach) --out.first;
  while (out.second < edge.segments && ahead(out.second) < reach) ++out.second;
  return out;
}

}  // namespace scree::coupling
