#include "coupling/transfer/construction.h"

#include <algorithm>
#include <tuple>

#include "coupling/contact/law/coulomb.h"
#include "coupling/contact/law/normal_spring.h"
#include "coupling/contact/table/contact_point.h"
#include "coupling/integrate/point_springs.h"

namespace scree::coupling {
namespace {

/// Position on the edge of the beginning, or the end, of a segment of an outline.
SupportForce spot(const Setup& from, SegmentIndex segment, bool at_end) {
  const Outlines& o = from.outlines();
  const Outlines::Edge& edge = o.edges[o.segments[segment].edge];
  const Body& b = from.body(edge.body);
  const SegmentIndex first = o.edges[from.edge_of(b.block.value, 0, 0)].first_segment;
  const Boundary::Segment& s = from.pool_of(b).boundary(b.index).segments[static_cast<std::size_t>(segment - first)];
  SupportForce out;
  out.block = b.block;
  out.ring = s.edge.ring;
  out.edge = s.edge.edge;
  out.s = at_end ? s.s1 : s.s0;
  return out;
}

/// Adds a force at a point to the replacing forces that act in full.
void stand_in(SupportForce at, const Vec2& force, std::vector<SupportForce>& forces) {
  const auto same = std::find_if(forces.begin(), forces.end(), [&](const SupportForce& f) {
    return f.block == at.block && f.ring == at.ring && f.edge == at.edge && f.s == at.s;
  });
  if (same != forces.end()) {
    same->x += force.x();
    same->y += force.y();
    return;
  }
  at.x = force.x();
  at.y = force.y();
  forces.push_back(at);
}

/// Forces of a closed contact on its corner and on the ends of its segment, without damping.
void add_contact(const Setup& from, const ContactMemory& m, const std::vector<char>& gone, const State& state,
                 std::vector<SupportForce>& forces) {
  const Outlines& o = from.outlines();
  const auto first_segment = [&](std::int32_t block, std::int32_t ring, std::int32_t edge) {
    return o.edges[from.edge_of(block, ring, edge)].first_segment;
  };
  const SegmentIndex own = first_segment(m.key.block_p, m.key.ring_p, m.key.vertex) + m.key.part,
                     segment = first_segment(m.key.block_e, m.key.ring_e, m.key.edge) + m.segment;
  const auto at = [&](OutlineNode node) { return position(o.nodes[node], state.q); };
  const Outlines::Segment& s = o.segments[segment];
  const ContactGeometry g = contact_geometry(at(o.vertices[start_of(own)].node), at(s.a), at(s.b));
  const ContactRow normal = gap_row(g), tangential = stretch_row(g, m.anchor);
  const auto force = [&](std::size_t k) -> Vec2 {
    return (m.fn - m.fd + m.water) * normal[k] + (m.ft - m.fdt) * tangential[k];
  };
  const auto free = [&](std::int32_t block) {
    return gone[static_cast<std::size_t>(block)] == 0 && !from.bodies()[static_cast<std::size_t>(block)].driven;
  };
  if (free(m.key.block_p)) stand_in(spot(from, own, false), force(0), forces);
  if (!free(m.key.block_e)) return;
  stand_in(spot(from, segment, false), force(1), forces);
  stand_in(spot(from, segment, true), force(2), forces);
}

bool leaves(const ContactMemory& m, const std::vector<char>& gone) {
  return gone[static_cast<std::size_t>(m.key.block_p)] != 0 || gone[static_cast<std::size_t>(m.key.block_e)] != 0;
}

}  // namespace

void end_contacts(const Setup& from, const std::vector<char>& gone, State& state) {
  double energy = 0.0;
  std::vector<SupportForce> forces;
  for (const ContactMemory& m : state.contacts) {
    if (!leaves(m, gone)) continue;
    if (m.status != ContactStatus::open) {
      // A point whose corner another edge carries has no normal force, and no energy of its gap (contact_energy.h).
      if (m.fn != 0.0) energy += NormalSpring{m.kn, m.bonded != 0}.energy(m.gap);
      energy += tangential_spring_energy(m.kt, m.stretch);
      add_contact(from, m, gone, state, forces);
    } else if (m.water != 0.0) {
      add_contact(from, m, gone, state, forces);
    }
  }
  std::erase_if(state.contacts.memory, [&](const ContactMemory& m) { return leaves(m, gone); });
  std::vector<SupportForce>& all = state.support.forces;
  all.insert(all.end(), forces.begin(), forces.end());
  Ledger& ledger = state.ledger;
  ledger.set(Column::contact_springs, ledger[Column::contact_springs] - energy);
  ledger.book(Column::excavated, energy);
}

void end_supports(const Setup& from, const std::vector<char>& gone, State& state) {
  const auto leaves = [&](BlockId b) { return gone[b.index()] != 0; };
  std::erase_if(state.support.forces, [&](const SupportForce& f) { return leaves(f.block); });
  double springs = 0.0, reservoir = 0.0;
  for (const PointSpring& s : point_springs(from, state))
    if (gone[s.body.index()] != 0) springs += spring_energy(s, state.q);
  for (const Remainder& r : state.rest)
    if (leaves(r.block)) reservoir += r.kinetic + r.elastic;
  std::erase_if(state.rest, [&](const Remainder& r) { return leaves(r.block); });
  // A block that is added again has the position of the case, and so do the anchors of its supports.
  const auto& supports = from.model().point_supports;
  for (std::size_t i = 0; i < supports.size() && !state.anchors.empty(); ++i)
    if (leaves(supports[i].block)) state.anchors[2 * i] = state.anchors[2 * i + 1] = 0.0;
  Ledger& ledger = state.ledger;
  ledger.set(Column::support_springs, ledger[Column::support_springs] - springs);
  ledger.set(Column::reservoir, ledger[Column::reservoir] - reservoir);
  ledger.book(Column::excavated, springs);
  ledger.book(Column::excavated, reservoir);
}

void begin_release(const Construction& construction, State& state) {
  SupportForces& support = state.support;
  const Tick now = state.stage_begin.back();
  const double r = support.remaining(now);  // of the release before
  for (SupportForce& f : support.forces) {
    f.left = f.last + (f.left - f.last) * r;
    f.last = construction.release ? std::min(f.left, 1.0 - *construction.release) : f.left;
  }
  support.begin = now;
  support.end = now + (construction.release ? construction.release_time : 0);
  std::erase_if(support.forces, [&](const SupportForce& f) {
    return f.last == 0.0 && (f.left == 0.0 || support.begin == support.end);
  });
}

}  // namespace scree::coupling
