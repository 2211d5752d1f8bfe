#include "coupling/stages/step_grid.h"

#include <algorithm>

namespace scree::coupling {
namespace {

constexpr Tick kGroup = 8;

Tick parts(Tick whole, Tick most) { return (whole - 1) / most + 1; }

/// `count` equal parts of a stage: the first `short_ones` are a tick shorter than the others.
struct Grid {
  Grid(Tick of_begin, Tick end, Tick dt) : begin(of_begin), count(parts(end - of_begin, dt)) {
    step = (end - begin) / count;
    short_ones = count - (end - begin) % count;
  }
  [[nodiscard]] Tick point(Tick k) const { return begin + k * step + std::max<Tick>(0, k - short_ones); }
  /// The first point after a time, by its number.
  [[nodiscard]] Tick after(Tick now) const {
    const Tick passed = now - begin, of_short = short_ones * step;
    return passed < of_short ? passed / step + 1 : short_ones + (passed - of_short) / (step + 1) + 1;
  }
  Tick begin, count, step = 0, short_ones = 0;
};

}  // namespace

Tick next_step(Tick begin, Tick end, Tick now, Tick dt, Tick cap) {
  Tick target = end;
  if (dt > 0) {
    const Grid grid(begin, end, dt);
    const Tick group = cap < grid.step ? kGroup : 1;
    Tick k = parts(grid.after(now), group) * group;
    // Skip a point that is too close to be worth a step of its own.
    if (grid.point(std::min(k, grid.count)) - now < std::min(cap, grid.step) / 2) k += group;
    target = grid.point(std::min(k, grid.count));
  }
  const Tick left = target - now;
  return left / parts(left, cap);
}

}  // namespace scree::coupling
