// Curves and points over a common axis, with a legend: references against what was found.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::io {

struct PlotSeries {
  std::string name;
  std::vector<double> x, y;  // of equal length; values that are not finite are left out
  bool points = false;       // discs in place of a line
  bool dashed = false;
};

struct LinePlot {
  std::string title, x_label, y_label;  // labels with units
  std::vector<PlotSeries> series;
  bool log_x = false, log_y = false;  // decades; values that are not positive are left out
};

/// Draws a plot as PNG, PDF or SVG, by the name of the file.   @throws FileError
void draw_line_plot(const LinePlot& plot, const std::filesystem::path& file);

}  // namespace scree::io
