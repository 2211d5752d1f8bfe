// The law of a contact point in an explicit step: from its place and memory to its forces and new memory.
#pragma once

#include <algorithm>
#include <cmath>

#include "coupling/contact/law/dilation.h"
#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {

/// Motion of a contact point in the step that led to its present place.
struct PointMotion {
  double foot = 0.0, length = 0.0;  // of the corner on its segment: fraction, and the segment's length [m]
  double rate = 0.0, shear = 0.0;   // of gap and stretch (foot less anchor, times length) [m/s]
  double per_time = 0.0;            // one over the step [1/s]; 0: no step has been taken
  double cn = 0.0, ct = 0.0;        // dashpots, normal and (while it sticks) tangential [N s/m]
  bool held_elsewhere = false;      // another edge or corner carries the contact, or the foot is beyond the edge
};

/// Normal force of the spring and the dashpot of a point. It never pulls more than the bond bears.
/// @param opened  by dilation in this step, on which the dashpot does not act [m]
inline void press_point(const JointLaw& law, const PointMotion& motion, double opened, ContactMemory& m) {
  const double spring = -m.kn * m.gap, rate = motion.rate - motion.per_time * opened;
  m.fn = std::max(0.0 - tension_limit(law, m), spring - motion.cn * rate);
  m.fd = m.fn - spring;
}

/// Slides to Coulomb's limit, opening the joint where it dilates.   @pre k_t |stretch| is above the limit
void slide_point(const JointLaw& law, double tan_friction, const PointMotion& motion, ContactMemory& m);

/// Opens a point: no force, no stretch.
inline void open_point(ContactMemory& m) {
  m.status = ContactStatus::open;
  m.fn = m.fd = m.ft = m.fdt = m.stretch = 0.0;
}

/// Normal spring, which pulls up to the tension limit of a bond; tangential spring with Coulomb's limit (return
/// mapping). A spring and its dashpot together pull no more than the tension limit, and stay within Coulomb's limit.
/// In: m.gap and m.stretch as the motion left them without slip. Out: forces fn, ft with their parts of damping fd,
/// fdt; status; accumulated slip; the anchor moved by the slip; gap0 moved by the opening due to slip; failure of the
/// bond. The law depends on nothing else: same arguments, same result.
/// @param tan_friction  tangent of law.friction   @pre m.kn, m.kt and m.tributary are those of the point
/// @source docs/theory/contact-law.md, "Coulomb friction"
inline void explicit_law(const JointLaw& law, double tan_friction, const PointMotion& motion, ContactMemory& m) {
  if (m.bonded != 0 && m.kn * m.gap > tension_limit(law, m)) mark_failed(law, m);
  // Where slip opens the joint, a point may have a gap up to the opening of this step's slip, and is closed after it.
  const double follows =
      law.dilation > 0.0 && m.status != ContactStatus::open ? opened_in(law, m.slip, std::abs(m.stretch)) : 0.0;
  if (motion.held_elsewhere || (m.gap >= follows && m.bonded == 0)) return open_point(m);
  press_point(law, motion, 0.0, m);
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
    if (pulled) return open_point(m);  // sheared through
    slide_point(law, tan_friction, motion, m);
  } else {
    m.status = ContactStatus::stick;
  }
  if (m.gap >= 0.0 && m.bonded == 0) return open_point(m);  // it did not slip far enough to stay closed
  // Damping only where the contact sticks, and in total never beyond the limit above.
  const double spring_t = -m.kt * m.stretch;
  m.ft = m.status == ContactStatus::stick ? std::clamp(spring_t - motion.ct * motion.shear, -limit, limit) : spring_t;
  m.fdt = m.ft - spring_t;
}

}  // namespace scree::coupling
