#include "coupling/integrate/gmres.h"

#include <Eigen/Sparse>
#include <algorithm>
#include <unsupported/Eigen/IterativeSolvers>

namespace scree::coupling {
namespace {
class Applied;
}  // namespace
}  // namespace scree::coupling

// What Eigen's iterative solvers want of a matrix that has no numbers ("Matrix-free solvers" in its documentation).
namespace Eigen::internal {
template <>
struct traits<scree::coupling::Applied> : public traits<SparseMatrix<double>> {};
}  // namespace Eigen::internal

namespace scree::coupling {
namespace {

class Applied : public Eigen::EigenBase<Applied> {
 public:
  using Scalar = double;
  using RealScalar = double;
  using StorageIndex = int;
  static constexpr int ColsAtCompileTime = Eigen::Dynamic;     // NOLINT(readability-identifier-naming)
  static constexpr int MaxColsAtCompileTime = Eigen::Dynamic;  // NOLINT(readability-identifier-naming)
  static constexpr bool IsRowMajor = false;                    // NOLINT(readability-identifier-naming)

  Applied(const Operator& apply, Eigen::Index size) : apply_(&apply), size_(size) {}
  [[nodiscard]] Eigen::Index rows() const { return size_; }
  [[nodiscard]] Eigen::Index cols() const { return size_; }
  template <class Rhs>
  Eigen::Product<Applied, Rhs, Eigen::AliasFreeProduct> operator*(const Eigen::MatrixBase<Rhs>& x) const {
    return {*this, x.derived()};
  }
  [[nodiscard]] Eigen::VectorXd to(const Eigen::VectorXd& x) const { return (*apply_)(x); }

 private:
  const Operator* apply_;
  Eigen::Index size_;
};

}  // namespace
}  // namespace scree::coupling

namespace Eigen::internal {
template <class Rhs>
struct generic_product_impl<scree::coupling::Applied, Rhs, SparseShape, DenseShape, GemvProduct>
    : generic_product_impl_base<scree::coupling::Applied, Rhs, generic_product_impl<scree::coupling::Applied, Rhs>> {
  template <class Dest>
  static void scaleAndAddTo(Dest& out, const scree::coupling::Applied& a, const Rhs& x,
                            const double& factor) {  // NOLINT
    out.noalias() += factor * a.to(x);
  }
};
}  // namespace Eigen::internal

namespace scree::coupling {

bool gmres(const Operator& apply, const Eigen::VectorXd& b, double tolerance, Eigen::VectorXd& x) {
  constexpr Eigen::Index kRestart = 100, kMost = 500;
  const Applied matrix(apply, b.size());
  Eigen::GMRES<Applied, Eigen::IdentityPreconditioner> solver;
  solver.compute(matrix);
  solver.set_restart(std::min(kRestart, b.size()));
  solver.setMaxIterations(kMost);
  solver.setTolerance(tolerance);
  x = solver.solve(b);
  constexpr double kRounding = 10.0;  // the solver's own residual is a recurrence, and a breakdown counts as success
  return x.allFinite() && (apply(x) - b).norm() <= kRounding * tolerance * b.norm();
}

}  // namespace scree::coupling
