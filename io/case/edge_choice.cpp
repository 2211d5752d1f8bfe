#include "io/case/edge_choice.h"

#include <fmt/format.h>

#include "io/case/block_choice.h"
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

/// The edge as the block keeps it, from its number in the case.
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
  // Rings written clockwise were turned, see read_blocks.
  const bool turned = signed_area(listed[block.index()].ring("polygon")) < 0.0 && written < corners - 1;
  return {{block, {0, turned ? corners - 2 - written : written}, 0.0, 1.0}};
}

}  // namespace

std::vector<EdgeSpan> chosen_edges(const Section& s, const Section& root, const Model& model, BlockId block) {
  if (s.has("on") == s.has("edge"))
    throw s.error(s.has("on") ? "edge" : "on",
                  s.has("on") ? "on and edge are both given" : "nothing says which part of the outline is meant",
                  "either on or edge", "write on = [[x, y], [x, y]], the ends of a straight line");
  return s.has("on") ? on_line(s, model, block) : by_number(s, root, model, block);
}

}  // namespace scree::io
