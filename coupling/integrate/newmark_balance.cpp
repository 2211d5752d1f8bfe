// Newton's method for one implicit step: its right-hand side, iterations and what counts as a balance.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/integrate/newmark.h"
#include "coupling/linear/vectors.h"

namespace scree::coupling {
namespace {

constexpr double kBalanced = 1e-11;  // of the largest force
constexpr double kWorkLeft = 4e-16;  // of the energy moved: work of a residual that the ledger may leave over in a step
constexpr int kRefinements = 2;      // of an iterate; further ones only stir round-off
constexpr int kIterations = 50;
constexpr int kMoreIterations = 4;  // that a step may take with a kept tangent beyond the fewest

}  // namespace

double Newmark::residual(const State& state, double h, double& largest) {
  const auto mask = system_.nonlinear_dofs();
  // Bodies whose force is linear: f(d) = f_0 - K d.
  for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] = mask[i] != 0.0 ? 0.0 : d_[i];
  system_.pattern().multiply_add(-1.0, K_, rate_, force_after_);
  for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] = 2.0 / h * d_[i] - system_.rate()[i];
  damping_forces(state, rate_, damped_after_);
  out_ = inertia_;
  system_.pattern().multiply_add(-mass_factor(h), system_.mass(), d_, out_);
  largest = std::max({largest_of(gravity_), largest_of(load_), largest_of(force_after_), largest_of(damped_after_.mass),
                      largest_of(damped_after_.stiffness), largest_of(out_)});
  for (std::size_t i = 0; i < out_.size(); ++i)
    out_[i] += damped_after_.added_to(gravity_[i] + load_[i] + force_after_[i], i);
  if (damper_.acts()) {
    largest = std::max(largest, largest_of(damped_after_.sliding));
    for (std::size_t i = 0; i < out_.size(); ++i) out_[i] += damped_after_.sliding[i];
  }
  if (interface_.acts()) {
    largest = std::max(largest, interface_.largest());
    largest_interface_force_ = largest;  // without the forces of springs, which may be larger by far
  }
  largest = std::max(largest, contacts_.add_forces(d_, out_));
  largest = std::max(largest, bolts_.add(d_, springs_, out_));
  if (interface_.acts()) {
    const auto predicted = interface_.predicted();  // less the forces of the springs, which out_ includes
    for (std::size_t i = 0; i < out_.size(); ++i) out_[i] += predicted[i];
  }
  return largest_of(out_);
}

Newmark::RoundOff Newmark::round_off(const State& state) const {
  // A force is a sum of stiffness times positions, each known to half a unit in the last place.
  RoundOff out = largest_;
  for (std::size_t i = interface_springs_; i < springs_.size(); ++i) out.system = std::max(out.system, springs_.k[i]);
  const double places = std::numeric_limits<double>::epsilon() * largest_of(state.q);
  out.system *= 8.0 * places;
  out.bodies *= 2.0 * places;
  return out;
}

Newmark::LeftOver Newmark::left_over(const State& state) const {
  const double most = round_off(state).system;
  LeftOver out;
  for (std::size_t i = 0; i < d_.size(); ++i) {
    const double force = std::min(std::abs(out_[i]), most);
    out.force = std::max(out.force, force);
    out.work += force * std::abs(d_[i]);
  }
  return out;
}

void Newmark::find_right_side(std::span<const double> moved, std::span<const double> affine) {
  // (s M + K + 2 C/h) d = known inertia + loads + f(x_k) + K d_k + C v.
  for (std::size_t i = 0; i < d_.size(); ++i) rhs_[i] = inertia_[i] + gravity_[i] + load_[i] + force_[i];
  if (system_.nonlinear()) system_.pattern().multiply_add(1.0, K_, moved, rhs_);
  if (interface_.acts()) {
    const auto predicted = interface_.predicted();
    for (std::size_t i = 0; i < d_.size(); ++i) rhs_[i] += predicted[i];
  }
  if (!C_.empty()) system_.pattern().multiply_add(1.0, C_, system_.rate(), rhs_);
  if (options_.damping > 0.0) system_.pattern().multiply_add(options_.damping, system_.mass(), system_.rate(), rhs_);
  damper_.add_force(1.0, system_.rate(), rhs_);
  if (spares_affine())
    for (std::size_t i = 0; i < d_.size(); ++i) rhs_[i] += affine[i];
}

StepReport Newmark::not_finite(const StepReport& report, const State& state, double h) const {
  const auto wrong = std::find_if(load_.begin(), load_.end(), [](double x) { return !std::isfinite(x); });
  if (wrong == load_.end()) return lost(report, lost_place(*setup_, q_new_), state, h);
  return lost(report, {system_.body_of(static_cast<std::int32_t>(wrong - load_.begin())), "a load is not finite"},
              state, h);
}

void Newmark::describe_imbalance(double left, StepReport& report) const {
  report.status = StepReport::Status::no_balance;
  const auto worst =
      std::max_element(out_.begin(), out_.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  report.body = system_.body_of(static_cast<std::int32_t>(worst - out_.begin()));
  report.cause = fmt::format(
      "Newton's method left {:.2g} of the largest force after {} iterations (a step that "
      "turns or strains a block too far?)",
      left, report.iterations);
}

void Newmark::move_to_iterate(const State& state) {
  q_new_ = state.q;
  v_new_ = state.v;
  system_.retract(d_, rate_, interface_.acts(), q_new_, v_new_);
}

void Newmark::begin_balance(const State& state, double h, NewtonLoop& loop) {
  find_step_springs(state, h);
  bolts_.begin(state, driven_move_, springs_);
  contacts_.begin(*list_, state.q, driven_move_, springs_, velocity_is_physical() ? 1.0 / h : 0.0, damper_.terms());
  // Newton's method starts from no displacement; a linear system from the displacement at constant velocity.
  for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = system_.nonlinear() ? 0.0 : h * system_.rate()[i];
  force_ = force_before_;
  if (interface_.acts()) begin_interface_iteration(state, h);
  if (keep_) contacts_.keep_matrix();
  loop.fresh = !keep_;
  loop.iterative = system_.nonlinear() || spares_affine() || interface_.acts() || bolts_.any();
  if (bolts_.any()) {
    (void)bolts_.evaluate(d_);
    (void)bolts_.linearise(springs_);
    contacts_.change_springs();
  }
  loop.affine.assign(d_.size(), 0.0);
  loop.moved.resize(d_.size());
  if (spares_affine()) add_affine_damping(state, system_.rate(), loop.affine);
  if (!keep_) linear_system(h);
}

bool Newmark::solve_iterate(const State& state, double h, NewtonLoop& loop, StepReport& report) {
  const auto mask = system_.nonlinear_dofs();
  for (;;) {
    for (std::size_t i = 0; i < d_.size(); ++i) loop.moved[i] = mask[i] * d_[i];
    find_right_side(loop.moved, loop.affine);
    (void)bolts_.add(d_, springs_, rhs_);
    if (contacts_.solve(A_, loop.fresh, rhs_, d_, report)) break;
    if (report.status != StepReport::Status::not_definite || loop.kind != Stiffness::exact || !system_.nonlinear())
      return false;
    report.status = StepReport::Status::ok;
    report.cause.clear();
    loop.kind = Stiffness::definite;  // the same force, with slower convergence
    q_new_ = state.q;
    v_new_ = state.v;
    system_.retract(loop.moved, rate_, false, q_new_, v_new_);
    (void)system_.linearise(q_new_, loop.kind, false, K_, force_);
    linear_system(h);
    loop.fresh = made_ = true;
    for (std::size_t i = 0; i < d_.size(); ++i) d_[i] = loop.moved[i];
    (void)bolts_.evaluate(d_);
  }
  ++report.iterations;
  loop.fresh = false;
  if (!loop.iterative && contacts_.find_left(out_)) {  // one solution is enough: reach() moves the bodies
    for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] = 2.0 / h * d_[i] - system_.rate()[i];
    damping_forces(state, rate_, damped_after_);
    loop.left = largest_of(out_);
    if (std::isfinite(loop.left)) return true;
    move_to_iterate(state);
    report = not_finite(report, state, h);
    return false;
  }
  return evaluate_iterate(state, h, loop, report);
}

bool Newmark::evaluate_iterate(const State& state, double h, NewtonLoop& loop, StepReport& report) {
  for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] = 2.0 / h * d_[i] - system_.rate()[i];
  move_to_iterate(state);
  force_after_ = force_before_;
  energy_after_ = system_.linearise(q_new_, loop.kind, false, {}, force_after_);
  force_ = force_after_;
  (void)bolts_.evaluate(d_);
  loop.left = residual(state, h, loop.largest);
  report.residual = loop.largest > 0.0 ? loop.left / loop.largest : 0.0;
  if (std::isfinite(loop.left)) return true;
  report = not_finite(report, state, h);
  return false;
}

bool Newmark::refine(const State& state, double h, NewtonLoop& loop, StepReport& report) {
  for (int k = 0; k < kRefinements && std::abs(dot(out_, d_)) > kWorkLeft * state.ledger.moved(); ++k) {
    contacts_.correct(out_, d_, report);
    if (!evaluate_iterate(state, h, loop, report)) return false;
  }
  return true;
}

Newmark::Settled Newmark::settle(const State& state, double h, NewtonLoop& loop, StepReport& report) {
  const RoundOff rounded = loop.iterative ? round_off(state) : RoundOff{};
  loop.at_round_off = loop.left <= rounded.system;
  const bool balanced = !loop.iterative || loop.left <= kBalanced * loop.largest,
             stays = loop.at_round_off && report.iterations > 2 && loop.left > 0.5 * loop.last,
             kicked = interface_.acts() &&
                      loop.left <= rounded.bodies;  // InterfaceIteration::kick() applies the impulse of the residual
  bool met = !interface_.acts();
  const double allowed = std::max(options_.together * largest_interface_force_, rounded.system);
  if (interface_.acts()) {
    const bool first = report.iterations == 1 && (balanced || kicked);
    met = !interface_.predict_where_useful(iterate(state), allowed, first);
    if (met && !evaluate_interface_force(state, report)) return Settled::failed;
  }
  if (loop.iterative && !interface_.acts() && (balanced || stays) && !refine(state, h, loop, report))
    return Settled::failed;
  loop.apart = 0.0;
  for (;; met = true) {
    if (interface_.acts()) loop.apart = interface_.residual(out_);
    if (loop.apart > allowed || !(balanced || stays || kicked)) return Settled::no;
    if (met) {
      report.at_round_off = !balanced;
      return Settled::yes;
    }
    if (!evaluate_interface_force(state, report)) return Settled::failed;
  }
}

void Newmark::prepare_iterate(const State& state, double h, NewtonLoop& loop) {
  if (interface_.acts()) interface_.next(iterate(state));
  if (bolts_.linearise(springs_)) {
    contacts_.change_springs();
    loop.fresh = true;
  }
  // A kept stiffness that is too far from this iterate's is computed anew.
  if (system_.nonlinear() && loop.left > 0.05 * loop.last && !loop.at_round_off) {
    (void)system_.linearise(q_new_, loop.kind, false, K_, force_);
    linear_system(h);
    loop.fresh = made_ = true;
  }
  if (spares_affine()) {
    std::fill(loop.affine.begin(), loop.affine.end(), 0.0);
    for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] = 2.0 / h * d_[i] - system_.rate()[i];
    add_affine_damping(state, rate_, loop.affine);
  }
  loop.last = loop.left;
}

bool Newmark::balance(const State& state, double h, StepReport& report) {
  NewtonLoop loop;
  begin_balance(state, h, loop);
  for (;;) {
    if (!solve_iterate(state, h, loop, report)) return false;
    if (const Settled settled = settle(state, h, loop, report); settled != Settled::no) return settled == Settled::yes;
    const int most = !made_              ? tangent_.least + kMoreIterations
                     : interface_.acts() ? kIterations + FixedPoint::kPatience
                                         : kIterations;
    if (report.iterations >= most ||
        (report.iterations > 8 && loop.left > 1e3 * loop.last && loop.left > kBalanced * loop.largest)) {
      describe_imbalance(std::max(report.residual, loop.apart / loop.largest), report);
      return false;
    }
    prepare_iterate(state, h, loop);
  }
}

}  // namespace scree::coupling
