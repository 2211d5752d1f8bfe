#include "coupling/integrate/implicit_bolts.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/dense_algebra.h"

namespace scree::coupling {

void ImplicitBolts::enter(const State& state) {
  bolts_.clear();
  for (BoltRows& rows : acting_bolts(*setup_, state)) {
    const auto i = static_cast<std::size_t>(rows.bolt);
    bolts_.emplace_back(std::move(rows), BoltResponse(setup_->model().bolts[i]));
    One& one = bolts_.back();
    one.before = state.bolts[i];
    one.lengths.resize(one.rows.segments);
    one.shears.resize(one.rows.crossings());
  }
}

void ImplicitBolts::add_point(const One& one, std::size_t row, const Vec2& c, std::span<const Vec2> driven_move,
                              DofRows& out) const {
  const auto body = one.rows.body[row].index();
  if (setup_->bodies()[body].driven)
    out.add_known(c.dot(driven_move[body]));
  else
    ImplicitSystem::add_point(charts_[row], c, out);
}

void ImplicitBolts::begin(const State& state, std::span<const Vec2> driven_move, StepSprings& springs) {
  rows_.clear();
  for (One& one : bolts_) {
    const BoltRows& rows = one.rows;
    one.before = one.after = state.bolts[static_cast<std::size_t>(rows.bolt)];
    one.shape.measure(rows, state.q);
    charts_.assign(rows.row.size(), {});
    for (std::size_t k = 0; k < rows.row.size(); ++k)
      if (!setup_->body(rows.body[k]).driven) charts_[k] = system_->chart(rows.body[k], rows.row[k], state.q);
    one.first_row = rows_.size();
    for (std::size_t s = 0; s < rows.segments; ++s) {
      rows_.begin_row();
      add_point(one, s, -one.shape.direction(s), driven_move, rows_);
      add_point(one, s + 1, one.shape.direction(s), driven_move, rows_);
    }
    for (std::size_t c = 0; c < rows.crossings(); ++c) {
      rows_.begin_row();
      one.shape.shear_form(rows, c,
                           [&](std::size_t row, const Vec2& form) { add_point(one, row, form, driven_move, rows_); });
    }
    one.first_spring = springs.size();
    const auto spring = [&](double k) {
      springs.rows.begin_row();
      springs.k.push_back(k);
      springs.at.push_back(0.0);
    };
    for (std::size_t m = 0; m < rows.segments; ++m) {
      spring(0.0);
      combine(one, m, springs.rows);
    }
    for (std::size_t c = 0; c < rows.crossings(); ++c) {
      springs.rows.add_row(rows_[one.first_row + rows.segments + c]);
      springs.k.push_back(0.0);
      springs.at.push_back(0.0);
    }
    for (std::size_t s = 0; s < rows.segments; ++s) {
      spring(std::max(0.0, one.before.force[s]) / one.shape.lengths()[s]);
      const Vec2 across = quarter_turn() * one.shape.direction(s);
      add_point(one, s, -across, driven_move, springs.rows);
      add_point(one, s + 1, across, driven_move, springs.rows);
    }
  }
}

void ImplicitBolts::combine(const One& one, std::size_t m, DofRows& out) const {
  for (std::size_t s = 0; s < one.rows.segments; ++s) {
    if (one.rows.liner && s != m) continue;
    const DofRow row = rows_[one.first_row + s];
    const double part = one.rows.liner || one.vectors.size() == 0
                            ? 1.0
                            : one.vectors(static_cast<Eigen::Index>(s), static_cast<Eigen::Index>(m));
    out.add_known(part * row.known);
    for (std::size_t k = 0; k < row.dof.size(); ++k) out.add(row.dof[k], part * row.h[k]);
  }
}

bool ImplicitBolts::evaluate(std::span<const double> d) {
  bool found = true;
  for (One& one : bolts_) {
    const BoltRows& rows = one.rows;
    for (std::size_t s = 0; s < rows.segments; ++s)
      one.lengths[s] = one.shape.lengths()[s] + rows_[one.first_row + s].change(d);
    for (std::size_t c = 0; c < rows.crossings(); ++c)
      one.shears[c] = one.shape.shears()[c] + rows_[one.first_row + rows.segments + c].change(d);
    found = one.response.solve(one.before, one.lengths, one.shears, one.after) && found;
  }
  return found;
}

bool ImplicitBolts::linearise(StepSprings& springs) {
  bool changed = false;
  for (One& one : bolts_) {
    const BoltRows& rows = one.rows;
    if (one.response.tangent_changed(one.slopes, one.after)) {
      Eigen::MatrixXd tangent;
      one.response.tangent(one.after, tangent);
      if (rows.liner) {  // no slip couples its segments
        one.values = tangent.diagonal();
      } else {
        Modes parts = symmetric_modes(tangent);
        one.values = parts.values.cwiseMax(0.0);
        one.vectors = std::move(parts.vectors);
      }
    }
    for (std::size_t m = 0; m < rows.segments; ++m) {
      const double k = one.values(static_cast<Eigen::Index>(m));
      scratch_.clear();
      scratch_.begin_row();
      combine(one, m, scratch_);
      const DofRow now = scratch_[0], then = springs.rows[one.first_spring + m];
      const bool same = k == springs.k[one.first_spring + m] && std::equal(now.h.begin(), now.h.end(), then.h.begin());
      if (same) continue;
      changed = true;
      springs.k[one.first_spring + m] = k;
      springs.rows.take_row(one.first_spring + m, now);
    }
    for (std::size_t c = 0; c < rows.crossings(); ++c) {
      double& k = springs.k[one.first_spring + rows.segments + c];
      const double now = one.response.shear_tangent(c);
      changed = changed || k != now;
      k = now;
    }
  }
  return changed;
}

double ImplicitBolts::add(std::span<const double> d, const StepSprings& springs, std::span<double> out) const {
  double largest = 0.0;
  const auto push = [&](const DofRow& row, double force) {
    largest = std::max(largest, std::abs(force));
    if (force != 0.0) row.add_force(force, out);
  };
  for (const One& one : bolts_) {
    const BoltRows& rows = one.rows;
    for (std::size_t s = 0; s < rows.segments; ++s) push(rows_[one.first_row + s], -one.after.force[s]);
    for (std::size_t c = 0; c < rows.crossings(); ++c)
      push(rows_[one.first_row + rows.segments + c], -one.after.shear[c]);
    for (std::size_t k = one.first_spring; k < one.first_spring + rows.segments + rows.crossings(); ++k)
      if (const double force = springs.force(k, d); force != 0.0) springs.rows[k].add_force(-force, out);
  }
  return largest;
}

double ImplicitBolts::book(std::span<const double> d, const StepSprings& springs, Ledger& ledger) {
  double linear = 0.0;
  for (const One& one : bolts_) {
    const BoltRows& rows = one.rows;
    double driven = 0.0, damped = one.response.elastic_change(one.before, one.after);
    for (std::size_t s = 0; s < rows.segments; ++s) driven += one.after.force[s] * rows_[one.first_row + s].known;
    for (std::size_t c = 0; c < rows.crossings(); ++c)
      driven += one.after.shear[c] * rows_[one.first_row + rows.segments + c].known;
    for (std::size_t s = 0; s < rows.segments; ++s) {
      const std::size_t i = one.first_spring + rows.segments + rows.crossings() + s;
      const DofRow row = springs.rows[i];
      const double u = row.change(d), half = 0.5 * springs.k[i] * u * u;
      damped += half;
      linear += half;
      driven += springs.k[i] * u * row.known;
    }
    ledger.book(Column::newmark_damping, damped);
    ledger.book(Column::prescribed_motion, driven);
    linear += one.after.energy + one.after.dissipated - one.before.dissipated;
  }
  return linear;
}

void ImplicitBolts::accept(State& state, double linear) {
  double exact = 0.0, energy = 0.0, before = 0.0;
  Ledger& ledger = state.ledger;
  for (One& one : bolts_) {
    BoltMemory& now = state.bolts[static_cast<std::size_t>(one.rows.bolt)];
    one.shape.measure(one.rows, state.q);
    (void)one.response.solve(one.before, one.shape.lengths(), one.shape.shears(), one.after);
    const double lost = one.after.dissipated - one.before.dissipated;
    ledger.book(Column::bolt_yield, lost);
    exact += one.after.energy + lost;
    before += one.before.energy;
    if (one.response.rupture(one.after)) {
      (void)one.response.solve(one.after, one.shape.lengths(), one.shape.shears(), now);
      const double more = now.dissipated - one.after.dissipated;
      ledger.book(Column::bolt_yield, more);
      ledger.book(Column::bolts_broken, one.after.energy - now.energy - more);
    } else {
      now = one.after;
    }
    energy += now.energy;
  }
  ledger.book(Column::update_contact, exact - linear);
  ledger.set(Column::bolts, ledger[Column::bolts] + (energy - before));
}

}  // namespace scree::coupling
