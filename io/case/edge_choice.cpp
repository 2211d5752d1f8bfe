#include "io/case/edge_choice.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "io/case/block_choice.h"
#include "io/case/read_parts.h"
#include "model/edge_selection.h"

namespace scree::io {
namespace {

std::vector<EdgeSpan> on_line(const Section& s, const Model& model, BlockId block) {
  const Block& of = model.blocks[block.index()];
  const Ring line = s.ring("on");
  const char* allowed = "[[x, y], [x, y]], the ends of a straight line";
  if (line.size() != 2)
    throw s.error("on", fmt::format("a straight line has two ends, not {}", line.size()), allowed,
                  "write one section for each straight part");
  const double near = near_outline(of.polygon);
  if ((line[1] - line[0]).norm() <= near)
    throw s.error("on", "the line has no length", fmt::format("ends more than {:.3g} m apart", near),
                  "write the two ends of the stretch");
  std::vector<EdgeSpan> spans = edges_on_line(block, of.polygon, line[0], line[1], near);
  if (!spans.empty()) return spans;
  const NearestEdge nearest = nearest_edge(of.polygon, line[0], line[1]);
  const auto [from, to] = ends_of(of.polygon, nearest.edge);
  throw s.error(
      "on", fmt::format("no edge of block {} lies on the line", in_quotes(of.name)),
      fmt::format("a line within {:.3g} m of the outline", near),
      fmt::format(
          "the nearest edge runs from ({:.10g}, {:.10g}) to ({:.10g}, {:.10g}); the line is up to {:.4g} m away "
          "from it",
          from.x(), from.y(), to.x(), to.y(), nearest.distance));
}

/// The edge of the block that has this number in the case.
std::vector<EdgeSpan> by_number(const Section& s, const Section& root, const Model& model, BlockId block) {
  const Block& of = model.blocks[block.index()];
  const std::vector<Section> listed = root.list("block");
  if (block.index() >= listed.size())
    throw s.error(
        "edge",
        fmt::format("block {} is cut from the domain: its edges have no numbers in the case", in_quotes(of.name)),
        "on = [[x, y], [x, y]]", "give the ends of the stretch with on");
  const auto corners = static_cast<std::int32_t>(of.polygon.outer.size());
  const std::int32_t written = s.integer("edge");
  if (written >= corners)
    throw s.error("edge", fmt::format("block {} has {} edges", in_quotes(of.name), corners),
                  fmt::format("0 to {}", corners - 1), "edge 0 runs from the first corner of polygon to the second");
  // Rings written clockwise were reversed, see read_blocks.
  const bool turned = signed_area(listed[block.index()].ring("polygon")) < 0.0 && written < corners - 1;
  return {{block, {0, turned ? corners - 2 - written : written}, 0.0, 1.0}};
}

}  // namespace

namespace {

/// 1e-6 of the extent of the model.
double near_model(const Model& model) {
  Box all = bounds(model.blocks.front().polygon);
  for (const Block& b : model.blocks) {
    const Box box = bounds(b.polygon);
    all.lo = all.lo.cwiseMin(box.lo);
    all.hi = all.hi.cwiseMax(box.hi);
  }
  return 1e-6 * (all.hi - all.lo).maxCoeff();
}

/// Blocks that a section names; empty: it names none.
std::vector<BlockId> named(const Section& s, const Model& model) {
  std::vector<BlockId> out;
  if (s.has("block")) out.push_back(block_of(s, model));
  if (s.has("at")) out.push_back(block_at(s, "at", model));
  if (!s.has("blocks")) return out;
  const std::vector<std::string> known = names_of(model.blocks);
  for (std::size_t i = 0; i < s.texts("blocks").size(); ++i)
    for (const std::int32_t b : find_names(s, "blocks", i, "block", known)) out.emplace_back(b);
  return out;
}

/// Parts of edges that lie in a box, as free_edges_in_box() finds them, but including edges on joints.
std::vector<EdgeSpan> in_box_of(const Model& model, const std::vector<BlockId>& blocks, const Box& box, double near) {
  Model alone;  // holds one block at a time: no other block faces it
  std::vector<EdgeSpan> out;
  for (const BlockId b : blocks) {
    alone.blocks = {model.blocks[b.index()]};
    for (EdgeSpan span : free_edges_in_box(alone, box, near)) {
      span.block = b;
      out.push_back(span);
    }
  }
  return out;
}

}  // namespace

std::vector<EdgeSpan> free_edges(const Section& s, const Model& model) {
  const double near = near_model(model);
  const std::vector<BlockId> blocks = named(s, model);
  std::vector<EdgeSpan> out;
  if (s.has("box")) {
    const Ring ends = s.ring("box");
    if (ends.size() != 2 || ends[0] == ends[1])
      throw s.error("box", "a box has two opposite corners", "[[x, y], [x, y]]", "write two points");
    const Box box{ends[0].cwiseMin(ends[1]), ends[0].cwiseMax(ends[1])};
    out = blocks.empty() ? free_edges_in_box(model, box, near) : in_box_of(model, blocks, box, near);
    if (out.empty())
      throw s.error("box", "no outline lies in the box", "a box that holds parts of outlines that face no other block",
                    "name the blocks to include joints; `scree check --blocks` lists where blocks are");
    return out;
  }
  const Ring line = s.ring("on");
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    if ((line[i + 1] - line[i]).norm() <= near)
      throw s.error("on", i, "the line has no length here", fmt::format("points more than {:.3g} m apart", near),
                    "remove the point");
    std::vector<EdgeSpan> part;
    if (blocks.empty()) part = free_edges_on_line(model, line[i], line[i + 1], near);
    for (const BlockId b : blocks)
      for (const EdgeSpan& span : edges_on_line(b, model.blocks[b.index()].polygon, line[i], line[i + 1], near))
        part.push_back(span);
    if (part.empty()) {
      double least = std::numeric_limits<double>::infinity();
      for (const Block& b : model.blocks)
        least = std::min(least, nearest_edge(b.polygon, line[i], line[i + 1]).distance);
      throw s.error(
          "on", i,
          fmt::format(
              "no outline that faces no other block lies on the line from ({:.10g}, {:.10g}) to ({:.10g}, {:.10g})",
              line[i].x(), line[i].y(), line[i + 1].x(), line[i + 1].y()),
          fmt::format("a line within {:.3g} m of outlines", near),
          fmt::format(
              "the edge that comes nearest to holding it is up to {:.4g} m away; name the blocks to include joints",
              least));
    }
    out.insert(out.end(), part.begin(), part.end());
  }
  return out;
}

std::vector<EdgeSpan> chosen_edges(const Section& s, const Section& root, const Model& model, BlockId block) {
  if (s.has("on") == s.has("edge"))
    throw s.error(s.has("on") ? "edge" : "on",
                  s.has("on") ? "on and edge are both given" : "the part of the outline is not given",
                  "either on or edge", "write on = [[x, y], [x, y]], the ends of a straight line");
  return s.has("on") ? on_line(s, model, block) : by_number(s, root, model, block);
}

}  // namespace scree::io
