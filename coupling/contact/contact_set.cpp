#include "coupling/contact/contact_set.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {
namespace {

/// Plane modulus K + 4G/3 of the softer block [Pa]: times unit thickness, the guideline's scale (thesis eq. 7.56).
double softer_modulus(const Model& model, BlockId a, BlockId b) {
  const auto modulus = [&](BlockId id) {
    const Material& m = model.material_of(id);
    return m.young * (1.0 - m.poisson) / ((1.0 + m.poisson) * (1.0 - 2.0 * m.poisson));
  };
  return std::min(modulus(a), modulus(b));
}

/// Distance from a point to the segment, and the fraction nearest to it.
double distance_to(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  const double s = std::clamp((p - a).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (p - a - s * d).norm();
}

constexpr double kWedgeTolerance = 0.17;  // sine of 10 degrees: how far a corner's sides may lean into the edge

}  // namespace

double normal_stiffness(const Model& model, const JointLaw& law, BlockId a, BlockId b) {
  return law.penalty ? *law.penalty : softer_modulus(model, a, b);
}

double tangential_stiffness(const Model& model, const JointLaw& law, BlockId a, BlockId b) {
  return law.shear_penalty ? *law.shear_penalty : normal_stiffness(model, law, a, b);
}

double friction_limit(const JointLaw& law, const ContactMemory& memory, double fn) {
  const double cohesion = memory.failed != 0 ? 0.0 : law.cohesion * law.contact_length;
  return cohesion + fn * std::tan(law.friction);
}

ContactFinder::ContactFinder(const Setup& setup, double detection)
    : setup_(&setup),
      detection_(detection),
      touching_(1e-3 * detection),
      search_(setup, 2.0 * detection),
      x_(setup.outlines().nodes.size()) {}

void ContactFinder::set_range(ContactPoint& p, bool closed) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& edge = o.edges[static_cast<std::size_t>(p.edge)];
  const std::int32_t part = o.segments[static_cast<std::size_t>(p.segment)].part;
  // Beyond a re-entrant corner the solid goes on; beyond a convex one there is nothing, but a closed contact is kept a
  // little further, so that corners which meet exactly do not lose and find each other.
  const auto beyond = [&](bool convex) {
    return !convex ? detection_ : (closed ? 0.25 * detection_ : 1e-9 * p.at.length);
  };
  p.s_low = part == 0 ? -beyond(edge.convex_start) : -detection_;
  p.s_high = p.at.length + (part == edge.segments - 1 ? beyond(edge.convex_end) : detection_);
}

bool ContactFinder::admissible(const ContactPoint& p) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Corner& c = o.corners[static_cast<std::size_t>(p.corner)];
  const Vec2& at = x_[static_cast<std::size_t>(c.node)];
  const Vec2 forward =
      (x_[static_cast<std::size_t>(o.segments[static_cast<std::size_t>(c.segment_out)].b)] - at).normalized();
  const Vec2 backward =
      (x_[static_cast<std::size_t>(o.segments[static_cast<std::size_t>(c.segment_in)].a)] - at).normalized();
  return p.at.n.dot(forward) >= -kWedgeTolerance && p.at.n.dot(backward) >= -kWedgeTolerance;
}

std::int32_t ContactFinder::law_of(const ContactPoint& p) const {
  const Outlines& o = setup_->outlines();
  const Outlines::Edge& edge = o.edges[static_cast<std::size_t>(p.edge)];
  if (edge.joint.valid()) return edge.joint.value;
  // Else the law of the corner's own edge that faces this one.
  const Outlines::Corner& c = o.corners[static_cast<std::size_t>(p.corner)];
  const auto direction = [&](std::int32_t s) {
    const Outlines::Segment& segment = o.segments[static_cast<std::size_t>(s)];
    return (x_[static_cast<std::size_t>(segment.b)] - x_[static_cast<std::size_t>(segment.a)]).normalized();
  };
  const bool out_faces = direction(c.segment_out).dot(p.at.t) < direction(c.segment_in).dot(p.at.t);
  const JointId own = o.edges[static_cast<std::size_t>(out_faces ? c.edge_out : c.edge_in)].joint;
  return own.valid() ? own.value : setup_->model().default_joint.value;
}

void ContactFinder::set_damping(const ContactPoint& p, ContactMemory& m) const {
  const Outlines& o = setup_->outlines();
  const auto compliance = [&](std::int32_t node) {
    const Body& b = setup_->bodies()[static_cast<std::size_t>(o.node_body[static_cast<std::size_t>(node)])];
    return b.driven ? 0.0
                    : setup_->pool_of(b).compliance(b.index, setup_->local(b, o.nodes[static_cast<std::size_t>(node)]));
  };
  const double mu = compliance(p.node[0]) + std::max(compliance(p.node[1]), compliance(p.node[2]));
  const double fraction = setup_->model().joints[static_cast<std::size_t>(m.joint)].damping;
  m.cn = 2.0 * fraction * std::sqrt(m.kn / mu);
  m.ct = 2.0 * fraction * std::sqrt(m.kt / mu);
}

void ContactFinder::pair_edges(ContactList& list) const {
  const Outlines& o = setup_->outlines();
  for (std::size_t i = 0; i < list.points.size(); ++i)
    for (std::size_t j = i + 1; j < list.points.size() && list.points[j].corner == list.points[i].corner; ++j) {
      const Outlines::Edge &a = o.edges[static_cast<std::size_t>(list.points[i].edge)],
                           &b = o.edges[static_cast<std::size_t>(list.points[j].edge)];
      if (a.body != b.body || a.ring != b.ring) continue;
      const bool follows = a.edge + 1 == b.edge && a.convex_end;
      const bool closes_ring = a.edge == 0 && b.edge > 1 && a.convex_start && b.convex_end;
      if (!follows && !closes_ring) continue;
      for (const auto& [of, other] : {std::pair(i, j), std::pair(j, i)}) {
        std::int32_t(&partner)[2] = list.points[of].partner;
        partner[partner[0] < 0 ? 0 : 1] = static_cast<std::int32_t>(other);
      }
    }
}

void ContactFinder::suppress_second_edges(ContactList& list) const {
  // A corner inside another body near one of that body's convex corners penetrates both edges; it leaves by the nearer
  // one (shortest path, thesis 2.4.3), and the choice is kept until the other is clearly nearer.
  for (std::size_t i = 0; i < list.points.size(); ++i)
    for (const std::int32_t other : list.points[i].partner) {
      if (other <= static_cast<std::int32_t>(i)) continue;
      const auto j = static_cast<std::size_t>(other);
      const ContactMemory &ma = list.memory[i], &mb = list.memory[j];
      if (ma.gap >= 0.0 || mb.gap >= 0.0 || list.points[i].beyond || list.points[j].beyond) continue;
      const double keep_a = ma.status != ContactStatus::open ? 0.5 : 1.0,
                   keep_b = mb.status != ContactStatus::open ? 0.5 : 1.0;
      const bool a_wins = -ma.gap * keep_a <= -mb.gap * keep_b;
      list.points[a_wins ? j : i].suppressed = true;
    }
}

void ContactFinder::find(std::span<const double> q, std::span<const ContactMemory> known, bool at_start,
                         ContactList& out) {
  const Outlines& o = setup_->outlines();
  for (std::size_t i = 0; i < x_.size(); ++i) x_[i] = position(o.nodes[i], q);
  const std::span<const Candidate> candidates = search_.update(x_);
  out.points.clear();
  out.memory.clear();
  auto old = known.begin();
  for (std::size_t i = 0; i < candidates.size();) {
    // The nearest segment of one edge.
    std::size_t next = i, best = i;
    double nearest = 0.0;
    const Outlines::Corner& corner = o.corners[static_cast<std::size_t>(candidates[i].corner)];
    const Vec2& xP = x_[static_cast<std::size_t>(corner.node)];
    for (; next < candidates.size() && candidates[next].corner == candidates[i].corner &&
           candidates[next].edge == candidates[i].edge;
         ++next) {
      const Outlines::Segment& s = o.segments[static_cast<std::size_t>(candidates[next].segment)];
      const double d = distance_to(xP, x_[static_cast<std::size_t>(s.a)], x_[static_cast<std::size_t>(s.b)]);
      if (next == i || d < nearest) {
        nearest = d;
        best = next;
      }
    }
    const Candidate& c = candidates[best];
    i = next;
    if (nearest > 2.0 * detection_) continue;
    const Outlines::Segment& s = o.segments[static_cast<std::size_t>(c.segment)];
    const Outlines::Edge& edge = o.edges[static_cast<std::size_t>(c.edge)];
    ContactPoint p;
    p.corner = c.corner;
    p.edge = c.edge;
    p.segment = c.segment;
    p.node = {corner.node, s.a, s.b};
    p.key = {setup_->bodies()[static_cast<std::size_t>(corner.body)].block.value, corner.ring, corner.vertex,
             setup_->bodies()[static_cast<std::size_t>(edge.body)].block.value,   edge.ring,   edge.edge};
    p.at = contact_geometry(xP, x_[static_cast<std::size_t>(s.a)], x_[static_cast<std::size_t>(s.b)]);
    while (old != known.end() && old->key < p.key) ++old;
    const bool remembered = old != known.end() && old->key == p.key;
    const bool closed = remembered && old->status != ContactStatus::open;
    set_range(p, closed);
    const double foot = p.at.xi * p.at.length;
    p.beyond = foot < p.s_low || foot > p.s_high;
    if (p.beyond && closed) continue;
    if (!closed && (nearest > detection_ || !admissible(p))) continue;

    ContactMemory m;
    if (remembered) {
      m = *old;
    } else {
      m.key = p.key;
      m.joint = law_of(p);
      const JointLaw& law = setup_->model().joints[static_cast<std::size_t>(m.joint)];
      m.kn = normal_stiffness(setup_->model(), law, BlockId{p.key.block_p}, BlockId{p.key.block_e});
      m.kt = tangential_stiffness(setup_->model(), law, BlockId{p.key.block_p}, BlockId{p.key.block_e});
      set_damping(p, m);
      if (at_start && std::abs(p.at.gap) <= touching_) m.gap0 = p.at.gap;
    }
    if (m.segment < 0) set_damping(p, m);  // a body changed its method, and with it the mass behind the contact
    m.gap = p.at.gap - m.gap0;
    if (!closed) {
      m.segment = s.part;
      m.anchor = p.at.xi;
      m.stretch = 0.0;
    } else if (m.segment < 0) {  // the edge was divided anew: the stretch is what carries over
      m.segment = s.part;
      m.anchor = p.at.xi - m.stretch / p.at.length;
    } else if (m.segment != s.part) {
      // The stretch as the old segment sees it now, then the same stretch on the new one.
      const Outlines::Segment& before = o.segments[static_cast<std::size_t>(edge.first_segment + m.segment)];
      const ContactGeometry g =
          contact_geometry(xP, x_[static_cast<std::size_t>(before.a)], x_[static_cast<std::size_t>(before.b)]);
      m.segment = s.part;
      m.anchor = p.at.xi - (g.xi - m.anchor) * g.length / p.at.length;
    }
    // Always from the anchor, so that finding twice at one place gives the same bits.
    if (closed) m.stretch = (p.at.xi - m.anchor) * p.at.length;
    out.points.push_back(p);
    out.memory.push_back(m);
  }
  pair_edges(out);
  suppress_second_edges(out);
}

}  // namespace scree::coupling
