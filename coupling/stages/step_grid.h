// Where the steps of a stage end: by the stage alone, whoever looks on.
#pragma once

#include "model/ids.h"

namespace scree::coupling {

/// Length of the next step of a stage from `begin` to `end`, at most `cap`.
///   dt = 0   an equal part of what is left of the stage
///   dt > 0   the stage is divided into the fewest equal parts that are not above dt, and steps end where parts do.
///            Where only shorter ones are allowed, an equal part of the way to the end of the present group of eight
///            parts; after that, in one step or two, back to where a part ends.
/// @pre begin <= now < end, cap >= 1     @return 1 to end - now
[[nodiscard]] Tick next_step(Tick begin, Tick end, Tick now, Tick dt, Tick cap);

}  // namespace scree::coupling
