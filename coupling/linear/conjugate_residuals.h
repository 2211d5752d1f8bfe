// Conjugate residuals with a preconditioner, for systems whose factor is that of a neighbour: of other states of the
// contacts, or without the friction that makes them unsymmetric.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace scree::coupling {

/// Generalised conjugate residuals: of all corrections that the preconditioner offers, the sum that leaves the least
/// residual, as GMRES does, with solution and residual at hand. Keeps its scratch between solves.
/// @source [Eisenstat1983]
class ConjugateResiduals {
 public:
  static constexpr std::size_t kDepth = 40;  // corrections remembered before it begins afresh

  /// Improves x until no number of b - A x over its unit is above `enough`.
  /// @param A        A(x, y) sets y = A x
  /// @param inverse  inverse(r, z) sets z to about A^-1 r
  /// @param unit     of every number of b: results do not depend on the units that the unknowns are counted in
  /// @param most     iterations
  /// @return iterations taken; -1: not there by then, x is the best so far
  template <class Matrix, class Inverse>
  int solve(Matrix&& A, Inverse&& inverse, std::span<const double> b, std::span<const double> unit, double enough,
            int most, std::span<double> x) {
    unit_ = unit;
    weight_.resize(unit.size());
    for (std::size_t i = 0; i < unit.size(); ++i) weight_[i] = 1.0 / (unit[i] * unit[i]);
    residual(A, b, x);
    std::size_t depth = 0;
    for (int taken = 0;; ++taken) {
      if (largest() <= enough) {
        if (depth == 0) return taken;
        // The residual carried along may be better than the true one: what round-off has taken is made up for afresh.
        residual(A, b, x);
        depth = 0;
        if (largest() <= enough) return taken;
      }
      if (taken == most || !std::isfinite(largest())) return -1;
      if (depth == kDepth) depth = 0;
      if (!correct(A, inverse, depth, x)) return -1;
      ++depth;
    }
  }

 private:
  struct Correction {
    std::vector<double> z, Az;
    double square = 0.0;  // Az.Az
  };
  [[nodiscard]] double dot(const std::vector<double>& u, const std::vector<double>& v) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < u.size(); ++i) sum += u[i] * v[i] * weight_[i];
    return sum;
  }
  static void subtract(double factor, const std::vector<double>& u, std::vector<double>& from) {
    for (std::size_t i = 0; i < u.size(); ++i) from[i] -= factor * u[i];
  }
  [[nodiscard]] double largest() const {
    double most = 0.0;
    for (std::size_t i = 0; i < r_.size(); ++i)
      if (const double value = std::abs(r_[i]) / unit_[i]; !(value <= most)) most = value;
    return most;
  }
  template <class Matrix>
  void residual(Matrix& A, std::span<const double> b, std::span<const double> x) {
    r_.resize(b.size());
    A(x, r_);
    for (std::size_t i = 0; i < r_.size(); ++i) r_[i] = b[i] - r_[i];
  }
  /// One more correction, the residual of which no earlier one has a part of. False: it does not help.
  template <class Matrix, class Inverse>
  [[nodiscard]] bool correct(Matrix& A, Inverse& inverse, std::size_t depth, std::span<double> x) {
    if (corrections_.size() == depth) corrections_.emplace_back();
    Correction& c = corrections_[depth];
    c.z.resize(r_.size());
    c.Az.resize(r_.size());
    inverse(r_, c.z);
    A(c.z, c.Az);
    for (std::size_t k = 0; k < depth; ++k) {
      const Correction& before = corrections_[k];
      const double part = dot(c.Az, before.Az) / before.square;
      subtract(part, before.Az, c.Az);
      subtract(part, before.z, c.z);
    }
    c.square = dot(c.Az, c.Az);
    const double step = dot(r_, c.Az) / c.square;
    if (!std::isfinite(step) || step == 0.0) return false;
    for (std::size_t i = 0; i < r_.size(); ++i) x[i] += step * c.z[i];
    subtract(step, c.Az, r_);
    return true;
  }

  std::vector<double> r_;
  std::span<const double> unit_;
  std::vector<double> weight_;  // of a number of the residual in a product
  std::vector<Correction> corrections_;
};

}  // namespace scree::coupling
