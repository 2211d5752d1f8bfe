// What leaves and comes as a stage begins: contacts of blocks that leave end, and their forces stand in.
#pragma once

#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/plan.h"

namespace scree::coupling {

/// Ends the contacts of the blocks that leave. The force of each on a block that stays, its spring's and its water's,
/// goes to State::support as forces on the outline of that block, whole; damping does not. The energy of the springs is
/// booked as excavated.
/// @param from   bodies and outlines before the change, at the positions state.q
/// @param gone   one flag a body: it is there now and not in what follows
void end_contacts(const Setup& from, const std::vector<char>& gone, State& state);

/// Ends the forces on blocks that leave, books the energy of their point supports, and of what a hand-over has kept of
/// them.
void end_supports(const Setup& from, const std::vector<char>& gone, State& state);

/// Lets go of the forces that stand in, as the stage says: what acts of each falls to 1 - release, or stays where that
/// is more than what is left. What has been released before is dropped.
/// @pre state.stage_begin has the stage
void begin_release(const Construction& construction, State& state);

}  // namespace scree::coupling
