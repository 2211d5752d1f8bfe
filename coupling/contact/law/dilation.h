// Dilation: slip opens a joint by tan psi times the slip, and the opening presses the normal spring.
#pragma once

#include "model/model.h"

namespace scree::coupling {

struct Strength;

/// How far a point of the joint has opened by dilation after a slip in either direction [m]: tan psi min(slip,
/// dilation_slip).
[[nodiscard]] double opened_by_slip(const JointLaw& law, double slip);

/// Opening of a point that has slipped by `before` and slips further by `slip` [m].
[[nodiscard]] double opened_in(const JointLaw& law, double before, double slip);

/// Normal and tangential state of a dilating point whose spring is beyond Coulomb's limit.   `pressed` may be negative.
struct DilatingTrial {
  double kn = 0.0, kt = 0.0;  // springs [N/m]
  double pressed = 0.0;       // normal force without further opening, damping included [N]
  double per_opening = 0.0;   // increase of this force per opening, k_n + c_n/h [N/m]
  double stretch = 0.0;       // tangential elongation without slip [m]
  double before = 0.0;        // accumulated slip [m]
};
/// Slip of such a point [m]. The opening loads the normal spring and its dashpot, so that the limit grows with the
/// slip:
///   k_t (|e| - s) = c + tan phi f(s),   f(s) = max(0, pressed + per_opening tan psi min(s, left))
/// with `left` the slip after which the joint opens no further. Between 0 and |e|.
/// @param cohesion  as a force, times the tributary length [N]   @param mu  tan phi
[[nodiscard]] double dilating_slip(const JointLaw& law, const DilatingTrial& t, double cohesion, double mu);

/// Normal force of a slipping point that dilates, linear in gap g and elongation e of an implicit step:
///   f_n = -(per_gap g + per_stretch e + constant)
struct DilatingForce {
  double per_gap = 0.0, per_stretch = 0.0;  // [N/m]
  double constant = 0.0;                    // [N]
};
/// With |s| = -dir e - (c + tan phi f_n)/k_t the slip and k the normal stiffness, f_n = -k g + k tan psi |s| has f_n on
/// both sides:  f_n (1 + k tan psi tan phi/k_t) = -k g - k tan psi (dir e + c/k_t).
/// After the end of dilation `left` takes the place of |s|: f_n = -k g + k tan psi left.
/// @param k  normal stiffness, the dashpot included [N/m]   @param direction  `dir`, the sign of the friction force
/// @param opens  true: all slip of the step dilates   @param left  slip that still dilates [m]
[[nodiscard]] DilatingForce dilating_force(const JointLaw& law, const Strength& strength, double k, double kt,
                                           double direction, bool opens, double left);

}  // namespace scree::coupling
