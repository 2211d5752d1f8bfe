// Sparse symmetric positive definite systems by CHOLMOD: a fixed part, and springs that are added and removed.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "coupling/linear/dof_rows.h"
#include "coupling/linear/symmetric_pattern.h"

namespace scree::coupling {

/// A = values on a fixed pattern + sum of scale h h^T. The symbolic analysis is kept while it has a place for every
/// number of the h, so that the present one may depend on earlier systems: matrix() describes it completely.
/// BLAS runs on one thread: results must not depend on their number.
class Cholesky {
 public:
  Cholesky();
  Cholesky(const Cholesky&) = delete;
  Cholesky& operator=(const Cholesky&) = delete;
  ~Cholesky();

  /// The fixed part's pattern; must outlive this. It is read again only when this is called again. Forgets the factor.
  void set_pattern(const SymmetricPattern& pattern);
  /// Factorises the fixed part's numbers + sum scale_i h_i h_i^T. Rows of zero scale have a place all the same.
  /// @return false where the matrix is not positive definite
  [[nodiscard]] bool factorise(std::span<const double> values, const DofRows& rows, std::span<const double> scale);
  /// Factorises the matrix of another instance, to the same bits.
  [[nodiscard]] bool factorise(const SymmetricMatrix& matrix);
  /// The matrix that factorise() used.
  [[nodiscard]] const SymmetricMatrix& matrix() const;
  /// True if there is a factor, of any matrix.
  [[nodiscard]] bool factored() const;

  /// A change of the system: A += delta h h^T.
  struct Change {
    std::size_t row = 0;
    double delta = 0.0;
  };
  /// Rough work of update() over that of factorise(); both counted in operations, not measured.
  [[nodiscard]] double relative_work(const DofRows& rows, std::span<const Change> changes);
  /// True if that is not above one.
  [[nodiscard]] bool update_pays(const DofRows& rows, std::span<const Change> changes);
  /// Changes the factor itself by rank updates (first) and downdates, until the next factorise() or drop_updates().
  /// @return false: the matrix is not positive definite any more, or the numbers are lost
  [[nodiscard]] bool update(const DofRows& rows, std::span<const Change> changes);
  /// Returns to the factor as factorise() made it.
  void drop_updates();
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
