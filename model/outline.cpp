#include "model/outline.h"

#include <cmath>
#include <numbers>

namespace scree {

double interior_angle(const Vec2& before, const Vec2& vertex, const Vec2& after) {
  const Vec2 out = after - vertex, in = before - vertex;
  const double angle = std::atan2(cross(out, in), out.dot(in));
  return angle > 0.0 ? angle : angle + 2.0 * std::numbers::pi;
}

}  // namespace scree
