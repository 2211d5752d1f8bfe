#include "io/case/drawn_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <set>

#include "io/case/line_file.h"
#include "io/case/read_parts.h"
#include "io/case/suggest.h"
#include "io/case/text_file.h"
#include "io/drawing/dxf.h"

namespace scree::io {
namespace {

constexpr std::size_t kLargestDrawing = std::size_t{256} << 20;  // bytes
constexpr double kFarthest = 1e9;                                // [m], as for coordinates in the case file

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::tolower(c); });
  return out;
}

/// Drawing from a file with columns x, y and the name of a layer.
Drawing of_columns(const std::filesystem::path& file, double unit, const std::string& unit_from) {
  Drawing out;
  out.form = "text";
  out.unit = unit;
  out.unit_from = unit_from;
  std::map<std::string, int> count;
  for (FileLine& line : read_lines(file)) {
    const std::string layer = line.label.empty() ? "0" : line.label;
    ++count[layer];
    DrawnLine drawn{layer, "line", line.rows.front(), std::move(line.points), false, {}};
    if (drawn.points.size() > 3 && drawn.points.front() == drawn.points.back()) {
      drawn.points.pop_back();
      drawn.closed = true;
    }
    for (Vec2& p : drawn.points) p *= unit;
    out.lines.push_back(std::move(drawn));
  }
  for (const auto& [layer, n] : count) out.counts.push_back({layer, "line", n, {}});
  return out;
}

}  // namespace

DrawnLayers::DrawnLayers(const Section& root, const std::filesystem::path& folder) {
  const Section s = root.table("drawing");
  const std::filesystem::path path = folder / s.text("file");
  const std::string extension = lower(path.extension().string());
  const std::string& unit = s.text("unit");
  try {
    if (extension == ".csv" || extension == ".txt" || extension == ".dat") {
      drawing_ =
          of_columns(path, unit == "auto" ? 1.0 : unit_of(unit), unit == "auto" ? "files of columns" : "the case");
    } else {
      DrawingOptions options;
      if (unit != "auto") options.unit = unit_of(unit);
      options.tolerance = s.number_or_auto("tolerance");
      drawing_ = read_dxf(read_text_file(path, "drawing", kLargestDrawing), options);
    }
  } catch (const DrawingError& e) {
    throw CaseError(path.string(), {e.row, e.row > 0 ? 1 : 0}, {e.what(), "", "", e.allowed, e.hint});
  } catch (const CaseError& e) {
    if (e.line > 0) throw;
    throw s.error("file", e.problem + ": " + in_quotes(path.string(), 400),
                  "path of an ASCII DXF, or of a file of columns",
                  "paths start from the folder of the case file; " + e.hint);
  }
  drawing_.file = path.string();
  const Vec2 offset = s.point("offset");
  Box box{Vec2::Constant(std::numeric_limits<double>::infinity()),
          Vec2::Constant(-std::numeric_limits<double>::infinity())};
  const auto move = [&](Vec2& p, int row, const std::string& entity) {
    p -= offset;
    if (!(p.cwiseAbs().maxCoeff() <= kFarthest))
      throw error(row, fmt::format("a point of {} lies at ({:.10g}, {:.10g}) m", entity, p.x(), p.y()),
                  "-1e9 <= value <= 1e9 [m]", "check the unit of the drawing, and drawing.offset");
    box.lo = box.lo.cwiseMin(p);
    box.hi = box.hi.cwiseMax(p);
  };
  for (DrawnLine& l : drawing_.lines)
    for (Vec2& p : l.points) move(p, l.row, l.entity);
  for (DrawnPoint& p : drawing_.points) move(p.at, p.row, p.entity);
  const double extent = (box.hi - box.lo).maxCoeff();
  join_ = s.number_or_auto("join").value_or(extent > 0.0 ? 1e-6 * extent : 0.0);
}

CaseError DrawnLayers::error(int row, std::string problem, std::string allowed, std::string hint) const {
  return {drawing_.file, {row, row > 0 ? 1 : 0}, {std::move(problem), "", "", std::move(allowed), std::move(hint)}};
}

std::vector<std::string> DrawnLayers::layers(const Section& s, std::string_view key) const {
  if (empty())
    throw s.error(key, "the case has no drawing", "a layer of [drawing]", "add [drawing] with file = \"section.dxf\"");
  std::set<std::string> all, found;
  for (const DrawnCount& c : drawing_.counts) all.insert(c.layer);
  for (const std::string& layer : all)
    if (matches(lower(s.text(key)), lower(layer))) found.insert(layer);
  if (found.empty())
    throw s.error(key, fmt::format("the drawing has no such layer: {}", in_quotes(s.text(key))),
                  listed({all.begin(), all.end()}), "* stands for any characters");
  return {found.begin(), found.end()};
}

std::vector<const DrawnLine*> DrawnLayers::lines(const Section& s, std::string_view key, const std::string& use) const {
  std::vector<const DrawnLine*> out;
  for (const std::string& layer : layers(s, key)) {
    std::string& told = uses_[layer];
    if (told.find(use) == std::string::npos) told += (told.empty() ? "" : ", ") + use;
    for (const DrawnLine& l : drawing_.lines) {
      if (l.layer != layer) continue;
      if (!l.unusable.empty())
        throw error(l.row, fmt::format("{} on the layer {}: {}", l.entity, in_quotes(layer), l.unusable),
                    "lines and curves of the plane",
                    fmt::format("draw it anew, or move it to a layer that the case does not use ({} does)", use));
      out.push_back(&l);
    }
  }
  if (out.empty())
    throw s.error(key, fmt::format("the layer {} holds no line", in_quotes(s.text(key))),
                  "a layer with lines or curves", "`scree check` lists what the layers hold");
  return out;
}

std::vector<Chain> DrawnLayers::chains(const Section& s, std::string_view key, const std::string& use) const {
  try {
    return chained(lines(s, key, use), join_);
  } catch (const DrawingError& e) {
    throw error(e.row, fmt::format("{}: {}", use, e.what()), e.allowed, e.hint);
  }
}

std::vector<Chain> DrawnLayers::rings(const Section& s, std::string_view key, const std::string& use) const {
  std::vector<Chain> out = chains(s, key, use);
  for (const Chain& c : out)
    if (!c.closed)
      throw error(
          c.row,
          fmt::format("{}: the line is open: it runs from ({:.10g}, {:.10g}) to ({:.10g}, {:.10g}) m, {:.4g} m away",
                      use, c.points.front().x(), c.points.front().y(), c.points.back().x(), c.points.back().y(),
                      (c.points.front() - c.points.back()).norm()),
          "closed lines, or lines that meet end to end", "close it, or raise drawing.join");
  return out;
}

std::vector<Chain> DrawnLayers::polylines(const Section& s, std::string_view key, const std::string& use) const {
  return chains(s, key, use);
}

std::vector<DrawnPoint> DrawnLayers::points(const Section& s, std::string_view key, const std::string& use) const {
  std::vector<DrawnPoint> out;
  for (const std::string& layer : layers(s, key)) {
    std::string& told = uses_[layer];
    if (told.find(use) == std::string::npos) told += (told.empty() ? "" : ", ") + use;
    for (const DrawnPoint& p : drawing_.points)
      if (p.layer == layer) out.push_back(p);
  }
  if (out.empty())
    throw s.error(key, fmt::format("the layer {} holds no point", in_quotes(s.text(key))), "a layer with POINTs",
                  "draw a POINT at each place");
  return out;
}

DrawingReport DrawnLayers::report() const {
  DrawingReport out;
  out.file = drawing_.file;
  out.form = drawing_.form;
  out.unit = drawing_.unit;
  out.tolerance = drawing_.tolerance;
  out.join = join_;
  out.unit_from = drawing_.unit_from;
  out.box = {Vec2::Constant(std::numeric_limits<double>::infinity()),
             Vec2::Constant(-std::numeric_limits<double>::infinity())};
  const auto see = [&](const Vec2& p) {
    out.box.lo = out.box.lo.cwiseMin(p);
    out.box.hi = out.box.hi.cwiseMax(p);
  };
  for (const DrawnLine& l : drawing_.lines)
    for (const Vec2& p : l.points) see(p);
  for (const DrawnPoint& p : drawing_.points) see(p.at);
  for (const DrawnCount& c : drawing_.counts) {
    const auto use = uses_.find(c.layer);
    out.rows.push_back({c.layer, c.entity, c.count,
                        !c.left_out.empty()  ? "left out: " + c.left_out
                        : use == uses_.end() ? "left out: no section of the case uses the layer"
                                             : use->second});
  }
  return out;
}

}  // namespace scree::io
