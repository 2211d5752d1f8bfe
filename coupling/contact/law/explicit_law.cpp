#include "coupling/contact/law/explicit_law.h"

#include "coupling/contact/law/coulomb.h"

namespace scree::coupling {

void slide_point(const JointLaw& law, double tan_friction, const PointMotion& motion, ContactMemory& m) {
  press_point(law, motion, 0.0, m);
  if (law.dilation > 0.0) {
    const DilatingTrial trial{
        m.kn, m.kt, -m.kn * m.gap - motion.cn * motion.rate, m.kn + motion.cn * motion.per_time, m.stretch, m.slip};
    const double slip = dilating_slip(law, trial, friction_limit(law, m, 0.0), friction_coefficient(law, m)),
                 opened = opened_in(law, m.slip, slip);
    m.gap -= opened;
    m.gap0 += opened;
    press_point(law, motion, opened, m);
  }
  const CoulombStep step = sliding(m.kt, m.stretch, strength(law, tan_friction, m).friction_limit(m.fn));
  m.slip += std::abs(step.slip);
  m.anchor = motion.foot - step.stretch / motion.length;
  m.stretch = (motion.foot - m.anchor) * motion.length;
  m.status = ContactStatus::slip;
}

}  // namespace scree::coupling
