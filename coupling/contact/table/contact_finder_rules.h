// Constants shared by the rules of which contact carries.
#pragma once

namespace scree::coupling {

inline constexpr double kInLine = 0.5;  // of a corner's depth: above it the depth is that of the joint beside it

}  // namespace scree::coupling
