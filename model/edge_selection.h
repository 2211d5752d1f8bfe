// Stretches of a block's outline by where they are: what a load or a support along a line acts on.
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

/// Parts of the outline, holes too, that lie on the straight piece a -> b, whichever way that runs; by ring, edge.
/// A part lies on it where it runs beside it and both its ends are within the tolerance of it. Ends of a part within
/// the tolerance of a vertex are that vertex; parts shorter than twice the tolerance do not count.
/// @param tolerance [m], > 0      @pre |b - a| > tolerance
[[nodiscard]] std::vector<EdgeSpan> edges_on_line(BlockId block, const Polygon& polygon, const Vec2& a, const Vec2& b,
                                                  double tolerance);

/// Parts of the outlines of all blocks that lie on the straight piece a -> b and face no other block's edge there: the
/// free faces of a model that blocks were cut from, by block, ring, edge, then along a -> b. Parts as in
/// edges_on_line().
/// @param tolerance [m], > 0      @pre |b - a| > tolerance
[[nodiscard]] std::vector<EdgeSpan> free_edges_on_line(const Model& model, const Vec2& a, const Vec2& b,
                                                       double tolerance);

/// The same within a box (its border belongs to it), whatever way the edges run.
[[nodiscard]] std::vector<EdgeSpan> free_edges_in_box(const Model& model, const Box& box, double tolerance);

/// The faces of a model that water before a slope can press on: those that face no other block and from which a
/// straight line leads out of the model, up or up to either side, through no block; not those on the left, right and
/// lower border of the model's box.
[[nodiscard]] std::vector<EdgeSpan> outer_faces(const Model& model, double tolerance);

/// Length of a span [m].
[[nodiscard]] double length_of(const Model& model, const EdgeSpan& span);

/// The outline edge that comes nearest to holding the whole of a -> b, and how far the piece strays from it.
struct NearestEdge {
  OutlineEdge edge;
  double distance = 0.0;  // largest distance of a point of a -> b from the edge [m]
};
[[nodiscard]] NearestEdge nearest_edge(const Polygon& polygon, const Vec2& a, const Vec2& b);

}  // namespace scree
