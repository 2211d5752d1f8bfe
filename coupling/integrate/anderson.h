// Anderson acceleration of a fixed-point iteration x = g(x); for a linear g it is GMRES.
#pragma once

#include <Eigen/Dense>
#include <vector>

namespace scree::coupling {

class Anderson {
 public:
  explicit Anderson(int window) : window_(window) {}
  void reset() {
    x_.clear();
    r_.clear();
  }
  /// Next iterate from x and g = g(x).
  Eigen::VectorXd next(const Eigen::VectorXd& x, const Eigen::VectorXd& g) {
    const Eigen::VectorXd r = g - x;
    Eigen::VectorXd out = g;
    const auto m = static_cast<Eigen::Index>(x_.size());
    if (m > 0) {
      Eigen::MatrixXd dr(x.size(), m), dx(x.size(), m);
      for (Eigen::Index j = 0; j < m; ++j) {
        dr.col(j) = r - r_[static_cast<std::size_t>(j)];
        dx.col(j) = x - x_[static_cast<std::size_t>(j)];
      }
      const Eigen::VectorXd c = dr.completeOrthogonalDecomposition().solve(r);
      out = x + r - (dx + dr) * c;
    }
    x_.push_back(x);
    r_.push_back(r);
    if (static_cast<int>(x_.size()) > window_) {
      x_.erase(x_.begin());
      r_.erase(r_.begin());
    }
    return out;
  }

 private:
  int window_;
  std::vector<Eigen::VectorXd> x_, r_;
};

}  // namespace scree::coupling
