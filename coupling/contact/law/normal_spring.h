// Normal spring of a contact point: force, stiffness and energy of its gap.
#pragma once

#include <algorithm>

namespace scree::coupling {

/// Penalty spring of stiffness k_n over the gap g, less gap0 (negative: pressed). Forces are per metre of thickness. A
/// pressed spring pushes; one that is bonded also pulls. With the depth d = g where bonded, else min(g, 0):
///   U = 1/2 k_n d^2,   f_n = -dU/dg = -k_n d,   -df_n/dg = k_n where d = g, else 0
struct NormalSpring {
  double k = 0.0;       // [N/m]
  bool bonded = false;  // it bears a pull as well

  /// [m]
  [[nodiscard]] double depth(double gap) const { return bonded ? gap : std::min(gap, 0.0); }
  /// On the corner, along the outward normal of the edge [N].
  [[nodiscard]] double force(double gap) const { return -k * depth(gap); }
  /// Derivative of -force with respect to the gap [N/m]; at the kink g = 0 that of the open side.
  [[nodiscard]] double tangent(double gap) const { return bonded || gap < 0.0 ? k : 0.0; }
  /// [J]
  [[nodiscard]] double energy(double gap) const {
    const double d = depth(gap);
    return 0.5 * k * d * d;
  }
};

}  // namespace scree::coupling
