#include "coupling/integrate/central_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <compare>
#include <utility>

#include "coupling/integrate/lost_state.h"
#include "coupling/integrate/support_release.h"
#include "coupling/integrate/viscous_edges.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// out = v + h/2 a, moved = q + h out over a chunk. sum = out.f, then f = 0.
/// @param most  largest |component of out|; skips what is not a number
void kick_and_drift(const Chunk& c, double h, const double* q, const double* v, const double* a, double* f, double* out,
                    double* moved, double& sum, double& most) {
  double work = 0.0, largest = 0.0;
#pragma omp simd reduction(+ : work) reduction(max : largest)
  for (std::size_t i = c.begin; i < c.end; ++i) {
    const double u = v[i] + 0.5 * h * a[i], size = std::abs(u);
    out[i] = u;
    moved[i] = q[i] + h * u;
    work += u * f[i];
    f[i] = 0.0;
    largest = size > largest ? size : largest;
  }
  sum = work;
  most = largest;
}

/// out = v + k a over a chunk; returns a number that is finite if all of out is (and smaller than 1e150).
double kick(const Chunk& c, const double* v, double k, const double* a, double* out) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = c.begin; i < c.end; ++i) {
    out[i] = v[i] + k * a[i];
    sum += out[i] * out[i];
  }
  return sum;
}

}  // namespace

CentralDifference::CentralDifference(const Setup& setup, const StepControl& control, double detection,
                                     const ExplicitDamping& damping, bool rest)
    : setup_(&setup),
      control_(control),
      damping_(damping),
      rest_(rest),
      lags_(damping.stiffness > 0.0 || damping.local > 0.0 || !setup.model().viscous_edges.empty()),
      contact_(setup, detection, !rest),
      chunks_(setup),
      sliding_(setup, damping.sliding),
      stacks_(setup, sliding_),
      weights_(body_loads(setup)),
      factor_(weights_.size(), 0.0),
      weight_power_(weights_.size(), 0.0),
      partial_(chunks_.count() * (weights_.size() + 1), 0.0),
      left_(chunks_.count()) {
  for (const Row& row : setup.outlines().nodes)
    outline_weights_ = std::max(outline_weights_, std::abs(row.w[0]) + std::abs(row.w[1]) + std::abs(row.w[2]));
  const std::size_t n = 2 * static_cast<std::size_t>(setup.nodes());
  for (auto* v : {&stress_, &total_, &q_new_, &v_half_, &v_new_, &a_new_}) v->assign(n, 0.0);
  if (damping.stiffness > 0.0) stiffness_.force.assign(n, 0.0);
  if (damping.local > 0.0) local_.force.assign(n, 0.0);
  if (!sliding_.used()) return;
  for (auto* v : {&rigid_turn_, &momentum_, &turn_momentum_, &unit_mass_}) v->assign(n, 0.0);
  for (const std::size_t p : setup.own_pools())
    setup.pool(p).body_force({1.0, 1.0}, setup.part(std::span<double>(unit_mass_), p));
}

void CentralDifference::add_term(std::unique_ptr<ForceTerm> term) { terms_.push_back(std::move(term)); }

Instant CentralDifference::lagging(const State& state) const {
  return {state.q, lags() ? state.v_before : state.v, seconds(state.time)};
}

double CentralDifference::add_stress(std::span<const double> q) {
  double energy = 0.0;
  for (const std::size_t p : setup_->fast_pools())
    energy += setup_->pool(p).internal_force(setup_->part(q, p), setup_->part(std::span<double>(stress_), p));
  slow_.now = slow_.next;
  if (slow_.now == 0.0) return energy + slow_.energy;
  slow_.energy = 0.0;
  for (const std::size_t p : setup_->slow_pools()) {
    const auto force = setup_->part(std::span<double>(stress_), p);
    slow_.energy += setup_->pool(p).internal_force(setup_->part(q, p), force);
    for (double& f : force) f *= slow_.now;
  }
  return energy + slow_.energy;
}

void CentralDifference::restore_stress(const State& state) {
  std::fill(stress_.begin(), stress_.end(), 0.0);
  (void)add_stress(state.q);
}

void CentralDifference::sum_up(const Instant& at) {
  for (std::size_t i = 0; i < weights_.size(); ++i) factor_[i] = setup_->factor(weights_[i].function, at.t);
  const std::size_t sums = weights_.size() + 1;
  chunks_.for_free([&](const Chunk& c, std::size_t index) {
    const double *v = at.v.data(), *stress = stress_.data();
    double *total = total_.data(), *partial = &partial_[index * sums];
    double power = 0.0;
#pragma omp simd reduction(+ : power)
    for (std::size_t i = c.begin; i < c.end; ++i) {
      total[i] = stress[i];
      power += v[i] * stress[i];
    }
    partial[0] = power;
    for (std::size_t w = 0; w + 1 < sums; ++w) {
      const double factor = factor_[w], *weight = weights_[w].force.data();
      power = 0.0;
#pragma omp simd reduction(+ : power)
      for (std::size_t i = c.begin; i < c.end; ++i) {
        total[i] += factor * weight[i];
        power += v[i] * weight[i];
      }
      partial[w + 1] = power;
    }
  });
  stress_right_ = 0.0;
  std::fill(weight_power_.begin(), weight_power_.end(), 0.0);
  for (std::size_t index = 0; index < chunks_.count(); ++index) {
    stress_right_ += partial_[index * sums];
    for (std::size_t w = 0; w + 1 < sums; ++w) weight_power_[w] += partial_[index * sums + w + 1];
  }
  for (const auto* held : {&chunks_.driven(), &chunks_.resting(), &chunks_.ghosts()}) {
    if (held == &chunks_.resting() && terms_.empty()) continue;  // contacts leave no force on bodies that rest
    for (const Chunk& c : *held)
      std::fill(total_.begin() + static_cast<std::ptrdiff_t>(c.begin),
                total_.begin() + static_cast<std::ptrdiff_t>(c.end), 0.0);
  }
  contact_.add(total_);
  for (const auto& term : terms_) term->add(at, total_);
  if (!stiffness_.force.empty()) {
    std::fill(stiffness_.force.begin(), stiffness_.force.end(), 0.0);
    for (const std::size_t p : setup_->own_pools())
      setup_->pool(p).stiffness_damping(setup_->part(at.q, p), setup_->part(at.v, p), damping_.stiffness,
                                        setup_->part(std::span<double>(stiffness_.force), p));
    chunks_.for_free([&](const Chunk& c, std::size_t) {
      for (std::size_t i = c.begin; i < c.end; ++i) total_[i] += stiffness_.force[i];
    });
  }
  if (!local_.force.empty()) {
    for (const std::size_t p : setup_->own_pools())
      setup_->pool(p).fold_forces(setup_->part(std::span<double>(total_), p));
    chunks_.for_free([&](const Chunk& c, std::size_t) {
      for (std::size_t i = c.begin; i < c.end; ++i) {
        const double sign = at.v[i] > 0.0 ? 1.0 : (at.v[i] < 0.0 ? -1.0 : 0.0);
        local_.force[i] = -damping_.local * std::abs(total_[i]) * sign;
        total_[i] += local_.force[i];
      }
    });
  }
}

void CentralDifference::accelerate(std::span<const double> q, std::span<double> a) const {
  for (const std::size_t p : setup_->own_pools())
    setup_->pool(p).mass_solve(setup_->part(q, p), setup_->part(std::span<const double>(total_), p),
                               setup_->part(a, p));
  for (const Chunk& c : chunks_.driven())
    std::fill(a.begin() + static_cast<std::ptrdiff_t>(c.begin), a.begin() + static_cast<std::ptrdiff_t>(c.end), 0.0);
}

double CentralDifference::forces_power(const State& state, const double* v) const {
  double power = chunks_.sum_free([&](const Chunk& c) { return dot(c, v, total_.data()); });
  if (!state.sliding.empty())
    power += chunks_.sum_free([&](const Chunk& c) { return dot(c, v, state.sliding.data()); });
  return power;
}

double CentralDifference::acceleration_energy(const State& state) const {
  const double* a = state.a.data();
  double energy = chunks_.sum_free([&](const Chunk& c) { return dot(c, a, total_.data()); });
  if (damps_rest()) energy += chunks_.sum_free([&](const Chunk& c) { return dot(c, a, state.damping.data()); });
  if (!state.sliding.empty())
    energy += chunks_.sum_free([&](const Chunk& c) { return dot(c, a, state.sliding.data()); });
  if (damps_all()) {  // M a = F - rate M v, so a.M.a = a.F - rate v.M a = a.F - rate (v.F - rate v.M v)
    const double power = forces_power(state, state.v.data());
    energy -= damping_.mass * (power - 2.0 * damping_.mass * kinetic_energy(state.q, state.v));
  }
  return energy;
}

void CentralDifference::change_step(State& state, double h) {
  const double energy = acceleration_energy(state), last = seconds(state.last_step);
  state.ledger.set(Column::shadow, -h * h / 8.0 * energy);
  state.ledger.book(Column::step_change, -(h * h - last * last) / 8.0 * energy);
}

void CentralDifference::add_terms(const State& state) {
  if (auto springs = point_springs(*setup_, state); !springs.empty())
    add_term(std::make_unique<PointSupports>(std::move(springs)));
  if (auto forces = point_forces(*setup_, state); !forces.empty())
    add_term(std::make_unique<PointLoads>(*setup_, std::move(forces)));
  if (SupportRelease release(*setup_, state); release.acts())
    add_term(std::make_unique<SupportReleaseTerm>(std::move(release)));
  if (auto rows = acting_bolts(*setup_, state); !rows.empty()) {
    auto bolts = std::make_unique<BoltForces>(*setup_, std::move(rows));
    bolts->take(state);
    bolts_ = bolts.get();
    add_term(std::move(bolts));
  }
  if (auto edges = dashpots(*setup_, state); !edges.empty())
    add_term(std::make_unique<ViscousEdges>(*setup_, std::move(edges)));
}

void CentralDifference::resume(State& state, const IntegratorMemory& memory) {
  add_terms(state);
  contact_.resume(state);
  sum_up(lagging(state));  // for the forces of the terms, which act on free bodies alone
  stress_ = memory.stress;
  total_ = memory.total;
  stiffness_.force = memory.stiffness;
  local_.force = memory.local;
  slow_ = {memory.slow_weight, memory.slow_weight, memory.slow_energy};
  if (held_ != nullptr) held_->take(memory.held, scratch());
  bound_ = memory.bound;
}

void CentralDifference::exchange(IntegratorMemory& memory) {
  memory.stress.swap(stress_);
  memory.total.swap(total_);
  memory.stiffness.swap(stiffness_.force);
  memory.local.swap(local_.force);
  memory.bound.swap(bound_);
}

IntegratorMemory CentralDifference::lend() {
  IntegratorMemory out;
  out.held.assign(held().begin(), held().end());
  exchange(out);
  out.slow_weight = slow_.now;
  out.slow_energy = slow_.energy;
  return out;
}

void CentralDifference::take_back(IntegratorMemory& memory) { exchange(memory); }

double CentralDifference::enter(State& state) {
  add_terms(state);
  const bool goes_on = !state.a.empty();
  contact_.enter(state, state.step == 0, goes_on);
  if (lags() && state.v_before.size() != state.v.size()) state.v_before = state.v;
  restore_stress(state);
  sum_up(lagging(state));
  accelerate(state.q, a_new_);
  if (sliding_.used()) state.sliding.reserve(state.q.size());  // so that steps need not allocate
  if (sliding_.used() && !goes_on) {
    v_new_ = state.v;
    damp_sliding(state.q, 0.0, state);
  }
  if (damps_rest() && !goes_on) {
    state.damping.assign(state.v.size(), 0.0);
    v_new_ = state.v;
    (void)damp_rest(1.0, state);
  } else if (damps_all()) {
    for (std::size_t i = 0; i < a_new_.size(); ++i) a_new_[i] -= damping_.mass * state.v[i];
  }
  for (const Chunk& c : chunks_.driven())
    for (std::size_t i = c.begin; i < c.end; ++i) a_new_[i] = 0.0;
  if (!goes_on) state.a = a_new_;
  return contact_energy(contact_.list());
}

double CentralDifference::kick_off(const State& state, double h) {
  const double *v = state.v.data(), *a = state.a.data(), *half = v_half_.data();
  chunks_.for_free([&](const Chunk& c, std::size_t index) {
    Left& left = left_[index];
    kick_and_drift(c, h, state.q.data(), v, a, stress_.data(), v_half_.data(), q_new_.data(), left.stress,
                   left.largest);
    if (damps_rest()) left.mass = dot(c, half, state.damping.data());
    if (!state.sliding.empty()) left.sliding = dot(c, half, state.sliding.data());
    if (!stiffness_.force.empty()) left.stiffness = dot(c, half, stiffness_.force.data());
    if (!local_.force.empty()) left.local = dot(c, half, local_.force.data());
  });
  Left all;
  for (const Left& left : left_) {
    all.stress += left.stress;
    all.largest = std::max(all.largest, left.largest);
    all.mass += left.mass;
    all.sliding += left.sliding;
    all.stiffness += left.stiffness;
    all.local += left.local;
  }
  stress_left_ = all.stress;
  mass_left_ = all.mass;
  sliding_left_ = all.sliding;
  stiffness_.left = all.stiffness;
  local_.left = all.local;
  // sqrt(2) times the largest component bounds the largest displacement. What is not a number is skipped here, and
  // detected later in the step.
  return h * std::sqrt(2.0) * all.largest;
}

StepReport CentralDifference::refuse(double h) const {
  const Outlines& o = setup_->outlines();
  OutlineNode where{0};
  double farthest = 0.0;
  for (const OutlineNode k : o.nodes.indices()) {
    if (!std::isfinite(farthest)) break;
    const double way = h * position(o.nodes[k], v_half_).norm();
    if (way <= farthest) continue;
    farthest = way;
    where = k;
  }
  StepReport report;
  if (farthest <= control_.max_displacement) return report;
  report.body = o.node_body[where];
  report.status = std::isfinite(farthest) ? StepReport::Status::too_far : StepReport::Status::non_finite;
  report.suggested = std::isfinite(farthest) ? control_.max_displacement / farthest : 0.0;
  report.cause = std::isfinite(farthest) ? fmt::format("a point would move {:.3g} m in one step, {:.3g} m is allowed",
                                                       farthest, control_.max_displacement)
                                         : "a velocity is not finite";
  return report;
}

bool CentralDifference::forces_stay_finite() const {
  if (contact_.list().points.empty()) return true;
  double sum = chunks_.sum_free([&](const Chunk& c) { return dot(c, v_half_.data(), stress_.data()); });
  for (const double f : held()) sum += f;
  return std::isfinite(sum);
}

StepReport CentralDifference::lost(const State& state, std::span<const double> forces, double t) const {
  LostPlace place = lost_place(*setup_, q_new_);
  if (!place.body.valid()) place = not_finite_at(*setup_, forces, "the force", state.q);
  if (!place.body.valid()) place = not_finite_at(*setup_, v_new_, "the velocity", state.q);
  return lost_state(place, t);
}

void CentralDifference::move_driven(const State& state, double h, double end, double& farthest) {
  if (!std::exchange(resting_placed_, true))
    for (const Chunk& c : chunks_.resting())
      for (std::size_t i = c.begin; i < c.end; ++i) {
        v_half_[i] = 0.0;
        q_new_[i] = state.q[i];
      }
  for (const Body& b : setup_->bodies()) {
    if (!b.driven || b.ghost || b.resting) continue;
    const Vec2 u = (setup_->driven_displacement(b, end) - setup_->driven_displacement(b, seconds(state.time))) / h;
    if (h * u.norm() > farthest) farthest = h * u.norm();
    const auto t = setup_->pool_of(b).translation(b.index);
    for (std::int32_t k = 0; k < b.nodes; ++k) {
      const auto i = 2 * static_cast<std::size_t>(b.first_node + k);
      v_half_[i] = t[static_cast<std::size_t>(k)] * u.x();
      v_half_[i + 1] = t[static_cast<std::size_t>(k)] * u.y();
      for (std::size_t j = i; j < i + 2; ++j) q_new_[j] = state.q[j] + h * v_half_[j];
    }
  }
}

std::span<double> CentralDifference::scratch() {
  resting_placed_ = false;
  std::fill(q_new_.begin(), q_new_.end(), 0.0);
  return q_new_;
}

void CentralDifference::turn(const State& state, double h) {
  for (const std::size_t p : setup_->own_pools())
    setup_->pool(p).turn(h, setup_->part(std::span<const double>(state.q), p),
                         setup_->part(std::span<double>(v_half_), p), setup_->part(std::span<double>(q_new_), p));
}

void CentralDifference::leave_instant(const State& state, double h) {
  contact_.leave(v_half_);
  for (const auto& term : terms_) term->leave(h, v_half_);
  if (damps_all()) {
    // -rate v_{n+1/2}.M v_n with v_{n+1/2} = v_n + h/2 a_n and M a_n = F_n - rate M v_n
    const double twice = 2.0 * kinetic_energy(state.q, state.v), power = forces_power(state, state.v.data());
    mass_left_ = -damping_.mass * (twice * (1.0 - 0.5 * h * damping_.mass) + 0.5 * h * power);
  }
}

void CentralDifference::book_step(double h, double stress_energy, double driven_before, Ledger& ledger) {
  const double half = 0.5 * h, *v = v_half_.data();
  // Forces on driven nodes in total_ are those of contacts alone.
  ledger.book(Column::prescribed_motion, -half * (driven_before + dot(chunks_.driven(), v, total_.data())));
  const double change = stress_energy - ledger[Column::elastic];
  ledger.set(Column::elastic, stress_energy);
  ledger.book(Column::elastic_trapezoid, change + half * (stress_left_ + stress_right_));
  for (const auto& term : terms_) term->arrive(h, v_half_, ledger);
  for (const auto& [lagged, column] :
       {std::pair(&stiffness_, Column::stiffness_damping), std::pair(&local_, Column::local_damping)})
    if (!lagged->force.empty())
      ledger.book(column, -half * (lagged->left + chunks_.sum_free([&, l = lagged](const Chunk& c) {
                    return dot(c, v, l->force.data());
                  })));
}

bool CentralDifference::arrive(double h) {
  const double check =
      chunks_.sum_free([&](const Chunk& c) { return kick(c, v_half_.data(), 0.5 * h, a_new_.data(), v_new_.data()); });
  for (const auto* held : {&chunks_.driven(), &chunks_.ghosts()})
    for (const Chunk& c : *held)
      for (std::size_t i = c.begin; i < c.end; ++i) v_new_[i] = v_half_[i];
  return std::isfinite(check);
}

double CentralDifference::damp_rest(double factor, State& state) {
  double power = 0.0;
  for (const std::size_t p : setup_->own_pools())
    power += setup_->pool(p).damp(factor, damping_.mass, setup_->part(std::span<const double>(v_half_), p),
                                  setup_->part(std::span<double>(v_new_), p),
                                  setup_->part(std::span<double>(state.damping), p),
                                  setup_->part(std::span<double>(a_new_), p));
  return power;
}

void CentralDifference::damp(double h, State& state) {
  const double rate = damping_.mass, factor = 1.0 / (1.0 + 0.5 * h * rate);
  double right = 0.0;
  if (damps_rest()) {
    right = damp_rest(factor, state);
    for (const Chunk& c : chunks_.driven())
      for (std::size_t i = c.begin; i < c.end; ++i) a_new_[i] = 0.0;
  } else if (damps_all()) {
    chunks_.for_free([&](const Chunk& c, std::size_t) {
      for (std::size_t i = c.begin; i < c.end; ++i) {
        v_new_[i] *= factor;
        a_new_[i] -= rate * v_new_[i];
      }
    });
    // -rate v_{n+1/2}.M v_{n+1} with v_{n+1/2} = v_{n+1} - h/2 a_{n+1} and M a_{n+1} = F_{n+1} - rate M v_{n+1}
    const double twice = 2.0 * kinetic_energy(q_new_, v_new_), power = forces_power(state, v_new_.data());
    right = -rate * (twice * (1.0 + 0.5 * h * rate) - 0.5 * h * power);
  } else {
    return;
  }
  state.ledger.book(Column::mass_damping, -0.5 * h * (mass_left_ + right));
}

StepReport CentralDifference::step(State& state, Tick ticks_of_step) {
  const double h = seconds(ticks_of_step), end = seconds(state.time + ticks_of_step);
  // Kick by half a step and drift; driven bodies follow their motions. The state has not changed yet: a step that
  // would move too far is refused here.
  double farthest = kick_off(state, h);
  move_driven(state, h, end, farthest);
  if (!chunks_.ghosts().empty()) move_ghosts(state, state.time + ticks_of_step, farthest);
  if (!(outline_weights_ * farthest <= control_.max_displacement)) {
    StepReport report = refuse(h);
    if (report.status != StepReport::Status::ok) {
      restore_stress(state);
      return report;
    }
  }
  const Ledger before = state.ledger;
  if (state.last_step != ticks_of_step) change_step(state, h);

  leave_instant(state, h);
  const double driven_left = dot(chunks_.driven(), v_half_.data(), total_.data());
  turn(state, h);

  // Forces at the new instant.
  const double energy = add_stress(q_new_);
  if (!std::isfinite(energy)) {
    StepReport report = lost(state, stress_, end);
    state.ledger = before;
    restore_stress(state);
    return report;
  }
  contact_.keep_for_undo(!forces_stay_finite());
  contact_.arrive(h, farthest, q_new_, v_half_, state);
  const Instant now{q_new_, v_half_, end};
  sum_up(now);

  // Kick by the other half.
  accelerate(q_new_, a_new_);
  if (!arrive(h)) {
    StepReport report = lost(state, total_, end);
    contact_.undo();
    state.ledger = before;
    restore_stress(state);
    sum_up(lagging(state));
    return report;
  }
  for (std::size_t i = 0; i < weights_.size(); ++i) {
    const double then = setup_->factor(weights_[i].function, seconds(state.time));
    state.ledger.book(weights_[i].column, 0.5 * h * (then + factor_[i]) * weight_power_[i]);
  }
  book_step(h, energy, driven_left, state.ledger);
  if (sliding_.used()) {
    const double left = state.sliding.empty() ? 0.0 : sliding_left_;
    damp_sliding(q_new_, 0.5 * h, state);
    const double right = state.sliding.empty() ? 0.0 : chunks_.sum_free([&](const Chunk& c) {
      return dot(c, v_half_.data(), state.sliding.data());
    });
    if (left != 0.0 || right != 0.0)
      state.ledger.book(Column::deformation_damping, -0.5 * h * (left + right) + h * stack_friction_);
    if (stack_friction_ != 0.0) state.ledger.book(Column::friction, -h * stack_friction_);
  }
  damp(h, state);

  state.q.swap(q_new_);
  state.v.swap(v_new_);
  state.a.swap(a_new_);
  if (lags()) state.v_before.swap(v_half_);
  state.time += ticks_of_step;
  if (bolts_ != nullptr) bolts_->keep(state);
  setup_->prescribe_motions(end, state.q, state.v);
  state.last_step = ticks_of_step;
  ++state.step;
  if (audit_ != nullptr) contact_.check(state.q, *audit_);
  if (rest_) relax(state);
  return {};
}

double CentralDifference::kinetic_energy(std::span<const double> q, std::span<const double> v) const {
  double kinetic = 0.0;
  for (const std::size_t p : setup_->own_pools())
    kinetic += setup_->pool(p).kinetic_energy(setup_->part(q, p), setup_->part(v, p), setup_->counted(p));
  return kinetic;
}

void CentralDifference::relax(State& state) {
  const double kinetic = kinetic_energy(state.q, state.v);
  if (kinetic >= state.relaxing) {
    state.relaxing = kinetic;
    return;
  }
  // Damping ends with the motion, so that the acceleration changes at this instant.
  const bool damped = damps_all() || damps_rest() || lags() || !state.sliding.empty();
  const double shadow = damped ? acceleration_energy(state) : 0.0;
  state.ledger.book(Column::rest_damping, kinetic);
  std::fill(state.v.begin(), state.v.end(), 0.0);
  setup_->prescribe_motions(seconds(state.time), state.q, state.v);
  state.relaxing = 0.0;
  if (!damped) return;
  std::fill(state.v_before.begin(), state.v_before.end(), 0.0);
  std::fill(state.damping.begin(), state.damping.end(), 0.0);
  state.sliding.clear();
  sum_up(lagging(state));
  accelerate(state.q, state.a);
  const double h = seconds(state.last_step);
  state.ledger.book(Column::step_change, -h * h / 8.0 * (acceleration_energy(state) - shadow));
}

void CentralDifference::update_ledger(State& state) {
  state.ledger.set(Column::kinetic, kinetic_energy(state.q, state.v));
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
  state.v_before.clear();
  state.damping.clear();
  state.sliding.clear();
  state.contacts.forget_points();
}

double CentralDifference::stable_step(const State& state, std::string* binding) {
  const ContactList& list = contact_.list();
  bound_.resize(list.points.size());
  parallel_for(std::ssize(bound_), [&](std::int64_t at) {
    const auto i = static_cast<std::size_t>(at);
    bound_[i] = {list.points[i].key, std::max(list.memory[i].kn, list.memory[i].kt) + list.points[i].margin};
  });
  if (!step_bound_) step_bound_.emplace(*setup_);
  return step_bound_->certified_step({contact_.list(), point_springs(*setup_, state), dashpots(*setup_, state),
                                      damping_, bolt_springs(*setup_, state)},
                                     binding);
}

bool CentralDifference::step_still_stable() const {
  const ContactList& list = contact_.list();
  // A contact that has ended leaves the bound safe; one that is new or has grown stiffer is not covered. Both lists are
  // in the order of their keys.
  const auto covered = [&](std::int64_t begin, std::int64_t end) {
    const auto before = [](const IntegratorMemory::Bound& b, const ContactKey& key) { return b.key < key; };
    auto at = std::lower_bound(bound_.begin(), bound_.end(), list.points[static_cast<std::size_t>(begin)].key, before);
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i, ++at) {
      while (at != bound_.end() && at->key < list.points[i].key) ++at;
      if (at == bound_.end() || at->key != list.points[i].key) return false;
      if (std::max(list.memory[i].kn, list.memory[i].kt) > at->stiffness) return false;
    }
    return true;
  };
  std::atomic<bool> all = true;
  parallel_for_chunks(std::ssize(list.points), [&](std::int64_t begin, std::int64_t end) {
    if (all.load(std::memory_order_relaxed) && !covered(begin, end)) all.store(false, std::memory_order_relaxed);
  });
  return all;
}

}  // namespace scree::coupling
