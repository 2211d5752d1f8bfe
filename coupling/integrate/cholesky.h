// Sparse symmetric positive definite systems by CHOLMOD, assembled from small dense blocks.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

namespace scree::coupling {

/// Assemble, factorise, solve; the symbolic analysis is kept while the pattern of the blocks stays the same.
/// BLAS runs on one thread: results must not depend on their number.
class Cholesky {
 public:
  Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;
  ~Cholesky();

  /// Starts an empty system of n unknowns.
  void begin(std::int32_t n);
  /// A(dof_i, dof_j) += scale * h_i h_j. Zero scale keeps the places, so that the pattern does not change.
  void add_outer(std::span<const std::int32_t> dof, std::span<const double> h, double scale);
  /// A(first+i, first+j) += m(i, j), m column-major n x n, symmetric.
  void add_block(std::int32_t first, std::int32_t n, const double* m);
  /// False where the matrix is not positive definite.
  [[nodiscard]] bool factorise();
  /// x = A^-1 b.
  void solve(std::span<const double> b, std::span<double> x);

  [[nodiscard]] std::int64_t factorisations() const;
  [[nodiscard]] std::int64_t analyses() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::coupling
