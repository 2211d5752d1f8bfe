// The interface force in an implicit step: its prediction, its evaluation, and the impulse of the remaining residual.
#include <algorithm>
#include <cmath>

#include "coupling/integrate/newmark.h"

namespace scree::coupling {

void Newmark::subtract_constraint_forces(std::span<const double> half, std::span<double> out) const {
  const std::size_t n = half.size() / 2;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i)
      for (std::size_t d = 0; d < 2; ++d)
        out[2 * i + d] -= interface_->constraint_factor()[j * n + i] * half[2 * j + d];
}

void Newmark::sum_predicted() {
  std::copy_n(predicted_.begin(), predicted_unknowns_force_.size(), predicted_unknowns_force_.begin());
  for (std::size_t i = 0; i < constraint_rows_.size(); ++i)
    constraint_rows_[i].add_force(predicted_[d_.size() + i], predicted_unknowns_force_);
}

void Newmark::find_along(std::span<const double> d) {
  for (std::size_t k = 0; k < along_.size(); ++k)
    along_[k] = std::sqrt(springs_.k[constraint_springs_ + k]) * springs_.rows[constraint_springs_ + k].change(d);
}

void Newmark::begin_interface_iteration(const State& state, double h) {
  // The iteration starts from the motion of the last step. Where interface constraints act it starts from rest: gaps
  // that are left at the constraints add up over the steps, and iterations from a farther start end with smaller ones.
  const bool goes_on = constraint_rows_.size() == 0;
  const std::size_t n = d_.size();
  predicted_.assign(n + constraint_rows_.size(), 0.0);
  corrected_.assign(predicted_.size(), 0.0);
  held_.assign(interface_->held().begin(), interface_->held().end());
  apart_.resize(held_.size());
  along_.resize(held_.size());
  units_.assign(predicted_.size(), 1.0);
  std::copy(system_.unit().begin(), system_.unit().end(), units_.begin());
  interface_iteration_.begin(units_);
  system_.accelerations(state.q, state.a, acceleration_);
  for (std::size_t i = 0; i < n; ++i) {
    d_[i] = h * system_.rate()[i];
    if (goes_on) d_[i] += 0.5 * h * h * acceleration_[i];
  }
  move_to_iterate(state);
  std::fill(predictor_error_.begin(), predictor_error_.end(), 0.0);
  if (!predict_interface_force(state)) {
    interface_nodes_.assign(interface_->present().begin(), interface_->present().end());
    apply_interface_force(state);
  }
  std::copy_n(corrected_.begin(), n, predicted_.begin());
  const auto held = std::span(predicted_).subspan(n);
  find_along(d_);
  for (double& a : along_) a = -a;
  std::copy(held_.begin(), held_.end(), held.begin());
  subtract_constraint_forces(along_, held);
  sum_predicted();
  if (!system_.nonlinear()) return;
  if (goes_on)
    (void)system_.linearise(q_new_, Stiffness::exact, false, {}, force_);
  else
    std::fill(d_.begin(), d_.end(), 0.0);
}

void Newmark::move_to_iterate(const State& state) {
  q_new_ = state.q;
  v_new_ = state.v;
  system_.retract(d_, rate_, interface_ != nullptr, q_new_, v_new_);
}

double Newmark::largest_change_since_interface_force() const {
  double farthest = 0.0;
  for (std::size_t i = 0; i < d_.size(); ++i)
    farthest = std::max(farthest, system_.unit()[i] * std::abs(d_[i] - interface_force_at_[i]));
  return farthest;
}

void Newmark::apply_interface_force(const State& state) {
  interface_force_at_ = d_;
  std::fill(interface_force_.begin(), interface_force_.end(), 0.0);
  system_.add_forces(interface_nodes_, state.q, interface_force_);
  std::copy(interface_force_.begin(), interface_force_.end(), corrected_.begin());
  for (std::size_t i = interface_springs_; i < constraint_springs_; ++i)
    springs_.rows[i].add_force(springs_.k[i] * springs_.rows[i].change(d_), corrected_);
}

bool Newmark::predict_interface_force(const State& state) {
  interface_nodes_.assign(state.q.size(), 0.0);
  if (!interface_->foresee(q_new_, interface_nodes_)) return false;
  apply_interface_force(state);
  for (std::size_t i = 0; i < interface_force_.size(); ++i) {
    interface_force_[i] += predictor_error_[i];
    corrected_[i] += predictor_error_[i];
  }
  return true;
}

bool Newmark::evaluate_interface_force(const State& state, bool foreseen, StepReport& report) {
  if (foreseen) predictor_ = interface_force_;
  interface_nodes_.assign(state.q.size(), 0.0);
  // The constraint forces with which the balance was computed.
  const auto predicted = std::span(predicted_).subspan(d_.size());
  find_along(d_);
  std::copy(predicted.begin(), predicted.end(), held_.begin());
  subtract_constraint_forces(along_, held_);
  const StepReport found = interface_->mean(q_new_, held_, interface_nodes_, apart_);
  if (found.status != StepReport::Status::ok) {
    report.status = found.status;
    report.suggested = found.suggested;
    report.body = found.body;
    report.cause = found.cause;
    return false;
  }
  apply_interface_force(state);
  if (foreseen && interface_force_ != predictor_) {
    for (std::size_t i = 0; i < interface_force_.size(); ++i)
      predictor_error_[i] += interface_force_[i] - predictor_[i];
    interface_iteration_.begin(units_);  // earlier values belong to another prediction
  }
  const auto corrected = std::span(corrected_).subspan(d_.size());
  std::copy(predicted.begin(), predicted.end(), corrected.begin());
  const std::size_t count = interface_->interface_constraints().size();
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0.0;
      for (std::size_t i = j; i < count; ++i) sum += interface_->constraint_factor()[j * count + i] * apart_[2 * i + d];
      along_[2 * j + d] = sum;
    }
  subtract_constraint_forces(along_, corrected);
  return true;
}

double Newmark::interface_residual() {
  // Interface force at the iterate less the one with which the balance was computed, and the residual of that balance.
  double apart = 0.0;
  for (std::size_t i = 0; i < predicted_.size(); ++i) apart = std::max(apart, std::abs(corrected_[i] - predicted_[i]));
  for (std::size_t i = 0; i < d_.size(); ++i) mismatch_[i] = corrected_[i] - predicted_[i] + out_[i];
  return apart;
}

void Newmark::kick(double h) {
  if (!system_.constant_charts() || !mass_made_) {
    if (!mass_made_) mass_factor_.set_pattern(system_.pattern());
    mass_made_ = mass_factor_.factorise(system_.mass(), DofRows(), {});
  }
  for (std::size_t i = 0; i < d_.size(); ++i) out_[i] = h * mismatch_[i];
  mass_factor_.solve(out_, kick_);
  for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] += kick_[i];
}

}  // namespace scree::coupling
