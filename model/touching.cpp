#include "model/touching.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "model/near_pairs.h"

namespace scree {
namespace {

struct Edge {
  Vec2 a, b;
  std::size_t ring, edge;
};

std::vector<Edge> edges_of(const Polygon& polygon) {
  std::vector<Edge> edges;
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring& ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({ring[i], ring[(i + 1) % ring.size()], r, i});
  }
  return edges;
}

/// Distance of a point from a segment.
double distance(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double s = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (a + s * d - p).norm();
}

double distance(const Edge& e, const Edge& f) {
  const Vec2 d = e.b - e.a, g = f.b - f.a;
  const auto sides = [](const Vec2& from, const Vec2& along, const Vec2& p, const Vec2& q) {
    return cross(along, p - from) * cross(along, q - from) < 0.0;
  };
  if (sides(e.a, d, f.a, f.b) && sides(f.a, g, e.a, e.b)) return 0.0;  // they cross
  return std::min({distance(e.a, f.a, f.b), distance(e.b, f.a, f.b), distance(f.a, e.a, e.b), distance(f.b, e.a, e.b)});
}

/// Length of edge e that edge f, of opposite direction, covers: the ends of f projected on e, both within the gap.
std::optional<double> common_length(const Edge& e, const Edge& f, double gap) {
  const Vec2 d = e.b - e.a;
  const double length = d.norm();
  const Vec2 t = d / length;
  if (t.dot(f.b - f.a) >= 0.0) return std::nullopt;
  const double from = std::max(0.0, t.dot(f.b - e.a)), to = std::min(length, t.dot(f.a - e.a));
  if (to - from <= 2.0 * gap) return std::nullopt;
  for (const double s : {from, to})
    if (distance(e.a + s * t, f.a, f.b) > gap) return std::nullopt;
  return to - from;
}

struct Outline {
  Box box;
  double root_area = 0.0;
  std::vector<Edge> edges;
};

std::vector<Outline> outlines(const Model& model) {
  std::vector<Outline> out;
  out.reserve(model.blocks.size());
  for (const Block& b : model.blocks)
    out.push_back({bounds(b.polygon), std::sqrt(moments(b.polygon).area), edges_of(b.polygon)});
  return out;
}

bool near(const Box& a, const Box& b, double gap) {
  return a.lo.x() - gap <= b.hi.x() && b.lo.x() - gap <= a.hi.x() && a.lo.y() - gap <= b.hi.y() &&
         b.lo.y() - gap <= a.hi.y();
}

Box box_of(const Edge& e) { return {e.a.cwiseMin(e.b), e.a.cwiseMax(e.b)}; }

/// Contact of two blocks; empty if they do not touch.
std::optional<Touch> touch_of(const Model& model, const std::vector<Outline>& all, std::size_t i, std::size_t j) {
  const double gap = kTouchingGap * std::min(all[i].root_area, all[j].root_area);
  Touch touch{BlockId(static_cast<std::int32_t>(i)), BlockId(static_cast<std::int32_t>(j)), {}};
  bool meets = false;
  for (const Edge& e : all[i].edges) {
    if (!near(box_of(e), all[j].box, gap)) continue;
    for (const Edge& f : all[j].edges) {
      if (!near(box_of(e), box_of(f), gap) || distance(e, f) > gap) continue;
      meets = true;
      const auto length = common_length(e, f, gap);
      if (!length) continue;
      const Vec2 t = (e.b - e.a).normalized();
      touch.facing.push_back(
          {Vec2(t.y(), -t.x()), *length,
           law_between(model, model.joint_of(touch.a, e.ring, e.edge), model.joint_of(touch.b, f.ring, f.edge))});
    }
  }
  return meets ? std::optional(std::move(touch)) : std::nullopt;
}

}  // namespace

JointId law_between(const Model& model, JointId a, JointId b) {
  if (!a.valid() && !b.valid()) return model.default_joint;
  if (!a.valid() || !b.valid()) return a.valid() ? a : b;
  const double friction_a = model.joints[a.index()].friction, friction_b = model.joints[b.index()].friction;
  if (friction_a != friction_b) return friction_a < friction_b ? a : b;
  return a.value < b.value ? a : b;
}

std::vector<Touch> touching_blocks(const Model& model) {
  const std::vector<Outline> all = outlines(model);
  std::vector<double> margin;
  margin.reserve(all.size());
  for (const Outline& o : all) margin.push_back(kTouchingGap * o.root_area);
  std::vector<Touch> touches;
  for (const auto& [i, j] : near_pairs(model.blocks, margin))
    if (auto touch = touch_of(model, all, static_cast<std::size_t>(i), static_cast<std::size_t>(j)))
      touches.push_back(std::move(*touch));
  return touches;
}

Neighbour nearest_other(const Model& model, const std::vector<BlockId>& blocks) {
  std::vector<char> own(model.blocks.size(), 0);
  for (const BlockId b : blocks) own[b.index()] = 1;
  Neighbour nearest{BlockId{}, std::numeric_limits<double>::infinity()};
  for (std::size_t other = 0; other < model.blocks.size(); ++other) {
    if (own[other] != 0) continue;
    const Box box = bounds(model.blocks[other].polygon);
    const std::vector<Edge> edges = edges_of(model.blocks[other].polygon);
    for (const BlockId b : blocks)
      for (const Edge& e : edges_of(model.blocks[b.index()].polygon)) {
        if (!near(box_of(e), box, nearest.gap)) continue;
        for (const Edge& f : edges)
          if (const double gap = distance(e, f); gap < nearest.gap)
            nearest = {BlockId(static_cast<std::int32_t>(other)), gap};
      }
  }
  return nearest;
}

}  // namespace scree
