// Functions of the explicit integrator that other integrators use: ghosts on given paths, held and weighted forces,
// predicted contacts, return to an earlier instant.
#include <algorithm>
#include <cmath>

#include "coupling/integrate/central_difference.h"

namespace scree::coupling {

void CentralDifference::hold_nodes(std::vector<std::int32_t> nodes) {
  auto held = std::make_unique<HeldForce>(std::move(nodes));
  held_ = held.get();
  add_term(std::move(held));
}

void CentralDifference::hold(State& state, std::span<const double> force) {
  held_->take(force, scratch());
  jump(state);
}

void CentralDifference::weigh(State& state, double weight) {
  slow_.next = weight;
  if (weight == slow_.now) return;
  const double factor = weight / slow_.now;
  const std::span<double> changes = scratch();
  for (const std::size_t p : setup_->slow_pools()) {
    const auto stress = setup_->part(std::span<double>(stress_), p), change = setup_->part(changes, p);
    for (std::size_t i = 0; i < stress.size(); ++i) {
      const double force = factor * stress[i];
      change[i] = force - stress[i];
      stress[i] = force;
    }
  }
  slow_.now = weight;
  jump(state);
}

void CentralDifference::jump(State& state) {
  const double before = acceleration_energy(state);
  std::fill(a_new_.begin(), a_new_.end(), 0.0);
  for (const std::size_t p : setup_->own_pools())
    setup_->pool(p).mass_solve(setup_->part(std::span<const double>(state.q), p),
                               setup_->part(std::span<const double>(q_new_), p),
                               setup_->part(std::span<double>(a_new_), p));
  chunks_.for_free([&](const Chunk& c, std::size_t) {
    for (std::size_t i = c.begin; i < c.end; ++i) {
      total_[i] += q_new_[i];
      state.a[i] += a_new_[i];
    }
  });
  const double h = seconds(state.last_step), after = acceleration_energy(state);
  state.ledger.set(Column::shadow, -h * h / 8.0 * after);
  state.ledger.book(Column::step_change, -h * h / 8.0 * (after - before));
}

void CentralDifference::lead_ghosts(const State& state, std::span<const double> end, Tick time) {
  lead_.begin = state.time;
  lead_.end = time;
  lead_.from.assign(state.q.begin(), state.q.end());
  lead_.to.assign(end.begin(), end.end());
}

void CentralDifference::move_ghosts(const State& state, Tick arrival, double& farthest) {
  const double h = seconds(arrival - state.time), s = seconds(arrival - lead_.begin) / seconds(lead_.end - lead_.begin);
  double most = 0.0;
  for (const Chunk& c : chunks_.ghosts())
    for (std::size_t i = c.begin; i < c.end; ++i) {
      // Exact to the last bit at the end: the ghost's own integrator continues from there.
      q_new_[i] = arrival == lead_.end ? lead_.to[i] : lead_.from[i] + s * (lead_.to[i] - lead_.from[i]);
      v_half_[i] = (q_new_[i] - state.q[i]) / h;
      most = std::max(most, std::abs(v_half_[i]));
    }
  farthest = std::max(farthest, h * std::sqrt(2.0) * most);
}

void CentralDifference::foresee(const State& state, std::span<const double> end, Tick ticks_of_step, bool again,
                                std::span<double> f) {
  const double h = seconds(ticks_of_step);
  for (const Chunk& c : chunks_.ghosts())
    for (std::size_t i = c.begin; i < c.end; ++i) {
      q_new_[i] = end[i];
      v_half_[i] = (end[i] - state.q[i]) / h;
    }
  chunks_.for_free([&](const Chunk& c, std::size_t) {
    for (std::size_t i = c.begin; i < c.end; ++i) {
      v_half_[i] = state.v[i] + 0.5 * h * state.a[i];
      q_new_[i] = state.q[i] + h * v_half_[i];
    }
  });
  double farthest = 0.0;
  move_driven(state, h, seconds(state.time + ticks_of_step), farthest);
  turn(state, h);
  if (again)
    contact_.foresee_again(h, q_new_, v_half_, f);
  else
    contact_.foresee(h, q_new_, v_half_, f);
}

void CentralDifference::mark(Mark& out) const {
  contact_.mark(out.contacts);
  out.stress = stress_;
  out.total = total_;
  out.stiffness = stiffness_.force;
  out.local = local_.force;
  out.held.assign(held().begin(), held().end());
  out.slow_weight = slow_.now;
  out.slow_energy = slow_.energy;
}

void CentralDifference::go_back(State& state, const Mark& mark) {
  contact_.go_back(mark.contacts);
  if (held_ != nullptr) held_->take(mark.held, scratch());
  if (bolts_ != nullptr) bolts_->take(state);
  for (const auto& term : terms_) term->add(lagging(state), total_);  // restores the forces that terms store
  stress_ = mark.stress;
  total_ = mark.total;
  stiffness_.force = mark.stiffness;
  local_.force = mark.local;
  slow_ = {mark.slow_weight, mark.slow_weight, mark.slow_energy};
}

}  // namespace scree::coupling
