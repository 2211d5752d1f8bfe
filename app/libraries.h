// Shared libraries that add methods and laws to the command (--load).
#pragma once

#include <string>
#include <vector>

namespace scree::app {

/// Loads libraries in order and lets each register its methods and laws (coupling/library.h).
/// @pre no case has been read, nor the schema
/// @return the fault of the first library that cannot be used; empty: all are loaded
[[nodiscard]] std::string load_libraries(const std::vector<std::string>& files);

}  // namespace scree::app
