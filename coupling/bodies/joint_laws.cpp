#include "coupling/bodies/joint_laws.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {

namespace {

/// Writes the divided strengths of a law into another; copies no list, which is not allowed in steps.
void divide_into(const JointLaw& law, double factor, StrengthPlan::Part part, JointLaw& out) {
  const double f = part == StrengthPlan::Part::cohesion ? 1.0 : factor,
               c = part == StrengthPlan::Part::friction ? 1.0 : factor;
  const auto angle = [f](double phi) { return f == 1.0 ? phi : std::atan(std::tan(phi) / f); };
  out.friction = angle(law.friction);
  if (law.residual_friction) out.residual_friction = angle(*law.residual_friction);
  out.dilation = angle(law.dilation);
  out.cohesion = law.cohesion / c;
  out.residual_cohesion = law.residual_cohesion / c;
  out.tensile_strength = law.tensile_strength / c;
}

}  // namespace

JointLaw divided(const JointLaw& law, double factor, StrengthPlan::Part part) {
  JointLaw out = law;
  divide_into(law, factor, part, out);
  return out;
}

JointLaw without_weakening(JointLaw law) {
  law.residual_friction.reset();
  law.weakening_slip = 0.0;
  law.residual_cohesion = law.cohesion;
  law.friction_law = nullptr;
  law.friction_constants.clear();
  return law;
}

double strength_factor(const StrengthPlan& plan, double part) {
  const double p = std::clamp(part, 0.0, 1.0);
  if (p == 0.0 || plan.from == plan.to) return plan.from;
  return p == 1.0 ? plan.to : plan.from * std::pow(plan.to / plan.from, p);
}

JointLaws::JointLaws(const std::vector<JointLaw>& laws) : model_(&laws), now_(laws) {
  for (const JointLaw& law : laws) tan_friction_.push_back(std::tan(law.friction));
}

void JointLaws::divide(const StrengthPlan& plan, double factor) {
  for (const JointId joint : plan.joints) {
    const std::size_t j = joint.index();
    divide_into((*model_)[j], factor, plan.part, now_[j]);
    const double t = std::tan((*model_)[j].friction);
    tan_friction_[j] = plan.part == StrengthPlan::Part::cohesion ? t : t / factor;
  }
}

}  // namespace scree::coupling
