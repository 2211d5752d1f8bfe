// Springs of an implicit step beside the contacts.
#pragma once

#include <span>
#include <vector>

#include "coupling/linear/dof_rows.h"

namespace scree::coupling {

/// Springs of stiffness k between bodies or to the ground that do not change during a step: force -k (at + u) along
/// their rows, u the change. Supports; dashpots with k = 2 c/h and at = -h v_n/2.
struct StepSprings {
  DofRows rows;
  std::vector<double> k;   // [N/m]
  std::vector<double> at;  // elongation at the start of the step [m]
  [[nodiscard]] std::size_t size() const { return k.size(); }
  [[nodiscard]] double force(std::size_t i, std::span<const double> d) const {
    return -k[i] * (at[i] + rows[i].change(d));
  }
  void clear() {
    rows.clear();
    k.clear();
    at.clear();
  }
};

}  // namespace scree::coupling
