// Strength of intact or jointed rock against the stress in it: Mohr-Coulomb, or Hoek and Brown. Blocks stay elastic;
// the utilisation shows where that is no longer true.
#pragma once

#include <variant>

namespace scree {

/// tau = c + sigma_n tan(phi), with a tension cut-off.
struct MohrCoulombStrength {
  double cohesion = 0.0;  // [Pa], > 0
  double friction = 0.0;  // [rad], 0 <= . < pi/2
  double tension = 0.0;   // [Pa], >= 0, <= c/tan(phi)
};

/// s1 = s3 + ucs (m_b s3/ucs + s)^a, compression positive.
/// @source [Hoek2002], eqs. 2 to 5
struct HoekBrownStrength {
  double ucs = 0.0;  // uniaxial compressive strength of the intact pieces [Pa], > 0
  double mb = 0.0, s = 0.0, a = 0.5;

  /// m_b = m_i exp((GSI - 100)/(28 - 14 D)), s = exp((GSI - 100)/(9 - 3 D)),
  /// a = 1/2 + (exp(-GSI/15) - exp(-20/3))/6
  /// @param gsi  geological strength index, 0 < . <= 100    @param mi  of the intact rock, > 0    @param d disturbance,
  /// 0 to 1
  [[nodiscard]] static HoekBrownStrength of_rock_mass(double ucs, double gsi, double mi, double d);
  /// The largest tension, s ucs/m_b [Pa].
  [[nodiscard]] double tension() const { return s * ucs / mb; }
};

using RockStrength = std::variant<MohrCoulombStrength, HoekBrownStrength>;

/// Upper limit of the reported utilisation, which would be infinite without any strength.
inline constexpr double kMostUtilisation = 999.0;

/// Utilisation of the strength by a stress in the plane: the radius of Mohr's circle over that of the circle about the
/// same centre that touches the envelope, or the tension over the tensile strength, whichever is larger. 1:
/// failure; at most kMostUtilisation.
/// @param s1,s3  larger and smaller principal stress in the plane, tension positive [Pa]
[[nodiscard]] double utilisation(const RockStrength& strength, double s1, double s3);

}  // namespace scree
