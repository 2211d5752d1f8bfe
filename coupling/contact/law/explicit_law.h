// The law of a contact point in an explicit step: from its place and memory to its forces and new memory.
#pragma once

#include "coupling/contact_memory.h"
#include "model/model.h"

namespace scree::coupling {

/// Motion of a contact point in the step that led to its present place.
struct PointMotion {
  double foot = 0.0, length = 0.0;  // of the corner on its segment: fraction, and the segment's length [m]
  double rate = 0.0, shear = 0.0;   // of gap and stretch (foot less anchor, times length) [m/s]
  double per_time = 0.0;            // one over the step [1/s]; 0: no step has been taken
  double cn = 0.0, ct = 0.0;        // dashpots, normal and (while it sticks) tangential [N s/m]
  bool held_elsewhere = false;      // another edge or corner carries the contact, or the foot is beyond the edge
};

/// Normal spring, which pulls up to the tension limit of a bond; tangential spring with Coulomb's limit (return
/// mapping). A spring and its dashpot together pull no more than the tension limit, and stay within Coulomb's limit.
/// In: m.gap and m.stretch as the motion left them without slip. Out: forces fn, ft with their parts of damping fd,
/// fdt; status; accumulated slip; the anchor moved by the slip; gap0 moved by the opening due to slip; failure of the
/// bond. The law depends on nothing else: same arguments, same result.
/// @param tan_friction  tangent of law.friction   @pre m.kn, m.kt and m.tributary are those of the point
/// @source docs/theory/contact-law.md, "Coulomb friction"
void explicit_law(const JointLaw& law, double tan_friction, const PointMotion& motion, ContactMemory& m);

}  // namespace scree::coupling
