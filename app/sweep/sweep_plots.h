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

/// One plot for each result that differs between runs that are done. If one parameter varies, in numbers: one point
/// per run. If two vary: the one with more values along the axis, one curve per value of the other, at most twelve.
/// Otherwise no plots.
[[nodiscard]] std::vector<NamedPlot> sweep_plots(const ResultTable& table);

/// Draws them as <folder>/<result>.svg, in place of earlier ones.   @return their number   @throws FileError
std::size_t draw_sweep_plots(const ResultTable& table, const std::filesystem::path& folder);

}  // namespace scree::app
