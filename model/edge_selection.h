// Selects stretches of block outlines by position, for loads and supports along a line.
#pragma once

#include <vector>

#include "model/geometry.h"
#include "model/loads.h"
#include "model/model.h"

namespace scree {

/// Distance from a point to the straight piece a -> b [m]; a = b is a point.
[[nodiscard]] double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b);

/// Ends of an outline edge: vertex `edge` and the one after it.
/// @pre the polygon has that edge
struct EdgeEnds {
  Vec2 from, to;
};
[[nodiscard]] EdgeEnds ends_of(const Polygon& polygon, const OutlineEdge& edge);

/// Unit normal of an outline edge that points out of the solid; in a hole that is into the hole.
///   n = (d.y, -d.x)/|d|,  d = to - from
/// @pre the polygon is oriented, the edge has a length
[[nodiscard]] Vec2 outward_normal(const Polygon& polygon, const OutlineEdge& edge);

/// Parts of the outline, holes too, that lie on the straight piece a -> b, in either direction; by ring, edge.
/// A part lies on the piece if it runs beside the piece and both its ends are within the tolerance of it. An end within
/// the tolerance of a vertex is set to that vertex; parts shorter than twice the tolerance are ignored.
/// @param tolerance [m], > 0      @pre |b - a| > tolerance
[[nodiscard]] std::vector<EdgeSpan> edges_on_line(BlockId block, const Polygon& polygon, const Vec2& a, const Vec2& b,
                                                  double tolerance);

/// Parts of the outlines of all blocks that lie on the straight piece a -> b and face no other block's edge there: the
/// free faces of a domain that was cut into blocks. Ordered by block, ring, edge, then along a -> b. Parts are as in
/// edges_on_line().
/// @param tolerance [m], > 0      @pre |b - a| > tolerance
[[nodiscard]] std::vector<EdgeSpan> free_edges_on_line(const Model& model, const Vec2& a, const Vec2& b,
                                                       double tolerance);

/// Free parts of the outlines within a box, its border included, whatever the direction of the edges.
[[nodiscard]] std::vector<EdgeSpan> free_edges_in_box(const Model& model, const Box& box, double tolerance);

/// Faces of a model on which water in front of a slope can act: they face no other block, and from them a straight
/// line, upwards or obliquely upwards to either side, leaves the model without crossing a block. Faces on the left,
/// right and lower border of the model's box are excluded.
[[nodiscard]] std::vector<EdgeSpan> outer_faces(const Model& model, double tolerance);

/// Length of a span [m].
[[nodiscard]] double length_of(const Model& model, const EdgeSpan& span);

/// The outline edge nearest to the whole of a -> b, and the largest distance of the piece from it.
struct NearestEdge {
  OutlineEdge edge;
  double distance = 0.0;  // largest distance of a point of a -> b from the edge [m]
};
[[nodiscard]] NearestEdge nearest_edge(const Polygon& polygon, const Vec2& a, const Vec2& b);

}  // namespace scree
