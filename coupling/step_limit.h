// How long the steps of a partitioned stage may be after one that did not converge, or took too many iterations.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/ids.h"

namespace scree::coupling {

/// A step whose iteration does not converge is repeated with a shorter length. The next steps begin with the length
/// that converged, and this length is doubled only after some steps: after twice as many each time that doubling
/// failed. Without it every step of a stage that needs shorter steps begins with attempts that fail, each as costly as
/// several steps that converge. A step that converged, in so many iterations that steps of half its length take less
/// for the same time, is followed by those, under the same rule.
struct StepLimit {
  enum class Iteration { short_, long_, failed };  // in the first attempt of a step

  Tick length = 0;             // longest attempt; 0: none
  std::int32_t hold = 0;       // steps until it grows
  std::int32_t next_hold = 1;  // after the next step that does not converge, or takes too many iterations

  /// A step has been taken.
  /// @param h          its length
  /// @param iteration  of its first attempt
  /// @param largest    length that the stage would have without this
  void taken(Tick h, Iteration iteration, Tick largest) {
    constexpr std::int32_t kLongest = 32;
    if (iteration != Iteration::short_) {
      length = iteration == Iteration::failed ? h : std::max<Tick>(1, h / 2);
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
