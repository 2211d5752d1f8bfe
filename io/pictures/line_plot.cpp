#include "io/pictures/line_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "io/pictures/colour_map.h"
#include "io/pictures/plot_curves.h"

namespace scree::io {
namespace {

constexpr double kWidth = 504.0, kPanel = 220.0, kTop = 34.0, kBottom = 40.0;  // [pt]
constexpr double kGap = 10.0, kSample = 20.0, kLine = 12.0;                    // legend [pt]
constexpr double kMostNames = 150.0, kDisc = 2.2;                              // [pt]
constexpr int kPixels = 1680;

std::vector<double> on_axis(const std::vector<double>& values, bool log) {
  if (!log) return values;
  std::vector<double> decades;
  decades.reserve(values.size());
  for (const double v : values) decades.push_back(v > 0.0 ? std::log10(v) : std::numeric_limits<double>::quiet_NaN());
  return decades;
}

/// Ticks of an axis, and its ends: whole decades where it is logarithmic.
Ticks ticks_of(Range& range, bool log, int count) {
  if (!log) {
    range.widen(0.04);
    return round_ticks(range.low, range.high, count);
  }
  if (range.empty()) range.add(0.0);
  range.low = std::floor(range.low + 1e-9);
  range.high = std::max(std::ceil(range.high - 1e-9), range.low + 1.0);
  return power_ticks(static_cast<int>(range.low), static_cast<int>(range.high), count);
}

void draw_discs(const Canvas& canvas, const PlotArea& area, const std::vector<double>& x,
                const std::vector<double>& y) {
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(x[i]) || !std::isfinite(y[i])) continue;
    cairo_arc(canvas.get(), area.px(x[i]), area.py(y[i]), kDisc, 0.0, 2.0 * std::numbers::pi);
    cairo_fill(canvas.get());
  }
}

void use_dashes(const Canvas& canvas, bool dashed) {
  const double dashes[] = {4.0, 2.5};
  cairo_set_dash(canvas.get(), dashes, dashed ? 2 : 0, 0.0);
}

void draw_legend(const Canvas& canvas, double x, double y, double room, const std::vector<PlotSeries>& series) {
  TextStyle style = kTickText;
  style.up = 0.5;
  for (std::size_t i = 0; i < series.size(); ++i, y += kLine) {
    const PlotArea here{x, y, kSample, 1.0};
    canvas.ink(distinct_colour(i));
    use_dashes(canvas, series[i].dashed);
    if (series[i].points)
      draw_discs(canvas, here, {0.5}, {1.0});
    else
      canvas.line(x, y, x + kSample, y, 1.2, distinct_colour(i));
    use_dashes(canvas, false);
    canvas.text(x + kSample + 4.0, y, canvas.fitted(series[i].name, room, style), style);
  }
}

}  // namespace

void draw_line_plot(const LinePlot& plot, const std::filesystem::path& file) {
  const PictureFormat format = format_or_error(file);
  Range xs, ys;
  for (const PlotSeries& s : plot.series) xs.add(on_axis(s.x, plot.log_x)), ys.add(on_axis(s.y, plot.log_y));
  const Ticks x_ticks = ticks_of(xs, plot.log_x, 7), y_ticks = ticks_of(ys, plot.log_y, 6);

  // Margins come from the widths of what stands in them, so nothing overlaps.
  const Canvas ruler(kWidth, 10.0, 64);
  double names = 0.0;
  for (const PlotSeries& s : plot.series) names = std::max(names, ruler.text_width(s.name, kTickText));
  names = std::min(names + 1.0, kMostNames);
  const double left = 30.0 + widest(ruler, y_ticks), right = kGap + kSample + 4.0 + names + 8.0;
  const double height = std::max(kPanel, kLine * static_cast<double>(plot.series.size()));
  const PlotArea area{left, kTop, kWidth - left - right, height, xs.low, xs.high, ys.low, ys.high};

  const Canvas canvas(kWidth, kTop + height + kBottom, kPixels, format);
  TextStyle title{9.5};
  title.bold = true;
  canvas.text(left, kTop - 14.0, canvas.fitted(plot.title, kWidth - left - 8.0, title), title);
  draw_axes(canvas, area, x_ticks, y_ticks, plot.x_label, plot.y_label, true);
  draw_legend(canvas, left + area.w + kGap, kTop + 0.5 * kLine, names, plot.series);
  const Clip clip(canvas, area);
  cairo_set_line_width(canvas.get(), 1.1);
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const PlotSeries& s = plot.series[i];
    const std::vector<double> x = on_axis(s.x, plot.log_x);
    std::vector<double> y = on_axis(s.y, plot.log_y);
    for (std::size_t k = 0; k < x.size(); ++k)
      if (!std::isfinite(x[k])) y[k] = x[k];
    canvas.ink(distinct_colour(i));
    use_dashes(canvas, s.dashed);
    s.points ? draw_discs(canvas, area, x, y) : draw_curve(canvas, area, x, y);
  }
  use_dashes(canvas, false);
  canvas.save(file);
}

}  // namespace scree::io
