// Implicit steps with an interface force: the first guess of their iteration, and the tangent that they keep.
#include <Eigen/LU>
#include <algorithm>

#include "coupling/integrate/newmark.h"

namespace scree::coupling {

void Newmark::begin_interface_iteration(const State& state, double h) {
  // The iteration starts from the motion of the last step. Where interface constraints act it starts from rest: gaps
  // that are left at the constraints add up over the steps, and iterations from a farther start end with smaller ones.
  // For the same reason they do not use the iterates of earlier steps: errors in the halves' gaps would be continued.
  const bool goes_on = !interface_.constrained();
  acceleration_.resize(d_.size());
  system_.accelerations(state.q, state.a, acceleration_);
  for (std::size_t i = 0; i < d_.size(); ++i) {
    d_[i] = h * system_.rate()[i];
    if (goes_on) d_[i] += 0.5 * h * h * acceleration_[i];
  }
  plain_start_ = d_;
  if (goes_on && !renewed_ && start_.step != 0 && seconds(start_.step) == h)
    for (std::size_t i = 0; i < d_.size(); ++i)
      d_[i] += start_.part[0] * start_.lacked[0][i] + start_.part[1] * start_.lacked[1][i];
  move_to_iterate(state);
  interface_.begin(iterate(state), goes_on && !renewed_);
  if (!system_.nonlinear()) return;
  if (goes_on)
    (void)system_.linearise(q_new_, Stiffness::exact, false, {}, force_);
  else
    std::fill(d_.begin(), d_.end(), 0.0);
}

bool Newmark::evaluate_interface_force(const State& state, StepReport& report) {
  const StepReport found = interface_.evaluate(iterate(state));
  if (found.status == StepReport::Status::ok) return true;
  report.status = found.status;
  report.suggested = found.suggested;
  report.body = found.body;
  report.cause = found.cause;
  return false;
}

IntegratorMemory Newmark::lend() {
  IntegratorMemory out;
  std::swap(tangent_, out.tangent);
  std::swap(start_, out.start);
  std::swap(interface_.kept(), out.iterates);
  return out;
}

void Newmark::take_back(IntegratorMemory& memory) {
  std::swap(tangent_, memory.tangent);
  std::swap(start_, memory.start);
  std::swap(interface_.kept(), memory.iterates);
}

void Newmark::take_tangent(const State& state, double h) {
  K_ = tangent_.stiffness;
  linear_system(h);
  contacts_.enter(state.factored);
  has_tangent_ = true;
}

void Newmark::keep_for_next_step(Tick ticks_of_step, int iterations) {
  // An iteration costs about half of a new tangent with its factor.
  constexpr std::int32_t kPays = 2;
  const bool may_stay = tangent_may_stay_ && !interface_.constrained() && !damper_.acts() && list_->points.empty() &&
                        dashpots_.empty() && !bolts_.any();
  has_end_ = may_stay;
  if (!may_stay) {
    tangent_.step = 0;
  } else if (made_) {
    tangent_ = {ticks_of_step, iterations, 0, K_};
    has_tangent_ = true;
  } else {
    tangent_.excess += std::max(0, iterations - tangent_.least);
    tangent_.least = std::min(tangent_.least, iterations);
    if (tangent_.excess >= kPays) tangent_.step = 0;
  }

  interface_.accept();

  // The combination of the differences between solution and first guess in the last two steps that is nearest to the
  // difference in this one, by least squares. The next step corrects its first guess by the same combination.
  auto& [last, before] = start_.lacked;
  if (start_.step != ticks_of_step) last.clear();
  start_.step = ticks_of_step;
  last.resize(d_.size(), 0.0);
  before.resize(d_.size(), 0.0);
  Mat2 products = Mat2::Zero();
  Vec2 right = Vec2::Zero();
  for (std::size_t i = 0; i < d_.size(); ++i) {
    const double unit = system_.unit()[i];
    const Vec2 known = unit * Vec2(last[i], before[i]);
    products += known * known.transpose();
    right += unit * (d_[i] - plain_start_[i]) * known;
    before[i] = d_[i] - plain_start_[i];
  }
  before.swap(last);
  const double determinant = products.determinant();
  const Vec2 part = determinant > 1e-6 * products(0, 0) * products(1, 1) ? Vec2(products.inverse() * right)
                    : products(0, 0) > 0.0                               ? Vec2(right.x() / products(0, 0), 0.0)
                                                                         : Vec2(0.0, 0.0);
  start_.part = {part.x(), part.y()};
}

}  // namespace scree::coupling
