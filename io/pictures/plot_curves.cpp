#include "io/pictures/plot_curves.h"

#include <algorithm>
#include <cmath>

namespace scree::io {

namespace {

constexpr Colour kStage{0.45, 0.45, 0.45};

}  // namespace

void Range::add(double value) {
  if (std::isfinite(value)) low = std::min(low, value), high = std::max(high, value);
}

void Range::add(const std::vector<double>& values) {
  for (const double v : values) add(v);
}

void Range::widen(double fraction) {
  if (empty()) low = high = 0.0;
  const double d = high > low ? fraction * (high - low) : std::max(std::abs(high), 1.0);
  low -= d, high += d;
}

void draw_curve(const Canvas& canvas, const PlotArea& area, const std::vector<double>& x,
                const std::vector<double>& y) {
  cairo_t* c = canvas.get();
  bool down = false;
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (!std::isfinite(y[i])) {
      down = false;
      continue;
    }
    const double px = area.px(x[i]), py = area.py(y[i]);
    if (!down) cairo_move_to(c, px, py);
    cairo_line_to(c, px, py);
    down = true;
  }
  cairo_stroke(c);
}

Clip::Clip(const Canvas& canvas, const PlotArea& a) : cairo_(canvas.get()) {
  cairo_save(cairo_);
  cairo_rectangle(cairo_, a.x, a.y, a.w, a.h);
  cairo_clip(cairo_);
  cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
}

void draw_stages(const Canvas& canvas, const PlotArea& area, const std::vector<StoredStage>& stages, bool names) {
  const double dots[] = {1.0, 2.0};
  TextStyle style = kTickText;
  style.across = 0.5, style.colour = kStage;
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (!stages[i].start) continue;
    const double start = std::max(*stages[i].start, area.x0);
    double end = area.x1;
    if (i + 1 < stages.size() && stages[i + 1].start) end = *stages[i + 1].start;
    if (i > 0 && start > area.x0 && start < area.x1) {
      cairo_set_dash(canvas.get(), dots, 2, 0.0);
      canvas.line(area.px(start), area.y, area.px(start), area.y + area.h, 0.8, kStage);
      cairo_set_dash(canvas.get(), nullptr, 0, 0.0);
    }
    const double room = area.px(end) - area.px(start) - 4.0;
    if (names && stages.size() > 1 && canvas.text_width(stages[i].name, style) <= room)
      canvas.text(0.5 * (area.px(start) + area.px(end)), area.y - 4.0, stages[i].name, style);
  }
}

}  // namespace scree::io
