#include "io/pictures/model_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>

#include "io/pictures/colour_map.h"
#include "io/pictures/model_marks.h"
#include "io/pictures/plot_curves.h"
#include "io/results/file_error.h"
#include "model/edge_selection.h"
#include "model/touching.h"

namespace scree::io {
namespace {

constexpr double kPictureWidth = 504.0, kPictureTop = 34.0, kPictureEdge = 8.0;  // of the page [pt]
constexpr double kAxis = 38.0, kRow = 13.0, kMotion = 74.0, kColumn = 158.0;     // below the section [pt]
constexpr std::size_t kMostMotions = 4;

Colour tint(std::size_t material) {
  const Colour c = distinct_colour(material);
  const auto pale = [](double v) { return 0.78 + 0.22 * v; };
  return {pale(c.r), pale(c.g), pale(c.b)};
}
/// Laws in stronger colours that materials do not have.
Colour colour_of(JointId law) { return law.valid() ? distinct_colour(law.index() + 3) : Colour{0.5, 0.5, 0.5}; }

Box box_of(const Model& model, const ModelPictureOptions& options) {
  if (options.window) return *options.window;
  Box box = bounds(model.blocks.front().polygon);
  const auto see = [&](const Vec2& p) {
    box.lo = box.lo.cwiseMin(p);
    box.hi = box.hi.cwiseMax(p);
  };
  for (const Block& b : model.blocks)
    for (const Vec2& p : b.polygon.outer) see(p);
  for (const JointWater& w : model.waters)
    for (const Vec2& p : w.line)
      if (p.x() >= box.lo.x() && p.x() <= box.hi.x()) see(p);
  const double margin = 0.05 * (box.hi - box.lo).maxCoeff();
  return {box.lo.array() - margin, box.hi.array() + margin};
}

PlotArea placed(const Box& box, double left) {
  const double w = kPictureWidth - left - kPictureEdge;
  const Vec2 size = box.hi - box.lo;
  const double h = w * std::clamp(size.y() / size.x(), 0.22, 1.0), metres = std::max(size.x() / w, size.y() / h);
  const Vec2 middle = 0.5 * (box.lo + box.hi), half(0.5 * w * metres, 0.5 * h * metres);
  return {left,
          kPictureTop,
          w,
          h,
          middle.x() - half.x(),
          middle.x() + half.x(),
          middle.y() - half.y(),
          middle.y() + half.y()};
}

void block_path(const Canvas& canvas, const PlotArea& area, const Block& block) {
  for (std::size_t r = 0; r < block.polygon.rings(); ++r) {
    cairo_new_sub_path(canvas.get());
    for (const Vec2& p : block.polygon.ring(r)) cairo_line_to(canvas.get(), area.px(p.x()), area.py(p.y()));
    cairo_close_path(canvas.get());
  }
}

void draw_blocks(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks) {
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    block_path(canvas, area, model.blocks[i]);
    if (model.support_of(BlockId{static_cast<std::int32_t>(i)}) != nullptr) {
      canvas.hatch_path();
      cairo_new_path(canvas.get());
      marks.insert(Mark::held_block);
      continue;
    }
    canvas.ink(tint(model.blocks[i].material.index()));
    cairo_fill(canvas.get());
  }
}

/// Faces between blocks by their law, those with less friction last, because theirs is the law of the joint; then
/// cracks, then free faces in black.
void draw_joints(const Canvas& canvas, const PlotArea& area, const Model& model, const Box& box,
                 std::set<JointId>& laws, std::set<Mark>& marks) {
  const auto stroke = [&](const Vec2& a, const Vec2& b, double width, const Colour& colour) {
    canvas.line(area.px(a.x()), area.py(a.y()), area.px(b.x()), area.py(b.y()), width, colour);
  };
  cairo_set_line_cap(canvas.get(), CAIRO_LINE_CAP_ROUND);
  const double extent = (box.hi - box.lo).maxCoeff();
  std::vector<EdgeSpan> free =
      free_edges_in_box(model, {box.lo.array() - extent, box.hi.array() + extent}, 1e-6 * extent);
  const auto is_free = [&](const EdgeSpan& e) {
    return std::any_of(free.begin(), free.end(), [&](const EdgeSpan& f) {
      return f.block == e.block && f.edge == e.edge && f.s0 <= 1e-6 && f.s1 >= 1.0 - 1e-6;
    });
  };
  struct Face {
    Vec2 a, b;
    JointId law;
    double friction;
  };
  std::vector<Face> faces;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const BlockId block{static_cast<std::int32_t>(i)};
    const Polygon& polygon = model.blocks[i].polygon;
    for (std::size_t r = 0; r < polygon.rings(); ++r)
      for (std::size_t k = 0; k < polygon.ring(r).size(); ++k) {
        const OutlineEdge edge{static_cast<std::int32_t>(r), static_cast<std::int32_t>(k)};
        if (is_free({block, edge, 0.0, 1.0})) continue;
        JointId law = model.joint_of(block, r, k);
        if (!law.valid()) law = model.default_joint;
        const auto [from, to] = ends_of(polygon, edge);
        faces.push_back({from, to, law, law.valid() ? model.joints[law.index()].friction : 2.0});
      }
  }
  std::stable_sort(faces.begin(), faces.end(), [](const Face& x, const Face& y) { return x.friction > y.friction; });
  for (const Face& f : faces) {
    stroke(f.a, f.b, 0.9, colour_of(f.law));
    laws.insert(f.law);
  }
  const double dash[] = {2.5, 1.5};
  cairo_set_line_cap(canvas.get(), CAIRO_LINE_CAP_BUTT);
  cairo_set_dash(canvas.get(), dash, 2, 0.0);
  for (const Crack& c : model.cracks) {
    stroke(c.from, c.to, 0.9, colour_of(c.joint));
    laws.insert(c.joint);
    marks.insert(Mark::crack);
  }
  cairo_set_dash(canvas.get(), nullptr, 0, 0.0);
  cairo_set_line_cap(canvas.get(), CAIRO_LINE_CAP_ROUND);
  for (const EdgeSpan& f : free) {
    const auto [from, to] = ends_of(model.blocks[f.block.index()].polygon, f.edge);
    stroke(from + f.s0 * (to - from), from + f.s1 * (to - from), 0.7, kInk);
  }
}

/// Names in the middles of blocks, as large as fits between 3 and 7 pt.
void draw_block_names(const Canvas& canvas, const PlotArea& area, const Model& model) {
  const double points = area.w / (area.x1 - area.x0);
  for (const Block& b : model.blocks) {
    const Moments m = moments(b.polygon);
    TextStyle style{7.0, 0.5, 0.5};
    const double room = 0.8 * points * std::sqrt(m.area), width = canvas.text_width(b.name, style);
    style.size = std::clamp(7.0 * room / width, 3.0, 7.0);
    Vec2 at = m.centroid;
    if (!contains(b.polygon, at)) at = b.polygon.outer[0];
    canvas.text(area.px(at.x()), area.py(at.y()), b.name, style);
  }
}

/// A line of the legend: what draws its sample, and its text.
struct Entry {
  std::function<void(double x, double y)> sample;
  std::string text;
};

std::vector<Entry> legend_of(const Canvas& canvas, const Model& model, const std::set<JointId>& laws,
                             const std::set<Mark>& marks) {
  std::vector<Entry> out;
  std::set<std::size_t> materials;
  for (std::size_t i = 0; i < model.blocks.size(); ++i)
    if (model.support_of(BlockId{static_cast<std::int32_t>(i)}) == nullptr)
      materials.insert(model.blocks[i].material.index());
  out.reserve(materials.size());
  for (const std::size_t m : materials)
    out.push_back({[&canvas, m](double x, double y) {
                     canvas.box(x + 1.0, y - 4.0, 14.0, 8.0, tint(m));
                     canvas.frame(x + 1.0, y - 4.0, 14.0, 8.0, 0.4, kInk);
                   },
                   model.materials[m].name});
  for (const JointId law : laws) {
    std::string text = "no law";
    if (law.valid()) {
      const JointLaw& j = model.joints[law.index()];
      text = fmt::format("{}: {:g}°", j.name, std::round(j.friction * 1.8e4 / 3.14159265358979) / 100.0);
      if (j.cohesion > 0.0) text += fmt::format(", c {:g} kPa", 1e-3 * j.cohesion);
      if (j.tensile_strength > 0.0 && std::isfinite(j.tensile_strength))
        text += fmt::format(", t {:g} kPa", 1e-3 * j.tensile_strength);
    }
    out.push_back({[&canvas, law](double x, double y) { canvas.line(x, y, x + 16.0, y, 1.6, colour_of(law)); }, text});
  }
  for (const Mark m : marks)
    out.push_back({[&canvas, m](double x, double y) { draw_sample(canvas, m, x, y); }, meaning_of(m)});
  return out;
}

void draw_motion(const Canvas& canvas, const GroundMotion& motion, double left, double y) {
  Range range;
  range.add(motion.accelerations());
  range.add(0.0);
  range.widen(0.06);
  const double t0 = motion.setting().start + motion.times().front(),
               t1 = motion.setting().start + motion.times().back();
  const PlotArea area{left, y, kPictureWidth - left - kPictureEdge, kMotion - 40.0, t0, t1, range.low, range.high};
  std::vector<double> t = motion.times();
  for (double& v : t) v += motion.setting().start;
  {
    const Clip clip(canvas, area);
    canvas.line(area.x, area.py(0.0), area.x + area.w, area.py(0.0), 0.4, kFaint);
    canvas.ink({0.15, 0.30, 0.60});
    cairo_set_line_width(canvas.get(), 0.5);
    draw_curve(canvas, area, t, motion.accelerations());
  }
  draw_axes(canvas, area, round_ticks(t0, t1, 8), round_ticks(range.low, range.high, 3), "t [s]", "a [m/s²]", false);
  TextStyle style{7.0};
  style.up = 1.0;
  const Vec2 d = motion.direction();
  canvas.text(area.x + 3.0, area.y + 3.0,
              fmt::format("{}, along ({:.3g}, {:.3g})", motion.setting().name, d.x(), d.y()), style);
}

}  // namespace

void draw_model(const Model& model, const ModelPictureOptions& options, const std::filesystem::path& file) {
  const PictureFormat format = format_or_error(file);
  if (model.blocks.empty()) throw FileError(file, "the model has no block to draw");
  const Box box = box_of(model, options);
  const auto ticks_of = [](double low, double high, double length) {
    return round_ticks(low, high, std::clamp(static_cast<int>(length / 48.0), 3, 9));
  };
  const Canvas ruler(kPictureWidth, 10.0, 64);
  const PlotArea guess = placed(box, 50.0);
  const double left = kPictureEdge + 22.0 + widest(ruler, ticks_of(guess.y0, guess.y1, guess.h));
  const PlotArea area = placed(box, left);

  // The contents of the legend are known only after drawing: everything is first drawn on a page that is discarded.
  std::set<JointId> laws;
  std::set<Mark> marks;
  const auto draw_section = [&](const Canvas& canvas) {
    cairo_save(canvas.get());
    cairo_rectangle(canvas.get(), area.x, area.y, area.w, area.h);
    cairo_clip(canvas.get());
    draw_blocks(canvas, area, model, marks);
    draw_joints(canvas, area, model, box, laws, marks);
    draw_water(canvas, area, model, marks);
    draw_supports(canvas, area, model, marks);
    draw_loads(canvas, area, model, marks);
    draw_bolts(canvas, area, model, marks);
    if (options.names) draw_block_names(canvas, area, model);
    draw_monitors(canvas, area, model, model.monitors.size() <= 12 || options.names, marks);
    cairo_restore(canvas.get());
  };
  draw_section(Canvas(kPictureWidth, area.y + area.h, 64));
  const std::size_t columns = 3, entries = legend_of(ruler, model, laws, marks).size(),
                    motions = std::min(model.motions.size(), kMostMotions);
  const std::size_t rows = (entries + columns - 1) / columns;
  const double below = area.y + area.h + kAxis, legend_height = kRow * static_cast<double>(rows) + 6.0;
  const Canvas canvas(kPictureWidth, below + legend_height + kMotion * static_cast<double>(motions) + kPictureEdge,
                      options.width, format);
  draw_section(canvas);
  draw_axes(canvas, area, ticks_of(area.x0, area.x1, area.w), ticks_of(area.y0, area.y1, area.h),
            axis_label('x', model.origin.x()), axis_label('y', model.origin.y()), false);
  TextStyle title{10.5};
  title.bold = true;
  canvas.text(area.x, area.y - 10.0,
              canvas.fitted(model.title.empty() ? fmt::format("{} blocks", model.blocks.size())
                                                : fmt::format("{}: {} blocks", model.title, model.blocks.size()),
                            area.w, title),
              title);
  const std::vector<Entry> legend = legend_of(canvas, model, laws, marks);
  TextStyle style = kTickText;
  style.up = 0.5;
  for (std::size_t i = 0; i < legend.size(); ++i) {
    const std::size_t column = i % columns, row = i / columns;
    const double x = area.x + kColumn * static_cast<double>(column), y = below + 4.0 + kRow * static_cast<double>(row);
    legend[i].sample(x, y);
    canvas.text(x + 21.0, y, canvas.fitted(legend[i].text, kColumn - 26.0, style), style);
  }
  for (std::size_t i = 0; i < motions; ++i)
    draw_motion(canvas, model.motions[i], area.x, below + legend_height + kMotion * static_cast<double>(i));
  canvas.save(file);
}

}  // namespace scree::io
