// What to say where a step ends in a state without a meaning.
#pragma once

#include <span>
#include <string>

#include "coupling/integrate/time_integrator.h"

namespace scree::coupling {

/// Where a state has lost its meaning.
struct LostPlace {
  BodyIndex body;    // not valid: none
  std::string what;  // e.g. "element 12 near (0.5, 2) is turned inside out"
};
/// The first body that cannot be as q says: not finite, or turned inside out.
[[nodiscard]] LostPlace lost_place(const Setup& setup, std::span<const double> q);
/// The first node of a free body at which two numbers (x, y) a node are not both finite.
/// @param name  of the numbers, for the message   @param q  where the nodes are, finite
[[nodiscard]] LostPlace not_finite_at(const Setup& setup, std::span<const double> values, const std::string& name,
                                      std::span<const double> q);
/// Place, time and what may have caused it.   @param t  the instant that the step was to reach [s]
[[nodiscard]] StepReport lost_state(const LostPlace& place, double t);

}  // namespace scree::coupling
