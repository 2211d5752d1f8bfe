#include "coupling/contact/law/joint_strength.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {

namespace {

double coefficient(const JointLaw& law, double peak, const ContactMemory& memory) {
  if (!law.residual_friction) return peak + memory.friction_change;
  const double lost = law.weakening_slip > 0.0 ? std::min(1.0, memory.slip / law.weakening_slip)
                                               : static_cast<double>(memory.failed != 0);
  return peak + lost * (std::tan(*law.residual_friction) - peak);
}

}  // namespace

double friction_coefficient(const JointLaw& law, const ContactMemory& memory) {
  return coefficient(law, std::tan(law.friction), memory);
}

Strength strength(const JointLaw& law, const ContactMemory& memory) {
  return strength(law, std::tan(law.friction), memory);
}

Strength strength(const JointLaw& law, double tan_friction, const ContactMemory& memory) {
  const double tension = tension_limit(law, memory);
  const double cohesion =
      std::isinf(tension) ? tension : (memory.failed != 0 ? law.residual_cohesion : law.cohesion) * memory.tributary;
  return {cohesion, coefficient(law, tan_friction, memory), tension};
}

double friction_limit(const JointLaw& law, const ContactMemory& memory, double fn) {
  return strength(law, memory).friction_limit(fn);
}

double tension_limit(const JointLaw& law, const ContactMemory& memory) {
  return memory.bonded != 0 ? law.tensile_strength * memory.tributary : 0.0;
}

bool can_fail(const JointLaw& law) {
  return law.cohesion > 0.0 || law.tensile_strength > 0.0 || (law.residual_friction && law.weakening_slip == 0.0);
}

void mark_failed(const JointLaw& law, ContactMemory& memory) {
  if (can_fail(law)) memory.failed = 1;
  memory.bonded = 0;
}

}  // namespace scree::coupling
