#include "coupling/linear/fixed_point.h"

#include <Eigen/QR>

namespace scree::coupling {

void FixedPoint::begin(std::span<const double> unit) {
  unit_ = unit;
  last_answer_.clear();
  count_ = 0;
}

void FixedPoint::next(std::span<const double> answer, std::span<double> x) {
  const auto n = static_cast<Eigen::Index>(x.size());
  const Eigen::Map<const Eigen::ArrayXd> unit(unit_.data(), n);
  const Eigen::Map<const Eigen::VectorXd> t(answer.data(), n);
  Eigen::Map<Eigen::VectorXd> iterate(x.data(), n);
  const Eigen::VectorXd residual = (t - iterate).array() / unit;
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
    residuals_.col(count_) = residual - Eigen::Map<const Eigen::VectorXd>(last_residual_.data(), n);
    ++count_;
  }
  last_answer_.assign(answer.begin(), answer.end());
  last_residual_.assign(residual.data(), residual.data() + n);
  iterate = t;
  if (count_ == 0) return;
  // The rank of the decomposition leaves out directions that hardly differ.
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(residuals_.leftCols(count_));
  qr.setThreshold(1e-10);
  const Eigen::VectorXd gamma = qr.solve(residual);
  iterate.noalias() -= answers_.leftCols(count_) * gamma;
}

}  // namespace scree::coupling
