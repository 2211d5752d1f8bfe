// A block that cannot be discretised as its stage requires.
#pragma once

#include <stdexcept>

namespace scree {

/// What a pool throws from add(): it names the block, the cause and what to change.
struct MeshError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace scree
