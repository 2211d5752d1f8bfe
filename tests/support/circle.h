// A circle as a ring of corners.
#pragma once

#include <cmath>
#include <numbers>

#include "tests/support/scene.h"

namespace scree::test {

/// A regular ring of the same area as the circle about the origin.
/// @param turn  angle of the first corner from the x axis, over the angle between corners
[[nodiscard]] inline Ring circle(double radius, int corners, bool clockwise, double turn = 0.0) {
  const double step = 2.0 * std::numbers::pi / corners, r = radius * std::sqrt(step / std::sin(step));
  Ring ring;
  for (int i = 0; i < corners; ++i) {
    const double angle = (clockwise ? -1.0 : 1.0) * step * (i + turn);
    ring.push_back(r * Vec2(std::cos(angle), std::sin(angle)));
  }
  return ring;
}

}  // namespace scree::test
