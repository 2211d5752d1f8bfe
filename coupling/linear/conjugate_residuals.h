// Conjugate residuals with a preconditioner, for systems with the factor of a similar matrix: of other states of the
// contacts, incomplete, or without the friction that makes the system unsymmetric.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace scree::coupling {

/// Generalised conjugate residuals: of all linear combinations of the corrections z_j, the one with the least
/// residual, as in GMRES. With W the reciprocal units,
///   W A z_j = sum_{k<j} R_kj q_k + q_j,   q_k.q_j = 0,   s_j = r.q_j/q_j.q_j,   r -= s_j q_j,
/// and sum y_j z_j, R y = s, is added to x once the updated residual is small enough. Columns are made orthogonal all
/// at once (classical Gram-Schmidt, repeated where little of a column is left): two passes through memory for any
/// number of them. Sums run over fixed chunks: the bits do not depend on the number of threads. Keeps its scratch
/// between solves.
/// @source [Eisenstat1983]; Gram-Schmidt: [Saad2003] 6.3.2
class ConjugateResiduals {
 public:
  static constexpr std::size_t kDepth = 40;  // corrections remembered before a restart

  /// Improves x until no number of b - A x over its unit is above `enough`.
  /// @param A        A(x, y) sets y = A x
  /// @param inverse  inverse(r, z) sets z to about A^-1 r; corrections are kept in the precision that z has
  /// @param unit     of every number of b: results do not depend on the units that the unknowns are counted in
  /// @param most     iterations
  /// @return iterations taken; -1: not converged by then, x is the best so far
  template <class Matrix, class Inverse>
  int solve(Matrix&& A, Inverse&& inverse, std::span<const double> b, std::span<const double> unit, double enough,
            int most, std::span<double> x) {
    return solve(A, A, inverse, b, unit, enough, most, x);
  }
  /// The same where products for corrections may round more than those of the solution.
  /// @param exact   as A, with full accuracy: residuals of x are taken with it. It may add what does not depend on x.
  /// @param enough  or a function that returns it, called once, after the first product
  template <class Exact, class Matrix, class Inverse, class Enough>
  int solve(Exact&& exact, Matrix&& A, Inverse&& inverse, std::span<const double> b, std::span<const double> unit,
            Enough&& enough, int most, std::span<double> x) {
    constexpr bool kSingle = std::is_invocable_v<Inverse, std::span<const double>, std::span<float>>;
    begin(unit, kSingle);
    exact(x, product_);
    take_residual(b);
    double limit = 0.0;
    if constexpr (std::is_invocable_v<Enough>)
      limit = enough();
    else
      limit = enough;
    std::size_t depth = 0;
    for (int taken = 0;; ++taken) {
      if (largest_ <= limit) {
        if (depth == 0) return taken;
        // The updated residual may be smaller than the true one: the loss by round-off is corrected in a restart.
        add_corrections(depth, x);
        depth = 0;
        exact(x, product_);
        take_residual(b);
        if (largest_ <= limit) return taken;
      }
      const bool full = depth == kDepth, ends = taken == most || !std::isfinite(largest_);
      if (full || ends) {
        add_corrections(depth, x);
        depth = 0;
      }
      if (ends) return -1;
      Correction& c = next(depth);
      if constexpr (kSingle) {
        inverse(std::span<const double>(product_), std::span<float>(c.single));
        A(in_double(c.single), std::span<double>(product_));
      } else {
        inverse(std::span<const double>(product_), std::span<double>(c.z));
        A(std::span<const double>(c.z), std::span<double>(product_));
      }
      if (!correct(depth)) {
        add_corrections(depth, x);
        return -1;
      }
      ++depth;
    }
  }

  /// (b - A x)/unit of the last solve that converged, taken with the exact product.
  [[nodiscard]] std::span<const double> residual() const { return r_; }

 private:
  struct Correction {
    std::vector<double> z, q;           // q in units
    std::vector<float> single;          // z of an inverse in single precision
    double square = 0.0;                // q.q
    std::array<double, kDepth> part{};  // R: of the earlier columns in A z
    double step = 0.0;                  // s
  };
  void begin(std::span<const double> unit, bool single);
  /// r_ = (b - product_)/unit.
  void take_residual(std::span<const double> b);
  /// Room for another correction; product_ = the residual that it is to correct [unit of b].
  Correction& next(std::size_t depth);
  [[nodiscard]] std::span<const double> in_double(std::span<const float> z);
  /// The part of A z in product_ orthogonal to the earlier columns, and the step along it.   @return false: none helps
  [[nodiscard]] bool correct(std::size_t depth);
  /// part[k] += q.q_k/q_k.q_k, q -= that of q_k, for all k < depth.   @return q.q after it
  double orthogonalise(std::size_t depth);
  /// x += sum y_j z_j, R y = s.
  void add_corrections(std::size_t depth, std::span<double> x);

  std::span<const double> unit_;
  std::vector<double> r_, product_;  // r_ in units
  std::vector<double> z_;            // scratch: a correction that is kept in single precision
  bool single_ = false;              // corrections are kept in single precision
  double largest_ = 0.0;             // |r_|
  std::vector<Correction> corrections_;
  std::vector<double> partial_;  // sums of chunks, kDepth + 2 each
};

}  // namespace scree::coupling
