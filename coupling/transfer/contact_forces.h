// What happens to contacts when bodies are made anew: vertices of a mesh go, their forces stay.
#pragma once

#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// Removes the contacts of mesh vertices that belong to bodies which change. The force of each goes to the points of
/// the same two edges that remain on either side of it, by the lever rule: resultant and moment stay what they were.
/// Marks the contacts of changed bodies (segment = -1), so that they are measured anew without changing their force.
/// @param from     bodies and outlines before the change, at the positions state.q
/// @param changed  one flag a body
void hand_contacts_over(const Setup& from, const std::vector<char>& changed, State& state);

}  // namespace scree::coupling
