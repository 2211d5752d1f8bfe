#include "io/pictures/bolt_marks.h"

#include <algorithm>
#include <cmath>

namespace scree::io {
namespace {
constexpr double kThin = 0.7, kWide = 2.6, kRim = 0.8;  // [pt]
}  // namespace

void draw_bolts(const Canvas& canvas, const PlotArea& area, const StoredBolts& bolts) {
  const Colour rim{1.0, 1.0, 1.0, 0.8};
  double largest = 0.0;
  for (const double f : bolts.force) largest = std::max(largest, std::abs(f));
  for (const bool on_rim : {true, false})
    for (std::size_t k = 0; k + 1 < bolts.bolt.size(); ++k) {
      if (bolts.bolt[k] != bolts.bolt[k + 1]) continue;
      const double part = largest > 0.0 ? std::abs(bolts.force[k]) / largest : 0.0;
      const double width = kThin + part * (kWide - kThin);
      canvas.line(area.px(bolts.position[2 * k]), area.py(bolts.position[2 * k + 1]),
                  area.px(bolts.position[2 * k + 2]), area.py(bolts.position[2 * k + 3]), on_rim ? width + kRim : width,
                  on_rim ? rim : kBoltInk);
    }
}

void draw_bolt_sample(const Canvas& canvas, double x, double y) { canvas.line(x, y, x + 14.0, y, kWide, kBoltInk); }

}  // namespace scree::io
