#include "io/live/quantise.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::io {
namespace {

constexpr double kSteps = 65534.0;

struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  [[nodiscard]] double middle() const { return low > high ? 0.0 : 0.5 * low + 0.5 * high; }
  [[nodiscard]] double step() const { return low > high ? 0.0 : high / kSteps - low / kSteps; }
};

Range range(std::span<const double> d) {
  Range r;
  for (const double value : d)
    if (std::isfinite(value)) r.low = std::min(r.low, value), r.high = std::max(r.high, value);
  return r;
}

std::vector<std::int16_t> steps(std::span<const double> d, double base, double scale) {
  std::vector<std::int16_t> q(d.size(), kNotFinite);
  const double per_step = scale > 0.0 ? 1.0 / scale : 0.0;
  for (std::size_t i = 0; i < d.size(); ++i) {
    if (!std::isfinite(d[i])) continue;
    // std::round would be a function call; rounding may exceed the end of the range by one.
    const double exact = (d[i] - base) * per_step;
    q[i] = static_cast<std::int16_t>(std::clamp(exact + std::copysign(0.5, exact), -32767.0, 32767.0));
  }
  return q;
}

}  // namespace

Quantised quantise(std::span<const double> dx, std::span<const double> dy) {
  const Range x = range(dx), y = range(dy);
  Quantised result;
  result.base = {x.middle(), y.middle()};
  result.scale = std::max(x.step(), y.step());
  if (!std::isnormal(result.scale)) result.scale = 0.0;  // below 1e-307 m: treated as no range
  result.dx = steps(dx, result.base[0], result.scale);
  result.dy = steps(dy, result.base[1], result.scale);
  return result;
}

double restore(double base, double scale, std::int16_t q) {
  return q == kNotFinite ? std::numeric_limits<double>::quiet_NaN() : base + scale * q;
}

}  // namespace scree::io
