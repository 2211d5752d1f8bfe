// Report of a step that ends in a meaningless state.
#pragma once

#include <span>
#include <string>

#include "coupling/integrate/time_integrator.h"

namespace scree::coupling {

/// Place where a state is meaningless.
struct LostPlace {
  BodyIndex body;    // not valid: none
  std::string what;  // e.g. "element 12 near (0.5, 2) is turned inside out"
};
/// The first body whose positions q are not possible: not finite, or turned inside out. Of the setup's own pools: other
/// bodies keep their shape, or another integrator judges them.
[[nodiscard]] LostPlace lost_place(const Setup& setup, std::span<const double> q);
/// The first node of a free body whose two values (x, y) are not both finite.
/// @param name  of the values, for the message   @param q  positions of the nodes, finite
[[nodiscard]] LostPlace not_finite_at(const Setup& setup, std::span<const double> values, const std::string& name,
                                      std::span<const double> q);
/// Report with place, time and likely causes.   @param t  the instant that the step was to reach [s]
[[nodiscard]] StepReport lost_state(const LostPlace& place, double t);

}  // namespace scree::coupling
