#include "app/slope/sliding_block.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace scree::app {
namespace {

/// Excess of the ground's acceleration along one step: from x0, growing by `slope` per second, for h seconds.
struct Piece {
  double x0, slope, h;
  [[nodiscard]] double excess(double t) const { return x0 + slope * t; }
  [[nodiscard]] double velocity(double v, double t) const { return v + t * (x0 + 0.5 * slope * t); }
  [[nodiscard]] double way(double v, double t) const { return t * (v + t * (0.5 * x0 + slope * t / 6.0)); }
  /// The piece that is left after t seconds.
  [[nodiscard]] Piece after(double t) const { return {excess(t), slope, h - t}; }
};

/// When a block at rest begins to slide; h: not within the piece.
double begin_of_slide(const Piece& p) {
  if (p.x0 > 0.0 || (p.x0 == 0.0 && p.slope > 0.0)) return 0.0;
  return p.slope > 0.0 ? std::min(p.h, -p.x0 / p.slope) : p.h;
}

/// First time above 0 at which the velocity v + x0 t + slope t^2/2 returns to zero; h: not within the piece.
double end_of_slide(const Piece& p, double v) {
  const double a = 0.5 * p.slope, b = p.x0, discriminant = b * b - 4.0 * a * v;
  if (discriminant < 0.0) return p.h;
  const double root = std::sqrt(discriminant), q = -0.5 * (b + (b >= 0.0 ? root : -root));
  double first = p.h;  // of both roots, in the form that does not cancel
  for (const double t : {a != 0.0 ? q / a : p.h, q != 0.0 ? v / q : p.h})
    if (t > 0.0 && t < first) first = t;
  return first;
}

}  // namespace

BlockSlide slide_of(const Samples& record, double yield, double factor) {
  if (!(yield > 0.0) || !(factor > 0.0))
    throw std::invalid_argument("the yield acceleration of a block and its factor are above 0");
  BlockSlide out;
  double v = 0.0;
  bool slides = false;
  const auto pass = [&](Piece p) {
    while (p.h > 0.0) {
      double t = 0.0;
      if (!slides) {
        t = begin_of_slide(p);
        if (t >= p.h) return;
        slides = true;
        ++out.slips;
      } else {
        t = end_of_slide(p, v);
        if (p.slope < 0.0)  // the peak of the velocity may lie within
          if (const double top = -p.x0 / p.slope; top > 0.0 && top < t)
            out.peak_velocity = std::max(out.peak_velocity, p.velocity(v, top));
        out.displacement += p.way(v, t);
        v = p.velocity(v, t);
        out.peak_velocity = std::max(out.peak_velocity, v);
        if (t < p.h) {
          v = 0.0;
          slides = false;
        }
      }
      p = p.after(t);
      if (slides && v == 0.0) p.x0 = std::max(0.0, p.x0);  // at the start of a slide the excess is exactly zero
    }
  };
  const std::vector<double>&time = record.time, &a = record.acceleration;
  for (std::size_t i = 0; i + 1 < time.size(); ++i) {
    const double h = time[i + 1] - time[i];
    pass({factor * (a[i] - yield), factor * (a[i + 1] - a[i]) / h, h});
  }
  if (slides) {  // the ground then moves at constant velocity
    out.displacement += 0.5 * v * v / (factor * yield);
  }
  return out;
}

Samples reversed(Samples record) {
  for (double& a : record.acceleration) a = -a;
  return record;
}

}  // namespace scree::app
