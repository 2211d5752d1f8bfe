#include "coupling/contact/law/friction_evolution.h"

#include <cmath>

namespace scree::coupling {

void FrictionEvolution::advance(double step, std::span<ContactMemory> contacts) {
  for (std::size_t j = 0; j < joints_->size(); ++j) {
    const JointLaw& law = (*joints_)[j];
    if (law.friction_law == nullptr) continue;
    rows_.clear();
    contact_.clear();
    for (std::size_t i = 0; i < contacts.size(); ++i) {
      ContactMemory& m = contacts[i];
      if (m.joint != static_cast<std::int32_t>(j)) continue;
      rows_.push_back({m.slip - m.slip_known, m.friction_change});
      contact_.push_back(i);
      m.slip_known = m.slip;
    }
    law.friction_law->evolve(std::tan(law.friction), law.friction_constants, step, rows_);
    for (std::size_t k = 0; k < rows_.size(); ++k) contacts[contact_[k]].friction_change = rows_[k].change;
  }
}

}  // namespace scree::coupling
