// What the rules of which contact carries have in common.
#pragma once

namespace scree::coupling {

inline constexpr double kInLine = 0.5;  // of a corner's depth: more of it is that of the joint that goes on beside it

}  // namespace scree::coupling
