#include "model/edge_selection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

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
    // An edge across the line also has a stretch within the tolerance, but does not run beside the line.
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

namespace {

struct Interval {
  double from = 0.0, to = 0.0;
};

/// The rest of an interval without some others; rests shorter than `least` are ignored.
std::vector<Interval> without(Interval whole, std::vector<Interval> taken, double least) {
  std::sort(taken.begin(), taken.end(), [](const Interval& x, const Interval& y) { return x.from < y.from; });
  std::vector<Interval> left;
  double at = whole.from;
  for (const Interval& t : taken) {
    if (t.from - at > least) left.push_back({at, std::min(t.from, whole.to)});
    at = std::max(at, t.to);
    if (at >= whole.to) break;
  }
  if (whole.to - at > least) left.push_back({at, whole.to});
  return left;
}

bool apart(const Box& a, const Box& b, double tolerance) {
  return (a.lo.array() > b.hi.array() + tolerance).any() || (b.lo.array() > a.hi.array() + tolerance).any();
}

Box box_of(const Vec2& a, const Vec2& b) { return {a.cwiseMin(b), a.cwiseMax(b)}; }

std::vector<Box> boxes_of(const Model& model) {
  std::vector<Box> boxes;
  for (const Block& b : model.blocks) boxes.push_back(bounds(b.polygon));
  return boxes;
}

/// Part of an edge within a box; from >= to if there is none.
Interval clipped(const Vec2& a, const Vec2& b, const Box& box, double tolerance) {
  Interval in{0.0, 1.0};
  for (int d = 0; d < 2; ++d) {
    const double lo = box.lo[d] - tolerance - a[d], hi = box.hi[d] + tolerance - a[d], rise = b[d] - a[d];
    if (std::abs(rise) <= tolerance) {
      if (lo > std::max(0.0, rise) || hi < std::min(0.0, rise)) return {1.0, 0.0};
      continue;
    }
    in.from = std::max(in.from, std::min(lo / rise, hi / rise));
    in.to = std::min(in.to, std::max(lo / rise, hi / rise));
  }
  return in;
}

}  // namespace

namespace {

/// True where a ray meets no edge of any block.
bool leads_out(const Model& model, const std::vector<Box>& boxes, const Vec2& from, const Vec2& along) {
  for (std::size_t b = 0; b < boxes.size(); ++b) {
    const Polygon& polygon = model.blocks[b].polygon;
    bool hit = false;
    each_edge(polygon, [&](const OutlineEdge& edge) {
      const auto [p, q] = ends_of(polygon, edge);
      const Vec2 d = q - p, to = p - from;
      const double sine = cross(along, d);
      if (hit || std::abs(sine) < 1e-14 * d.norm()) return;
      const double t = cross(to, d) / sine, s = cross(to, along) / sine;
      hit = t > 0.0 && s >= 0.0 && s <= 1.0;
    });
    if (hit) return false;
  }
  return true;
}

}  // namespace

std::vector<EdgeSpan> outer_faces(const Model& model, double tolerance) {
  const std::vector<Box> boxes = boxes_of(model);
  Box all = boxes.front();
  for (const Box& b : boxes) all = {all.lo.cwiseMin(b.lo), all.hi.cwiseMax(b.hi)};
  std::vector<EdgeSpan> out;
  for (const EdgeSpan& span : free_edges_in_box(model, all, tolerance)) {
    const Polygon& polygon = model.blocks[span.block.index()].polygon;
    const auto [from, to] = ends_of(polygon, span.edge);
    const Vec2 middle = from + 0.5 * (span.s0 + span.s1) * (to - from), n = outward_normal(polygon, span.edge);
    const auto on_border = [&](const Vec2& side, double at) {
      return n.dot(side) > 1.0 - 1e-9 && std::abs(side.dot(middle) - at) <= 10.0 * tolerance;
    };
    if (on_border({-1.0, 0.0}, -all.lo.x()) || on_border({1.0, 0.0}, all.hi.x()) || on_border({0.0, -1.0}, -all.lo.y()))
      continue;
    const Vec2 outside = middle + 20.0 * tolerance * n;
    for (const Vec2& along : {Vec2(1e-3, 1.0), Vec2(-1.0, 1.0), Vec2(1.0, 1.0)})
      if (leads_out(model, boxes, outside, along.normalized())) {
        out.push_back(span);
        break;
      }
  }
  return out;
}

double length_of(const Model& model, const EdgeSpan& span) {
  const auto [from, to] = ends_of(model.blocks[span.block.index()].polygon, span.edge);
  return (span.s1 - span.s0) * (to - from).norm();
}

std::vector<EdgeSpan> free_edges_on_line(const Model& model, const Vec2& a, const Vec2& b, double tolerance) {
  const Box line = box_of(a, b);
  const double length = (b - a).norm();
  const Vec2 along = (b - a) / length;
  struct Part {
    EdgeSpan span;
    Interval t;  // along the line [m]
    bool left;   // the solid lies to the left of a -> b
  };
  std::vector<Part> parts;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const Polygon& polygon = model.blocks[i].polygon;
    if (apart(bounds(polygon), line, tolerance)) continue;
    for (const EdgeSpan& s : edges_on_line(BlockId{static_cast<std::int32_t>(i)}, polygon, a, b, tolerance)) {
      const auto [from, to] = ends_of(polygon, s.edge);
      const double t0 = (from + s.s0 * (to - from) - a).dot(along), t1 = (from + s.s1 * (to - from) - a).dot(along);
      parts.push_back({s, {std::min(t0, t1), std::max(t0, t1)}, t1 > t0});
    }
  }
  std::vector<EdgeSpan> out;
  for (const Part& p : parts) {
    std::vector<Interval> taken;
    for (const Part& o : parts)
      if (o.left != p.left && o.t.from < p.t.to && o.t.to > p.t.from) taken.push_back(o.t);
    const double whole = p.t.to - p.t.from, range = p.span.s1 - p.span.s0;
    for (const Interval& rest : without(p.t, std::move(taken), 2.0 * tolerance)) {
      double s0 = (rest.from - p.t.from) / whole, s1 = (rest.to - p.t.from) / whole;
      if (!p.left) s0 = 1.0 - std::exchange(s1, 1.0 - s0);
      EdgeSpan span = p.span;
      span.s0 = p.span.s0 + range * s0;
      span.s1 = p.span.s0 + range * s1;
      out.push_back(span);
    }
  }
  return out;
}

std::vector<EdgeSpan> free_edges_in_box(const Model& model, const Box& box, double tolerance) {
  const std::vector<Box> boxes = boxes_of(model);
  std::vector<EdgeSpan> out;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    if (apart(boxes[i], box, tolerance)) continue;
    const BlockId block{static_cast<std::int32_t>(i)};
    each_edge(model.blocks[i].polygon, [&](const OutlineEdge& edge) {
      const auto [from, to] = ends_of(model.blocks[i].polygon, edge);
      const double length = (to - from).norm(), hair = tolerance / length;
      const Interval in = clipped(from, to, box, tolerance);
      if (in.to - in.from <= 2.0 * hair) return;
      std::vector<Interval> taken;
      for (std::size_t j = 0; j < boxes.size(); ++j) {
        if (j == i || apart(boxes[j], box_of(from, to), tolerance)) continue;
        const Polygon& other = model.blocks[j].polygon;
        for (const EdgeSpan& s : edges_on_line(BlockId{static_cast<std::int32_t>(j)}, other, from, to, tolerance)) {
          const auto [p, q] = ends_of(other, s.edge);
          const Vec2 d = (to - from) / (length * length);
          const double t0 = (p + s.s0 * (q - p) - from).dot(d), t1 = (p + s.s1 * (q - p) - from).dot(d);
          if (t1 < t0) taken.push_back({t1, t0});  // runs the other way: it faces this edge
        }
      }
      for (const Interval& rest : without(in, std::move(taken), 2.0 * hair))
        out.push_back({block, edge, rest.from < hair ? 0.0 : rest.from, rest.to > 1.0 - hair ? 1.0 : rest.to});
    });
  }
  return out;
}

NearestEdge nearest_edge(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  NearestEdge nearest{{}, std::numeric_limits<double>::infinity()};
  each_edge(polygon, [&](const OutlineEdge& edge) {
    const auto [from, to] = ends_of(polygon, edge);
    // The distance from a straight piece is convex along a -> b, hence largest at an end.
    const double distance = std::max(distance_to_segment(a, from, to), distance_to_segment(b, from, to));
    if (distance < nearest.distance) nearest = {edge, distance};
  });
  return nearest;
}

}  // namespace scree
