// Limit of the step length in a partitioned stage after a step that did not converge, or took too many iterations.
#pragma once

#include <algorithm>
#include <cstdint>

#include "model/ids.h"

namespace scree::coupling {

/// A step whose iteration does not converge is repeated with a shorter length. The next steps begin with the length
/// that converged, and this length is doubled only after a number of steps, which itself doubles each time that
/// doubling the length failed. Without this limit every step of a stage that needs shorter steps begins with attempts
/// that fail, each as costly as several steps that converge. If a step converged, but in so many iterations that steps
/// of half its length are cheaper for the same time, steps of half its length follow, under the same rule.
struct StepLimit {
  enum class Iteration { short_, long_, failed };  // in the first attempt of a step

  Tick length = 0;             // longest attempt; 0: no limit
  std::int32_t hold = 0;       // steps until the length is doubled
  std::int32_t next_hold = 1;  // `hold` after the next step that does not converge, or takes too many iterations

  /// Updates the limit after a step.
  /// @param h          its length
  /// @param iteration  of its first attempt
  /// @param largest    step length of the stage without this limit
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
