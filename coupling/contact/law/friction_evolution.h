// Laws of friction at work on the contact points of a run.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "coupling/contact_memory.h"
#include "model/model.h"

namespace scree::coupling {

/// Changes the friction of contact points whose joints have a law of friction, law by law.
class FrictionEvolution {
 public:
  explicit FrictionEvolution(const std::vector<JointLaw>& joints) : joints_(&joints) {}
  /// True if any joint has such a law.
  [[nodiscard]] bool used() const {
    return std::any_of(joints_->begin(), joints_->end(), [](const JointLaw& j) { return j.friction_law != nullptr; });
  }
  /// Changes tan phi by the slip of a step.   @param step  that has been taken [s]
  /// @param contacts  with their slip at the end of the step
  void advance(double step, std::span<ContactMemory> contacts);
  /// Leaves friction as it is after the slip so far. Called where a stage begins: the slip of a stage to rest has no
  /// rate, and must not count as that of the first step after it.
  static void skip(std::span<ContactMemory> contacts) {
    for (ContactMemory& m : contacts) m.slip_known = m.slip;
  }

 private:
  const std::vector<JointLaw>* joints_;
  std::vector<FrictionRow> rows_;     // of one joint
  std::vector<std::size_t> contact_;  // of a row
};

}  // namespace scree::coupling
