#include "coupling/linear/block_ilu.h"

#include <Eigen/LU>
#include <cmath>

namespace scree::coupling {
namespace {

FloatBlock rounded(const double* block) {
  FloatBlock out;
  for (int j = 0; j < kBlockSide; ++j) {
    out.column[j] = FloatColumn{};
    for (int i = 0; i < kBlockSide; ++i) out.column[j][i] = static_cast<float>(block[kBlockSide * j + i]);
  }
  return out;
}

/// Inverse of a pivot.   @return false: it has none, or one that single precision cannot tell from none
bool invert(const FloatBlock& pivot, FloatBlock& inverse) {
  using Matrix = Eigen::Matrix<double, kBlockSide, kBlockSide>;
  using Scale = Eigen::Matrix<double, kBlockSide, 1>;
  Matrix m;
  for (int j = 0; j < kBlockSide; ++j)
    for (int i = 0; i < kBlockSide; ++i) m(i, j) = static_cast<double>(pivot.column[j][i]);
  // A unit diagonal makes what follows independent of the units of the unknowns. That of a system with inertia is
  // positive, friction or not.
  if (!m.allFinite() || !(m.diagonal().minCoeff() > 0.0)) return false;
  const Scale scale = m.diagonal().cwiseSqrt().cwiseInverse();
  m = scale.asDiagonal() * m * scale.asDiagonal();
  const Eigen::PartialPivLU<Matrix> lu(m);
  constexpr double kSingular = 1e-7;
  if (!(lu.matrixLU().diagonal().cwiseAbs().minCoeff() > kSingular)) return false;
  m = scale.asDiagonal() * lu.inverse() * scale.asDiagonal();
  inverse = rounded(m.data());
  return m.allFinite();
}

FloatColumn column_of(const double* x) {
  FloatColumn out{};
  for (int i = 0; i < kBlockSide; ++i) out[i] = static_cast<float>(x[i]);
  return out;
}

}  // namespace

bool BlockIlu::eliminate(std::int32_t i) {
  const auto row = static_cast<std::size_t>(i);
  const std::int32_t begin = start_[row], end = start_[row + 1];
  for (std::int32_t k = begin; k < end; ++k)
    place_[static_cast<std::size_t>(column_[static_cast<std::size_t>(k)])] = k;
  for (std::int32_t k = begin; k < diagonal_[row]; ++k) {
    const auto c = static_cast<std::size_t>(column_[static_cast<std::size_t>(k)]);
    const FloatBlock left = factor_[static_cast<std::size_t>(k)].times(inverse_[c]);
    factor_[static_cast<std::size_t>(k)] = left;
    for (std::int32_t m = diagonal_[c] + 1; m < start_[c + 1]; ++m)
      if (const std::int32_t at = place_[static_cast<std::size_t>(column_[static_cast<std::size_t>(m)])]; at >= 0)
        factor_[static_cast<std::size_t>(at)].subtract_product(left, factor_[static_cast<std::size_t>(m)]);
  }
  for (std::int32_t k = begin; k < end; ++k)
    place_[static_cast<std::size_t>(column_[static_cast<std::size_t>(k)])] = -1;
  return invert(factor_[static_cast<std::size_t>(diagonal_[row])], inverse_[row]);
}

bool BlockIlu::factorise(const BlockMatrix& A) {
  made_ = false;
  const std::int32_t n = A.rows();
  start_.resize(static_cast<std::size_t>(n) + 1);
  column_.resize(A.blocks());
  diagonal_.resize(static_cast<std::size_t>(n));
  factor_.resize(A.blocks());
  inverse_.resize(static_cast<std::size_t>(n));
  place_.assign(static_cast<std::size_t>(n), -1);
  y_.resize(static_cast<std::size_t>(n));
  start_[0] = 0;
  for (std::int32_t i = 0; i < n; ++i) {
    const auto row = static_cast<std::size_t>(i);
    start_[row + 1] = A.row_begin(i + 1);
    diagonal_[row] = A.diagonal(i);
    for (std::int32_t k = A.row_begin(i); k < A.row_begin(i + 1); ++k) {
      column_[static_cast<std::size_t>(k)] = A.column(k);
      factor_[static_cast<std::size_t>(k)] = rounded(A.block(k));
    }
    if (!eliminate(i)) return false;
  }
  return made_ = true;
}

void BlockIlu::solve(std::span<const double> r, std::span<double> z) {
  const std::size_t n = inverse_.size();
  for (std::size_t i = 0; i < n; ++i) {
    FloatColumn sum = column_of(&r[kBlockSide * i]);
    for (auto k = static_cast<std::size_t>(start_[i]); k < static_cast<std::size_t>(diagonal_[i]); ++k)
      sum -= factor_[k].times(y_[static_cast<std::size_t>(column_[k])]);
    y_[i] = sum;
  }
  for (std::size_t i = n; i-- > 0;) {
    FloatColumn sum = y_[i];
    for (auto k = static_cast<std::size_t>(diagonal_[i]) + 1; k < static_cast<std::size_t>(start_[i + 1]); ++k)
      sum -= factor_[k].times(y_[static_cast<std::size_t>(column_[k])]);
    y_[i] = inverse_[i].times(sum);
    for (int j = 0; j < kBlockSide; ++j) z[kBlockSide * i + static_cast<std::size_t>(j)] = static_cast<double>(y_[i][j]);
  }
}

}  // namespace scree::coupling
