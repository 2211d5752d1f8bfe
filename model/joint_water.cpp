#include "model/joint_water.h"

#include <algorithm>

namespace scree {
namespace {

/// Height of the line above a point, negative below it [m].
double depth(const JointWater& water, const Vec2& x) {
  const auto& line = water.line;
  const auto next =
      std::upper_bound(line.begin(), line.end(), x.x(), [](double at, const Vec2& p) { return at < p.x(); });
  if (next == line.begin()) return line.front().y() - x.y();
  if (next == line.end()) return line.back().y() - x.y();
  const Vec2 &a = *(next - 1), &b = *next;
  return a.y() + (b.y() - a.y()) * ((x.x() - a.x()) / (b.x() - a.x())) - x.y();
}

/// Integral of d(r) (1 - r) from r0 to r1, d linear between the values given; Simpson's rule is exact.
double weighted(double r0, double d0, double r1, double d1) {
  const double middle = 0.5 * (r0 + r1);
  return (r1 - r0) / 6.0 * (d0 * (1.0 - r0) + 2.0 * (d0 + d1) * (1.0 - middle) + d1 * (1.0 - r1));
}

/// The same integral over the part where d is positive.
double weighted_wet(double r0, double d0, double r1, double d1) {
  if (d0 <= 0.0 && d1 <= 0.0) return 0.0;
  if (d0 >= 0.0 && d1 >= 0.0) return weighted(r0, d0, r1, d1);
  const double dry = r0 + (r1 - r0) * d0 / (d0 - d1);
  return d0 > 0.0 ? weighted(r0, d0, dry, 0.0) : weighted(dry, 0.0, r1, d1);
}

}  // namespace

JointWater JointWater::in_stage(std::int32_t stage) const {
  JointWater out = *this;
  out.levels.clear();
  for (const Level& l : levels)
    if (l.stage.value <= stage) out.line = l.line;
  return out;
}

bool JointWater::fills(JointId joint) const {
  return joints.empty() || std::find(joints.begin(), joints.end(), joint) != joints.end();
}

double water_pressure(const JointWater& water, const Vec2& x) {
  return water.unit_weight * std::max(0.0, depth(water, x));
}

double water_force(const JointWater& water, const Vec2& from, const Vec2& way) {
  double sum = 0.0, last = 0.0, before = depth(water, from);
  const auto up_to = [&](double r) {
    const double here = depth(water, from + r * way);
    sum += weighted_wet(last, before, r, here);
    last = r;
    before = here;
  };
  // Below the kinks of the line, in the order in which the stretch passes them.
  const std::size_t points = water.line.size();
  for (std::size_t i = 0; i < points; ++i) {
    const Vec2& kink = water.line[way.x() > 0.0 ? i : points - 1 - i];
    const double r = (kink.x() - from.x()) / way.x();  // not a number or infinite on an upright stretch
    if (r > last && r < 1.0) up_to(r);
  }
  up_to(1.0);
  return water.unit_weight * way.norm() * sum;
}

}  // namespace scree
