#include "coupling/integrate/bolt_forces.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {

BoltForces::BoltForces(const Setup& setup, std::vector<BoltRows> rows) {
  for (BoltRows& r : rows) {
    const Bolt& bolt = setup.model().bolts[static_cast<std::size_t>(r.bolt)];
    const std::size_t count = r.row.size();
    bolts_.push_back({std::move(r), {}, BoltResponse(bolt), {}, {}, std::vector<Vec2>(count)});
  }
}

void BoltForces::take(const State& state) {
  for (One& one : bolts_) one.now = one.trial = state.bolts[static_cast<std::size_t>(one.rows.bolt)];
  time_ = seconds(state.time);
}

void BoltForces::keep(State& state) const {
  for (const One& one : bolts_) state.bolts[static_cast<std::size_t>(one.rows.bolt)] = one.now;
}

void BoltForces::add(const Instant& at, std::span<double> f) {
  on_trial_ = at.t != time_;
  trial_time_ = at.t;
  for (One& one : bolts_) {
    one.shape.measure(one.rows, at.q);
    if (on_trial_) {
      const bool found = one.response.solve(one.now, one.shape.lengths(), one.shape.shears(), one.trial);
      if (!found) one.trial.force[0] = std::numeric_limits<double>::quiet_NaN();  // the step ends as lost
    }
    one.shape.push(one.rows, on_trial_ ? one.trial : one.now, one.force);
    for (std::size_t k = 0; k < one.force.size(); ++k) add_force(one.rows.row[k], one.force[k], f);
  }
}

double BoltForces::half_work(double h, std::span<const double> v) const {
  double power = 0.0;
  for (const One& one : bolts_)
    for (std::size_t k = 0; k < one.force.size(); ++k) power += one.force[k].dot(position(one.rows.row[k], v));
  return 0.5 * h * power;
}

void BoltForces::find_broken(One& one) {
  if (!one.response.rupture(one.now)) return;
  BoltMemory& left = one.trial;  // the bolt after rupture, at the same lengths
  (void)one.response.solve(one.now, one.shape.lengths(), one.shape.shears(), left);
  one.now.breaking = one.now.energy - left.energy - (left.dissipated - one.now.dissipated);
}

void BoltForces::arrive(double h, std::span<const double> v, Ledger& ledger) {
  double energy = 0.0, before = 0.0, lost = 0.0, broken = 0.0;
  for (One& one : bolts_) {
    before += one.now.energy;
    energy += one.trial.energy;
    lost += one.trial.dissipated - one.now.dissipated;
    broken += one.now.breaking;
    std::swap(one.now, one.trial);
  }
  time_ = trial_time_;
  ledger.set(Column::bolts, ledger[Column::bolts] + (energy - before));
  ledger.book(Column::bolt_yield, lost);
  if (broken != 0.0) ledger.book(Column::bolts_broken, broken);
  ledger.book(Column::bolt_trapezoid, energy - before + lost + broken + work_ + half_work(h, v));
  for (One& one : bolts_) find_broken(one);
}

namespace {

/// Springs of a liner: its segments, and for every turn k (c.dx)^2, with rows scaled by the length of c.
void add_liner_springs(const Bolt& liner, const BoltRows& rows, std::span<const double> q,
                       std::vector<BoltSpring>& out) {
  BoltShape shape;
  shape.measure(rows, q);
  const auto add = [&](BoltSpring& to, std::size_t row, double scale) {
    Row scaled = rows.row[row];
    for (double& w : scaled.w) w *= scale;
    to.rows.push_back(scaled);
    to.body.push_back(rows.body[row]);
  };
  for (std::size_t s = 0; s < rows.segments; ++s) {
    BoltSpring& bar = out.emplace_back();
    add(bar, s, 1.0);
    add(bar, s + 1, 1.0);
    bar.k = liner.segment_stiffness(s);
  }
  for (std::size_t c = 0; c < rows.turn.size() && liner.bending > 0.0; ++c) {
    BoltSpring& turn = out.emplace_back();
    turn.k = liner.turn_stiffness(c);
    shape.shear_form(rows, c, [&](std::size_t row, const Vec2& form) { add(turn, row, form.norm()); });
  }
}

}  // namespace

std::vector<BoltSpring> bolt_springs(const Setup& setup, const State& state) {
  std::vector<BoltSpring> out;
  const auto mobility = [&](const BoltRows& rows, std::size_t k) {
    const Body& b = setup.body(rows.body[k]);
    return b.driven || setup.on_ghost(rows.row[k]) ? 0.0
                                                   : setup.pool_of(b).compliance(b.index, setup.local(b, rows.row[k]));
  };
  for (const BoltRows& rows : acting_bolts(setup, state)) {
    const Bolt& bolt = setup.model().bolts[static_cast<std::size_t>(rows.bolt)];
    if (bolt.liner()) {
      add_liner_springs(bolt, rows, state.q, out);
      continue;
    }
    const auto add = [&](const std::vector<std::size_t>& which, double k) {
      BoltSpring s;
      for (const std::size_t r : which) {
        s.rows.push_back(rows.row[r]);
        s.body.push_back(rows.body[r]);
      }
      s.k = k;
      out.push_back(std::move(s));
    };
    // Bond: the bar is fixed, rock moves relative to it; the plate moves relative to a fixed bar.
    double of_bond = 0.0, of_bar = 0.0;
    for (std::size_t i = 0; i < rows.nodes; ++i) {
      const double length = bolt.nodes[i].length;
      const double k = length > 0.0 ? bolt.bond_stiffness * length
                                    : (rows.segments > 1 ? bolt.segment_stiffness(i == 0 ? 0 : i - 1)
                                                         : std::numeric_limits<double>::infinity());
      of_bond += k * mobility(rows, i);
    }
    for (std::size_t s = 0; s < rows.segments; ++s)
      of_bar += bolt.segment_stiffness(s) * (mobility(rows, s) + mobility(rows, s + 1));
    const bool by_bond = of_bond < of_bar;
    for (std::size_t i = 0; by_bond && i < rows.nodes; ++i)
      add({i}, bolt.nodes[i].length > 0.0 ? bolt.bond_stiffness * bolt.nodes[i].length
                                          : bolt.segment_stiffness(i == 0 ? 0 : i - 1));
    for (std::size_t s = 0; s < rows.segments; ++s) {
      // The tension adds a stiffness across the bar: N/l, EA/l times the strain at yield.
      constexpr double kMostStrain = 0.01;
      const double strain = std::min(kMostStrain, bolt.yield / bolt.stiffness), k = bolt.segment_stiffness(s);
      add({s, s + 1}, by_bond ? strain * k : k);
    }
    if (bolt.shear_stiffness > 0.0)
      for (std::size_t c = 0; c < rows.crossings(); ++c)
        add({rows.leaves(c), rows.leaves(c) + 1}, bolt.shear_stiffness);
  }
  return out;
}

}  // namespace scree::coupling
