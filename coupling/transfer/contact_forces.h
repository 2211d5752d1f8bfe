// Contacts where bodies are created anew: vertices of a mesh are removed, their forces stay.
#pragma once

#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// Removes the contacts of mesh vertices that belong to bodies which change. The force of each is distributed to
/// the remaining points of the same two edges on either side, by the lever rule: resultant and moment are preserved.
/// Marks the contacts of changed bodies (segment = -1), so that they are measured anew without changing their force.
/// @param from     bodies and outlines before the change, at the positions state.q
/// @param changed  one flag per body
void hand_contacts_over(const Setup& from, const std::vector<char>& changed, State& state);

}  // namespace scree::coupling
