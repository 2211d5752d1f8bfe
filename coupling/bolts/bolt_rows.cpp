#include "coupling/bolts/bolt_rows.h"

#include <algorithm>
#include <cmath>

#include "coupling/bolts/bolt_response.h"

namespace scree::coupling {
namespace {

/// True if this setup applies the forces of a bolt.
bool applies(const Setup& setup, const BoltRows& rows) {
  bool own = false, ghost = false;
  for (std::size_t k = 0; k < rows.row.size(); ++k) {
    if (setup.on_ghost(rows.row[k]))
      ghost = true;
    else if (!setup.body(rows.body[k]).driven)
      own = true;
  }
  return own && (!ghost || setup.applies(rows.row));
}

double energy_of(const State& state) {
  double sum = 0.0;
  for (const BoltMemory& m : state.bolts) sum += m.energy;
  return sum;
}

}  // namespace

BoltRows bolt_rows(const Setup& setup, const State& state, std::size_t bolt) {
  const Bolt& of = setup.model().bolts[bolt];
  BoltRows out;
  out.bolt = static_cast<std::int32_t>(bolt);
  const auto add = [&](BlockId block, const Vec2& at) {
    const auto index = block.index();
    const Body& b = setup.bodies()[index];
    // Material point: from its first place in the model to the present reference shape.
    const ReferenceShape& shape = state.bodies[index].shape;
    const AffineMotion map = affine_fit(shape.origin, shape.outline);
    out.row.push_back(setup.global(b, setup.pool_of(b).row_at(b.index, map.c + map.F * at)));
    out.body.push_back(BodyIndex::of(index));
  };
  out.liner = of.liner();
  for (const Bolt::Node& n : of.nodes) add(n.block, of.place(n));
  out.nodes = of.nodes.size();
  out.segments = out.nodes - 1;
  for (const Bolt::Crossing& c : of.crossings) {
    out.segment.push_back(c.segment);
    add(c.before, of.point(c.leaves));
    add(c.after, of.point(c.enters));
  }
  for (std::size_t c = 0; c < of.turns(); ++c) {
    const std::size_t next = of.segment_after(c);
    out.turn.push_back({{c, next}, {c, c + 1, next + 1}});
  }
  return out;
}

std::vector<BoltRows> acting_bolts(const Setup& setup, const State& state) {
  std::vector<BoltRows> out;
  for (std::size_t i = 0; i < state.bolts.size(); ++i) {
    if (state.bolts[i].installed != 1) continue;
    BoltRows rows = bolt_rows(setup, state, i);
    if (applies(setup, rows)) out.push_back(std::move(rows));
  }
  return out;
}

void BoltShape::measure(const BoltRows& rows, std::span<const double> q) {
  length_.resize(rows.segments);
  along_.resize(rows.segments);
  shear_.resize(rows.crossings());
  turn_.resize(rows.crossings());
  across_.resize(rows.crossings());
  for (std::size_t s = 0; s < rows.segments; ++s) {
    const Vec2 d = position(rows.row[s + 1], q) - position(rows.row[s], q);
    length_[s] = d.norm();
    along_[s] = length_[s] > 0.0 ? Vec2(d / length_[s]) : Vec2(0.0, 0.0);
  }
  const auto gap = [&](std::size_t c) {
    return Vec2(position(rows.row[rows.leaves(c) + 1], q) - position(rows.row[rows.leaves(c)], q));
  };
  for (std::size_t c = 0; c < rows.turn.size(); ++c) {
    const Vec2 &a = along_[rows.turn[c].segment[0]], &b = along_[rows.turn[c].segment[1]];
    shear_[c] = std::atan2(cross(a, b), a.dot(b));
  }
  for (std::size_t c = 0; c < rows.segment.size(); ++c) {
    const auto s = static_cast<std::size_t>(rows.segment[c]);
    Vec2 inside = position(rows.row[s + 1], q) - position(rows.row[s], q);
    for (std::size_t other = 0; other < rows.segment.size(); ++other)
      if (rows.segment[other] == rows.segment[c]) inside -= gap(other);
    const double size = inside.norm();
    const Vec2 t = size > 0.0 ? Vec2(inside / size) : along_[s], D = gap(c);
    across_[c] = Vec2(-t.y(), t.x());
    shear_[c] = across_[c].dot(D);
    turn_[c] = size > 0.0 ? -D.dot(t) / size : 0.0;
  }
}

void BoltShape::push(const BoltRows& rows, const BoltMemory& memory, std::span<Vec2> force) const {
  std::fill(force.begin(), force.end(), Vec2(0.0, 0.0));
  for (std::size_t s = 0; s < rows.segments; ++s) {
    force[s] += memory.force[s] * along_[s];
    force[s + 1] -= memory.force[s] * along_[s];
  }
  for (std::size_t c = 0; c < rows.crossings(); ++c) {
    const double Q = memory.shear[c];
    if (Q != 0.0) shear_form(rows, c, [&](std::size_t row, const Vec2& form) { force[row] -= Q * form; });
  }
}

void add_bolt_forces(const Setup& setup, const State& state, std::span<double> f) {
  BoltShape shape;
  std::vector<Vec2> force;
  for (const BoltRows& rows : acting_bolts(setup, state)) {
    shape.measure(rows, state.q);
    force.resize(rows.row.size());
    shape.push(rows, state.bolts[static_cast<std::size_t>(rows.bolt)], force);
    for (std::size_t k = 0; k < force.size(); ++k) add_force(rows.row[k], force[k], f);
  }
}

void install_bolts(const Setup& setup, State& state) {
  const std::vector<Bolt>& bolts = setup.model().bolts;
  state.bolts.resize(bolts.size());
  BoltShape shape;
  for (std::size_t i = 0; i < bolts.size(); ++i) {
    BoltMemory& memory = state.bolts[i];
    if (memory.installed != 0 || (bolts[i].stage.valid() && bolts[i].stage.value > state.stage)) continue;
    shape.measure(bolt_rows(setup, state, i), state.q);
    BoltResponse(bolts[i]).install(shape.lengths(), shape.shears(), memory);
    state.ledger.book(Column::bolt_tension, memory.energy + memory.dissipated);
    state.ledger.book(Column::bolt_yield, memory.dissipated);
  }
  if (!bolts.empty()) state.ledger.set(Column::bolts, energy_of(state));
}

void settle_broken_bolts(const Setup& setup, State& state) {
  BoltShape shape;
  for (std::size_t i = 0; i < state.bolts.size(); ++i) {
    BoltMemory& memory = state.bolts[i];
    if (memory.installed != 1 || memory.breaking == 0.0) continue;
    const BoltMemory before = memory;
    shape.measure(bolt_rows(setup, state, i), state.q);
    (void)BoltResponse(setup.model().bolts[i]).solve(before, shape.lengths(), shape.shears(), memory);
    const double lost = memory.dissipated - before.dissipated;
    state.ledger.book(Column::bolt_yield, lost);
    state.ledger.book(Column::bolts_broken, before.energy - memory.energy - lost);
  }
  if (!state.bolts.empty()) state.ledger.set(Column::bolts, energy_of(state));
}

void keep_bolt_forces(const std::vector<BoltRows>& before, std::span<const double> q_before, const Setup& to,
                      State& state) {
  BoltShape was, is;
  for (const BoltRows& old : before) {
    const auto i = static_cast<std::size_t>(old.bolt);
    BoltMemory& memory = state.bolts[i];
    was.measure(old, q_before);
    is.measure(bolt_rows(to, state, i), state.q);
    for (std::size_t s = 0; s < memory.rest.size(); ++s) memory.rest[s] += is.lengths()[s] - was.lengths()[s];
    for (std::size_t c = 0; c < memory.offset.size(); ++c) memory.offset[c] += is.shears()[c] - was.shears()[c];
  }
}

}  // namespace scree::coupling
