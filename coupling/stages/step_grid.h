// Ends of the steps of a stage: set by the stage alone, independent of output, streams and monitors.
#pragma once

#include "model/ids.h"

namespace scree::coupling {

/// Length of the next step of a stage from `begin` to `end`, at most `cap`.
///   dt = 0   an equal part of the rest of the stage
///   dt > 0   the stage is divided into the fewest equal parts that are not above dt, and steps end where parts do.
///            Where only shorter steps are allowed, an equal part of the time to the end of the present group of eight
///            parts; after that, one or two steps lead back to the end of a part.
/// @pre begin <= now < end, cap >= 1     @return 1 to end - now
[[nodiscard]] Tick next_step(Tick begin, Tick end, Tick now, Tick dt, Tick cap);

}  // namespace scree::coupling
