// Common parts of plots over time: ranges, curves, the stages behind them.
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "io/pictures/plot_area.h"
#include "io/results/run_reader.h"

namespace scree::io {

/// The least and the largest of values; those that are not finite are left out.
struct Range {
  double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();

  [[nodiscard]] bool empty() const { return !(low <= high); }
  void add(double value);
  void add(const std::vector<double>& values);
  /// Adds a fraction of its length at both ends; about one around a single value or none.
  void widen(double fraction);
};

/// A line through the points with the current ink, width and dashes. A value that is not finite interrupts it.
void draw_curve(const Canvas& canvas, const PlotArea& area, const std::vector<double>& x, const std::vector<double>& y);

/// Restricts drawing to an area during its lifetime.
class Clip {
 public:
  Clip(const Canvas& canvas, const PlotArea& area);
  Clip(const Clip&) = delete;
  Clip& operator=(const Clip&) = delete;
  ~Clip() { cairo_restore(cairo_); }

 private:
  cairo_t* cairo_;
};

/// Vertical lines where stages begin, except the first; with `names`, each stage's name above the area where it fits.
void draw_stages(const Canvas& canvas, const PlotArea& area, const std::vector<StoredStage>& stages, bool names);

}  // namespace scree::io
