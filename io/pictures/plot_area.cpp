#include "io/pictures/plot_area.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace scree::io {

namespace {

constexpr double kTickLength = 3.0, kTickGap = 2.5, kFrame = 0.6;  // [pt]
constexpr double kBar = 10.0, kArrow = 8.0;                        // [pt]

}  // namespace

double widest(const Canvas& canvas, const Ticks& ticks) {
  double w = 0.0;
  for (const std::string& label : ticks.label) w = std::max(w, canvas.text_width(label, kTickText));
  return w;
}

std::string axis_label(char axis, double from) {
  if (from == 0.0) return fmt::format("{} [m]", axis);
  return fmt::format("{} {} {} [m]", axis, from > 0.0 ? "−" : "+", std::abs(from));
}

void draw_axes(const Canvas& canvas, const PlotArea& a, const Ticks& x, const Ticks& y, const std::string& x_label,
               const std::string& y_label, bool grid) {
  TextStyle below = kTickText, left = kTickText, title = kLabelText, turned = kLabelText;
  below.across = 0.5, below.up = 1.0;
  left.across = 1.0, left.up = 0.5;
  title.across = 0.5, title.up = 1.0;
  turned.across = 0.5, turned.turned = true;
  for (std::size_t i = 0; i < x.at.size(); ++i) {
    const double px = a.px(x.at[i]);
    if (grid) canvas.line(px, a.y, px, a.y + a.h, 0.35, kFaint);
    canvas.line(px, a.y + a.h, px, a.y + a.h + kTickLength, kFrame, kInk);
    if (!x_label.empty()) canvas.text(px, a.y + a.h + kTickLength + kTickGap, x.label[i], below);
  }
  for (std::size_t i = 0; i < y.at.size(); ++i) {
    const double py = a.py(y.at[i]);
    if (grid) canvas.line(a.x, py, a.x + a.w, py, 0.35, kFaint);
    canvas.line(a.x - kTickLength, py, a.x, py, kFrame, kInk);
    canvas.text(a.x - kTickLength - kTickGap, py, y.label[i], left);
  }
  canvas.frame(a.x, a.y, a.w, a.h, kFrame, kInk);
  if (!x_label.empty()) canvas.text(a.x + 0.5 * a.w, a.y + a.h + kTickLength + kTickGap + 11.0, x_label, title);
  canvas.text(a.x - kTickLength - kTickGap - std::max(widest(canvas, y), a.numbers) - 6.0, a.y + 0.5 * a.h, y_label,
              turned);
}

double draw_colour_bar(const Canvas& canvas, double x, double y, double h, const ColourScale& scale,
                       const std::string& label) {
  const double top = y + (scale.above ? kArrow : 0.0), bottom = y + h - (scale.below ? kArrow : 0.0);
  const PlotArea bar{x, top, kBar, bottom - top, 0.0, 1.0, scale.low, scale.high};
  // Strips overlap by one so that no white shows between them.
  const int strips = 256;
  const double strip = bar.h / strips;
  for (int i = 0; i < strips; ++i)
    canvas.box(x, bottom - (i + 1) * strip, kBar, i == 0 ? strip : 2.0 * strip, scale.colour((i + 0.5) / strips));
  cairo_t* c = canvas.get();
  const auto arrow = [&](double base, double tip, double t) {
    cairo_move_to(c, x, base), cairo_line_to(c, x + 0.5 * kBar, tip), cairo_line_to(c, x + kBar, base);
    canvas.ink(scale.colour(t));
    cairo_fill(c);
  };
  if (scale.above) arrow(top, y, 1.0);
  if (scale.below) arrow(bottom, y + h, 0.0);
  cairo_move_to(c, x, bottom);
  if (scale.below) cairo_line_to(c, x + 0.5 * kBar, y + h);
  cairo_line_to(c, x + kBar, bottom), cairo_line_to(c, x + kBar, top);
  if (scale.above) cairo_line_to(c, x + 0.5 * kBar, y);
  cairo_line_to(c, x, top), cairo_close_path(c);
  canvas.ink(kInk);
  cairo_set_line_width(c, kFrame);
  cairo_stroke(c);

  const Ticks ticks = round_ticks(scale.low, scale.high, std::clamp(static_cast<int>(h / 28.0), 3, 8));
  TextStyle right = kTickText, turned = kLabelText;
  right.up = 0.5;
  turned.across = 0.5, turned.up = 1.0, turned.turned = true;
  for (std::size_t i = 0; i < ticks.at.size(); ++i) {
    canvas.line(x + kBar, bar.py(ticks.at[i]), x + kBar + kTickLength, bar.py(ticks.at[i]), kFrame, kInk);
    canvas.text(x + kBar + kTickLength + kTickGap, bar.py(ticks.at[i]), ticks.label[i], right);
  }
  const double numbers = kBar + kTickLength + kTickGap + widest(canvas, ticks) + 6.0;
  canvas.text(x + numbers, y + 0.5 * h, canvas.fitted(label, std::max(h, 90.0), turned), turned);
  return numbers + kLabelText.size;
}

}  // namespace scree::io
