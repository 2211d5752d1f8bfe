// Strength of a contact point under its law, as reduced by failure and slip.
#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/contact_memory.h"
#include "model/model.h"

namespace scree::coupling {

/// Strength of a point at an instant.
struct Strength {
  double cohesion = 0.0;     // times its tributary; infinite: it never slips [N]
  double coefficient = 0.0;  // tan phi
  double tension = 0.0;      // the largest pull that it bears [N]

  /// Coulomb's limit of the tangential force [N].   @param fn  normal force [N], negative where a bond is pulled
  [[nodiscard]] double friction_limit(double fn) const {
    const double limit = cohesion + fn * coefficient;
    return limit > 0.0 ? limit : 0.0;
  }
};
/// tan phi of a point: linear in its accumulated slip s from peak to residual over the weakening slip D,
///   tan phi = tan phi_p + (tan phi_r - tan phi_p) min(1, s/D);   D = 0: the residual after the first failure.
/// Without a residual friction: tan phi_p plus the change by a law of friction (ContactMemory::friction_change).
[[nodiscard]] double friction_coefficient(const JointLaw& law, const ContactMemory& memory);
/// The same with the tangent of the law's friction angle, which takes as long to compute as all the rest.
[[nodiscard]] inline double friction_coefficient(const JointLaw& law, double tan_friction,
                                                 const ContactMemory& memory) {
  if (!law.residual_friction) return tan_friction + memory.friction_change;
  const double lost = law.weakening_slip > 0.0 ? std::min(1.0, memory.slip / law.weakening_slip)
                                               : static_cast<double>(memory.failed != 0);
  return tan_friction + lost * (std::tan(*law.residual_friction) - tan_friction);
}

/// The largest pull that the point bears [N]: tensile strength * share while it is bonded, else 0.
[[nodiscard]] inline double tension_limit(const JointLaw& law, const ContactMemory& memory) {
  return memory.bonded != 0 ? law.tensile_strength * memory.tributary : 0.0;
}

[[nodiscard]] Strength strength(const JointLaw& law, const ContactMemory& memory);
[[nodiscard]] inline Strength strength(const JointLaw& law, double tan_friction, const ContactMemory& memory) {
  const double tension = tension_limit(law, memory);
  const double cohesion =
      std::isinf(tension) ? tension : (memory.failed != 0 ? law.residual_cohesion : law.cohesion) * memory.tributary;
  return {cohesion, friction_coefficient(law, tan_friction, memory), tension};
}

/// Coulomb's limit of the tangential force [N]: max(0, c * share + f_n tan phi), c the residual cohesion after the
/// first failure; infinite for a bond that never fails.
/// @param fn  normal force [N], negative where a bond is pulled
[[nodiscard]] double friction_limit(const JointLaw& law, const ContactMemory& memory, double fn);

/// True if a joint of this law has strength that failure may reduce.
[[nodiscard]] inline bool can_fail(const JointLaw& law) {
  return law.cohesion > 0.0 || law.tensile_strength > 0.0 || (law.residual_friction && law.weakening_slip == 0.0);
}

/// Marks a point as failed, with the residual strengths from now on, and ends its bond.
void mark_failed(const JointLaw& law, ContactMemory& memory);

}  // namespace scree::coupling
