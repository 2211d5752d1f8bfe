#include "coupling/linear/fixed_point.h"

#include <algorithm>
#include <utility>

namespace scree::coupling {
namespace {

// Part of a difference that must be no combination of newer ones. Of earlier iterations, whose maps were others,
// smaller parts do more harm than good: with 1e-2 steps of stiff stacks fail to converge.
constexpr double kOfIteration = 1e-4, kOfEarlier = 0.05;

}  // namespace

void FixedPoint::begin(std::span<const double> unit, bool use_kept) {
  unit_ = unit;
  uses_kept_ = use_kept && kept_.answers.size() == static_cast<std::size_t>(kept_.count) * unit.size();
  last_answer_.clear();
  count_ = 0;
  iterates_ = 0;
}

void FixedPoint::take_difference(std::span<const double> answer) {
  const auto n = static_cast<Eigen::Index>(answer.size());
  const Eigen::Map<const Eigen::VectorXd> t(answer.data(), n);
  if (!last_answer_.empty()) {
    if (answers_.rows() != n) {
      answers_.resize(n, kMost);
      residuals_.resize(n, kMost);
    }
    if (count_ == kMost) {
      for (Eigen::Index k = 0; k + 1 < kMost; ++k) {
        answers_.col(k) = answers_.col(k + 1);
        residuals_.col(k) = residuals_.col(k + 1);
      }
      --count_;
    }
    answers_.col(count_) = t - Eigen::Map<const Eigen::VectorXd>(last_answer_.data(), n);
    residuals_.col(count_) = residual_ - Eigen::Map<const Eigen::VectorXd>(last_residual_.data(), n);
    ++count_;
  }
  last_answer_.assign(answer.begin(), answer.end());
  last_residual_.assign(residual_.data(), residual_.data() + n);
}

void FixedPoint::apply(const double* answer, const double* residual, double least,
                       Eigen::Map<Eigen::VectorXd> iterate) {
  if (rank_ == kMost) return;
  auto base = base_.col(rank_), step = step_.col(rank_);
  base = Eigen::Map<const Eigen::VectorXd>(residual, base.size());
  step = Eigen::Map<const Eigen::VectorXd>(answer, step.size());
  const double whole = base.norm();
  for (int twice = 0; twice < 2; ++twice)  // once would leave round-off that is not orthogonal
    for (Eigen::Index k = 0; k < rank_; ++k) {
      const double along = base_.col(k).dot(base);
      base -= along * base_.col(k);
      step -= along * step_.col(k);
    }
  const double rest = base.norm();
  if (!(rest > least * whole)) return;
  base /= rest;
  step /= rest;
  const double along = base.dot(left_);
  left_ -= along * base;
  iterate -= along * step;
  ++rank_;
}

void FixedPoint::next(std::span<const double> answer, std::span<double> x) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::ArrayXd> unit(unit_.data(), n);
  const Eigen::Map<const Eigen::VectorXd> t(answer.data(), n);
  const Eigen::Map<Eigen::VectorXd> iterate(x.data(), n);
  residual_ = (t - iterate).array() / unit;
  take_difference(answer);
  uses_kept_ = uses_kept_ && ++iterates_ <= kPatience;
  Eigen::Map<Eigen::VectorXd>(x.data(), n) = t;
  if (count_ == 0 && (!uses_kept_ || kept_.count == 0)) return;
  if (base_.rows() != n) {
    base_.resize(n, kMost);
    step_.resize(n, kMost);
  }
  left_ = residual_;
  rank_ = 0;
  for (Eigen::Index k = count_; k-- > 0;)
    apply(answers_.col(k).data(), residuals_.col(k).data(), kOfIteration, iterate);
  if (!uses_kept_) return;
  for (std::size_t k = static_cast<std::size_t>(kept_.count); k-- > 0;)
    apply(&kept_.answers[k * x.size()], &kept_.residuals[k * x.size()], kOfEarlier, iterate);
}

void FixedPoint::accept() {
  const std::size_t n = unit_.size(),
                    most = std::min(static_cast<std::size_t>(kMost), kMostKept / std::max<std::size_t>(1, n));
  if (!uses_kept_) kept_ = {};
  const auto made = static_cast<std::size_t>(std::exchange(count_, 0));
  const std::size_t fresh = std::min(made, most), had = static_cast<std::size_t>(kept_.count),
                    stay = std::min(had, most - fresh);
  if (fresh == 0) return;
  const auto keep = [&](std::vector<double>& all, const Eigen::MatrixXd& of_iteration) {
    all.erase(all.begin(), all.begin() + static_cast<std::ptrdiff_t>((had - stay) * n));
    const double* first = of_iteration.col(static_cast<Eigen::Index>(made - fresh)).data();
    all.insert(all.end(), first, first + fresh * n);
  };
  keep(kept_.answers, answers_);
  keep(kept_.residuals, residuals_);
  kept_.count = static_cast<std::int32_t>(stay + fresh);
}

}  // namespace scree::coupling
