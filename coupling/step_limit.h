// How long the steps of a partitioned stage may be after one that did not converge.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/ids.h"

namespace scree::coupling {

/// Steps whose iteration does not converge are repeated shorter; the next ones begin with what converged, and grow by a
/// factor of two only after some steps, twice as many each time that was too early. Without it every step of a stage
/// that needs shorter ones begins with attempts in vain, which cost more than all that follow.
struct StepLimit {
  Tick length = 0;             // longest attempt; 0: none
  std::int32_t hold = 0;       // steps until it grows
  std::int32_t next_hold = 1;  // after the next step that does not converge

  /// A step has been taken.
  /// @param h          its length
  /// @param converged  in its first attempt
  /// @param largest    length that the stage would have without this
  void taken(Tick h, bool converged, Tick largest) {
    constexpr std::int32_t kLongest = 32;
    if (!converged) {
      length = h;
      hold = next_hold;
      next_hold = std::min(2 * next_hold, kLongest);
    } else if (length == 0) {
      next_hold = std::max(1, next_hold / 2);
    } else if (--hold <= 0) {
      length *= 2;
      hold = 1;
      if (length >= largest) length = 0;
    }
  }
};

}  // namespace scree::coupling
