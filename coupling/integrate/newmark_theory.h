// Newmark's schemes on one free oscillator, step by step: the reference for every time scheme in Scree.
#pragma once

#include "model/geometry.h"

namespace scree::coupling {

/// Newmark's scheme (beta, gamma) on u'' = -w^2 u with steps h, Omega = w h:
///   u' = u + h v + h^2 [(1/2 - beta) a + beta a'],   v' = v + h [(1 - gamma) a + gamma a'],   a = -w^2 u
/// (1/2, 1) is Scree's implicit step, (1/4, 1/2) the trapezoidal rule, (0, 1/2) central difference with synchronised
/// velocities.
/// @source [Qu2013] 2.5.1, eq. 2.2 to 2.14, without the load and the third row, which add nothing but an eigenvalue 0
struct NewmarkTheory {
  double beta = 0.5, gamma = 1.0;  // beta >= 0, gamma >= 1/2

  /// A with z' = A z, z = (u, h v).   @pre Omega > 0
  [[nodiscard]] Mat2 amplification(double Omega) const;
  /// Omega at which the eigenvalues become real, and the spectral radius is least; infinite where they never do.
  ///   ((gamma + 1/2)^2/4 - beta)^-1/2      @source [Qu2013] eq. 2.11
  [[nodiscard]] double bifurcation() const;
  /// Largest stable Omega, (gamma/2 - beta)^-1/2; infinite where 2 beta >= gamma.
  [[nodiscard]] double stability_limit() const;

  struct Peak {
    double Omega, value;
  };
  /// Largest damping measure over 0 < Omega <= most.   @pre it has one maximum there (gamma = 1)
  [[nodiscard]] Peak largest_damping(double most) const;
};

/// Largest modulus of the eigenvalues of an amplification matrix.
[[nodiscard]] double spectral_radius(const Mat2& A);
/// Measure of damping, xi = -ln(A2)/(2 Omega), A2 = det A: the damping ratio of the oscillation as long as
/// the eigenvalues are complex and Omega is small.   @return not a number where det A <= 0
/// @source [Qu2013] eq. 2.14
[[nodiscard]] double damping_measure(const Mat2& A, double Omega);
/// (T' - T)/T, T' = 2 pi h / arg(eigenvalue).   @return not a number where the eigenvalues are real
[[nodiscard]] double period_error(const Mat2& A, double Omega);

}  // namespace scree::coupling
