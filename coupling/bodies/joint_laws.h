// The joint laws of a run at an instant: those of the model, their strengths divided by a factor where a stage sets
// one.
#pragma once

#include <vector>

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

/// A law with tan phi, cohesion, tensile strength and tan psi, peak and residual, divided by a factor. An infinite
/// tensile strength stays: such a bond never fails. Stiffness, damping and the slips over which strength changes stay.
/// @pre factor > 0   @source [Griffiths1999] section 2 (shear strength reduction), here for joints
[[nodiscard]] JointLaw divided(const JointLaw& law, double factor, StrengthPlan::Part part = StrengthPlan::Part::all);

/// A law whose strength failure and slip do not change: residual strengths are those of the peak. A joint that opens
/// loses its tensile strength all the same.
[[nodiscard]] JointLaw without_weakening(JointLaw law);

/// The factor of a stage at a time within it: from `from` to `to` over the stage, by equal ratios.
/// @param part  elapsed part of the stage's duration, 0 to 1
[[nodiscard]] double strength_factor(const StrengthPlan& plan, double part);

/// The strengths of joints for contacts. The law between two edges is chosen by the model's own friction angles,
/// independent of the factor.
class JointLaws {
 public:
  explicit JointLaws(const std::vector<JointLaw>& laws);

  /// Divides the strengths of the model.   @param plan  which laws and strengths   @param factor  1: those of the model
  void divide(const StrengthPlan& plan, double factor);
  [[nodiscard]] const JointLaw& operator[](std::size_t joint) const { return now_[joint]; }
  [[nodiscard]] const std::vector<JointLaw>& all() const { return now_; }
  /// Tangent of a law's friction angle, stored because it takes as long to compute as all the rest of the law.
  [[nodiscard]] double tan_friction(std::size_t joint) const { return tan_friction_[joint]; }

 private:
  const std::vector<JointLaw>* model_;
  std::vector<JointLaw> now_;
  std::vector<double> tan_friction_;
};

}  // namespace scree::coupling
