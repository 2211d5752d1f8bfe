// Sparse symmetric positive definite systems by CHOLMOD: a fixed part, and springs that come and go.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "coupling/integrate/symmetric_pattern.h"

namespace scree::coupling {

/// A = values on a fixed pattern + sum of scale h h^T. The symbolic analysis, and the place of every number in the
/// system, are kept while neither the fixed pattern nor the lists of the h change.
/// BLAS runs on one thread: results must not depend on their number.
class Cholesky {
 public:
  Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;
  ~Cholesky();

  /// The fixed part's pattern; must outlive this. It is read again only when this is called again.
  void set_pattern(const SymmetricPattern& pattern);
  /// Starts a system with the numbers of the fixed part, which must outlive factorise().
  void begin(std::span<const double> values);
  /// A(dof_i, dof_j) += scale * h_i h_j. Zero scale keeps the places, so that the pattern does not change.
  void add_outer(std::span<const std::int32_t> dof, std::span<const double> h, double scale);
  /// False where the matrix is not positive definite.
  [[nodiscard]] bool factorise();
  /// A change of the system: A += delta h h^T.
  struct Change {
    std::span<const std::int32_t> dof;  // each once
    std::span<const double> h;
    double delta = 0.0;
  };
  /// Work that update() would take, over that of factorise(), roughly; both counted in operations, not measured.
  [[nodiscard]] double relative_work(std::span<const Change> changes);
  /// Changes the factor itself by rank updates (first) and downdates, until the next factorise().
  /// @return false: the matrix is not positive definite any more, or the numbers are lost; factorise() is needed
  [[nodiscard]] bool update(std::span<const Change> changes);
  /// x = A^-1 b.
  void solve(std::span<const double> b, std::span<double> x);

  [[nodiscard]] std::int64_t factorisations() const;
  [[nodiscard]] std::int64_t analyses() const;
  /// Numbers in the factor.
  [[nodiscard]] double factor_size() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::coupling
