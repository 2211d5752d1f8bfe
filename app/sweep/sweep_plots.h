// Results of a sweep over the parameters that vary, as pictures.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/sweep/result_table.h"
#include "io/pictures/line_plot.h"

namespace scree::app {

struct NamedPlot {
  std::string name;  // of the result
  io::LinePlot plot;
};

/// One plot for each result that differs between runs that are done. One parameter that varies, in numbers: a point a
/// run. Two: the one with more values along the axis, a curve for each value of the other, at most twelve. Otherwise
/// none.
[[nodiscard]] std::vector<NamedPlot> sweep_plots(const ResultTable& table);

/// Draws them as <folder>/<result>.svg, in place of earlier ones.   @return their number   @throws FileError
std::size_t draw_sweep_plots(const ResultTable& table, const std::filesystem::path& folder);

}  // namespace scree::app
