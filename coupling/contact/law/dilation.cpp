#include "coupling/contact/law/dilation.h"

#include <algorithm>
#include <cmath>

#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {

double opened_by_slip(const JointLaw& law, double slip) {
  if (law.dilation == 0.0) return 0.0;
  return std::tan(law.dilation) * std::min(slip, law.dilation_slip.value_or(slip));
}

double opened_in(const JointLaw& law, double before, double slip) {
  return opened_by_slip(law, before + slip) - opened_by_slip(law, before);
}

double dilating_slip(const JointLaw& law, const DilatingTrial& t, double cohesion, double mu) {
  const double slope = t.per_opening * std::tan(law.dilation), e = std::abs(t.stretch);
  const double left = law.dilation_slip ? std::max(0.0, *law.dilation_slip - t.before) : e;
  double slip = (t.kt * e - cohesion - mu * t.pressed) / (t.kt + mu * slope);
  if (slip > left) slip = e - (cohesion + mu * (t.pressed + slope * left)) / t.kt;
  if (t.pressed + slope * std::min(slip, left) < 0.0) slip = e - cohesion / t.kt;
  return std::clamp(slip, 0.0, e);
}

DilatingForce dilating_force(const JointLaw& law, const Strength& strength, double k, double kt, double direction,
                             bool opens, double left) {
  const double slope = k * std::tan(law.dilation);
  if (!opens) return {k, 0.0, -slope * left};
  const double part = 1.0 / (1.0 + slope / kt * strength.coefficient);
  return {part * k, part * slope * direction, part * slope * strength.friction_limit(0.0) / kt};
}

}  // namespace scree::coupling
