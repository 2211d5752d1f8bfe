#include <fmt/format.h>

#include <algorithm>

#include "io/case/block_choice.h"
#include "io/case/read_parts.h"
#include "model/edge_selection.h"

namespace scree::io {
namespace {

/// True if all of a -> b lies in the polygon or on its outline: the lines of the edges divide it into pieces that
/// do not change sides, so it suffices to test the middle of each piece.
bool inside(const Polygon& polygon, const Vec2& a, const Vec2& b) {
  const Vec2 d = b - a;
  std::vector<double> cuts{0.0, 1.0};
  for (std::size_t r = 0; r < polygon.rings(); ++r) {
    const Ring& ring = polygon.ring(r);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 edge = ring[(i + 1) % ring.size()] - ring[i];
      const double t = cross(ring[i] - a, edge) / cross(d, edge);
      if (t > 0.0 && t < 1.0) cuts.push_back(t);  // false for parallel lines
    }
  }
  std::sort(cuts.begin(), cuts.end());
  if (!on_block(polygon, a) || !on_block(polygon, b)) return false;
  for (std::size_t i = 1; i < cuts.size(); ++i)
    if (!on_block(polygon, a + 0.5 * (cuts[i - 1] + cuts[i]) * d)) return false;
  return true;
}

void read_crack(const Section& s, Model& model) {
  const BlockId block{find_name(s, "block", "block", names_of(model.blocks))};
  const Block& of = model.blocks[block.index()];
  JointId joint = of.joint.valid() ? of.joint : model.default_joint;
  if (s.has("joint")) joint = JointId{find_name(s, "joint", "joint", names_of(model.joints))};
  const Ring points = s.ring("points");
  const double near = near_outline(of.polygon);
  const Box box = bounds(of.polygon);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vec2 &a = points[i - 1], &b = points[i];
    const auto piece = [&] {
      return fmt::format("the piece from ({:.10g}, {:.10g}) to ({:.10g}, {:.10g})", a.x(), a.y(), b.x(), b.y());
    };
    if ((b - a).norm() <= near)
      throw s.error("points", i, piece() + " has no length", fmt::format("points more than {:.3g} m apart", near),
                    "remove the repeated point");
    if (!inside(of.polygon, a, b))
      throw s.error(
          "points", i, fmt::format("{} leaves block {}", piece(), in_quotes(of.name)),
          "a line inside the block, which may end on its outline",
          fmt::format("end the crack at the outline; the block lies within [{:.10g}, {:.10g}] to [{:.10g}, {:.10g}]",
                      box.lo.x(), box.lo.y(), box.hi.x(), box.hi.y()));
    if (!edges_on_line(block, of.polygon, a, b, near).empty())
      throw s.error("points", i, fmt::format("{} runs along the outline of block {}", piece(), in_quotes(of.name)),
                    "a line inside the block", "an edge has the joint of block.edge_joints; it needs no crack");
    model.cracks.push_back({a, b, joint, block});
  }
}

}  // namespace

void read_cracks(const Section& root, Model& model) {
  for (const Section& s : root.list("crack")) read_crack(s, model);
}

}  // namespace scree::io
