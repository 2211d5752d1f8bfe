// How a stage comes to rest, for the message where it does not.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// What is kept of a stage that runs to rest, in four parts of its time or of its steps. Part of a checkpoint: it
/// changes nothing but what is told.
struct RestTrace {
  static constexpr int kParts = 4;
  std::vector<double>
      least;  // a part so far: the smallest unbalanced force, of the largest force; where it is measured
  std::vector<double> centre;  // part after part: x, y per body, its centre of mass as the part began [m]

  /// @param progress  0 to 1   @return true if a part begins
  [[nodiscard]] bool begins_part(double progress) const;
  /// A part begins.   @param centres  a body
  void begin_part(std::span<const Vec2> centres);
  /// After a step.   @param ratio  unbalanced force, of the largest force
  void follow(double ratio);

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("rest.least", least);
    see("rest.centre", centre);
  }
};

/// Whether blocks creep, slide or stand still, which of them, and how fast the unbalanced force has fallen; empty where
/// the stage was too short to tell.
///   way a part   d4 in the last, d3 in the one before; slides: d4 >= 0.9 d3, stands still: d4 < 1e-4 of its way in all
/// @param centres  of the bodies now   @param length  of the stage so far [s]
[[nodiscard]] std::string told(const RestTrace& trace, const Setup& setup, std::span<const Vec2> centres,
                               double length);

}  // namespace scree::coupling
