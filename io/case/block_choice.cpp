#include "io/case/block_choice.h"

#include <fmt/format.h>

#include <cstdint>
#include <vector>

#include "io/case/read_parts.h"
#include "model/edge_selection.h"

namespace scree::io {

double near_outline(const Polygon& polygon) {
  const Box box = bounds(polygon);
  return 1e-6 * (box.hi - box.lo).maxCoeff();
}

bool on_block(const Polygon& polygon, const Vec2& point) {
  if (contains(polygon, point)) return true;
  const double near = near_outline(polygon);
  for (std::size_t k = 0; k < polygon.rings(); ++k) {
    const Ring& ring = polygon.ring(k);
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (distance_to_segment(point, ring[i], ring[(i + 1) % ring.size()]) <= near) return true;
  }
  return false;
}

void check_point(const Section& s, const Model& model, BlockId block, const Vec2& point) {
  const Polygon& polygon = model.blocks[block.index()].polygon;
  if (on_block(polygon, point)) return;
  const Box box = bounds(polygon);
  throw s.error("point", fmt::format("the point is not on block {}", in_quotes(model.blocks[block.index()].name)),
                "a point inside the block or on its outline",
                fmt::format("the block lies within [{:.10g}, {:.10g}] to [{:.10g}, {:.10g}]", box.lo.x(), box.lo.y(),
                            box.hi.x(), box.hi.y()));
}

std::vector<BlockId> blocks_at(const Model& model, const Vec2& point) {
  std::vector<BlockId> holding;
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const Box box = bounds(model.blocks[b].polygon);
    const double near = near_outline(model.blocks[b].polygon);
    if ((point.array() < box.lo.array() - near).any() || (point.array() > box.hi.array() + near).any()) continue;
    if (on_block(model.blocks[b].polygon, point)) holding.push_back(BlockId{static_cast<std::int32_t>(b)});
  }
  return holding;
}

BlockId block_at(const Section& s, std::string_view key, const Model& model) {
  const Vec2 point = s.point(key);
  const std::vector<BlockId> holding = blocks_at(model, point);
  if (holding.empty())
    throw s.error(key, "the point is in no block", "a point inside a block",
                  "check the point, or give block = \"NAME\"");
  if (holding.size() > 1)
    throw s.error(
        key,
        fmt::format("the point lies on the boundary of blocks {} and {}",
                    in_quotes(model.blocks[holding[0].index()].name), in_quotes(model.blocks[holding[1].index()].name)),
        "a point inside one block", "move the point, or say which with block = \"NAME\"");
  return holding.front();
}

BlockId block_of(const Section& s, const Model& model, std::string_view at) {
  if (!s.has("block")) return block_at(s, at, model);
  return BlockId{find_name(s, "block", "block", names_of(model.blocks))};
}

}  // namespace scree::io
