#include "coupling/interface/interface_iteration.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "coupling/linear/vectors.h"

namespace scree::coupling {
namespace {

constexpr double kLittle = 0.5;  // of the mismatch allowed

}  // namespace

void InterfaceIteration::set(InterfaceForce* force) {
  force_ = force;
  fixed_point_.forget();
  for (auto* v : {&mean_, &predicted_unknowns_force_, &mismatch_, &kick_, &predictor_, &predictor_error_,
                  &evaluated_at_, &impulse_})
    v->assign(force == nullptr ? 0 : static_cast<std::size_t>(system_->dofs()), 0.0);
}

void InterfaceIteration::add_springs(std::span<const double> q, std::span<const Vec2> driven_move,
                                     StepSprings& springs) {
  springs_ = &springs;
  const auto begin = [&](double k) {
    springs.rows.begin_row();
    springs.k.push_back(k);
    springs.at.push_back(0.0);
  };
  const auto add = [&](BodyIndex body, const Row& row, const Vec2& direction) {
    if (setup_->body(body).driven)
      springs.rows.add_known(direction.dot(driven_move[body.index()]));
    else
      ImplicitSystem::add_point(system_->chart(body, row, q), direction, springs.rows);
  };
  first_spring_ = springs.size();
  for (const InterfaceForce::Spring& s : force_->springs()) {
    begin(s.k);
    for (std::size_t i = 0; i < s.count; ++i)
      add(setup_->outlines().node_body[s.node[i]], setup_->outlines().nodes[s.node[i]], s.direction[i]);
  }
  first_constraint_spring_ = springs.size();
  const std::span<const InterfaceForce::InterfaceConstraint> constraints = force_->interface_constraints();
  const std::span<const double> factor = force_->constraint_factor();
  const std::array<Vec2, 2> axes{Vec2(1.0, 0.0), Vec2(0.0, 1.0)};
  rows_.clear();
  for (const InterfaceForce::InterfaceConstraint& s : constraints)
    for (const Vec2& axis : axes) {
      rows_.begin_row();
      ImplicitSystem::add_point(system_->chart(s.body, s.row, q), axis, rows_);
    }
  for (std::size_t j = 0; j < constraints.size(); ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      const double first = factor[j * constraints.size() + j];
      begin(first * first);
      for (std::size_t i = j; i < constraints.size(); ++i)
        add(constraints[i].body, constraints[i].row, factor[j * constraints.size() + i] / first * axes[d]);
    }
}

void InterfaceIteration::subtract_constraint_forces(std::span<const double> half, std::span<double> out) const {
  const std::size_t n = half.size() / 2;
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = j; i < n; ++i)
      for (std::size_t d = 0; d < 2; ++d) out[2 * i + d] -= force_->constraint_factor()[j * n + i] * half[2 * j + d];
}

void InterfaceIteration::sum_predicted() {
  const std::size_t n = predicted_unknowns_force_.size();
  std::copy_n(predicted_.begin(), n, predicted_unknowns_force_.begin());
  for (std::size_t i = 0; i < rows_.size(); ++i) rows_[i].add_force(predicted_[n + i], predicted_unknowns_force_);
}

void InterfaceIteration::find_along(std::span<const double> d) {
  for (std::size_t k = 0; k < along_.size(); ++k)
    along_[k] =
        std::sqrt(springs_->k[first_constraint_spring_ + k]) * springs_->rows[first_constraint_spring_ + k].change(d);
}

void InterfaceIteration::begin(const Iterate& at, bool use_kept) {
  const std::size_t n = at.d.size();
  predicted_.assign(n + rows_.size(), 0.0);
  corrected_.assign(predicted_.size(), 0.0);
  held_.assign(force_->held().begin(), force_->held().end());
  apart_.resize(held_.size());
  along_.resize(held_.size());
  units_.assign(predicted_.size(), 1.0);
  std::copy(system_->unit().begin(), system_->unit().end(), units_.begin());
  fixed_point_.begin(units_, use_kept);
  std::fill(predictor_error_.begin(), predictor_error_.end(), 0.0);
  foreseen_ = unforeseen_ = false;
  if (!predict(at)) {
    nodes_.assign(force_->present().begin(), force_->present().end());
    apply(at);
  }
  std::copy_n(corrected_.begin(), n, predicted_.begin());
  const auto held = std::span(predicted_).subspan(n);
  find_along(at.d);
  for (double& a : along_) a = -a;
  std::copy(held_.begin(), held_.end(), held.begin());
  subtract_constraint_forces(along_, held);
  sum_predicted();
}

double InterfaceIteration::largest_change(std::span<const double> d) const {
  double farthest = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i)
    farthest = std::max(farthest, system_->unit()[i] * std::abs(d[i] - evaluated_at_[i]));
  return farthest;
}

void InterfaceIteration::apply(const Iterate& at) {
  std::copy(at.d.begin(), at.d.end(), evaluated_at_.begin());
  std::fill(mean_.begin(), mean_.end(), 0.0);
  system_->add_forces(nodes_, at.start, mean_);
  std::copy(mean_.begin(), mean_.end(), corrected_.begin());
  for (std::size_t i = first_spring_; i < first_constraint_spring_; ++i)
    springs_->rows[i].add_force(springs_->k[i] * springs_->rows[i].change(at.d), corrected_);
}

bool InterfaceIteration::predict(const Iterate& at) {
  nodes_.assign(at.start.size(), 0.0);
  if (!force_->foresee(at.end, nodes_)) return false;
  apply(at);
  for (std::size_t i = 0; i < mean_.size(); ++i) {
    mean_[i] += predictor_error_[i];
    corrected_[i] += predictor_error_[i];
  }
  foreseen_ = true;
  return true;
}

bool InterfaceIteration::predict_where_useful(const Iterate& at, double allowed, bool first) {
  const double moved = largest_change(at.d);
  if (moved * force_->stiffness() <= allowed) return false;
  if (!first || moved * force_->largest_stiffness() > kLittle * allowed) return predict(at);
  foreseen_ = false;  // the prediction was for another place: its difference to the evaluation is no error
  unforeseen_ = true;
  return false;
}

void InterfaceIteration::find_predictor_error(const Iterate& at) {
  // Predictions of later iterates must be consistent with what was evaluated at this one.
  predictor_ = mean_;
  evaluated_ = corrected_;
  if (predict(at))
    for (std::size_t i = 0; i < mean_.size(); ++i) predictor_error_[i] += predictor_[i] - mean_[i];
  mean_ = predictor_;
  corrected_ = evaluated_;
  foreseen_ = false;
}

StepReport InterfaceIteration::evaluate(const Iterate& at) {
  const bool foreseen = std::exchange(foreseen_, false);
  if (foreseen) predictor_ = mean_;
  nodes_.assign(at.start.size(), 0.0);
  // The constraint forces with which the balance was computed.
  const auto predicted = std::span(predicted_).subspan(at.d.size());
  find_along(at.d);
  std::copy(predicted.begin(), predicted.end(), held_.begin());
  subtract_constraint_forces(along_, held_);
  StepReport report = force_->mean(at.end, held_, nodes_, apart_);
  if (report.status != StepReport::Status::ok) return report;
  apply(at);
  if (foreseen && mean_ != predictor_) {
    for (std::size_t i = 0; i < mean_.size(); ++i) predictor_error_[i] += mean_[i] - predictor_[i];
    fixed_point_.restart();
  }
  const auto corrected = std::span(corrected_).subspan(at.d.size());
  std::copy(predicted.begin(), predicted.end(), corrected.begin());
  const std::size_t count = force_->interface_constraints().size();
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0.0;
      for (std::size_t i = j; i < count; ++i) sum += force_->constraint_factor()[j * count + i] * apart_[2 * i + d];
      along_[2 * j + d] = sum;
    }
  subtract_constraint_forces(along_, corrected);
  return report;
}

double InterfaceIteration::residual(std::span<const double> left) {
  double apart = 0.0;
  for (std::size_t i = 0; i < predicted_.size(); ++i) apart = std::max(apart, std::abs(corrected_[i] - predicted_[i]));
  for (std::size_t i = 0; i < left.size(); ++i) mismatch_[i] = corrected_[i] - predicted_[i] + left[i];
  return apart;
}

void InterfaceIteration::next(const Iterate& at) {
  if (std::exchange(unforeseen_, false)) find_predictor_error(at);
  fixed_point_.next(corrected_, predicted_);
  sum_predicted();
}

double InterfaceIteration::largest() const { return std::max(largest_of(mean_), largest_of(held_)); }

void InterfaceIteration::kick(double h, std::span<double> rate) {
  if (!system_->constant_charts() || !mass_made_) {
    if (!mass_made_) mass_factor_.set_pattern(system_->pattern());
    mass_made_ = mass_factor_.factorise(system_->mass(), DofRows(), {});
  }
  for (std::size_t i = 0; i < rate.size(); ++i) impulse_[i] = h * mismatch_[i];
  mass_factor_.solve(impulse_, kick_);
  for (std::size_t i = 0; i < rate.size(); ++i) rate[i] += kick_[i];
}

void InterfaceIteration::book(const Iterate& at, double h, std::span<const double> rate, Ledger& ledger) const {
  // The force acted along straight lines of the nodes; the step's equations have its work in their unknowns.
  double along = 0.0;
  for (std::size_t i = 0; i < nodes_.size(); ++i) along += nodes_[i] * (at.end[i] - at.start[i]);
  ledger.book(Column::update_contact, dot(mean_, at.d) - along);
  for (std::size_t i = 0; i < rows_.size(); ++i)
    ledger.book(Column::interface_constraints, held_[i] * rows_[i].change(at.d));
  // The impulse J does the work J.v - J.dv/2, v the velocity after it, dv its change; the mismatch did no work before.
  ledger.book(Column::waveform, h * (dot(mismatch_, rate) - 0.5 * dot(mismatch_, kick_)) - dot(mismatch_, at.d));
}

}  // namespace scree::coupling
