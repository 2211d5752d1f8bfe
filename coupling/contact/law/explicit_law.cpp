#include "coupling/contact/law/explicit_law.h"

#include <algorithm>
#include <cmath>

#include "coupling/contact/law/coulomb.h"
#include "coupling/contact/law/dilation.h"
#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {
namespace {

void open(ContactMemory& m) {
  m.status = ContactStatus::open;
  m.fn = m.fd = m.ft = m.fdt = m.stretch = 0.0;
}

/// Normal force of the spring and the dashpot. It never pulls more than the bond bears.
/// @param opened  by dilation in this step, on which the dashpot does not act [m]
void press(const JointLaw& law, const PointMotion& motion, double opened, ContactMemory& m) {
  const double spring = -m.kn * m.gap, rate = motion.rate - motion.per_time * opened;
  m.fn = std::max(0.0 - tension_limit(law, m), spring - motion.cn * rate);
  m.fd = m.fn - spring;
}

/// Slides to Coulomb's limit, opening the joint where it dilates.
void slide(const JointLaw& law, double tan_friction, const PointMotion& motion, ContactMemory& m) {
  press(law, motion, 0.0, m);
  if (law.dilation > 0.0) {
    const DilatingTrial trial{
        m.kn, m.kt, -m.kn * m.gap - motion.cn * motion.rate, m.kn + motion.cn * motion.per_time, m.stretch, m.slip};
    const double slip = dilating_slip(law, trial, friction_limit(law, m, 0.0), friction_coefficient(law, m)),
                 opened = opened_in(law, m.slip, slip);
    m.gap -= opened;
    m.gap0 += opened;
    press(law, motion, opened, m);
  }
  const CoulombStep step = sliding(m.kt, m.stretch, strength(law, tan_friction, m).friction_limit(m.fn));
  m.slip += std::abs(step.slip);
  m.anchor = motion.foot - step.stretch / motion.length;
  m.stretch = (motion.foot - m.anchor) * motion.length;
  m.status = ContactStatus::slip;
}

}  // namespace

void explicit_law(const JointLaw& law, double tan_friction, const PointMotion& motion, ContactMemory& m) {
  if (m.bonded != 0 && m.kn * m.gap > tension_limit(law, m)) mark_failed(law, m);
  // Where slip opens the joint, a point may have a gap up to the opening of this step's slip, and is closed after it.
  const double follows =
      law.dilation > 0.0 && m.status != ContactStatus::open ? opened_in(law, m.slip, std::abs(m.stretch)) : 0.0;
  if (motion.held_elsewhere || (m.gap >= follows && m.bonded == 0)) return open(m);
  press(law, motion, 0.0, m);
  if (m.status == ContactStatus::open) {  // closes here: the spring begins at the foot
    m.anchor = motion.foot;
    m.stretch = 0.0;
    m.status = ContactStatus::stick;
  }
  // An intact point does not fail because its dashpot lowers the normal force: then that of the spring counts.
  const double bearing = m.failed == 0 && can_fail(law) ? std::max(m.fn, m.fn - m.fd) : m.fn;
  const double limit = strength(law, tan_friction, m).friction_limit(bearing);
  if (m.kt * std::abs(m.stretch) > limit) {
    const bool pulled = m.bonded != 0 && m.gap >= 0.0;
    mark_failed(law, m);
    if (pulled) return open(m);  // sheared through
    slide(law, tan_friction, motion, m);
  } else {
    m.status = ContactStatus::stick;
  }
  if (m.gap >= 0.0 && m.bonded == 0) return open(m);  // it did not slip far enough to stay closed
  // Damping only where the contact sticks, and in total never beyond the limit above.
  const double spring_t = -m.kt * m.stretch;
  m.ft = m.status == ContactStatus::stick ? std::clamp(spring_t - motion.ct * motion.shear, -limit, limit) : spring_t;
  m.fdt = m.ft - spring_t;
}

}  // namespace scree::coupling
