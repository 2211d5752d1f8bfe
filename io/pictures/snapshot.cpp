#include "io/pictures/snapshot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "io/pictures/bolt_marks.h"
#include "io/pictures/colour_map.h"
#include "io/pictures/frame_field.h"
#include "io/pictures/frame_marks.h"
#include "io/pictures/plot_area.h"
#include "io/pictures/recovered_stress.h"
#include "io/results/rock_use.h"
#include "model/check.h"

namespace scree::io {

namespace {

constexpr double kSnapshotWidth = 504.0;                       // of the page: 7 inches [pt]
constexpr double kSnapshotTop = 40.0, kSnapshotBottom = 50.0;  // title; ticks, label and key [pt]
constexpr double kBarGap = 10.0, kSnapshotEdge = 8.0;          // [pt]
constexpr std::size_t kMostLegendNames = 24;                   // in a legend

/// Everything a drawing of one frame needs.
struct Scene {
  const RunReader& run;
  const SnapshotOptions& options;
  StoredFrame frame;
  std::vector<double> values;   // per cell
  std::vector<double> corners;  // of smoothed stress: an entry of frame.connectivity; else empty
  std::vector<char> held;       // per cell
  ColourScale scale;            // for fields with a unit

  Scene(const RunReader& reader, const SnapshotOptions& asked);
  [[nodiscard]] bool named() const { return *info(options.field).unit == '\0'; }
  [[nodiscard]] Colour colour(std::size_t cell) const;
  [[nodiscard]] Colour colour_of(double value) const;  // of a field with a unit
  [[nodiscard]] const std::string& name_of(std::size_t number) const;
};

std::size_t chosen_frame(const RunReader& run, const SnapshotOptions& options, const std::filesystem::path& folder) {
  if (run.times().empty()) throw FileError(folder, "has no frames yet");
  if (options.frame) return *options.frame;
  return options.time ? run.at_time(*options.time) : run.times().size() - 1;
}

Scene::Scene(const RunReader& reader, const SnapshotOptions& asked) : run(reader), options(asked) {}

/// Replaces the stress of cells by that at their corners, and by its mean.
void smooth(Scene& s) {
  const std::vector<double> stress = recovered_stress(s.frame);
  s.corners.resize(s.frame.connectivity.size());
  for (std::size_t i = 0; i < s.corners.size(); ++i)
    s.corners[i] = stress_value({stress[3 * i], stress[3 * i + 1], stress[3 * i + 2]}, s.options.field);
  for (std::size_t c = 0; c < s.values.size(); ++c) {
    const auto first = s.corners.begin() + s.frame.offsets[c], end = s.corners.begin() + s.frame.offsets[c + 1];
    if (first != end) s.values[c] = std::accumulate(first, end, 0.0) / static_cast<double>(end - first);
  }
}

void prepare(Scene& s, std::size_t index) {
  s.frame = s.run.frame(index);
  s.values = s.options.field == Field::utilisation ? cell_utilisation(s.frame, s.run.materials())
                                                   : cell_values(s.frame, s.options.field);
  if (s.options.smooth && info(s.options.field).is_signed) smooth(s);
  for (const std::int32_t b : s.frame.block) s.held.push_back(s.run.blocks()[static_cast<std::size_t>(b)].held ? 1 : 0);
  if (s.named()) return;
  const FieldInfo& field = info(s.options.field);
  const double rounding = rounding_of(s.options.field, s.frame, s.run.materials());
  const auto [low, high] =
      s.options.range ? *s.options.range : colour_range(s.frame, s.options.field, s.values, s.held, rounding);
  SCREE_ASSERT(low < high);
  s.scale.unit = prefixed(field.unit, std::max(std::abs(low), std::abs(high)));
  s.scale.low = low / s.scale.unit.factor;
  s.scale.high = high / s.scale.unit.factor;
  s.scale.colour = sequential_colour;
  if (field.is_signed)  // white at zero, wherever zero is in the range
    s.scale.colour = [a = low, b = high](double t) {
      return diverging_colour(0.5 + 0.5 * (a + t * (b - a)) / std::max(std::abs(a), std::abs(b)));
    };
  const double slack = 1e-9 * (high - low);
  for (std::size_t c = 0; c < s.values.size(); ++c) {
    if (s.held[c]) continue;
    s.scale.below = s.scale.below || s.values[c] < low - slack;
    s.scale.above = s.scale.above || s.values[c] > high + slack;
  }
}

Colour Scene::colour(std::size_t cell) const {
  return named() ? distinct_colour(static_cast<std::size_t>(values[cell])) : colour_of(values[cell]);
}

Colour Scene::colour_of(double value) const {
  if (!std::isfinite(value)) return {0.5, 0.5, 0.5};
  const double shown = value / scale.unit.factor;
  return scale.colour(std::clamp((shown - scale.low) / (scale.high - scale.low), 0.0, 1.0));
}

const std::string& Scene::name_of(std::size_t number) const {
  if (options.field == Field::method) return run.methods()[number];
  return options.field == Field::material ? run.materials()[number].name : run.blocks()[number].name;
}

/// The box of what is drawn, with a margin.
Box shown_box(const Scene& s) {
  if (s.options.window) return *s.options.window;
  Box box{Vec2::Constant(1e300), Vec2::Constant(-1e300)};
  const auto add = [&](const Vec2& p) {
    if (!p.allFinite()) return;  // runs that ended in non-finite numbers are drawn, too: they are viewed most of all
    box.lo = box.lo.cwiseMin(p);
    box.hi = box.hi.cwiseMax(p);
  };
  for (std::size_t p = 0; p < s.frame.points(); ++p) add({s.frame.position[2 * p], s.frame.position[2 * p + 1]});
  for (const StoredBlock& block : s.run.blocks())
    for (const Vec2& p : block.polygon.outer) add(p);
  const Vec2 margin = Vec2::Constant(std::max(0.025 * (box.hi - box.lo).maxCoeff(), 1e-9));
  return {box.lo - margin, box.hi + margin};
}

/// The plot on a page of fixed width, equal scales; a model much wider or taller than usual gets space around it.
PlotArea placed(const Box& box, double left, double right) {
  const double w = kSnapshotWidth - left - right;
  const Vec2 size = box.hi - box.lo;
  const double h = w * std::clamp(size.y() / size.x(), 0.28, 1.1);
  const double metres = std::max(size.x() / w, size.y() / h);  // per point of the page
  const Vec2 middle = 0.5 * (box.lo + box.hi), half(0.5 * w * metres, 0.5 * h * metres);
  return {left,
          kSnapshotTop,
          w,
          h,
          middle.x() - half.x(),
          middle.x() + half.x(),
          middle.y() - half.y(),
          middle.y() + half.y()};
}

void cell_path(const Canvas& canvas, const PlotArea& area, const StoredFrame& f, std::size_t cell) {
  cairo_t* c = canvas.get();
  cairo_new_sub_path(c);
  for (auto i = static_cast<std::size_t>(f.offsets[cell]); i < static_cast<std::size_t>(f.offsets[cell + 1]); ++i) {
    const auto p = static_cast<std::size_t>(f.connectivity[i]);
    cairo_line_to(c, area.px(f.position[2 * p]), area.py(f.position[2 * p + 1]));
  }
  cairo_close_path(c);
}

void draw_model_outlines(const Canvas& canvas, const PlotArea& area, const Scene& s) {
  for (const StoredBlock& block : s.run.blocks())
    for (std::size_t r = 0; r < block.polygon.rings(); ++r) {
      cairo_new_sub_path(canvas.get());
      for (const Vec2& p : block.polygon.ring(r)) cairo_line_to(canvas.get(), area.px(p.x()), area.py(p.y()));
      cairo_close_path(canvas.get());
    }
  canvas.ink({0.66, 0.66, 0.66});
  cairo_set_line_width(canvas.get(), 0.4);
  cairo_stroke(canvas.get());
}

/// Root of the mean area of the cells, and of the blocks, that are not held, on the page [pt].
std::pair<double, double> cell_and_block_size(const PlotArea& area, const Scene& s) {
  double sum = 0.0, cells = 0.0;
  std::set<std::int32_t> blocks;
  for (std::size_t c = 0; c < s.frame.cells(); ++c) {
    if (s.held[c]) continue;
    sum += std::abs(cell_area(s.frame, c));
    cells += 1.0;
    blocks.insert(s.frame.block[c]);
  }
  if (blocks.empty()) return {0.0, 0.0};
  const double points = area.w / (area.x1 - area.x0);
  return {points * std::sqrt(sum / cells), points * std::sqrt(sum / static_cast<double>(blocks.size()))};
}

/// A corner of a triangle on the page, with the value there.
struct Corner {
  Vec2 at;
  double value;
};

/// A triangle with values that are linear between its corners, in pieces of one colour.
void draw_triangle(const Canvas& canvas, const Scene& s, Corner a, Corner b, Corner c) {
  constexpr double kColours = 96.0, kSmallest = 1.2;  // shades of the bar that are distinguished; side of a piece [pt]
  const double low = std::min({a.value, b.value, c.value}), high = std::max({a.value, b.value, c.value});
  const double shade = (s.scale.high - s.scale.low) * s.scale.unit.factor / kColours;
  const double ab = (b.at - a.at).norm(), bc = (c.at - b.at).norm(), ca = (a.at - c.at).norm();
  if (!(high - low > shade) || std::max({ab, bc, ca}) < kSmallest) {
    cairo_t* page = canvas.get();
    cairo_move_to(page, a.at.x(), a.at.y());
    cairo_line_to(page, b.at.x(), b.at.y());
    cairo_line_to(page, c.at.x(), c.at.y());
    cairo_close_path(page);
    canvas.ink(s.colour_of((a.value + b.value + c.value) / 3.0));
    canvas.fill_piece();
    return;
  }
  if (bc >= ab && bc >= ca)
    std::swap(a, c);
  else if (ca >= ab && ca >= bc)
    std::swap(b, c);
  const Corner middle{0.5 * (a.at + b.at), 0.5 * (a.value + b.value)};  // of the longest side
  draw_triangle(canvas, s, a, middle, c);
  draw_triangle(canvas, s, middle, b, c);
}

/// A cell whose corners have values of their own.   @return false where it has one colour, or is not convex
bool draw_smooth(const Canvas& canvas, const PlotArea& area, const Scene& s, std::size_t cell) {
  if (s.corners.empty()) return false;
  std::vector<Corner> ring;
  double low = 1e300, high = -1e300;
  Corner middle{Vec2::Zero(), 0.0};
  for (auto i = static_cast<std::size_t>(s.frame.offsets[cell]);
       i < static_cast<std::size_t>(s.frame.offsets[cell + 1]); ++i) {
    const auto p = static_cast<std::size_t>(s.frame.connectivity[i]);
    ring.push_back({{area.px(s.frame.position[2 * p]), area.py(s.frame.position[2 * p + 1])}, s.corners[i]});
    low = std::min(low, s.corners[i]), high = std::max(high, s.corners[i]);
    middle.at += ring.back().at, middle.value += ring.back().value;
  }
  if (ring.size() < 3 || !(high > low)) return false;
  middle.at /= static_cast<double>(ring.size()), middle.value /= static_cast<double>(ring.size());
  const auto around = [&](std::size_t i) { return ring[i % ring.size()].at; };
  for (std::size_t i = 0; i < ring.size(); ++i)  // y is down on the page: corners run clockwise
    if (!(cross(around(i + 1) - around(i), around(i + 2) - around(i + 1)) <= 0.0)) return false;
  if (ring.size() == 3) {
    draw_triangle(canvas, s, ring[0], ring[1], ring[2]);
    return true;
  }
  for (std::size_t i = 0; i < ring.size(); ++i) draw_triangle(canvas, s, ring[i], ring[(i + 1) % ring.size()], middle);
  return true;
}

void draw_cells(const Canvas& canvas, const PlotArea& area, const Scene& s) {
  cairo_t* c = canvas.get();
  for (std::size_t cell = 0; cell < s.frame.cells(); ++cell)
    if (s.held[cell]) cell_path(canvas, area, s.frame, cell);
  // Without smoothing: smoothed neighbours let the white paper through between them. Outlines cover the steps.
  cairo_set_antialias(c, CAIRO_ANTIALIAS_NONE);
  canvas.hatch_path();
  for (std::size_t cell = 0; cell < s.frame.cells(); ++cell) {
    if (s.held[cell] || draw_smooth(canvas, area, s, cell)) continue;
    cell_path(canvas, area, s.frame, cell);
    canvas.ink(s.colour(cell));
    canvas.fill_piece();
  }
  cairo_set_antialias(c, CAIRO_ANTIALIAS_DEFAULT);
}

void draw_edges(const Canvas& canvas, const PlotArea& area, const Scene& s) {
  cairo_t* c = canvas.get();
  const auto [size, block_size] = cell_and_block_size(area, s);
  cairo_set_line_join(c, CAIRO_LINE_JOIN_ROUND);
  cairo_set_line_cap(c, CAIRO_LINE_CAP_ROUND);
  if (size > 2.0) {  // finer meshes would turn grey
    for (std::size_t cell = 0; cell < s.frame.cells(); ++cell)
      if (!s.held[cell]) cell_path(canvas, area, s.frame, cell);
    canvas.ink({0.0, 0.0, 0.0, std::clamp(0.05 * size, 0.12, 0.4)});
    cairo_set_line_width(c, 0.2);
    cairo_stroke(c);
  }
  for (const auto& [a, b] : outline_edges(s.frame)) {
    const auto p = static_cast<std::size_t>(a), q = static_cast<std::size_t>(b);
    cairo_move_to(c, area.px(s.frame.position[2 * p]), area.py(s.frame.position[2 * p + 1]));
    cairo_line_to(c, area.px(s.frame.position[2 * q]), area.py(s.frame.position[2 * q + 1]));
  }
  canvas.ink({0.08, 0.08, 0.08});
  cairo_set_line_width(c, std::clamp(0.05 * block_size, 0.3, 0.65));
  cairo_stroke(c);
}

ArrowMarks arrow_marks(const PlotArea& area, const Scene& s) {
  if (s.options.arrows == Arrows::none) return {};
  const double noise = rounding_of(Field::displacement, s.frame, {});
  const double block = cell_and_block_size(area, s).second;
  if (s.options.arrows == Arrows::displacement)
    return {s.frame, s.frame.cell_displacement, s.held, area, block, noise, "displacement", "m"};
  return {s.frame, s.frame.cell_velocity, s.held, area, block, noise, "velocity", "m/s"};
}

void draw_labels(const Canvas& canvas, const PlotArea& area, const Scene& s) {
  std::vector<std::string> names;
  names.reserve(s.run.blocks().size());
  for (const StoredBlock& b : s.run.blocks()) names.push_back(b.name);
  draw_names(canvas, area, s.frame, names, [&](std::size_t cell) { return s.held[cell] ? kHeld : s.colour(cell); });
}

struct Entry {
  std::string name;
  std::size_t number;
};

/// Names beside the plot for a field that counts names.
std::vector<Entry> legend_of(const Scene& s) {
  if (!s.named() || (s.options.field == Field::block && s.options.labels)) return {};
  std::set<std::size_t> used;
  for (std::size_t c = 0; c < s.values.size(); ++c)
    if (!s.held[c]) used.insert(static_cast<std::size_t>(s.values[c]));
  if (used.size() > kMostLegendNames) return {};
  std::vector<Entry> entries;
  entries.reserve(used.size());
  for (const std::size_t n : used) entries.push_back({s.name_of(n), n});
  return entries;
}

void draw_legend(const Canvas& canvas, const PlotArea& area, const std::vector<Entry>& entries, double width) {
  const double line = std::min(13.0, area.h / static_cast<double>(std::max<std::size_t>(entries.size(), 1)));
  TextStyle style = kTickText;
  style.up = 0.5, style.size = std::min(style.size, 0.85 * line);
  double y = area.y;
  for (const Entry& e : entries) {
    const double x = area.x + area.w + kBarGap, box = 0.65 * line;
    canvas.box(x, y, box, box, distinct_colour(e.number));
    canvas.frame(x, y, box, box, 0.4, kInk);
    canvas.text(x + box + 4.0, y + 0.5 * box, canvas.fitted(e.name, width - box - 4.0, style), style);
    y += line;
  }
}

/// The sign of stress and the length of arrows at the lower left; what hatching, bolts and grey lines mean at the lower
/// right.
void draw_key(const Canvas& canvas, const PlotArea& area, const Scene& s, const ArrowMarks& arrows, bool bolts) {
  TextStyle style = kTickText;
  style.across = 1.0, style.up = 0.5;
  double x = area.x + area.w;
  const double y = area.y + area.h + 36.0;  // below the label of x
  TextStyle left = style;
  left.across = 0.0;
  double from = area.x;
  if (info(s.options.field).is_signed) {
    const std::string sign = "tension positive";
    canvas.text(from, y, sign, left);
    from += canvas.text_width(sign, left) + 12.0;
  }
  arrows.draw_key(canvas, from, y);
  const std::string moved = "outline in the model", held = "held block";
  canvas.text(x, y, moved, style);
  x -= canvas.text_width(moved, style) + 4.0;
  canvas.line(x - 14.0, y, x, y, 0.6, {0.6, 0.6, 0.6});
  if (bolts) {
    const std::string bolt = "bolt, wide as its force";
    x -= 26.0;
    canvas.text(x, y, bolt, style);
    x -= canvas.text_width(bolt, style) + 4.0;
    draw_bolt_sample(canvas, x - 14.0, y);
  }
  if (std::find(s.held.begin(), s.held.end(), 1) == s.held.end()) return;
  x -= 26.0;
  canvas.text(x, y, held, style);
  x -= canvas.text_width(held, style) + 4.0;
  cairo_rectangle(canvas.get(), x - 14.0, y - 4.0, 14.0, 8.0);
  canvas.hatch_path();
  canvas.frame(x - 14.0, y - 4.0, 14.0, 8.0, 0.4, kInk);
}

void draw_title(const Canvas& canvas, const PlotArea& area, const Scene& s) {
  TextStyle title{10.5}, line{8.5};
  title.bold = true;
  const double room = canvas.width() - area.x - kSnapshotEdge;
  std::string second = fmt::format("t = {:.6g} s", s.frame.time);
  if (!s.frame.stage.empty()) second += fmt::format(",  stage “{}” ({})", s.frame.stage, s.frame.integrator);
  if (s.run.title().empty()) {
    canvas.text(area.x, area.y - 8.0, canvas.fitted(second, room, line), line);
    return;
  }
  canvas.text(area.x, area.y - 21.0, canvas.fitted(s.run.title(), room, title), title);
  canvas.text(area.x, area.y - 8.0, canvas.fitted(second, room, line), line);
}

}  // namespace

const std::vector<std::string>& field_names() {
  static const std::vector<std::string> kNames{"displacement", "speed", "sxx",    "syy",      "sxy",        "s1",
                                               "s3",           "block", "method", "material", "utilisation"};
  return kNames;
}

std::optional<Field> field_named(std::string_view name) {
  const auto at = std::find(field_names().begin(), field_names().end(), name);
  if (at == field_names().end()) return std::nullopt;
  return static_cast<Field>(at - field_names().begin());
}

void snapshot(const std::filesystem::path& run_folder, const SnapshotOptions& options,
              const std::filesystem::path& file) {
  const PictureFormat format = format_or_error(file);
  const RunReader run(run_folder);
  Scene s(run, options);
  prepare(s, chosen_frame(run, options, run_folder));
  const Box box = shown_box(s);

  // Margins come from the widths of what stands in them, so nothing overlaps.
  const Canvas ruler(kSnapshotWidth, 10.0, 64);
  const std::vector<Entry> legend = legend_of(s);
  double names = 0.0;
  for (const Entry& e : legend) names = std::max(names, ruler.text_width(e.name, kTickText) + 14.0);
  names = std::min(names, 110.0);
  const double bar = 46.0 + (s.named() ? 0.0 : widest(ruler, round_ticks(s.scale.low, s.scale.high, 6)) - 10.0);
  const double right = kSnapshotEdge + (legend.empty() && s.named() ? 0.0 : kBarGap + (s.named() ? names : bar));
  const PlotArea guess = placed(box, 50.0, right);
  const auto ticks_of = [](double low, double high, double length) {
    return round_ticks(low, high, std::clamp(static_cast<int>(length / 48.0), 3, 9));
  };
  const double left = kSnapshotEdge + 22.0 + widest(ruler, ticks_of(guess.y0, guess.y1, guess.h));
  const PlotArea area = placed(box, left, right);

  const Canvas canvas(kSnapshotWidth, area.y + area.h + kSnapshotBottom, options.width, format);
  cairo_save(canvas.get());
  cairo_rectangle(canvas.get(), area.x, area.y, area.w, area.h);
  cairo_clip(canvas.get());
  draw_model_outlines(canvas, area, s);
  draw_cells(canvas, area, s);
  draw_edges(canvas, area, s);
  const StoredBolts bolts = run.bolts(static_cast<std::size_t>(s.frame.index));
  draw_bolts(canvas, area, bolts);
  if (options.labels) draw_labels(canvas, area, s);
  const ArrowMarks arrows = arrow_marks(area, s);
  arrows.draw(canvas, area);
  cairo_restore(canvas.get());
  draw_axes(canvas, area, ticks_of(area.x0, area.x1, area.w), ticks_of(area.y0, area.y1, area.h),
            axis_label('x', run.origin().x()), axis_label('y', run.origin().y()), false);
  draw_key(canvas, area, s, arrows, !bolts.bolt.empty());
  draw_title(canvas, area, s);
  if (s.named())
    draw_legend(canvas, area, legend, names);
  else
    draw_colour_bar(canvas, area.x + area.w + kBarGap, area.y, area.h, s.scale,
                    std::string(info(options.field).label) + " [" + s.scale.unit.name + "]");
  canvas.save(file);
}

}  // namespace scree::io
