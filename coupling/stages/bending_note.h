// How much too stiffly the covers of a stage make slender blocks bend.
#pragma once

#include <optional>
#include <string>

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

/// The part by which a block of constant-strain elements bends too stiffly.   @param cover,thickness [m]
/// @source docs/theory/kinematics-and-nmm.md, "Bending"
[[nodiscard]] constexpr double bending_excess(double cover, double thickness) {
  return 1.8 * (cover / thickness) * (cover / thickness);
}

inline constexpr double kBendingSlender = 4.0;  // length over thickness, from which a block is taken to bend
inline constexpr double kBendingExcess = 0.1;   // what is told

/// A line on the worst of the slender blocks that a stage of the NMM moves; empty: none is too stiff by kBendingExcess.
/// Thickness and length are those of the rectangle with the second moments of the block.
[[nodiscard]] std::optional<std::string> bending_note(const Model& model, const Stage& stage);

}  // namespace scree::coupling
