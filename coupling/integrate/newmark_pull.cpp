// The force from outside in an implicit step: foreseen, met, and what is left of it given as a kick.
#include <algorithm>
#include <cmath>

#include "coupling/integrate/newmark.h"

namespace scree::coupling {

void Newmark::take_seams(std::span<const double> half, std::span<double> out) const {
  const std::size_t n = half.size() / 2;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i)
      for (std::size_t d = 0; d < 2; ++d) out[2 * i + d] -= path_->seam_factor()[j * n + i] * half[2 * j + d];
}

void Newmark::sum_asked() {
  std::copy_n(asked_.begin(), asked_forces_.size(), asked_forces_.begin());
  for (std::size_t i = 0; i < seam_rows_.size(); ++i) seam_rows_[i].add_force(asked_[d_.size() + i], asked_forces_);
}

void Newmark::find_along(std::span<const double> d) {
  for (std::size_t k = 0; k < along_.size(); ++k)
    along_[k] = std::sqrt(springs_.k[seams_ + k]) * springs_.rows[seams_ + k].change(d);
}

void Newmark::begin_pull(const State& state, double h) {
  // To begin with both sides go on as they did in the last step; where seams hold them, as they are: what seams are
  // apart in the end adds up over the steps, and iterations from farther off end nearer.
  const bool goes_on = seam_rows_.size() == 0;
  const std::size_t n = d_.size();
  asked_.assign(n + seam_rows_.size(), 0.0);
  answer_.assign(asked_.size(), 0.0);
  held_.assign(path_->held().begin(), path_->held().end());
  apart_.resize(held_.size());
  along_.resize(held_.size());
  units_.assign(asked_.size(), 1.0);
  std::copy(system_.unit().begin(), system_.unit().end(), units_.begin());
  pull_iteration_.begin(units_);
  system_.accelerations(state.q, state.a, acceleration_);
  for (std::size_t i = 0; i < n; ++i) {
    d_[i] = h * system_.rate()[i];
    if (goes_on) d_[i] += 0.5 * h * h * acceleration_[i];
  }
  move_to_iterate(state);
  std::fill(unforeseen_.begin(), unforeseen_.end(), 0.0);
  if (!foresee_pull(state)) {
    pull_nodes_.assign(path_->present().begin(), path_->present().end());
    take_pull(state);
  }
  std::copy_n(answer_.begin(), n, asked_.begin());
  const auto held = std::span(asked_).subspan(n);
  find_along(d_);
  for (double& a : along_) a = -a;
  std::copy(held_.begin(), held_.end(), held.begin());
  take_seams(along_, held);
  sum_asked();
  if (!system_.nonlinear()) return;
  if (goes_on)
    (void)system_.linearise(q_new_, Stiffness::exact, false, {}, force_);
  else
    std::fill(d_.begin(), d_.end(), 0.0);
}

void Newmark::move_to_iterate(const State& state) {
  q_new_ = state.q;
  v_new_ = state.v;
  system_.retract(d_, rate_, path_ != nullptr, q_new_, v_new_);
}

double Newmark::way_since_pull() const {
  double farthest = 0.0;
  for (std::size_t i = 0; i < d_.size(); ++i)
    farthest = std::max(farthest, system_.unit()[i] * std::abs(d_[i] - pulled_at_[i]));
  return farthest;
}

void Newmark::take_pull(const State& state) {
  pulled_at_ = d_;
  std::fill(pull_.begin(), pull_.end(), 0.0);
  system_.add_forces(pull_nodes_, state.q, pull_);
  std::copy(pull_.begin(), pull_.end(), answer_.begin());
  for (std::size_t i = guides_; i < seams_; ++i)
    springs_.rows[i].add_force(springs_.k[i] * springs_.rows[i].change(d_), answer_);
}

bool Newmark::foresee_pull(const State& state) {
  pull_nodes_.assign(state.q.size(), 0.0);
  if (!path_->foresee(q_new_, pull_nodes_)) return false;
  take_pull(state);
  for (std::size_t i = 0; i < pull_.size(); ++i) {
    pull_[i] += unforeseen_[i];
    answer_[i] += unforeseen_[i];
  }
  return true;
}

bool Newmark::meet_pull(const State& state, bool foreseen, StepReport& report) {
  if (foreseen) foreseen_ = pull_;
  pull_nodes_.assign(state.q.size(), 0.0);
  // The balance was made with these forces of the seams.
  const auto asked = std::span(asked_).subspan(d_.size());
  find_along(d_);
  std::copy(asked.begin(), asked.end(), held_.begin());
  take_seams(along_, held_);
  const StepReport found = path_->mean(q_new_, held_, pull_nodes_, apart_);
  if (found.status != StepReport::Status::ok) {
    report.status = found.status;
    report.suggested = found.suggested;
    report.body = found.body;
    report.cause = found.cause;
    return false;
  }
  take_pull(state);
  if (foreseen && pull_ != foreseen_) {
    for (std::size_t i = 0; i < pull_.size(); ++i) unforeseen_[i] += pull_[i] - foreseen_[i];
    pull_iteration_.begin(units_);  // earlier answers were others
  }
  const auto answer = std::span(answer_).subspan(d_.size());
  std::copy(asked.begin(), asked.end(), answer.begin());
  const std::size_t seams = path_->seams().size();
  for (std::size_t j = 0; j < seams; ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0.0;
      for (std::size_t i = j; i < seams; ++i) sum += path_->seam_factor()[j * seams + i] * apart_[2 * i + d];
      along_[2 * j + d] = sum;
    }
  take_seams(along_, answer);
  return true;
}

double Newmark::pulls_apart() {
  // What the other side pulls by now, less what the balance was made with; and what that left.
  double apart = 0.0;
  for (std::size_t i = 0; i < asked_.size(); ++i) apart = std::max(apart, std::abs(answer_[i] - asked_[i]));
  for (std::size_t i = 0; i < d_.size(); ++i) mismatch_[i] = answer_[i] - asked_[i] + out_[i];
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
