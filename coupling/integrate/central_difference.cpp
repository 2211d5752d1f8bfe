#include "coupling/integrate/central_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/integrate/step_bound.h"
#include "model/parallel.h"

namespace scree::coupling {

CentralDifference::CentralDifference(const Setup& setup, const StepControl& control, double detection, double damping,
                                     bool rest)
    : setup_(&setup),
      control_(control),
      damping_(damping),
      rest_(rest),
      contact_(setup, detection),
      damping_force_(2 * static_cast<std::size_t>(setup.nodes()), 0.0) {
  add_term(std::make_unique<InternalForce>(setup));
  add_term(std::make_unique<Gravity>(setup));
}

void CentralDifference::add_term(std::unique_ptr<ForceTerm> term) {
  terms_.push_back(std::move(term));
  force_.emplace_back(2 * static_cast<std::size_t>(setup_->nodes()), 0.0);
  half_free_.push_back(0.0);
  half_driven_.push_back(0.0);
}

double CentralDifference::work(std::span<const double> v, std::span<const double> f, bool free) const {
  const std::vector<double>& mask = setup_->free();
  return parallel_sum(static_cast<std::int64_t>(mask.size()), partial_, [&](std::int64_t begin, std::int64_t end) {
    double sum = 0.0;
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      const double take = free ? mask[k] : 1.0 - mask[k];
      sum += take * (v[2 * k] * f[2 * k] + v[2 * k + 1] * f[2 * k + 1]);
    }
    return sum;
  });
}

void CentralDifference::evaluate(const State& state, std::vector<std::vector<double>>& forces,
                                 std::vector<double>& total) {
  const std::size_t n = state.q.size();
  contact_force_.assign(n, 0.0);
  contact_.add(contact_force_);
  total.assign(contact_force_.begin(), contact_force_.end());
  const auto count = static_cast<std::int64_t>(n);
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    std::vector<double>& f = forces[i];
    parallel_for(count, [&](std::int64_t k) { f[static_cast<std::size_t>(k)] = 0.0; });
    terms_[i]->add(state.q, seconds(state.time), f);
    parallel_for(count, [&](std::int64_t k) { total[static_cast<std::size_t>(k)] += f[static_cast<std::size_t>(k)]; });
  }
}

void CentralDifference::damp(State& state, double factor) {
  std::fill(damping_force_.begin(), damping_force_.end(), 0.0);
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    setup_->pool(p).damp(factor, damping_, setup_->part(std::span<double>(state.v), p),
                         setup_->part(std::span<double>(damping_force_), p));
  parallel_for(static_cast<std::int64_t>(total_.size()), [&](std::int64_t i) {
    total_[static_cast<std::size_t>(i)] += damping_force_[static_cast<std::size_t>(i)];
  });
  accelerate(state);
}

void CentralDifference::kick(State& state, double h) {
  parallel_for(static_cast<std::int64_t>(state.v.size()), [&](std::int64_t i) {
    state.v[static_cast<std::size_t>(i)] += h * state.a[static_cast<std::size_t>(i)];
  });
}

void CentralDifference::accelerate(State& state) const {
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    setup_->pool(p).mass_solve(setup_->part(std::span<const double>(state.q), p),
                               setup_->part(std::span<const double>(total_), p),
                               setup_->part(std::span<double>(state.a), p));
  const std::vector<double>& free = setup_->free();
  parallel_for(static_cast<std::int64_t>(free.size()), [&](std::int64_t n) {
    const auto k = static_cast<std::size_t>(n);
    if (free[k] == 0.0) state.a[2 * k] = state.a[2 * k + 1] = 0.0;
  });
}

double CentralDifference::acceleration_energy(const State& state) const { return work(state.a, total_, true); }

void CentralDifference::change_step(State& state, double h) {
  const double energy = acceleration_energy(state), last = seconds(state.last_step);
  state.ledger.set(Column::shadow, -h * h / 8.0 * energy);
  state.ledger.book(Column::step_change, -(h * h - last * last) / 8.0 * energy);
}

double CentralDifference::enter(State& state) {
  auto springs = point_springs(*setup_, state);
  if (!springs.empty()) add_term(std::make_unique<PointSupports>(std::move(springs)));
  contact_.enter(state, state.step == 0, !state.a.empty());
  state.a.assign(state.q.size(), 0.0);
  evaluate(state, force_, total_);
  if (damping_ > 0.0)
    damp(state, 1.0);
  else
    accelerate(state);
  return contact_energy(contact_.list());
}

StepReport CentralDifference::step(State& state, Tick ticks_of_step) {
  StepReport report;
  const double h = seconds(ticks_of_step), end = seconds(state.time + ticks_of_step);
  const std::size_t nodes = setup_->free().size();

  // Nothing has changed yet: a step that would go too far is refused here.
  std::vector<std::size_t>& farthest_in = farthest_;  // by chunk, then over the chunks: the first of the largest
  farthest_in.assign((nodes + kChunk - 1) / kChunk, 0);
  const auto reach = [&](std::size_t k) {  // squared displacement of a node in this step
    const double x = state.v[2 * k] + 0.5 * h * state.a[2 * k], y = state.v[2 * k + 1] + 0.5 * h * state.a[2 * k + 1];
    return h * h * (x * x + y * y);
  };
  parallel_for_chunks(static_cast<std::int64_t>(nodes), [&](std::int64_t begin, std::int64_t chunk_end) {
    auto best = static_cast<std::size_t>(begin);
    for (std::size_t k = best + 1; k < static_cast<std::size_t>(chunk_end); ++k)
      if (!(reach(k) <= reach(best))) best = k;
    farthest_in[static_cast<std::size_t>(begin / kChunk)] = best;
  });
  std::size_t where = 0;
  for (std::size_t k : farthest_in)
    if (!(reach(k) <= reach(where))) where = k;
  const double farthest = std::sqrt(reach(where));
  const auto body_at = [&] {
    const auto& bodies = setup_->bodies();
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (static_cast<std::int32_t>(where) >= bodies[b].first_node &&
          static_cast<std::int32_t>(where) < bodies[b].first_node + bodies[b].nodes)
        return static_cast<std::int32_t>(b);
    return std::int32_t{-1};
  };
  if (!(farthest <= control_.max_displacement)) {
    report.body = body_at();
    report.status = std::isfinite(farthest) ? StepReport::Status::too_far : StepReport::Status::non_finite;
    report.suggested = std::isfinite(farthest) ? control_.max_displacement / farthest : 0.0;
    report.cause =
        std::isfinite(farthest)
            ? fmt::format("a point would move {:.3g} m in one step, {:.3g} m is allowed", farthest,
                          control_.max_displacement)
            : "a velocity is not finite: the step is above the stable one, or an element was turned inside out";
    return report;
  }

  if (state.last_step != ticks_of_step) change_step(state, h);
  // Kick by half a step; driven bodies go where they are told.
  kick(state, 0.5 * h);
  for (const Body& b : setup_->bodies()) {
    if (!b.driven) continue;
    const Vec2 u = (setup_->driven_displacement(b, end) - setup_->driven_displacement(b, seconds(state.time))) / h;
    const auto t = setup_->pool_of(b).translation(b.index);
    for (std::int32_t k = 0; k < b.nodes; ++k) {
      const auto i = 2 * static_cast<std::size_t>(b.first_node + k);
      state.v[i] = t[static_cast<std::size_t>(k)] * u.x();
      state.v[i + 1] = t[static_cast<std::size_t>(k)] * u.y();
    }
  }
  contact_.leave(h, state.v);
  for (std::size_t i = 0; i < terms_.size(); ++i) {
    half_free_[i] = work(state.v, force_[i], true);
    half_driven_[i] = work(state.v, force_[i], false);
  }
  double driven = work(state.v, contact_force_, false);
  const double damped = damping_ > 0.0 ? work(state.v, damping_force_, true) : 0.0;

  // Drift, forces at the new instant.
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    setup_->pool(p).drift(h, setup_->part(std::span<double>(state.q), p), setup_->part(std::span<double>(state.v), p));
  state.time += ticks_of_step;
  contact_.arrive(h, state.q, state.v, state);
  evaluate(state, force_, total_);
  driven += work(state.v, contact_force_, false);
  state.ledger.book(Column::prescribed_motion, -0.5 * h * driven);
  for (std::size_t i = 0; i < terms_.size(); ++i)
    terms_[i]->book(0.5 * h * (half_free_[i] + work(state.v, force_[i], true)),
                    0.5 * h * (half_driven_[i] + work(state.v, force_[i], false)), state.ledger);

  // Kick by the other half.
  accelerate(state);
  const std::span<double> v(state.v);
  if (damping_ > 0.0) v_before_.assign(v.begin(), v.end());
  kick(state, 0.5 * h);
  if (damping_ > 0.0) {
    damp(state, 1.0 / (1.0 + 0.5 * h * damping_));
    state.ledger.book(Column::mass_damping, -0.5 * h * (damped + work(v_before_, damping_force_, true)));
  }
  setup_->prescribe(end, state.q, state.v);
  if (rest_) relax(state);
  state.last_step = ticks_of_step;
  ++state.step;
  return report;
}

double CentralDifference::kinetic_energy(const State& state) const {
  double kinetic = 0.0;
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    kinetic += setup_->pool(p).kinetic_energy(setup_->part(std::span<const double>(state.q), p),
                                              setup_->part(std::span<const double>(state.v), p), setup_->counted(p));
  return kinetic;
}

void CentralDifference::relax(State& state) const {
  const double kinetic = kinetic_energy(state);
  if (kinetic >= state.relaxing) {
    state.relaxing = kinetic;
    return;
  }
  state.ledger.book(Column::rest_damping, kinetic);
  std::fill(state.v.begin(), state.v.end(), 0.0);
  setup_->prescribe(seconds(state.time), state.q, state.v);
  state.relaxing = 0.0;
}

void CentralDifference::update_ledger(State& state) {
  state.ledger.set(Column::kinetic, kinetic_energy(state));
  // Within a stage the shadow follows the acceleration; only a change of the step is booked.
  const double h = seconds(state.last_step);
  state.ledger.set(Column::shadow, -h * h / 8.0 * acceleration_energy(state));
}

void CentralDifference::leave(State& state) {
  update_ledger(state);
  change_step(state, 0.0);
  state.last_step = 0;
  state.relaxing = 0.0;
  state.a.clear();
}

double CentralDifference::stable_step(const State& state, std::string* binding) {
  std::vector<PointSpring> springs = point_springs(*setup_, state);
  const ContactList& list = contact_.list();
  bound_.clear();
  for (std::size_t i = 0; i < list.points.size(); ++i)
    bound_.push_back({list.points[i].key, std::max(list.memory[i].kn, list.memory[i].kt) + list.points[i].margin});
  return certified_step(*setup_, contact_.list(), springs, binding);
}

bool CentralDifference::step_still_stable() const {
  const ContactList& list = contact_.list();
  // A contact that ended only leaves slack; one that is new or has grown stiffer is not covered.
  std::size_t at = 0;
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    while (at < bound_.size() && bound_[at].key < list.points[i].key) ++at;
    if (at == bound_.size() || bound_[at].key != list.points[i].key) return false;
    if (std::max(list.memory[i].kn, list.memory[i].kt) > bound_[at].stiffness) return false;
  }
  return true;
}

}  // namespace scree::coupling
