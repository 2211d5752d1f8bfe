#include "io/drawing/dxf.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/drawing/dxf_entities.h"
#include "io/text/printable.h"

namespace scree::io {
namespace {

constexpr int kDeepest = 16;                  // levels of blocks in blocks
constexpr std::size_t kMostPoints = 5000000;  // of all lines together
constexpr std::size_t kMostPieces = 1000000;

/// x -> A x + b
struct Placing {
  Mat2 A = Mat2::Identity();
  Vec2 b{0.0, 0.0};
  [[nodiscard]] Vec2 operator()(const Vec2& x) const { return A * x + b; }
  [[nodiscard]] Placing operator*(const Placing& inner) const { return {A * inner.A, A * inner.b + b}; }
  [[nodiscard]] double stretch() const { return A.norm(); }
};

/// $INSUNITS in metres.   @source [Autodesk2018], header variable $INSUNITS
double metres_of(int code) {
  switch (code) {
    case 1:
      return 0.0254;  // inch
    case 2:
      return 0.3048;  // foot
    case 4:
      return 1e-3;
    case 5:
      return 1e-2;
    case 6:
      return 1.0;
    case 7:
      return 1e3;
    case 10:
      return 0.9144;  // yard
    case 14:
      return 0.1;
    default:
      return 0.0;
  }
}

std::string release_of(const std::string& version) {
  static const std::pair<const char*, const char*> kNames[] = {
      {"AC1006", "R10"},   {"AC1009", "R12"},   {"AC1012", "R13"},   {"AC1014", "R14"},   {"AC1015", "R2000"},
      {"AC1018", "R2004"}, {"AC1021", "R2007"}, {"AC1024", "R2010"}, {"AC1027", "R2013"}, {"AC1032", "R2018"}};
  for (const auto& [code, name] : kNames)
    if (version == code) return fmt::format("DXF {} ({})", name, code);
  return version.empty() ? std::string("DXF") : fmt::format("DXF ({})", printable_line(version));
}

/// Places inserted blocks and converts curves to lines.
class Maker {
 public:
  Maker(const DxfContent& content, Drawing& out, double tolerance)
      : content_(&content), out_(&out), tolerance_(tolerance) {}

  void make() {
    for (const DxfEntity& e : content_->entities) add(e, Placing(), e.layer, 0, e.row);
    for (const auto& [key, what] : content_->left_out) counts_[{key.first, key.second, what.second}] += what.first;
    for (const auto& [key, count] : counts_)
      out_->counts.push_back({std::get<0>(key), std::get<1>(key), count, std::get<2>(key)});
  }

 private:
  [[noreturn]] static void too_many(int row) {
    throw DrawingError(row, "the inserted blocks make too many entities", fmt::format("at most {}", kMostPieces),
                       "explode the blocks that are needed, and remove the others");
  }

  void add(const DxfEntity& e, const Placing& place, const std::string& layer, int depth, int row) {
    if (++pieces_ > kMostPieces) too_many(row);
    if (e.kind == DxfEntity::Kind::insert) {
      insert(e, place, layer, depth);
      return;
    }
    ++counts_[{layer, e.type, e.unusable}];
    Placing to = place;
    if (e.mirrored) to.A.col(0) *= -1.0;
    if (e.kind == DxfEntity::Kind::point) {
      out_->points.push_back({layer, e.type, e.row, to(e.vertices[0])});
      return;
    }
    DrawnLine line{layer, e.type, e.row, {}, e.closed, e.unusable};
    if (e.unusable.empty()) {
      points_of(e, to, line);
      points_ += line.points.size();
      if (points_ > kMostPoints)
        throw DrawingError(row, "the lines have too many points", fmt::format("at most {}", kMostPoints),
                           "give a coarser tolerance, or draw less");
      if (line.points.size() < 2) line.unusable = "all its points are one";
    }
    if (!line.unusable.empty()) line.points.clear();
    out_->lines.push_back(std::move(line));
  }

  void insert(const DxfEntity& e, const Placing& place, const std::string& layer, int depth) {
    const auto found = content_->blocks.find(e.block);
    if (found == content_->blocks.end())
      throw DrawingError(
          e.row, fmt::format("INSERT of the block \"{}\", which the file does not hold", printable_line(e.block)),
          "the name of a block of the file", "bind external references, or remove the INSERT");
    if (depth >= kDeepest)
      throw DrawingError(e.row, "blocks are inserted in blocks too deeply, or in themselves",
                         fmt::format("at most {} levels", kDeepest), "explode the blocks");
    if (!e.unusable.empty()) {
      ++counts_[{layer, e.type, e.unusable}];
      return;
    }
    if (static_cast<double>(e.columns) * e.rows * static_cast<double>(found->second.entities.size()) >
        static_cast<double>(kMostPieces))
      too_many(e.row);
    const Mat2 R = rotation(e.turn);
    Placing outer = place;
    if (e.mirrored) outer.A.col(0) *= -1.0;
    for (int i = 0; i < e.columns; ++i)
      for (int j = 0; j < e.rows; ++j) {
        Placing inner;
        inner.A = R * e.scale.asDiagonal();
        inner.b = e.at + R * Vec2(i * e.pitch.x(), j * e.pitch.y()) - inner.A * found->second.base;
        const Placing to = outer * inner;
        for (const DxfEntity& part : found->second.entities)
          add(part, to, part.layer == "0" ? layer : part.layer, depth + 1, e.row);
      }
  }

  void points_of(const DxfEntity& e, const Placing& to, DrawnLine& line) const {
    const double tolerance = tolerance_ / std::max(to.stretch(), 1e-300);
    std::vector<Vec2> points;
    switch (e.kind) {
      case DxfEntity::Kind::polyline:
        for (std::size_t i = 0; i < e.vertices.size(); ++i) {
          if (i == 0) points.push_back(e.vertices[0]);
          const bool last = i + 1 == e.vertices.size();
          if (last && !e.closed) break;
          const std::vector<Vec2> next =
              bulge_points(e.vertices[i], e.vertices[last ? 0 : i + 1], e.bulges[i], tolerance);
          points.insert(points.end(), next.begin(), next.end());
        }
        break;
      case DxfEntity::Kind::arc:
        points = arc_points(e.c, e.a, e.b, e.from, e.to, tolerance);
        break;
      case DxfEntity::Kind::spline:
        points = spline_points(e.spline, tolerance);
        break;
      default:
        break;
    }
    for (const Vec2& p : points)
      if (const Vec2 x = to(p); line.points.empty() || x != line.points.back()) line.points.push_back(x);
    if (line.points.size() > 2 &&
        (line.points.front() - line.points.back()).norm() <= 1e-9 * tolerance_ + 1e-12 * line.points.front().norm()) {
      line.points.pop_back();
      line.closed = true;
    }
  }

  const DxfContent* content_;
  Drawing* out_;
  double tolerance_;  // in units of the drawing
  std::size_t points_ = 0, pieces_ = 0;
  std::map<std::tuple<std::string, std::string, std::string>, int> counts_;  // layer, type, why left out
};

/// Diagonal of the box of the vertices, control points and arcs of the model space; if this box has no extent, blocks
/// are included in the coordinates of their definitions.
double extent_of(const DxfContent& content) {
  Vec2 lo = Vec2::Constant(std::numeric_limits<double>::infinity()), hi = -lo;
  const auto see = [&](const Vec2& x) {
    lo = lo.cwiseMin(x);
    hi = hi.cwiseMax(x);
  };
  const auto all = [&](const std::vector<DxfEntity>& entities) {
    for (const DxfEntity& e : entities) {
      for (const Vec2& x : e.vertices) see(x);
      for (const Vec2& x : e.spline.control) see(x);
      if (e.kind != DxfEntity::Kind::arc) continue;
      see(e.c - e.a - e.b);
      see(e.c + e.a + e.b);
    }
  };
  all(content.entities);
  if (!(hi.x() > lo.x() || hi.y() > lo.y()))
    for (const auto& [name, block] : content.blocks) all(block.entities);
  const double extent = (hi - lo).norm();
  return std::isfinite(extent) && extent > 0.0 ? extent : 1.0;
}

}  // namespace

double unit_of(const std::string& name) {
  static const std::pair<const char*, double> kUnits[] = {{"m", 1.0},  {"cm", 1e-2},   {"mm", 1e-3},
                                                          {"km", 1e3}, {"in", 0.0254}, {"ft", 0.3048}};
  for (const auto& [unit, metres] : kUnits)
    if (name == unit) return metres;
  return 0.0;
}

Drawing read_dxf(std::string_view text, const DrawingOptions& options) {
  const DxfContent content = read_dxf_entities(text);
  Drawing out;
  out.form = release_of(content.version);
  out.unit = options.unit.value_or(metres_of(content.unit));
  out.unit_from = options.unit ? "the case" : "the header";
  if (!(out.unit > 0.0))
    throw DrawingError(
        0,
        content.unit == 0
            ? std::string("the header names no unit ($INSUNITS)")
            : fmt::format("the unit of the header, $INSUNITS = {}, is not one of lengths of sections", content.unit),
        "in, ft, mm, cm, dm, m, km or yd in the header, or a unit in the case", "give drawing.unit, for example \"m\"");
  out.tolerance = options.tolerance.value_or(1e-4 * out.unit * extent_of(content));
  Maker(content, out, out.tolerance / out.unit).make();
  for (DrawnLine& l : out.lines)
    for (Vec2& p : l.points) p *= out.unit;
  for (DrawnPoint& p : out.points) p.at *= out.unit;
  return out;
}

}  // namespace scree::io
