// A term of low rank beside a sparse matrix.
#pragma once

#include <Eigen/Core>
#include <cstddef>

namespace scree::coupling {

/// -Z W Z^T on successive unknowns, Z of three columns of `count` numbers.
struct LowRank {
  std::size_t first = 0, count = 0;
  const double* Z = nullptr;
  Eigen::Matrix3d W = Eigen::Matrix3d::Zero();
};

}  // namespace scree::coupling
