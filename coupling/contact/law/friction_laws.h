// The registry of laws of friction.
#pragma once

#include <deque>

#include "model/friction_law.h"

namespace scree::coupling {

/// Friction that falls with the slip rate.   @source docs/theory/contact-law.md, "Velocity weakening"
[[nodiscard]] FrictionLaw velocity_weakening();

/// All laws, those of Scree first, then those registered, in that order. The first call closes the registry; a law
/// stays where it is until the program ends.
[[nodiscard]] const std::deque<FrictionLaw>& friction_laws();

/// Adds a law before the first case is read, for example as a program begins.
/// @throws std::logic_error  a law of that name exists, its functions or names are missing, or friction_laws() was
/// called
void register_friction_law(FrictionLaw law);

}  // namespace scree::coupling
