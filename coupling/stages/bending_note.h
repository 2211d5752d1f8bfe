// Excess bending stiffness of slender blocks, due to the cover size of a stage.
#pragma once

#include <optional>
#include <string>

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

/// Relative excess of the bending stiffness of a block of constant-strain elements.   @param cover,thickness [m]
/// @source docs/theory/kinematics-and-nmm.md, "Bending"
[[nodiscard]] constexpr double bending_excess(double cover, double thickness) {
  return 1.8 * (cover / thickness) * (cover / thickness);
}

inline constexpr double kBendingSlender = 4.0;  // length over thickness from which a block counts as slender
inline constexpr double kBendingExcess = 0.1;   // threshold of the note

/// A line about the slender free block of an NMM stage with the largest excess; empty: no excess above kBendingExcess.
/// Thickness and length are those of the rectangle with the second moments of the block.
[[nodiscard]] std::optional<std::string> bending_note(const Model& model, const Stage& stage);

}  // namespace scree::coupling
