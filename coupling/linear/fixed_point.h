// Fixed-point iteration sped up by the differences of earlier iterates.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace scree::coupling {

/// Anderson's method for x = T(x): the next iterate is the answer T to that combination of earlier iterates whose
/// residual T(x) - x is least. On linear maps it takes as many iterations as GMRES, without a derivative of T.
/// @source [Anderson1965]; as interface quasi-Newton least squares: [Degroote2009]
class FixedPoint {
 public:
  /// Forgets earlier iterates.   @param unit  residuals are measured divided by it; must outlive the iteration
  void begin(std::span<const double> unit);
  /// @param answer  T(x)   @param x  the iterate x; becomes the next
  void next(std::span<const double> answer, std::span<double> x);

 private:
  static constexpr Eigen::Index kMost = 12;  // differences kept
  std::span<const double> unit_;
  std::vector<double> last_answer_, last_residual_;
  Eigen::MatrixXd answers_, residuals_;  // one column per difference, the newest last
  Eigen::Index count_ = 0;
};

}  // namespace scree::coupling
