// Certified bound of the explicit step with contacts and supports.
#pragma once

#include <span>
#include <string>

#include "coupling/contact/contact_finder.h"
#include "coupling/integrate/point_springs.h"

namespace scree::coupling {

/// h <= 2/sqrt(lambda),  lambda <= theta [lambda_body + max over groups of sum_{c touching it} k_c (mu_c + mu_c')]
/// with the groups of the method (covers, whole bodies), mu the compliance of a row in the method's diagonal mass (none
/// for driven bodies) and k_c the larger of the two stiffnesses of a point. Every point in the list counts as closed.
/// @param binding  receives what binds the step, if given
/// @return the bound [s]; infinite if nothing is stiff
/// @source contact.md "Explicit"
[[nodiscard]] double certified_step(const Setup& setup, const ContactList& contacts,
                                    std::span<const PointSpring> springs, std::string* binding);

}  // namespace scree::coupling
