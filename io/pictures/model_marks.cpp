#include "io/pictures/model_marks.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "io/pictures/bolt_marks.h"
#include "model/edge_selection.h"
#include "model/free_field.h"

namespace scree::io {
namespace {

constexpr Colour kSupport{0.10, 0.32, 0.18}, kLoad{0.72, 0.10, 0.10}, kWater{0.10, 0.38, 0.78},
    kViscous{0.45, 0.20, 0.60};
constexpr double kPitch = 9.0, kLongestArrow = 26.0;  // of marks along an edge, and of arrows [pt]

/// Ends of a span on the page, and its outward normal there (y down).
struct PageSpan {
  Vec2 a, b, n;
  [[nodiscard]] double length() const { return (b - a).norm(); }
};
PageSpan on_page(const PlotArea& area, const Model& model, const EdgeSpan& span) {
  const Polygon& polygon = model.blocks[span.block.index()].polygon;
  const auto [from, to] = ends_of(polygon, span.edge);
  const Vec2 p = from + span.s0 * (to - from), q = from + span.s1 * (to - from), n = outward_normal(polygon, span.edge);
  return {{area.px(p.x()), area.py(p.y())}, {area.px(q.x()), area.py(q.y())}, {n.x(), -n.y()}};
}

/// Places of marks along a span, evenly, at least one.
template <class At>
void along(const PageSpan& s, double pitch, const At& at) {
  const int n = std::max(1, static_cast<int>(std::lround(s.length() / pitch)));
  for (int i = 0; i < n; ++i) at(Vec2(s.a + (i + 0.5) / n * (s.b - s.a)));
}

void fixed_mark(const Canvas& canvas, const Vec2& x, const Vec2& n) {
  const Vec2 t(-n.y(), n.x()), foot = x + 5.0 * n - 4.0 * t;
  canvas.line(x.x(), x.y(), foot.x(), foot.y(), 0.7, kSupport);
}

void roller_mark(const Canvas& canvas, const Vec2& x, const Vec2& n) {
  const Vec2 middle = x + 2.4 * n;
  cairo_new_sub_path(canvas.get());
  cairo_arc(canvas.get(), middle.x(), middle.y(), 2.0, 0.0, 6.2832);
  canvas.ink({1.0, 1.0, 1.0});
  cairo_fill_preserve(canvas.get());
  canvas.ink(kSupport);
  cairo_set_line_width(canvas.get(), 0.7);
  cairo_stroke(canvas.get());
}

void triangle_mark(const Canvas& canvas, double x, double y) {
  cairo_t* c = canvas.get();
  cairo_move_to(c, x, y);
  cairo_line_to(c, x - 3.5, y + 6.0);
  cairo_line_to(c, x + 3.5, y + 6.0);
  cairo_close_path(c);
  canvas.ink(kSupport);
  cairo_fill(c);
}

void arrow(const Canvas& canvas, const Vec2& from, const Vec2& to, const Colour& colour) {
  const Vec2 d = to - from;
  const double length = d.norm(), head = std::min(4.0, 0.6 * length);
  if (!(length > 0.5)) return;
  const Vec2 e = d / length, side(-e.y(), e.x()), base = to - head * e;
  canvas.line(from.x(), from.y(), base.x(), base.y(), 0.7, colour);
  cairo_move_to(canvas.get(), to.x(), to.y());
  for (const double s : {1.0, -1.0}) {
    const Vec2 p = base + s * 0.4 * head * side;
    cairo_line_to(canvas.get(), p.x(), p.y());
  }
  cairo_close_path(canvas.get());
  canvas.ink(colour);
  cairo_fill(canvas.get());
}

/// On the page: from the head over where the bond begins to the toe.
void bolt_mark(const Canvas& canvas, const Vec2& head, const Vec2& bond, const Vec2& toe, bool plate) {
  constexpr double kBar = 0.9, kBond = 2.4, kPlate = 3.0;  // [pt]
  canvas.line(head.x(), head.y(), toe.x(), toe.y(), kBar, kBoltInk);
  if ((toe - bond).norm() > 0.0) canvas.line(bond.x(), bond.y(), toe.x(), toe.y(), kBond, kBoltInk);
  if (!plate || !((toe - head).norm() > 0.0)) return;
  const Vec2 along = (toe - head).normalized(), across(-along.y() * kPlate, along.x() * kPlate);
  canvas.line(head.x() - across.x(), head.y() - across.y(), head.x() + across.x(), head.y() + across.y(), 1.6,
              kBoltInk);
}

void monitor_mark(const Canvas& canvas, double x, double y) {
  cairo_t* c = canvas.get();
  cairo_new_sub_path(c);
  cairo_arc(c, x, y, 2.6, 0.0, 6.2832);
  canvas.ink({1.0, 0.85, 0.2});
  cairo_fill_preserve(c);
  canvas.ink(kInk);
  cairo_set_line_width(c, 0.6);
  cairo_stroke(c);
  canvas.line(x - 2.6, y, x + 2.6, y, 0.5, kInk);
  canvas.line(x, y - 2.6, x, y + 2.6, 0.5, kInk);
}

void water_sign(const Canvas& canvas, double x, double y) {
  cairo_t* c = canvas.get();
  cairo_move_to(c, x, y - 0.5);
  cairo_line_to(c, x - 4.0, y - 7.0);
  cairo_line_to(c, x + 4.0, y - 7.0);
  cairo_close_path(c);
  canvas.ink(kWater);
  cairo_set_line_width(c, 0.7);
  cairo_stroke(c);
  for (int i = 1; i < 3; ++i) canvas.line(x - 4.0 + 1.3 * i, y + 2.2 * i, x + 4.0 - 1.3 * i, y + 2.2 * i, 0.6, kWater);
}

/// A viscous edge as a row of short double strokes.
void viscous_mark(const Canvas& canvas, const Vec2& x, const Vec2& n) {
  const Vec2 t(-n.y(), n.x());
  for (const double off : {2.0, 4.2}) {
    const Vec2 a = x + off * n - 2.5 * t, b = x + off * n + 2.5 * t;
    canvas.line(a.x(), a.y(), b.x(), b.y(), 0.8, kViscous);
  }
}

bool slides(const EdgeSupport& s) { return s.held.determinant() < 0.5; }

}  // namespace

std::string meaning_of(Mark mark) {
  switch (mark) {
    case Mark::held_block:
      return "block held whole";
    case Mark::fixed_edge:
      return "fixed edge";
    case Mark::roller:
      return "edge on rollers";
    case Mark::point_support:
      return "supported point";
    case Mark::traction:
      return "traction";
    case Mark::point_load:
      return "point load";
    case Mark::viscous:
      return "viscous edge";
    case Mark::water:
      return "line of water";
    case Mark::monitor:
      return "monitor";
    case Mark::bolt:
      return "bolt, the bonded length wide";
    case Mark::liner:
      return "liner";
    case Mark::crack:
      break;
  }
  return "crack (ends in a block)";
}

void draw_sample(const Canvas& canvas, Mark mark, double x, double y) {
  const Vec2 down(0.0, 1.0);
  switch (mark) {
    case Mark::held_block:
      cairo_rectangle(canvas.get(), x + 1.0, y - 4.0, 14.0, 8.0);
      canvas.hatch_path();
      canvas.frame(x + 1.0, y - 4.0, 14.0, 8.0, 0.4, kInk);
      break;
    case Mark::fixed_edge:
    case Mark::roller:
      canvas.line(x, y - 2.0, x + 16.0, y - 2.0, 0.9, kInk);
      for (const double at : {3.0, 8.0, 13.0})
        (mark == Mark::roller ? roller_mark : fixed_mark)(canvas, Vec2(x + at, y - 2.0), down);
      break;
    case Mark::point_support:
      triangle_mark(canvas, x + 8.0, y - 3.0);
      break;
    case Mark::traction:
      for (const double at : {4.0, 8.0, 12.0}) arrow(canvas, {x + at, y - 5.0}, {x + at, y + 4.0}, kLoad);
      break;
    case Mark::point_load:
      arrow(canvas, {x + 1.0, y}, {x + 15.0, y}, kLoad);
      break;
    case Mark::viscous:
      for (const double at : {3.0, 8.0, 13.0}) viscous_mark(canvas, {x + at, y - 3.0}, down);
      break;
    case Mark::water:
      canvas.line(x, y, x + 16.0, y, 1.2, kWater);
      break;
    case Mark::bolt:
      bolt_mark(canvas, {x, y}, {x + 8.0, y}, {x + 16.0, y}, true);
      break;
    case Mark::liner:
      canvas.line(x, y, x + 16.0, y, 2.4, kBoltInk);
      break;
    case Mark::monitor:
      monitor_mark(canvas, x + 8.0, y);
      break;
    case Mark::crack: {
      const double dash[] = {2.5, 1.5};
      cairo_save(canvas.get());
      cairo_set_dash(canvas.get(), dash, 2, 0.0);
      canvas.line(x, y, x + 16.0, y, 1.0, kInk);
      cairo_restore(canvas.get());
    }
  }
}

void draw_supports(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks) {
  for (const EdgeSupport& s : model.edge_supports) {
    const PageSpan span = on_page(area, model, s.span);
    canvas.line(span.a.x(), span.a.y(), span.b.x(), span.b.y(), 1.1, kSupport);
    along(span, kPitch, [&](const Vec2& x) { (slides(s) ? roller_mark : fixed_mark)(canvas, x, span.n); });
    marks.insert(slides(s) ? Mark::roller : Mark::fixed_edge);
  }
  for (const PointSupport& s : model.point_supports) {
    triangle_mark(canvas, area.px(s.point.x()), area.py(s.point.y()));
    marks.insert(Mark::point_support);
  }
}

void draw_loads(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks) {
  double largest = 0.0, strongest = 0.0;
  for (const EdgeTraction& t : model.tractions)
    if (!of_free_field(model, t.function)) largest = std::max(largest, t.traction.norm());
  for (const PointLoad& l : model.point_loads) strongest = std::max(strongest, l.force.norm());
  for (const EdgeTraction& t : model.tractions) {
    if (of_free_field(model, t.function)) continue;
    if (!(t.traction.norm() > 0.0)) continue;
    const PageSpan span = on_page(area, model, t.span);
    const Vec2 d = kLongestArrow / largest * Vec2(t.traction.x(), -t.traction.y());
    const bool pushes = d.dot(span.n) < 0.0;  // then its tip is on the edge, else its foot
    along(span, kPitch,
          [&](const Vec2& x) { arrow(canvas, pushes ? Vec2(x - d) : x, pushes ? x : Vec2(x + d), kLoad); });
    marks.insert(Mark::traction);
  }
  for (const PointLoad& l : model.point_loads) {
    if (!(l.force.norm() > 0.0)) continue;
    const Vec2 x(area.px(l.point.x()), area.py(l.point.y())),
        d = kLongestArrow / strongest * Vec2(l.force.x(), -l.force.y());
    arrow(canvas, x - d, x, kLoad);
    marks.insert(Mark::point_load);
  }
  for (const ViscousEdge& e : model.viscous_edges) {
    const PageSpan span = on_page(area, model, e.span);
    along(span, kPitch, [&](const Vec2& x) { viscous_mark(canvas, x, span.n); });
    marks.insert(Mark::viscous);
  }
}

void draw_bolts(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks) {
  const auto on_page = [&area](const Vec2& p) { return Vec2(area.px(p.x()), area.py(p.y())); };
  for (const Bolt& b : model.bolts) {
    if (b.liner()) {
      for (const Bolt::Node& n : b.nodes) cairo_line_to(canvas.get(), area.px(n.place.x()), area.py(n.place.y()));
      canvas.ink(kBoltInk);
      cairo_set_line_width(canvas.get(), 2.4);
      cairo_stroke(canvas.get());
      marks.insert(Mark::liner);
      continue;
    }
    const double free = b.length() > 0.0 ? 1.0 - b.bond_length / b.length() : 1.0;
    bolt_mark(canvas, on_page(b.head), on_page(b.head + free * (b.toe - b.head)), on_page(b.toe), b.plate);
    marks.insert(Mark::bolt);
  }
}

void draw_water(const Canvas& canvas, const PlotArea& area, const Model& model, std::set<Mark>& marks) {
  for (const JointWater& w : model.waters) {
    std::vector<Vec2> line = w.line;
    line.insert(line.begin(), Vec2(std::min(area.x0, line.front().x()), line.front().y()));
    line.emplace_back(std::max(area.x1, line.back().x()), line.back().y());
    for (const Vec2& p : line) cairo_line_to(canvas.get(), area.px(p.x()), area.py(p.y()));
    canvas.ink(kWater);
    cairo_set_line_width(canvas.get(), 1.2);
    cairo_stroke(canvas.get());
    const Vec2 at = 0.5 * (w.line[0] + w.line[1]);
    water_sign(canvas, area.px(at.x()), area.py(at.y()));
    marks.insert(Mark::water);
  }
}

void draw_monitors(const Canvas& canvas, const PlotArea& area, const Model& model, bool names, std::set<Mark>& marks) {
  TextStyle style{6.5};
  style.up = 0.5;
  for (const Monitor& m : model.monitors) {
    const double x = area.px(m.point.x()), y = area.py(m.point.y());
    monitor_mark(canvas, x, y);
    marks.insert(Mark::monitor);
    if (!names) continue;
    const double width = canvas.text_width(m.name, style);
    const bool room = x + 6.0 + width < area.x + area.w;
    style.across = room ? 0.0 : 1.0;
    canvas.box(room ? x + 4.0 : x - 6.0 - width, y - 4.0, width + 2.0, 8.0, {1.0, 1.0, 1.0, 0.75});
    canvas.text(room ? x + 5.0 : x - 5.0, y, m.name, style);
  }
}

}  // namespace scree::io
