#include "coupling/integrate/newmark_theory.h"

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>

namespace scree::coupling {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// (trace/2)^2 - det: negative where the eigenvalues are complex.
double discriminant(const Mat2& A) { return 0.25 * A.trace() * A.trace() - A.determinant(); }

}  // namespace

Mat2 NewmarkTheory::amplification(double Omega) const {
  const double w2 = Omega * Omega, k = 1.0 / (1.0 + beta * w2);
  const double uu = k * (1.0 - (0.5 - beta) * w2), uv = k;  // u' of u and of h v
  Mat2 A;
  A << uu, uv,  //
      -w2 * (1.0 - gamma + gamma * uu), 1.0 - w2 * gamma * uv;
  return A;
}

double NewmarkTheory::bifurcation() const {
  const double inverse = 0.25 * (gamma + 0.5) * (gamma + 0.5) - beta;
  return inverse > 0.0 ? 1.0 / std::sqrt(inverse) : kInfinite;
}

double NewmarkTheory::stability_limit() const {
  const double inverse = 0.5 * gamma - beta;
  return inverse > 0.0 ? 1.0 / std::sqrt(inverse) : kInfinite;
}

NewmarkTheory::Peak NewmarkTheory::largest_damping(double most) const {
  const auto xi = [&](double Omega) {
    const double value = damping_measure(amplification(Omega), Omega);
    return std::isnan(value) ? -kInfinite : value;
  };
  constexpr double kGolden = 1.0 / std::numbers::phi;
  double low = 0.0, high = most;
  while (high - low > 1e-9 * most) {
    const double d = kGolden * (high - low);
    (xi(high - d) < xi(low + d) ? low : high) = xi(high - d) < xi(low + d) ? high - d : low + d;
  }
  const double Omega = 0.5 * (low + high);
  return {Omega, xi(Omega)};
}

double spectral_radius(const Mat2& A) {
  const double inside = discriminant(A);
  return inside < 0.0 ? std::sqrt(A.determinant()) : 0.5 * std::abs(A.trace()) + std::sqrt(inside);
}

double damping_measure(const Mat2& A, double Omega) {
  const double det = A.determinant();
  return det > 0.0 ? -std::log(det) / (2.0 * Omega) : kNone;
}

double period_error(const Mat2& A, double Omega) {
  const double inside = discriminant(A);
  return inside < 0.0 ? Omega / std::atan2(std::sqrt(-inside), 0.5 * A.trace()) - 1.0 : kNone;
}

}  // namespace scree::coupling
