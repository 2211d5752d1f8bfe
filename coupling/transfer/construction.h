// Blocks that are removed and added as a stage begins: contacts of removed blocks end, and forces replace them.
#pragma once

#include <vector>

#include "coupling/bodies/setup.h"
#include "coupling/plan.h"

namespace scree::coupling {

/// Ends the contacts of the removed blocks. The force of each contact on a block that stays, of its springs and its
/// water, is added to State::support in full as forces on the outline of that block; damping is not. The energy of the
/// springs is booked as excavated.
/// @param from   bodies and outlines before the change, at the positions state.q
/// @param gone   one flag per body: present now, absent in the next stage
void end_contacts(const Setup& from, const std::vector<char>& gone, State& state);

/// Ends the replacing forces on removed blocks; books the energy of their point supports and of their remainders
/// (State::rest).
void end_supports(const Setup& from, const std::vector<char>& gone, State& state);

/// Begins the release of the replacing forces, as the stage states: the acting fraction of each falls to 1 - release,
/// or stays if it is already smaller. Forces that have been released completely are dropped.
/// @pre state.stage_begin contains the stage
void begin_release(const Construction& construction, State& state);

}  // namespace scree::coupling
