// Warnings before the first step, about input that is allowed but seldom intended.
#pragma once

#include <string>
#include <vector>

#include "coupling/plan.h"
#include "model/model.h"
#include "model/touching.h"

namespace scree::coupling {

/// Damping that sliding requires: with less, modes of a block and of its slipping contacts coalesce, since friction
/// makes their stiffness unsymmetric; the block hops on its contacts, loses friction and slides too far. The defaults
/// of the case file are the thresholds.
struct SlidingNeeds {
  double joint_damping = JointLaw{}.damping;       // `damping` of a joint, fraction of critical
  double stage_damping = Stage{}.sliding_damping;  // `sliding_damping` of a stage, fraction of critical
  // Coalescence occurs where friction and slope of the joint are both at least this angle.
  double angle = 25.0 * 3.14159265358979323846 / 180.0;  // [rad]
};

/// Warnings about a model and its plan, one line each: nothing holds the model, blocks touch nothing, damping acts on
/// nothing, an area or a region of a partitioned stage holds no block, joints that may slide have less damping than
/// SlidingNeeds, stones of an arch on joints of the NMM.
/// @pre the model is checked
[[nodiscard]] std::vector<std::string> plan_warnings(const Model& model, const Plan& plan);

/// The single groups of warnings. Missing supports are checked in the directions of gravity and of lasting loads.
[[nodiscard]] std::vector<std::string> support_warnings(const Model& model, const std::vector<Touch>& touches,
                                                        const std::vector<BlockId>& absent = {});
[[nodiscard]] std::vector<std::string> damping_warnings(const Model& model, const Plan& plan);
[[nodiscard]] std::vector<std::string> partition_warnings(const Model& model, const Plan& plan);
[[nodiscard]] std::vector<std::string> sliding_warnings(const Model& model, const Plan& plan,
                                                        const std::vector<Touch>& touches);
[[nodiscard]] std::vector<std::string> arch_warnings(const Model& model, const Plan& plan,
                                                     const std::vector<Touch>& touches);
/// Slender blocks that stand alone on one joint of automatic stiffness, which a mesh divides, and that may be shaken:
/// the joint yields at its edge, that of a rigid block does not.
[[nodiscard]] std::vector<std::string> rocking_warnings(const Model& model, const Plan& plan,
                                                        const std::vector<Touch>& touches);

/// Blocks whose stresses are not in balance where a stage begins to move them: affine before, a mesh now.
[[nodiscard]] std::vector<std::string> hand_over_warnings(const Model& model, const Plan& plan);

/// Free blocks that only the thrust of their neighbours can carry, from both sides, as the stones of an arch: they do
/// not stand on joints that are less steep than their friction, nor between two blocks that stand.
[[nodiscard]] std::vector<BlockId> stones_of_arches(const Model& model, const std::vector<Touch>& touches);

/// "'a', 'b' and 3 more".
[[nodiscard]] std::string named_blocks(const Model& model, const std::vector<BlockId>& blocks);

}  // namespace scree::coupling
