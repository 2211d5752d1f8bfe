#include "model/time_function.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace scree {

double TimeFunction::value(double t) const {
  const double s = t - start;
  if (s < 0.0) return 0.0;
  const auto half_turns = [&] { return std::numbers::pi * s / duration; };
  switch (shape) {
    case Shape::constant:
      return amplitude;
    case Shape::ramp:
      return amplitude * (s < duration ? s / duration : 1.0);
    case Shape::sine:
      return duration > 0.0 && s > duration ? 0.0 : amplitude * std::sin(2.0 * std::numbers::pi * frequency * s);
    case Shape::half_sine:
      return s < duration ? amplitude * std::sin(half_turns()) : 0.0;
    case Shape::sine_squared:
      return s < duration ? amplitude * std::sin(half_turns()) * std::sin(half_turns()) : 0.0;
    case Shape::table:
      break;
  }
  if (time.empty() || s < time.front()) return 0.0;
  if (s >= time.back()) return amplitude * table.back();
  const auto next = static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), s) - time.begin());
  const double fraction = (s - time[next - 1]) / (time[next] - time[next - 1]);
  return amplitude * (table[next - 1] + fraction * (table[next] - table[next - 1]));
}

double TimeFunction::begin() const { return shape == Shape::table && !time.empty() ? start + time.front() : start; }

double TimeFunction::end() const {
  switch (shape) {
    case Shape::constant:
      return start;
    case Shape::sine:
      return duration > 0.0 ? start + duration : std::numeric_limits<double>::infinity();
    case Shape::table:
      return time.empty() ? start : start + time.back();
    default:
      return start + duration;
  }
}

}  // namespace scree
