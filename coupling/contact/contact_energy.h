// Energy of contact springs, one definition for every scheme.
#pragma once

#include "coupling/contact/law/coulomb.h"
#include "coupling/contact/law/normal_spring.h"
#include "coupling/contact/table/contact_finder.h"

namespace scree::coupling {

/// 1/2 k_n g^2 where the point is bonded or g < 0, unless another edge of the same corner carries the contact [J].
[[nodiscard]] inline double normal_energy(const ContactPoint& p, const ContactMemory& m, double kn) {
  return p.suppressed || p.beyond ? 0.0 : NormalSpring{kn, m.bonded != 0}.energy(m.gap);
}
[[nodiscard]] inline double normal_energy(const ContactPoint& p, const ContactMemory& m) {
  return normal_energy(p, m, m.kn);
}
/// 1/2 k_t e^2 while closed [J].
[[nodiscard]] inline double tangential_energy(const ContactMemory& m, double kt) {
  return m.status == ContactStatus::open ? 0.0 : tangential_spring_energy(kt, m.stretch);
}
[[nodiscard]] inline double tangential_energy(const ContactMemory& m) { return tangential_energy(m, m.kt); }
/// Both of a point that no other edge carries, from its memory alone; an open one has none [J].
[[nodiscard]] inline double closed_energy(const ContactMemory& m) {
  return m.status == ContactStatus::open
             ? 0.0
             : NormalSpring{m.kn, m.bonded != 0}.energy(m.gap) + tangential_spring_energy(m.kt, m.stretch);
}
[[nodiscard]] inline double contact_energy(const ContactList& list) {
  double sum = 0.0;
  for (std::size_t i = 0; i < list.points.size(); ++i)
    sum += normal_energy(list.points[i], list.memory[i]) + tangential_energy(list.memory[i]);
  return sum;
}

}  // namespace scree::coupling
