// History of a stage that runs to rest, for the message if it does not come to rest.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// History of a stage that runs to rest, in four parts of its time or of its steps. Part of a checkpoint; it affects
/// messages only.
struct RestTrace {
  static constexpr int kParts = 4;
  std::vector<double>
      least;  // per part so far: the smallest unbalanced force over the largest force; only where it is measured
  std::vector<double> centre;  // part after part: x, y per body of its centre of mass as the part began [m]

  /// @param progress  0 to 1   @return true if a part begins
  [[nodiscard]] bool begins_part(double progress) const;
  /// Begins a part.   @param centres  per body
  void begin_part(std::span<const Vec2> centres);
  /// Updates the part after a step.   @param ratio  unbalanced force over the largest force
  void follow(double ratio);

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("rest.least", least);
    see("rest.centre", centre);
  }
};

/// Whether blocks creep, slide or stand still, which of them, and how fast the unbalanced force has fallen; empty where
/// the stage was too short.
///   displacement per part   d4 in the last, d3 in the one before; slides: d4 >= 0.9 d3, stands still: d4 <= 1e-4 of
///                           its displacement in the stage
/// @param centres  of the bodies at present   @param length  of the stage so far [s]
[[nodiscard]] std::string rest_text(const RestTrace& trace, const Setup& setup, std::span<const Vec2> centres,
                                    double length);

}  // namespace scree::coupling
