// GMRES of an operator that is known by what it does to a vector.
#pragma once

#include <Eigen/Core>
#include <functional>

namespace scree::coupling {

using Operator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// Solves A x = b, A x = apply(x), not symmetric, beginning at x = 0 (Eigen's GMRES, restarted after 100 vectors).
/// @param tolerance  of |A x - b| over |b|
/// @return false if it is not reached in 500 applications; x is the best found
[[nodiscard]] bool gmres(const Operator& apply, const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd& x);

}  // namespace scree::coupling
