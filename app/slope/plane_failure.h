// Limit equilibrium of a rigid wedge on a plane: static, with water, and pseudo-static.
#pragma once

namespace scree::app {

/// A block of unit thickness that may slide down a plane. Forces per metre of thickness.
struct PlaneSlide {
  double dip = 0.0;       // of the plane [rad], 0 < dip < pi/2
  double weight = 0.0;    // [N/m]
  double length = 0.0;    // of the plane [m]
  double friction = 0.0;  // phi [rad]
  double cohesion = 0.0;  // c [Pa]
  double uplift = 0.0;    // U: force of water on the plane [N/m]
  double thrust = 0.0;    // V: horizontal force of water in a tension crack [N/m]

  /// Pseudo-static factor of safety. k_h g is the acceleration of the ground into the slope (inertia pushes out of it),
  /// k_v g that of the ground downwards (inertia lifts).
  ///   F = (c L + N' tan phi)/S,   N' = W[(1 - k_v) cos a - k_h sin a] - U - V sin a,
  ///                               S = W[(1 - k_v) sin a + k_h cos a] + V cos a
  /// A normal force N' below zero counts as zero: the block lifts off, and only cohesion is left. Infinite where
  /// nothing drives the block (S <= 0).
  /// @source [HoekBray1981] eq. 7.3; pseudo-static terms: [Kramer1996] section 10.6.1
  [[nodiscard]] double factor(double k_h = 0.0, double k_v = 0.0) const;
  /// k_h at which F = 1 [-]; below zero where the block slides without shaking.
  [[nodiscard]] double yield(double k_v = 0.0) const;
  /// Newmark's critical acceleration along the plane, (F - 1) sin a [g], F the static factor.
  /// @source [Newmark1965]
  [[nodiscard]] double critical() const;
  /// Acceleration of the block down the plane for each unit of horizontal acceleration above the yield:
  /// cos a + sin a tan phi.
  [[nodiscard]] double amplification() const;
};

/// A slope with a face, a plane through its toe, and a vertical tension crack behind the crest, level top.
struct PlaneSlope {
  double height = 0.0;                    // H [m]
  double face = 0.0;                      // angle of the face [rad]
  double dip = 0.0;                       // of the plane [rad], below that of the face
  double unit_weight = 0.0;               // gamma of the rock [N/m3]
  double friction = 0.0, cohesion = 0.0;  // [rad], [Pa]
  double crack = 0.0;                     // depth z of the tension crack from the top, behind the crest; 0: none [m]
  double water = 0.0;                     // depth of water in the crack z_w [m]
  double water_weight = 9810.0;           // gamma_w [N/m3]

  /// The block that slides. Water in the crack runs out at the toe: its pressure falls linearly from gamma_w z_w at the
  /// foot of the crack to zero at the toe.
  ///   W = gamma H^2/2 [(1 - (z/H)^2) cot a - cot f],  L = (H - z)/sin a,  U = gamma_w z_w L/2,  V = gamma_w z_w^2/2
  /// @throws std::invalid_argument where the slope is not of this kind: angles, a crack deeper than the plane under the
  ///         crest, water above the crack
  /// @source [HoekBray1981] eqs. 7.3 to 7.8 (crack in the top)
  [[nodiscard]] PlaneSlide slide() const;
};

}  // namespace scree::app
