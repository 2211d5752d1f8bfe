// What contact points take over from the instant before: where a vertex, a share, a kind or a mesh changes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/contact/law/dilation.h"
#include "coupling/contact/law/joint_strength.h"
#include "coupling/contact/table/contact_finder.h"

namespace scree::coupling {
namespace {

/// True if a point is of the kind of its memory: an edge-edge contact, or the same corner on the same edge.
/// @param passed  true: the memory is from another vertex or edge
bool same_kind(const ContactPoint& p, const ContactMemory& m, bool passed) {
  return m.edge_edge == static_cast<std::int32_t>(p.edge_edge) && (p.edge_edge || !passed);
}

}  // namespace

void ContactFinder::inherit(ContactList& out) {
  const Outlines& o = setup_->outlines();
  const auto in_line = [&](EdgeIndex a, EdgeIndex b) {
    const Outlines::Edge &ea = o.edges[a], &eb = o.edges[b];
    return (ea.end_vertex == eb.first_vertex() || eb.end_vertex == ea.first_vertex()) &&
           pairs_.direction(a).dot(pairs_.direction(b)) > kStillFaces;
  };
  for (const std::int32_t f : fresh_) {
    ContactPoint& p = out.points[static_cast<std::size_t>(f)];
    const Outlines::Vertex& v = o.vertices[p.vertex];
    double nearest = detection_;
    const auto look = [&](std::size_t g) {
      if (gone_[g] == 0 || !known_.closed(g)) return;
      const OutlineNode at = o.vertices[known_.vertex(g)].node;
      const double d = (x_[at] - x_[p.node[0]]).norm();
      const auto index = static_cast<std::int32_t>(g);
      if (d > nearest || (d == nearest && p.from >= 0 && p.from <= index)) return;
      nearest = d;
      p.from = index;
    };
    // Points of the other side whose place the vertex takes, and the vertex itself against the next edge in line.
    if (p.edge_edge)
      known_.for_vertices(
          p.edge, [&v](EdgeIndex edge) { return edge == v.edge_in || edge == v.edge_out; },
          [&](std::size_t g) {
            if (known_.edge_edge(g)) look(g);
          });
    known_.for_vertex(
        p.vertex, [&](EdgeIndex edge) { return in_line(edge, p.edge); }, look);
    if (p.from >= 0) gone_[static_cast<std::size_t>(p.from)] = 0;
  }
}

void ContactFinder::keep_force(const ContactMemory& old, bool divided, const ContactPoint& p, ContactMemory& m) {
  const double given = divided ? old.tributary / m.tributary : 1.0;
  const auto resting_on = [given](double now, double was) {
    const double own = std::max(now, was);
    constexpr double kStrains = 1.01;  // shares that differ by less are the same
    return given * now > kStrains * own ? given * now : own;
  };
  const double kn = resting_on(m.kn, old.kn), kt = resting_on(m.kt, old.kt);
  m.gap0 = p.at.gap + (m.fn - m.fd) / kn;
  m.stretch = -(m.ft - m.fdt) / kt;
}

void ContactFinder::set_gap0(bool known, const ContactPoint& p, ContactMemory& m) const {
  const double opened = opened_by_slip(setup_->laws()[static_cast<std::size_t>(m.joint)], m.slip),
               above = p.at.gap - opened;
  if (!known || m.gap < 0.0)
    m.gap0 = p.first_gap0;
  else if (m.segment < 0)
    m.gap0 = opened + std::min(above, 0.0);
  else
    m.gap0 = opened + (m.gap0 > opened ? 0.0 : std::clamp(above, m.gap0 - opened, 0.0));
}

bool ContactFinder::beside_next_corner(const ContactPoint& p) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& edge = o.edges[p.edge];
  const EdgeIndex next = o.vertices[edge.end_vertex].edge_out, before = o.vertices[edge.first_vertex()].edge_in;
  const Vec2& at = x_[p.node[0]];
  const auto meets = [&](VertexIndex v) { return (x_[o.vertices[v].node] - at).norm() <= touching_; };
  return meets(o.edges[next].end_vertex) || meets(o.edges[before].first_vertex());
}

void ContactFinder::fill(const ContactMemory* old, bool at_start, bool divided, ContactPoint& p,
                         ContactMemory& m) const {
  const Outlines& o = setup_->outlines();
  const std::int32_t part = o.segments[p.segment].part;
  if (old == nullptr)
    m.joint = p.joint;
  else if (old != &m)
    m = *old;
  const auto before = static_cast<std::size_t>(p.from);
  const bool passed = old != nullptr && (known_.vertex(before) != p.vertex || known_.edge(before) != p.edge);
  if (old == nullptr || passed) m.key = key_of(p.vertex, p.edge);
  p.key = m.key;
  const bool closed = m.status != ContactStatus::open;
  if (passed) m.joint = p.joint;
  if (m.segment < 0) m.impact = 0.0;  // a body was made anew
  // A corner that has passed to another edge keeps its force, independent of the stiffness there: see adopt_kinds(). In
  // an impact a point keeps kind, share and springs.
  if (!closed || (m.impact == 0.0 && same_kind(p, m, passed))) {
    m.edge_edge = static_cast<std::int32_t>(p.edge_edge);
    m.tributary = p.springs.tributary;
    m.kn = p.springs.kn;
    m.kt = p.springs.kt;
  }
  set_damping(p, m);
  if (at_start && old == nullptr && !p.beyond && std::abs(p.at.gap) <= touching_) {
    m.gap0 = p.at.gap;
    m.status = ContactStatus::stick;  // closed, without force
    m.bonded = setup_->laws()[static_cast<std::size_t>(m.joint)].tensile_strength > 0.0 ? 1 : 0;
    m.segment = part;
    m.anchor = p.at.xi;
    return;
  }
  if (closed && m.segment < 0)
    keep_force(*old, divided, p, m);
  else if (!closed && (!at_start || beside_next_corner(p)))
    set_gap0(old != nullptr, p, m);
  m.gap = p.at.gap - m.gap0;
  if (!closed) {
    m.segment = part;
    m.anchor = p.at.xi;
    m.stretch = 0.0;
    return;
  }
  if (m.segment < 0) {  // the edge was divided anew: the stretch is kept
    m.segment = part;
    m.anchor = p.at.xi - m.stretch / p.at.length;
  } else if (m.segment != part || passed) {
    // The stretch at the old place now, then the same stretch at the new one.
    const ContactGeometry g = geometry(known_.vertex(before), o.edges[known_.edge(before)].first_segment + m.segment);
    m.segment = part;
    m.anchor = p.at.xi - (g.xi - m.anchor) * g.length / p.at.length;
  }
  // Always from the anchor, so that finding twice at one place gives the same bits.
  m.stretch = (p.at.xi - m.anchor) * p.at.length;
}

void ContactFinder::remember(std::size_t i, bool at_start, ContactList& out) const {
  ContactPoint& p = out.points[i];
  ContactMemory& m = out.memory[i];
  const ContactList& known = known_.list();
  const ContactMemory* was = p.from < 0 ? nullptr : &known.memory[static_cast<std::size_t>(p.from)];
  const bool divided = was != nullptr && was->segment < 0 && is_divided(p);
  fill(was, at_start, divided, p, m);
  if (was != nullptr || p.beside < 0) return;
  const ContactMemory& beside = known.memory[static_cast<std::size_t>(p.beside)];
  if (beside.status == ContactStatus::open) return;
  // The joint is the same, and so is its friction. A bond is that of two blocks: it does not pass to the next one.
  if (std::minmax(beside.key.block_p, beside.key.block_e) == std::minmax(p.key.block_p, p.key.block_e))
    bond_like(beside, m);
  if (m.gap >= 0.0 && m.bonded == 0) return;
  m.status = ContactStatus::stick;
  m.failed = beside.failed;
  m.slip = m.slip_known = beside.slip;
  m.friction_change = beside.friction_change;
  m.stretch = beside.stretch;
  m.anchor = p.at.xi - m.stretch / p.at.length;
}

bool ContactFinder::adds(const ContactPoint& p) const {
  const Outlines::Vertex& v = setup_->outlines().vertices[p.vertex];
  return p.from < 0 && p.edge_edge && v.edge_in == v.edge_out;
}

EdgePair ContactFinder::joint_of(const ContactPoint& p, bool out) const {
  const Outlines::Vertex& v = setup_->outlines().vertices[p.vertex];
  const EdgeIndex own = out ? v.edge_out : v.edge_in;
  return {std::min(p.edge, own), std::max(p.edge, own)};
}

void ContactFinder::index_divided(const ContactList& out) {
  added_.clear();
  remembered_.clear();
  if (!known_.divided()) return;
  for (std::size_t i = 0; i < out.points.size(); ++i) {
    const ContactPoint& p = out.points[i];
    if (adds(p)) added_.push_back(joint_of(p, true));
    if (p.from < 0) continue;
    const EdgePair in = joint_of(p, false), leaving = joint_of(p, true);
    remembered_.push_back({in, static_cast<std::int32_t>(i)});
    if (leaving != in) remembered_.push_back({leaving, static_cast<std::int32_t>(i)});
  }
  std::sort(added_.begin(), added_.end());
  std::sort(remembered_.begin(), remembered_.end());
}

bool ContactFinder::is_divided(const ContactPoint& p) const {
  return std::binary_search(added_.begin(), added_.end(), joint_of(p, false)) ||
         std::binary_search(added_.begin(), added_.end(), joint_of(p, true));
}

void ContactFinder::bond_like(const ContactMemory& beside, ContactMemory& m) const {
  const JointLaw& law = setup_->laws()[static_cast<std::size_t>(m.joint)];
  m.bonded = beside.bonded;
  if (m.kn * m.gap > tension_limit(law, m)) m.bonded = 0;
}

void ContactFinder::interpolate(ContactList& out) const {
  if (!known_.closed_divided()) return;
  for (std::size_t f = 0; f < out.points.size(); ++f) {
    const ContactPoint& p = out.points[f];
    if (!adds(p)) continue;
    // Nearest remembered points of the two edges, before and behind.
    struct Neighbour {
      double distance = 0.0;
      const ContactMemory* memory = nullptr;
    } side[2], nearest;  // the nearest may be open: a joint torn at a corner stays torn
    const EdgePair joint = joint_of(p, true);
    for (auto r = std::lower_bound(remembered_.begin(), remembered_.end(), OnJoint{joint, 0});
         r != remembered_.end() && r->joint == joint; ++r) {
      const auto i = static_cast<std::size_t>(r->point);
      const ContactPoint& n = out.points[i];
      const double s = p.at.t.dot(x_[n.node[0]] - x_[p.node[0]]);
      if (nearest.memory == nullptr || std::abs(s) < nearest.distance) nearest = {std::abs(s), &out.memory[i]};
      if (out.memory[i].status == ContactStatus::open) continue;
      Neighbour& found = side[s < 0.0 ? 0 : 1];
      if (found.memory == nullptr || std::abs(s) < found.distance) found = {std::abs(s), &out.memory[i]};
    }
    const bool within = side[0].memory != nullptr && side[1].memory != nullptr;
    if (side[0].memory == nullptr) side[0] = side[1];
    if (side[0].memory == nullptr) continue;
    if (side[1].memory == nullptr) side[1] = side[0];
    const ContactMemory &a = *side[0].memory, &b = *side[1].memory;
    const double whole = side[0].distance + side[1].distance, w = whole > 0.0 ? side[0].distance / whole : 0.5;
    ContactMemory& m = out.memory[f];
    m.status = ContactStatus::stick;
    m.failed = w < 0.5 ? a.failed : b.failed;
    m.gap0 = (1.0 - w) * a.gap0 + w * b.gap0;
    m.slip = m.slip_known = (1.0 - w) * a.slip + w * b.slip;
    m.friction_change = (1.0 - w) * a.friction_change + w * b.friction_change;
    m.stretch = (1.0 - w) * a.stretch + w * b.stretch;
    m.gap = p.at.gap - m.gap0;
    if (within) {  // the traction is linear between them, however the edge is bent
      m.gap = (1.0 - w) * a.gap + w * b.gap;
      m.gap0 = p.at.gap - m.gap;
    }
    m.anchor = p.at.xi - m.stretch / p.at.length;
    bond_like(*nearest.memory, m);
  }
}

void ContactFinder::adopt_kind(const ContactPoint& p, ContactMemory& m, double& change) {
  if (!may_adopt(p, m)) return;
  const bool same_kind = m.edge_edge == static_cast<std::int32_t>(p.edge_edge);
  // A corner that begins to overlap stays one until the overlap is large enough: no force rests on a vanishing length.
  if (p.edge_edge && !same_kind && p.springs.tributary < std::min(m.tributary, 0.5 * p.largest_tributary)) return;
  // A share that has become smaller in an impact is followed from the next step on, as in sliding: see fill().
  if (p.edge_edge && same_kind && p.springs.tributary < m.tributary) return;
  const bool loaded = !p.suppressed && (m.gap < 0.0 || m.bonded != 0);
  const double gap = loaded ? m.gap * m.kn / p.springs.kn : m.gap, stretch = m.stretch * m.kt / p.springs.kt;
  if (loaded) change += 0.5 * (p.springs.kn * gap * gap - m.kn * m.gap * m.gap);
  change += 0.5 * (p.springs.kt * stretch * stretch - m.kt * m.stretch * m.stretch);
  m.gap0 += m.gap - gap;
  m.gap = gap;
  m.stretch = stretch;
  m.anchor = p.at.xi - stretch / p.at.length;
  m.edge_edge = static_cast<std::int32_t>(p.edge_edge);
  m.tributary = p.springs.tributary;
  m.kn = p.springs.kn;
  m.kt = p.springs.kt;
}

double ContactFinder::adopt_kinds(ContactList& list) const {
  double change = 0.0;
  for (std::size_t i = 0; i < list.points.size(); ++i) adopt_kind(list.points[i], list.memory[i], change);
  return change;
}

}  // namespace scree::coupling
