#include "io/pictures/frame_marks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "model/check.h"

namespace scree::io {

namespace {

constexpr double kHead = 5.0, kShortest = 3.0;                   // of arrows [pt]
constexpr double kLeastLongest = 10.0, kMostLongest = 34.0;      // [pt]
constexpr double kSpacing = 40.0;                                // [pt]
constexpr std::array<double, 4> kNameSizes{7.0, 6.0, 5.0, 4.0};  // that fit in [pt]
constexpr double kSmallName = 3.0;                               // of the others [pt]

/// A shaft with a filled head on a white rim, from (x, y) by (dx, dy) [pt].
void draw_arrow(const Canvas& canvas, double x, double y, double dx, double dy) {
  cairo_t* c = canvas.get();
  const double length = std::hypot(dx, dy), head = std::min(kHead, 0.6 * length);
  const double ex = dx / length, ey = dy / length, bx = x + dx - head * ex, by = y + dy - head * ey;
  const auto shape = [&] {
    cairo_new_path(c);
    cairo_move_to(c, x, y), cairo_line_to(c, bx, by);
    cairo_move_to(c, x + dx, y + dy);
    cairo_line_to(c, bx - 0.38 * head * ey, by + 0.38 * head * ex);
    cairo_line_to(c, bx + 0.38 * head * ey, by - 0.38 * head * ex);
    cairo_close_path(c);
  };
  cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  shape();
  canvas.ink({1.0, 1.0, 1.0, 0.85});
  cairo_set_line_width(c, 2.0);
  cairo_stroke(c);
  shape();
  canvas.ink({0.0, 0.0, 0.0});
  cairo_set_line_width(c, 0.8);
  cairo_fill_preserve(c);
  cairo_stroke(c);
}

/// How light a colour looks, 0 to 1.   @source [BT709], luma
double lightness(const Colour& c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; }

struct Held {
  std::vector<std::size_t> cells;
  Vec2 moment = Vec2::Zero();
  double area = 0.0;
};

/// The cell of a block that holds a point.
std::optional<std::size_t> cell_at(const StoredFrame& frame, const std::vector<std::size_t>& cells, const Vec2& point) {
  const auto at = std::find_if(cells.begin(), cells.end(), [&](std::size_t c) { return cell_holds(frame, c, point); });
  return at == cells.end() ? std::nullopt : std::optional(*at);
}

}  // namespace

double round_below(double x) {
  SCREE_ASSERT(x > 0.0 && std::isfinite(x));
  const double decade = std::pow(10.0, std::floor(std::log10(x)));
  const double m = x / decade * (1.0 + 1e-12);  // 5 stays 5
  return (m >= 5.0 ? 5.0 : m >= 2.0 ? 2.0 : 1.0) * decade;
}

bool cell_holds(const StoredFrame& f, std::size_t cell, const Vec2& point) {
  bool inside = false;  // after an odd number of edges to the right
  const auto first = static_cast<std::size_t>(f.offsets[cell]), end = static_cast<std::size_t>(f.offsets[cell + 1]);
  for (std::size_t i = first; i < end; ++i) {
    const auto p = static_cast<std::size_t>(f.connectivity[i]);
    const auto q = static_cast<std::size_t>(f.connectivity[i + 1 < end ? i + 1 : first]);
    const Vec2 a(f.position[2 * p], f.position[2 * p + 1]), b(f.position[2 * q], f.position[2 * q + 1]);
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) inside = !inside;
  }
  return inside;
}

ArrowMarks::ArrowMarks(const StoredFrame& frame, const std::vector<double>& value, const std::vector<char>& skip,
                       const PlotArea& area, double block, double noise, const std::string& name,
                       const std::string& si) {
  const double metres = (area.x1 - area.x0) / area.w;  // per point of the page
  arrows_ = arrows_of(frame, value, skip, kSpacing * metres);
  double longest = 0.0;
  for (const Arrow& a : arrows_) longest = std::max(longest, a.vector.norm());
  if (!(longest > noise)) {
    arrows_.clear();
    return;
  }
  points_ = std::clamp(0.9 * block, kLeastLongest, kMostLongest) / longest;
  const double round = round_below(longest);
  const Unit unit = prefixed(si, round);
  key_length_ = round * points_;
  key_ = fmt::format("{} {:g} {}", name, round / unit.factor, unit.name);
}

void ArrowMarks::draw(const Canvas& canvas, const PlotArea& area) const {
  for (const Arrow& a : arrows_) {
    const double dx = points_ * a.vector.x(), dy = -points_ * a.vector.y();  // y is down on the page
    if (std::hypot(dx, dy) > kShortest)
      draw_arrow(canvas, area.px(a.at.x()) - 0.5 * dx, area.py(a.at.y()) - 0.5 * dy, dx, dy);
  }
}

void ArrowMarks::draw_key(const Canvas& canvas, double x, double y) const {
  if (arrows_.empty()) return;
  TextStyle style = kTickText;
  style.up = 0.5;
  draw_arrow(canvas, x, y, key_length_, 0.0);
  canvas.text(x + key_length_ + 5.0, y, key_, style);
}

void draw_names(const Canvas& canvas, const PlotArea& area, const StoredFrame& frame,
                const std::vector<std::string>& names, const std::function<Colour(std::size_t)>& colour) {
  std::map<std::int32_t, Held> blocks;
  for (std::size_t c = 0; c < frame.cells(); ++c) {
    Held& block = blocks[frame.block[c]];
    block.cells.push_back(c);
    const double size = std::abs(cell_area(frame, c));
    block.moment += size * cell_middle(frame, c);
    block.area += size;
  }
  const double metres = (area.x1 - area.x0) / area.w;
  for (const auto& [number, block] : blocks) {
    const Vec2 middle = block.moment / block.area;
    if (!(block.area > 0.0) || !middle.allFinite()) continue;
    const std::string& name = names[static_cast<std::size_t>(number)];
    const Vec2 shown = middle.cwiseMax(Vec2(area.x0, area.y0)).cwiseMin(Vec2(area.x1, area.y1));
    if (shown != middle) continue;  // outside the window
    bool written = false;
    for (const double size : kNameSizes) {
      TextStyle style{size, 0.5, 0.5};
      const Vec2 half = 0.5 * metres * Vec2(canvas.text_width(name, style) + 1.0, size);
      bool fits = true;
      for (const double x : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 1.0})
          fits = fits && cell_at(frame, block.cells, middle + Vec2(x * half.x(), y * half.y()));
      const auto behind = cell_at(frame, block.cells, middle);
      if (!fits || !behind) continue;
      if (lightness(colour(*behind)) < 0.5) style.colour = {1.0, 1.0, 1.0};
      canvas.text(area.px(middle.x()), area.py(middle.y()), name, style);
      written = true;
      break;
    }
    if (written) continue;
    // In the cell that is nearest to the middle, if the middle lies outside of the block.
    const std::size_t cell =
        *std::min_element(block.cells.begin(), block.cells.end(), [&](std::size_t a, std::size_t b) {
          return (cell_middle(frame, a) - middle).norm() < (cell_middle(frame, b) - middle).norm();
        });
    const Vec2 at = cell_at(frame, block.cells, middle) ? middle : cell_middle(frame, cell);
    TextStyle style{kSmallName, 0.5, 0.5};
    Colour ground = colour(cell);
    if (lightness(ground) < 0.5) style.colour = {1.0, 1.0, 1.0};
    ground.a = 0.7;
    const double width = canvas.text_width(name, style) + 0.8;
    canvas.box(area.px(at.x()) - 0.5 * width, area.py(at.y()) - 0.5 * kSmallName, width, kSmallName, ground);
    canvas.text(area.px(at.x()), area.py(at.y()), name, style);
  }
}

}  // namespace scree::io
