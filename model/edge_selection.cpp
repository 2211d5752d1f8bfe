#include "model/edge_selection.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/check.h"

namespace scree {

double distance_to_segment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double length2 = d.squaredNorm();
  const double s = length2 > 0.0 ? std::clamp((p - a).dot(d) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * d).norm();
}

EdgeEnds ends_of(const Polygon& polygon, const OutlineEdge& edge) {
  const Ring& ring = polygon.ring(static_cast<std::size_t>(edge.ring));
  const auto i = static_cast<std::size_t>(edge.edge);
  return {ring[i], ring[(i + 1) % ring.size()]};
}

Vec2 outward_normal(const Polygon& polygon, const OutlineEdge& edge) {
  const auto [from, to] = ends_of(polygon, edge);
  const Vec2 d = (to - from).normalized();
  return {d.y(), -d.x()};
}

namespace {

template <class See>
void each_edge(const Polygon& polygon, const See& see) {
  for (std::size_t r = 0; r < polygon.rings(); ++r)
    for (std::size_t i = 0; i < polygon.ring(r).size(); ++i)
      see(OutlineEdge{static_cast<std::int32_t>(r), static_cast<std::int32_t>(i)});
}

}  // namespace

std::vector<EdgeSpan> edges_on_line(BlockId block, const Polygon& polygon, const Vec2& a, const Vec2& b,
                                    double tolerance) {
  const double length = (b - a).norm();
  SCREE_ASSERT(length > tolerance);
  const Vec2 along = (b - a) / length;
  std::vector<EdgeSpan> spans;
  each_edge(polygon, [&](const OutlineEdge& edge) {
    const auto [from, to] = ends_of(polygon, edge);
    const Vec2 d = to - from;
    const double rise = d.dot(along), edge_length = d.norm();
    // An edge across the line has a stretch within the tolerance too, but does not run beside it.
    if (std::abs(rise) <= std::abs(cross(along, d))) return;
    // x(s) = from + s d is beside the line where 0 <= (x - a).along <= length.
    double s0 = -(from - a).dot(along) / rise, s1 = s0 + length / rise;
    if (s0 > s1) std::swap(s0, s1);
    const double hair = tolerance / edge_length;
    s0 = s0 < hair ? 0.0 : s0;
    s1 = s1 > 1.0 - hair ? 1.0 : s1;
    if ((s1 - s0) * edge_length < 2.0 * tolerance) return;
    for (const double s : {s0, s1})
      if (std::abs(cross(along, from + s * d - a)) > tolerance) return;
    spans.push_back({block, edge, s0, s1});
  });
  return spans;
}

NearestEdge nearest_edge(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  NearestEdge nearest{{}, std::numeric_limits<double>::infinity()};
  each_edge(polygon, [&](const OutlineEdge& edge) {
    const auto [from, to] = ends_of(polygon, edge);
    // The distance from a straight piece is convex along a -> b: it is largest at an end.
    const double distance = std::max(distance_to_segment(a, from, to), distance_to_segment(b, from, to));
    if (distance < nearest.distance) nearest = {edge, distance};
  });
  return nearest;
}

}  // namespace scree
