#include "coupling/contact/audit/audit.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "coupling/contact/law/joint_strength.h"
#include "model/geometry.h"

namespace scree::coupling {
namespace {

constexpr double kSameNumber = 1e-9;  // of the detection distance: difference of gaps and stretches computed twice

/// The outline of a body at its present place, with the nodes of its mesh, since its edges may be bent.
struct PresentOutline {
  Polygon polygon;
  std::vector<Vec2> corners;  // of the outer ring
};
std::vector<PresentOutline> present_outlines(const Setup& setup, std::span<const double> q) {
  const Outlines& o = setup.outlines();
  std::vector<PresentOutline> out(setup.bodies().size());
  for (const Outlines::Edge& e : o.edges) {
    if (e.opposite.valid() || !e.touches) continue;  // of a crack
    PresentOutline& body = out[e.body.index()];
    const auto hole = static_cast<std::size_t>(e.ring);
    if (hole > 0) body.polygon.holes.resize(std::max(body.polygon.holes.size(), hole));
    Ring& ring = hole == 0 ? body.polygon.outer : body.polygon.holes[hole - 1];
    for (std::int32_t k = 0; k < e.segments; ++k) ring.push_back(position(o.nodes[o.vertices[e.vertex(k)].node], q));
    if (hole == 0) body.corners.push_back(position(o.nodes[o.vertices[e.first_vertex()].node], q));
  }
  return out;
}

/// Distance from a point to the nearest side of a polygon.
double depth_in(const Polygon& p, const Vec2& x) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t r = 0; r < p.rings(); ++r) {
    const Ring& ring = p.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], d = ring[(i + 1) % ring.size()] - a;
      const double s = std::clamp((x - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
      nearest = std::min(nearest, (x - a - s * d).norm());
    }
  }
  return nearest;
}

}  // namespace

std::string contact_name(const Model& model, const ContactKey& key) {
  const auto& blocks = model.blocks;
  return fmt::format("blocks '{}' and '{}', corner {} on edge {}", blocks[static_cast<std::size_t>(key.block_p)].name,
                     blocks[static_cast<std::size_t>(key.block_e)].name, key.vertex, key.edge);
}

void audit_geometry(const Setup& setup, const ContactList& list, std::span<const double> q, double detection,
                    Audit& audit) {
  const Outlines& o = setup.outlines();
  const auto at = [&](OutlineNode node) { return position(o.nodes[node], q); };
  double farthest = 0.0;
  for (const double x : q) farthest = std::max(farthest, std::abs(x));
  const double allowed = kSameNumber * detection + 64.0 * std::numeric_limits<double>::epsilon() * farthest;
  // Where joints cross, diagonal corners carry no force, and are as deep as the joints beside them are pressed.
  std::set<std::pair<BodyIndex, BodyIndex>> held, listed;
  std::vector<double> pressed(setup.bodies().size(), 0.0);  // the deepest closed point of a body [m]
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    const ContactGeometry g = contact_geometry(at(p.node[0]), at(p.node[1]), at(p.node[2]));
    const auto name = [&] { return contact_name(setup.model(), m.key); };
    audit.check(g.gap - m.gap0 - m.gap, allowed,
                [&] { return fmt::format("{}: the gap is {:.6g} m, not {:.6g} m", name(), g.gap - m.gap0, m.gap); });
    // A point that closed at a depth, or whose share changed under load, has no force at the gap gap0.
    const bool comes_out = m.gap >= 0.0 && m.gap + m.gap0 < 0.0;
    const std::pair<BodyIndex, BodyIndex> bodies = std::minmax(o.node_body[p.node[0]], o.node_body[p.node[1]]);
    if (m.status != ContactStatus::open || comes_out) held.insert(bodies);
    listed.insert(bodies);
    if (m.status == ContactStatus::open) continue;
    for (const BodyIndex b : {bodies.first, bodies.second})
      pressed[b.index()] = std::max(pressed[b.index()], -(m.gap + m.gap0));
    audit.check((g.xi - m.anchor) * g.length - m.stretch, allowed,
                [&] { return fmt::format("{}: the stretch is not {:.6g} m", name(), m.stretch); });
  }
  const std::vector<PresentOutline> outline = present_outlines(setup, q);
  std::vector<Box> box;
  box.reserve(outline.size());
  // Bodies of the other side of a partitioned stage, which this one does not touch, have no outline.
  for (const PresentOutline& p : outline) box.push_back(p.corners.empty() ? Box{} : bounds(p.polygon));
  for (std::size_t a = 0; a < outline.size(); ++a)
    for (std::size_t b = 0; b < outline.size(); ++b) {
      if (a == b || !setup.can_touch(a, b) || outline[a].corners.empty() || outline[b].corners.empty()) continue;
      if ((box[a].lo.array() > box[b].hi.array()).any() || (box[b].lo.array() > box[a].hi.array()).any()) continue;
      const std::pair<BodyIndex, BodyIndex> bodies = std::minmax({BodyIndex::of(a), BodyIndex::of(b)});
      if (held.contains(bodies)) continue;
      const double most = 0.1 * detection + (listed.contains(bodies) ? pressed[a] + pressed[b] : 0.0);
      for (const Vec2& x : outline[a].corners)
        if (contains(outline[b].polygon, x))
          audit.check(depth_in(outline[b].polygon, x), most, [&] {
            const auto& blocks = setup.model().blocks;
            return fmt::format("a corner of block '{}' is {:.3g} m inside block '{}' and nothing holds it",
                               blocks[setup.bodies()[a].block.index()].name, depth_in(outline[b].polygon, x),
                               blocks[setup.bodies()[b].block.index()].name);
          });
    }
}

void audit_law(const Setup& setup, const ContactMemory& m, double fn, double ft, double tolerance, Audit& audit) {
  const JointLaw& law = setup.laws()[static_cast<std::size_t>(m.joint)];
  const auto name = [&] { return contact_name(setup.model(), m.key); };
  audit.check(std::max(0.0, -fn - tension_limit(law, m)), tolerance, [&] {
    return fmt::format("{}: a pull of {:.3g} N, and it bears {:.3g} N", name(), -fn, tension_limit(law, m));
  });
  audit.check(std::max(0.0, std::abs(ft) - friction_limit(law, m, fn)), tolerance, [&] {
    return fmt::format("{}: a friction force of {:.6g} N, and its limit is {:.6g} N", name(), std::abs(ft),
                       friction_limit(law, m, fn));
  });
}

}  // namespace scree::coupling
