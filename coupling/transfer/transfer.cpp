#include "coupling/transfer/transfer.h"

#include <algorithm>
#include <cmath>

#include "coupling/transfer/contact_forces.h"
#include "model/elasticity.h"

namespace scree::coupling {
namespace {

BodyTotals totals_of(const Setup& setup, std::size_t body, const State& state) {
  const Body& b = setup.bodies()[body];
  const auto p = static_cast<std::size_t>(b.pool);
  return setup.pool_of(b).totals(b.index, setup.part(std::span<const double>(state.q), p),
                                 setup.part(std::span<const double>(state.v), p));
}

/// Errors against natural scales: momentum m sqrt(2T/m), angular momentum about the centre sqrt(2 T tr S).
void measure(TransferRow& row, double inertia) {
  const BodyTotals &a = row.before, &b = row.after;
  const auto relative = [](double error, double scale) { return scale > 0.0 ? std::abs(error) / scale : 0.0; };
  row.mass_error = relative(b.mass - a.mass, a.mass);
  row.momentum_error = relative((b.momentum - a.momentum).norm(), std::sqrt(2.0 * a.mass * a.kinetic));
  const double spin_a = a.angular_momentum - cross(a.centre, a.momentum),
               spin_b = b.angular_momentum - cross(b.centre, b.momentum);
  row.angular_error = relative(spin_b - spin_a, std::sqrt(2.0 * inertia * a.kinetic));
  row.energy_error = relative(
      b.kinetic + b.elastic + row.reservoir_kinetic + row.reservoir_elastic + row.booked - a.kinetic - a.elastic,
      a.kinetic + a.elastic);
}

}  // namespace

std::vector<Wish> wishes(const Model& model, const Stage& stage) {
  Formulation form;
  form.kinematics = stage.kinematics;
  form.mass =
      stage.mass.value_or(stage.integrator == Integrator::implicit ? MassKind::consistent : MassKind::affine_exact);
  form.cover_size = stage.cover_size;
  form.cracks = stage.cracks;
  std::vector<Wish> out(model.blocks.size(), Wish{stage.method, form});
  for (std::size_t i = 0; i < out.size(); ++i)
    if (model.blocks[i].cover_size > 0.0) out[i].form.cover_size = model.blocks[i].cover_size;
  for (const MethodRule& rule : stage.rules)
    for (BlockId b : rule.blocks) {
      Wish& w = out[b.index()];
      w.method = rule.method;
      w.form.onefold = rule.onefold;
      if (rule.cover_size > 0.0) w.form.cover_size = rule.cover_size;
    }
  for (Wish& w : out)
    if (w.method != "nmm") w.form = Formulation{};
  return out;
}

std::vector<BodyRecord> initial_records(const Model& model, const std::vector<Wish>& wish) {
  std::vector<BodyRecord> records;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const BlockId block{static_cast<std::int32_t>(i)};
    records.push_back({block, wish[i].method, reference_shape(model, block), wish[i].form});
  }
  return records;
}

HandOver hand_over(const Model& model, const Methods& methods, const Setup& from, const std::vector<Wish>& wish,
                   State& state) {
  HandOver out;
  const std::size_t count = state.bodies.size();
  std::vector<char> changed(count, 0), reformed(count, 0);
  std::vector<BodyTotals> before(count);  // of bodies that keep their unknowns and change their operators
  std::vector<Release> released(count);
  for (std::size_t i = 0; i < count; ++i) {
    BodyRecord& record = state.bodies[i];
    if (record.method == wish[i].method && record.form.same_mesh(wish[i].form)) {
      if (record.form == wish[i].form) continue;
      reformed[i] = 1;
      before[i] = totals_of(from, i, state);
      record.form = wish[i].form;  // the same unknowns with other operators
      continue;
    }
    changed[i] = 1;
    const Body& b = from.bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool);
    if (b.driven) {
      released[i].shape = reference_shape(model, record.block);  // it never deforms
    } else {
      released[i] = from.pool_of(b).release(b.index, from.part(std::span<const double>(state.q), p),
                                            from.part(std::span<const double>(state.v), p));
      TransferRow row;
      row.time = seconds(state.time);
      row.block = record.block;
      row.from = record.method;
      row.to = wish[i].method;
      row.before = totals_of(from, i, state);
      row.reservoir_kinetic = released[i].kinetic_rest;
      row.reservoir_elastic = released[i].elastic_rest;
      row.booked = released[i].elastic_cross;
      out.rows.push_back(row);
    }
    record = {record.block, wish[i].method, released[i].shape, wish[i].form};
    if (!b.driven) {
      // The outline that the block has become fits its first one but for what bent it, and its in-situ stress is
      // read there: what that changes does work on the strain.
      const Mat2& F = released[i].motion.F;
      const Mat2 U = polar_rotation(F).transpose() * F, strain = 0.5 * (U + U.transpose()) - Mat2::Identity(),
                 change = InSituStress(model, record).mean() - released[i].initial;
      out.rows.back().booked -= released[i].shape.area * change.cwiseProduct(strain).sum();
    }
  }

  hand_contacts_over(from, changed, state);
  out.setup = std::make_unique<Setup>(model, methods, state.bodies);
  const Setup& to = *out.setup;
  std::vector<double> q(2 * static_cast<std::size_t>(to.nodes()), 0.0), v = q;
  for (std::size_t i = 0; i < count; ++i) {
    const Body &a = from.bodies()[i], &b = to.bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool);
    if (changed[i] != 0) {
      to.pool_of(b).place(b.index, released[i].motion, to.part(std::span<double>(q), p),
                          to.part(std::span<double>(v), p));
    } else {
      const auto begin = 2 * static_cast<std::ptrdiff_t>(a.first_node),
                 end = begin + 2 * static_cast<std::ptrdiff_t>(a.nodes);
      std::copy(state.q.begin() + begin, state.q.begin() + end,
                q.begin() + 2 * static_cast<std::ptrdiff_t>(b.first_node));
      std::copy(state.v.begin() + begin, state.v.begin() + end,
                v.begin() + 2 * static_cast<std::ptrdiff_t>(b.first_node));
    }
  }
  to.prescribe(seconds(state.time), q, v);
  state.q = std::move(q);
  state.v = std::move(v);
  state.a.clear();
  state.v_before.clear();
  state.damping.clear();

  // Books: each body's energies after, measured anew by its new method; reservoir and cross terms beside them.
  Ledger& ledger = state.ledger;
  std::size_t next = 0;
  double kinetic = ledger[Column::kinetic], elastic = ledger[Column::elastic], reservoir = ledger[Column::reservoir];
  for (std::size_t i = 0; i < count; ++i) {
    if (to.bodies()[i].driven) continue;
    if (reformed[i] != 0) {  // another mass, another measure of strain: what the same motion now holds
      const BodyTotals after = totals_of(to, i, state);
      kinetic += after.kinetic - before[i].kinetic;
      elastic += after.elastic - before[i].elastic;
      ledger.book(Column::transfer, after.kinetic - before[i].kinetic);
      ledger.book(Column::transfer, after.elastic - before[i].elastic);
    }
    if (changed[i] == 0) continue;
    TransferRow& row = out.rows[next++];
    row.after = totals_of(to, i, state);
    measure(row, released[i].shape.second.trace());
    kinetic += row.after.kinetic - row.before.kinetic;
    elastic += row.after.elastic - row.before.elastic;
    reservoir += row.reservoir_kinetic + row.reservoir_elastic;
    ledger.book(Column::transfer, -row.booked);
    if (row.reservoir_kinetic != 0.0 || row.reservoir_elastic != 0.0)
      state.rest.push_back({state.bodies[i].block, row.reservoir_kinetic, row.reservoir_elastic,
                            released[i].velocity_rest, released[i].stress_rest});
  }
  ledger.set(Column::kinetic, kinetic);
  ledger.set(Column::elastic, elastic);
  ledger.set(Column::reservoir, reservoir);
  return out;
}

}  // namespace scree::coupling
