#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {

double friction_coefficient(const JointLaw& law, const ContactMemory& memory) {
  return friction_coefficient(law, std::tan(law.friction), memory);
}

Strength strength(const JointLaw& law, const ContactMemory& memory) {
  return strength(law, std::tan(law.friction), memory);
}

double friction_limit(const JointLaw& law, const ContactMemory& memory, double fn) {
  return strength(law, memory).friction_limit(fn);
}

void mark_failed(const JointLaw& law, ContactMemory& memory) {
  if (can_fail(law)) memory.failed = 1;
  memory.bonded = 0;
}

}  // namespace scree::coupling
