// How long the steps of a partitioned stage may be after one that did not converge.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/ids.h"

namespace scree::coupling {

/// A step whose iteration does not converge is repeated with a shorter length. The next steps begin with the length
/// that converged, and this length is doubled only after some steps: after twice as many each time that doubling
/// failed. Without it every step of a stage that needs shorter steps begins with attempts that fail, each as costly as
/// several steps that converge.
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
