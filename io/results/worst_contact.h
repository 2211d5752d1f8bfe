// The closed contacts with the deepest penetration and with the largest force at an instant.
#pragma once

#include <span>
#include <string>

#include "coupling/state.h"

namespace scree::io {

struct WorstContact {
  double time = -1.0;               // [s]; negative: not evaluated yet
  double depth = 0.0, force = 0.0;  // deepest penetration [m], largest force [N]
  std::string depth_at, force_at;   // that contact: vertex and edge, with the names of their blocks; empty: none closed
};

/// @param blocks  names; a block without a name is called "block" and its number
[[nodiscard]] WorstContact worst_contact(const coupling::State& state, std::span<const std::string> blocks);

}  // namespace scree::io
