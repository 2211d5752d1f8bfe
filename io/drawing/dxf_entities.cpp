#include "io/drawing/dxf_entities.h"

#include <dxflib/dl_creationadapter.h>
#include <dxflib/dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <sstream>

#include "io/drawing/dxf_groups.h"
#include "io/text/printable.h"

namespace scree::io {
namespace {

constexpr double kRadian = std::numbers::pi / 180.0;
constexpr std::size_t kLongestName = 255;  // of layers and blocks
constexpr std::size_t kMostEntities = 2000000;
constexpr double kFarthest = 1e15;  // of coordinates

/// Groups of an entity that are passed to dxflib; the other groups do not change its shape.
struct Type {
  std::string_view name;
  std::vector<int> codes, needed;
};
const std::vector<Type>& types() {
  static const std::vector<Type> kAll{
      {"LINE", {8, 67, 10, 20, 30, 11, 21, 31}, {10, 20, 11, 21}},
      {"LWPOLYLINE", {8, 67, 90, 70, 38, 10, 20, 42, 210, 220, 230}, {90}},
      {"POLYLINE", {8, 67, 66, 70, 10, 20, 30, 210, 220, 230}, {}},
      {"VERTEX", {8, 10, 20, 30, 42, 70}, {10, 20}},
      {"SEQEND", {}, {}},
      {"ARC", {8, 67, 10, 20, 30, 40, 50, 51, 210, 220, 230}, {10, 20, 40, 50, 51}},
      {"CIRCLE", {8, 67, 10, 20, 30, 40, 210, 220, 230}, {10, 20, 40}},
      {"ELLIPSE", {8, 67, 10, 20, 30, 11, 21, 31, 40, 41, 42, 210, 220, 230}, {10, 20, 11, 21, 40}},
      {"SPLINE", {8, 67, 70, 71, 72, 73, 74, 40, 41, 10, 20, 30}, {71, 72, 73}},
      {"POINT", {8, 67, 10, 20, 30}, {10, 20}},
      {"INSERT", {8, 67, 2, 10, 20, 30, 41, 42, 43, 50, 70, 71, 44, 45, 210, 220, 230}, {2, 10, 20}},
  };
  return kAll;
}
const Type* type_of(std::string_view name) {
  for (const Type& t : types())
    if (t.name == name) return &t;
  return nullptr;
}

/// An entity as in the file.
struct Raw {
  std::string_view name;
  int row = 0;
  std::vector<DxfGroup> groups;
  [[nodiscard]] const DxfGroup* find(int code) const {
    const auto at = std::find_if(groups.begin(), groups.end(), [&](const DxfGroup& g) { return g.code == code; });
    return at == groups.end() ? nullptr : &*at;
  }
  [[nodiscard]] std::int64_t whole(int code, std::int64_t none) const {
    const DxfGroup* g = find(code);
    return g == nullptr ? none : whole_of(*g);
  }
  [[nodiscard]] std::int64_t count(int code) const {
    return std::count_if(groups.begin(), groups.end(), [&](const DxfGroup& g) { return g.code == code; });
  }
};

/// Receives the entities that dxflib reads.
class Taker final : public DL_CreationAdapter {
 public:
  explicit Taker(std::vector<DxfEntity>* into) : into_(into) {}
  void into(std::vector<DxfEntity>* list) { into_ = list; }
  void begin(std::string_view type, int row) {
    type_ = type;
    row_ = row;
  }

  void addLine(const DL_LineData& l) override {
    DxfEntity& e = add(DxfEntity::Kind::polyline);
    e.vertices = {{l.x1, l.y1}, {l.x2, l.y2}};
    e.bulges = {0.0, 0.0};
  }
  void addPolyline(const DL_PolylineData& p) override {
    DxfEntity& e = add(DxfEntity::Kind::polyline);
    e.closed = (p.flags & 1U) != 0;
    if ((p.flags & (16U | 64U)) != 0) e.unusable = "it is a mesh, no line";
    look_from_above(e);
  }
  void addVertex(const DL_VertexData& v) override {
    if (into_->empty()) return;
    DxfEntity& e = into_->back();
    e.vertices.emplace_back(v.x, v.y);
    e.bulges.push_back(v.bulge);
  }
  void addArc(const DL_ArcData& a) override {
    DxfEntity& e = add_circle(a.cx, a.cy, a.radius);
    e.from = a.angle1 * kRadian;
    e.to = a.angle2 * kRadian;
    e.to -= 2.0 * std::numbers::pi * std::floor((e.to - e.from) / (2.0 * std::numbers::pi));
    if (e.to == e.from) e.to += 2.0 * std::numbers::pi;
  }
  void addCircle(const DL_CircleData& c) override {
    DxfEntity& e = add_circle(c.cx, c.cy, c.radius);
    e.closed = true;
  }
  void addEllipse(const DL_EllipseData& d) override {
    DxfEntity& e = add(DxfEntity::Kind::arc);
    const double side = getExtrusion()->getDirection()[2] < 0.0 ? -1.0 : 1.0;
    e.c = {d.cx, d.cy};
    e.a = {d.mx, d.my};
    e.b = side * d.ratio * Vec2(-d.my, d.mx);
    e.from = d.angle1;
    e.to = d.angle2;
    const double sweep = e.to - e.from;
    e.closed = std::abs(std::abs(sweep) - 2.0 * std::numbers::pi) < 1e-9 || sweep == 0.0;
    if (!e.closed && sweep < 0.0) e.to += 2.0 * std::numbers::pi;
    if (e.closed) e.to = e.from + 2.0 * std::numbers::pi;
    if (!(e.a.norm() > 0.0) || !(e.b.norm() > 0.0)) e.unusable = "an axis has no length";
    if (d.mz != 0.0) e.unusable = "it lies in another plane";
  }
  void addSpline(const DL_SplineData& s) override {
    DxfEntity& e = add(DxfEntity::Kind::spline);
    e.spline.degree = static_cast<int>(s.degree);
    e.closed = (s.flags & 1) != 0;
  }
  void addKnot(const DL_KnotData& k) override {
    if (!into_->empty()) into_->back().spline.knots.push_back(k.k);
  }
  void addControlPoint(const DL_ControlPointData& p) override {
    if (into_->empty()) return;
    into_->back().spline.control.emplace_back(p.x, p.y);
    into_->back().spline.weights.push_back(p.w);
  }
  void addPoint(const DL_PointData& p) override { add(DxfEntity::Kind::point).vertices = {{p.x, p.y}}; }
  void addInsert(const DL_InsertData& i) override {
    DxfEntity& e = add(DxfEntity::Kind::insert);
    e.block = i.name;
    e.at = {i.ipx, i.ipy};
    e.scale = {i.sx, i.sy};
    e.turn = i.angle * kRadian;
    e.columns = std::max(i.cols, 1);
    e.rows = std::max(i.rows, 1);
    e.pitch = {i.colSp, i.rowSp};
    look_from_above(e);
  }

 private:
  DxfEntity& add(DxfEntity::Kind kind) {
    DxfEntity e;
    e.kind = kind;
    e.layer = getAttributes().getLayer();
    e.type = type_;
    e.row = row_;
    into_->push_back(std::move(e));
    return into_->back();
  }
  DxfEntity& add_circle(double x, double y, double radius) {
    DxfEntity& e = add(DxfEntity::Kind::arc);
    e.c = {x, y};
    e.a = {radius, 0.0};
    e.b = {0.0, radius};
    e.to = 2.0 * std::numbers::pi;
    if (!(radius > 0.0)) e.unusable = "its radius is not positive";
    look_from_above(e);
    return e;
  }
  /// For entities drawn in a plane of their own: of these, only those seen from below lie in the plane of the drawing.
  void look_from_above(DxfEntity& e) {
    const double* n = getExtrusion()->getDirection();
    e.mirrored = n[2] < 0.0;
    if (std::hypot(n[0], n[1]) > 1e-9 * std::abs(n[2])) e.unusable = "it lies in another plane";
  }

  std::vector<DxfEntity>* into_;
  std::string type_;
  int row_ = 0;
};

/// Passes groups to dxflib one at a time.
class Library {
 public:
  explicit Library(Taker& taker) : taker_(&taker) {}
  void give(int code, std::string_view value) {
    stream_.clear();
    stream_.str(fmt::format("{}\n{}\n", code, value));
    (void)dxf_.readDxfGroups(stream_, taker_);
  }

 private:
  Taker* taker_;
  DL_Dxf dxf_;
  std::istringstream stream_;
};

[[noreturn]] void damaged(const Raw& raw, int row, std::string problem, std::string allowed) {
  throw DrawingError(row, fmt::format("{} (of line {}): {}", raw.name, raw.row, std::move(problem)), std::move(allowed),
                     "the file is damaged: save it again");
}

/// Checks what dxflib accepts without a check: names, needed groups, and counts.
void check(const Raw& raw, const Type& type) {
  for (const int code : type.needed)
    if (raw.find(code) == nullptr)
      damaged(raw, raw.row, fmt::format("it has no group {}", code), "all groups that its shape needs");
  for (const DxfGroup& g : raw.groups)
    if (is_real(g.code) && !(std::abs(real_of(g)) <= kFarthest) &&
        std::find(type.codes.begin(), type.codes.end(), g.code) != type.codes.end())
      damaged(raw, g.row, fmt::format("{} is out of range", g.value), "-1e15 <= value <= 1e15");
  for (const DxfGroup& g : raw.groups)
    if ((g.code == 8 || g.code == 2) && g.value.size() > kLongestName)
      damaged(raw, g.row, "the name is too long", fmt::format("at most {} characters", kLongestName));
  const auto counted = [&](int code, std::int64_t there, const char* what) {
    const DxfGroup* g = raw.find(code);
    if (g != nullptr && whole_of(*g) != there)
      damaged(raw, g->row, fmt::format("it says {} {} and has {}", g->value, what, there), "the number that follows");
  };
  const auto pairs = [&](int x, int y, const char* what) {
    if (raw.count(x) != raw.count(y)) damaged(raw, raw.row, fmt::format("{} without x or y", what), "both of each");
  };
  if (raw.name == "LWPOLYLINE") {
    counted(90, raw.count(10), "vertices");
    pairs(10, 20, "vertices");
  } else if (raw.name == "SPLINE") {
    counted(72, raw.count(40), "knots");
    counted(73, raw.count(10), "control points");
    counted(74, raw.count(11), "fit points");
    pairs(10, 20, "control points");
    if (raw.count(41) > raw.count(10)) damaged(raw, raw.row, "more weights than control points", "one each at most");
  } else if (raw.name == "INSERT") {
    for (const int code : {70, 71})
      if (const DxfGroup* g = raw.find(code); g != nullptr && (whole_of(*g) < 0 || whole_of(*g) > 10000))
        damaged(raw, g->row, fmt::format("{} columns or rows", g->value), "0 to 10000");
  }
}

/// Reads sections one after another.
class Reader {
 public:
  explicit Reader(std::string_view text) : groups_(text), taker_(&content_.entities), library_(taker_) {}

  DxfContent read() {
    bool ended = false;
    while (advance()) {
      if (group_.code == 999) continue;  // a comment
      if (group_.code != 0)
        throw DrawingError(group_.row, fmt::format("a section should begin here, not the group {}", group_.code),
                           "0, SECTION", "the file is damaged before this line, or is no DXF");
      if (group_.value == "EOF") {
        ended = true;
        break;
      }
      if (group_.value != "SECTION")
        throw DrawingError(group_.row, fmt::format("a section should begin here, not {}", quoted(group_.value)),
                           "0, SECTION", "the file is damaged before this line, or is no DXF");
      section();
    }
    if (!ended)
      throw DrawingError(last_row_, "the file ends before 0, EOF", "0, EOF in the end",
                         "the file is cut off: save it again");
    return std::move(content_);
  }

 private:
  static std::string quoted(std::string_view text) { return '"' + printable_line(text.substr(0, 60)) + '"'; }

  bool advance() {
    const auto next = groups_.next();
    if (!next) return false;
    group_ = *next;
    last_row_ = group_.row;
    return true;
  }
  void need(const char* what) {
    if (!advance())
      throw DrawingError(last_row_, fmt::format("the file ends in {}", what), "0, ENDSEC",
                         "the file is cut off: save it again");
  }

  void section() {
    need("the head of a section");
    if (group_.code != 2)
      throw DrawingError(group_.row, "the section has no name", "2, and its name", "the file is damaged");
    const std::string name(group_.value);
    if (name == "HEADER")
      header();
    else if (name == "BLOCKS")
      blocks();
    else if (name == "ENTITIES")
      entities(&content_.entities, "ENDSEC");
    else
      do need(("the section " + name).c_str());
      while (group_.code != 0 || group_.value != "ENDSEC");
  }

  void header() {
    std::string variable;
    for (need("the header"); group_.code != 0 || group_.value != "ENDSEC"; need("the header")) {
      if (group_.code == 9) variable = group_.value;
      if (variable == "$ACADVER" && group_.code == 1) content_.version = group_.value.substr(0, 16);
      if (variable == "$INSUNITS" && group_.code == 70)
        content_.unit = static_cast<int>(std::clamp<std::int64_t>(whole_of(group_), -1, 1000));
    }
  }

  void blocks() {
    need("the blocks");
    while (group_.code != 0 || group_.value != "ENDSEC") {
      if (group_.code != 0 || group_.value != "BLOCK")
        throw DrawingError(group_.row, fmt::format("a block should begin here, not {}", quoted(group_.value)),
                           "0, BLOCK or 0, ENDSEC", "the file is damaged before this line");
      const Raw head = raw_entity();
      const DxfGroup* name = head.find(2);
      if (name == nullptr || name->value.empty() || name->value.size() > kLongestName)
        damaged(head, head.row, "it has no name", fmt::format("1 to {} characters", kLongestName));
      DxfBlock block;
      if (const DxfGroup* x = head.find(10), *y = head.find(20); x != nullptr && y != nullptr)
        block.base = {real_of(*x), real_of(*y)};
      DxfBlock& kept = content_.blocks[std::string(name->value)] = std::move(block);
      taker_.into(&kept.entities);
      read_entities(&kept.entities, "ENDBLK", "a block");
      (void)raw_entity();  // ENDBLK and its groups
    }
    taker_.into(&content_.entities);
  }

  void entities(std::vector<DxfEntity>* list, const char* end) {
    need("the entities");
    taker_.into(list);
    read_entities(list, end, "the entities");
  }

  /// Reads the whole entity that begins at group_; afterwards group_ is the first group after it.
  Raw raw_entity() {
    Raw out{group_.value, group_.row, {}};
    for (need("an entity"); group_.code != 0; need("an entity")) {
      if (group_.code < 1000) out.groups.push_back(group_);
      if (out.groups.size() > 20 * kMostEntities) damaged(out, group_.row, "it is too large", "fewer groups");
    }
    return out;
  }

  void read_entities(std::vector<DxfEntity>* list, std::string_view end, const char* where) {
    bool in_polyline = false, passes = false;  // passes: skip the vertices of a polyline that is left out
    while (group_.code != 0 || group_.value != end) {
      if (group_.code != 0)
        throw DrawingError(group_.row, "an entity should begin here", "0, and its type", "the file is damaged");
      if (group_.value == "SECTION" || group_.value == "EOF" || group_.value == "ENDSEC" || group_.value == "BLOCK")
        throw DrawingError(group_.row, fmt::format("{} has no end", where), fmt::format("0, {}", end),
                           "the file is damaged before this line");
      const Raw raw = raw_entity();
      const Type* type = type_of(raw.name);
      if (raw.name == "POLYLINE") {
        in_polyline = true;
        passes = raw.whole(67, 0) != 0;
      }
      if (raw.name == "VERTEX" && passes) continue;
      if (raw.name == "SEQEND") in_polyline = false;
      if (raw.name == "VERTEX" && !in_polyline)
        damaged(raw, raw.row, "it stands outside a POLYLINE", "POLYLINE, VERTEX ..., SEQEND");
      if (in_polyline && raw.name != "POLYLINE" && raw.name != "VERTEX")
        damaged(raw, raw.row, "a POLYLINE before it has no SEQEND", "POLYLINE, VERTEX ..., SEQEND");
      if (type == nullptr) {
        leave_out(raw, "this kind is not read");
      } else if (raw.whole(67, 0) != 0) {
        leave_out(raw, "it is in paper space");
      } else {
        take(raw, *type, *list);
      }
      if (content_.entities.size() + list->size() > kMostEntities)
        throw DrawingError(raw.row, "there are too many entities", fmt::format("at most {}", kMostEntities),
                           "draw less");
    }
  }

  void leave_out(const Raw& raw, const char* why) {
    const DxfGroup* layer = raw.find(8);
    auto& entry = content_.left_out[{layer == nullptr ? "0" : std::string(layer->value.substr(0, kLongestName)),
                                     std::string(raw.name.substr(0, 40))}];
    ++entry.first;
    entry.second = why;
  }

  void take(const Raw& raw, const Type& type, std::vector<DxfEntity>& list) {
    check(raw, type);
    // Bit 16: a point of the frame of a spline-fit polyline, not of the line.
    if (raw.name == "VERTEX" && (raw.whole(70, 0) & 16) != 0) return;
    const std::size_t before = list.size();
    taker_.begin(raw.name, raw.row);
    library_.give(0, raw.name);
    for (const DxfGroup& g : raw.groups)
      if (std::find(type.codes.begin(), type.codes.end(), g.code) != type.codes.end()) library_.give(g.code, g.value);
    if (raw.name == "SPLINE" && raw.find(74) != nullptr && raw.count(10) > 0) library_.give(74, "0");
    library_.give(0, "ENDSEC");  // completes the entity
    if (list.size() <= before) return;
    DxfEntity& e = list.back();
    if (e.kind != DxfEntity::Kind::spline) return;
    if (e.spline.control.empty() && raw.count(11) > 0)
      e.unusable = "it is given by fit points alone, not by the curve";
    else
      e.unusable = spline_fault(e.spline);
  }

  DxfGroups groups_;
  DxfGroup group_;
  int last_row_ = 0;
  DxfContent content_;
  Taker taker_;
  Library library_;
};

}  // namespace

DxfContent read_dxf_entities(std::string_view text) { return Reader(text).read(); }

}  // namespace scree::io
