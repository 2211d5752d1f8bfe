// Masses in a row joined by springs, fixed at one end and pushed at the other.
#pragma once

#include <cmath>
#include <span>
#include <vector>

#include "coupling/linear/cholesky.h"

namespace scree::app {

/// n equal masses m, n equal springs k, the first to a wall, each with a dashpot beside it; F(t) = F0 sin(w t) on the
/// last mass, at rest before.
struct ChainSetting {
  int n = 10;
  double mass = 1000.0, stiffness = 1e7;  // [kg], [N/m]
  double force = 1e4, frequency = 0.0;    // F0 [N], w [rad/s]
  double damping = 0.0;                   // of one mass on one spring: c = 2 damping (k m)^1/2

  [[nodiscard]] double dashpot() const { return 2.0 * damping * std::sqrt(stiffness * mass); }  // [N s/m]
};

class MassChain {
 public:
  MassChain(const ChainSetting& setting, double h);

  /// Central difference, kick - drift - kick, as in coupling/integrate/central_difference; dashpots use the velocity
  /// between two instants, so that they need no solution.
  void step_explicit();
  /// Newmark (1/2, 1): (2 M/h^2 + 2 C/h + K) d = F - K u + C v + 2 M v/h, v' = 2 d/h - v. The matrix is assembled and
  /// factorised anew in each step, as contacts that open and close make necessary.
  void step_implicit();

  [[nodiscard]] double time() const { return h_ * steps_; }
  [[nodiscard]] std::span<const double> displacement() const { return u_; }

  /// Exact displacement of a mass by superposition of the chain's modes
  ///   w_j = 2 (k/m)^1/2 sin((2j-1) pi/(2 (2n+1))),  phi_j(i) = 2 (2n+1)^-1/2 sin(i (2j-1) pi/(2n+1)),
  /// each damped by z_j = damping w_j (m/k)^1/2 of its critical damping; not for z_j >= 1.
  /// @param i  0 to n-1
  [[nodiscard]] static double exact(const ChainSetting& setting, int i, double t);

 private:
  /// f_ = F(t) - K u - C v.   @param v  null: without dashpots
  void forces(double t, const double* v);

  ChainSetting setting_;
  double h_;
  double steps_ = 0.0;
  std::vector<double> u_, v_, f_, d_;
  coupling::SymmetricPattern no_fixed_part_;  // every entry comes from a spring, as in contact
  coupling::Cholesky matrix_;
  coupling::DofRows rows_;
  std::vector<double> scale_;
};

}  // namespace scree::app
