// A rectangle of a picture with data coordinates, its axes, and a colour bar.
#pragma once

#include <functional>
#include <string>

#include "io/pictures/canvas.h"
#include "io/pictures/ticks.h"

namespace scree::io {

/// Page rectangle [pt] (y down) and the data it shows (y up).
struct PlotArea {
  double x = 0.0, y = 0.0, w = 0.0, h = 0.0;
  double x0 = 0.0, x1 = 1.0, y0 = 0.0, y1 = 1.0;
  double numbers = 0.0;  // least room for the numbers of y, so that the labels of stacked plots stand in line [pt]

  [[nodiscard]] double px(double data_x) const { return x + (data_x - x0) / (x1 - x0) * w; }
  [[nodiscard]] double py(double data_y) const { return y + (y1 - data_y) / (y1 - y0) * h; }
};

inline constexpr TextStyle kTickText{7.5}, kLabelText{8.5};

/// Widest of the labels [pt].
[[nodiscard]] double widest(const Canvas& canvas, const Ticks& ticks);

/// Label of a coordinate relative to `from` [m]: "x [m]", "x − 500000 [m]".
[[nodiscard]] std::string axis_label(char axis, double from);

/// Frame, ticks outside, labels; grid lines if `grid` is true. An empty label of x leaves the numbers of x out, too.
void draw_axes(const Canvas& canvas, const PlotArea& area, const Ticks& x, const Ticks& y, const std::string& x_label,
               const std::string& y_label, bool grid);

/// What a colour bar shows.
struct ColourScale {
  double low = 0.0, high = 1.0;       // in the unit
  bool below = false, above = false;  // values beyond the ends exist: drawn as arrows
  Unit unit;
  std::function<Colour(double)> colour;  // of 0 to 1
};

/// A vertical colour bar with its ticks and label to the right of (x, y).   @return its width [pt]
double draw_colour_bar(const Canvas& canvas, double x, double y, double h, const ColourScale& scale,
                       const std::string& label);

}  // namespace scree::io
