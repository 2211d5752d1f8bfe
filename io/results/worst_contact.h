// The worst of the closed contacts of an instant.
#pragma once

#include <span>
#include <string>

#include "coupling/state.h"

namespace scree::io {

struct WorstContact {
  double time = -1.0;               // [s]; negative: none looked at yet
  double depth = 0.0, force = 0.0;  // deepest penetration [m], largest force [N]
  std::string depth_at, force_at;   // whose: corner and edge by the names of their blocks; empty: nothing is closed
};

/// @param blocks  names; a block without one is "block" and its number
[[nodiscard]] WorstContact worst_contact(const coupling::State& state, std::span<const std::string> blocks);

}  // namespace scree::io
