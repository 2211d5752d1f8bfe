// Conditions under which polygons can be blocks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/model.h"
#include "model/near_pairs.h"
#include "model/planar.h"

namespace scree {
namespace {

std::optional<GeometryFault> fault_of(const Model& model, BlockId id, double extent) {
  const Block& block = model.blocks[id.index()];
  const auto fault = [&](std::string what, std::string hint) {
    return GeometryFault{id, BlockId{}, std::move(what), std::move(hint)};
  };
  for (std::size_t k = 0; k < block.polygon.rings(); ++k) {
    const Ring& ring = block.polygon.ring(k);
    if (ring.size() < 3) return fault(fmt::format("a ring of {} points", ring.size()), "give at least three corners");
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!ring[i].allFinite()) return fault(fmt::format("corner {} is not finite", i + 1), "give finite coordinates");
      if ((ring[(i + 1) % ring.size()] - ring[i]).norm() <= 1e-9 * extent)
        return fault(fmt::format("corner ({:.10g}, {:.10g}) is given twice", ring[i].x(), ring[i].y()),
                     "remove the repeated corner; the first corner is not repeated at the end");
    }
  }
  if (std::string reason = invalidity(block.polygon); !reason.empty())
    return fault("the polygon is not simple: " + reason,
                 "list the corners in order around the block, without crossing edges, holes inside");
  const double area = moments(block.polygon).area;
  if (!(area > 1e-12 * extent * extent))
    return fault(fmt::format("its area is {:g} m2", area), "give corners that enclose an area");
  return std::nullopt;
}

bool convex(const Ring& ring) {
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i)
    if (cross(ring[(i + 1) % n] - ring[i], ring[(i + 2) % n] - ring[(i + 1) % n]) < 0.0) return false;
  return true;
}

/// True where an edge of the convex ring a has all of b on its outer side, within `slack` [m].
bool apart(const Ring& a, const Ring& b, double slack) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec2 d = (a[(i + 1) % a.size()] - a[i]).normalized();
    if (std::all_of(b.begin(), b.end(), [&](const Vec2& p) { return cross(d, p - a[i]) <= slack; })) return true;
  }
  return false;
}

}  // namespace

std::vector<GeometryFault> check_geometry(const Model& model) {
  std::vector<GeometryFault> faults;
  if (model.blocks.empty()) return faults;
  std::vector<Box> boxes;
  for (const Block& b : model.blocks) boxes.push_back(b.polygon.outer.empty() ? Box{} : bounds(b.polygon));
  Box all = boxes.front();
  for (const Box& b : boxes) all = {all.lo.cwiseMin(b.lo), all.hi.cwiseMax(b.hi)};
  const double extent = (all.hi - all.lo).maxCoeff();

  const auto count = static_cast<std::int32_t>(model.blocks.size());
  for (std::int32_t i = 0; i < count; ++i)
    if (auto f = fault_of(model, BlockId{i}, extent)) faults.push_back(std::move(*f));
  if (!faults.empty()) return faults;

  // Overlaps: for pairs whose boxes overlap, the common area against a sliver of width 1e-9 of the extent. In nearly
  // all pairs an edge of a convex block separates the two, and GEOS is not needed.
  std::vector<char> is_convex;
  for (const Block& b : model.blocks) is_convex.push_back(convex(b.polygon.outer) ? 1 : 0);
  for (const auto& [i, j] : near_pairs(model.blocks, std::vector<double>(model.blocks.size(), 1e-12 * extent))) {
    const Box &a = boxes[static_cast<std::size_t>(i)], &b = boxes[static_cast<std::size_t>(j)];
    if (b.lo.x() >= a.hi.x() || a.lo.x() >= b.hi.x() || b.lo.y() >= a.hi.y() || a.lo.y() >= b.hi.y()) continue;
    const BlockId first{i}, second{j};
    const Polygon &p = model.blocks[first.index()].polygon, &q = model.blocks[second.index()].polygon;
    const double slack = 1e-12 * extent;  // of rounded corners
    if ((is_convex[first.index()] != 0 && apart(p.outer, q.outer, slack)) ||
        (is_convex[second.index()] != 0 && apart(q.outer, p.outer, slack)))
      continue;
    const double area = overlap_area(p, q);
    if (area > 1e-9 * extent * (a.hi - a.lo).cwiseMin(b.hi - b.lo).maxCoeff())
      faults.push_back({second, first,
                        fmt::format("block '{}' overlaps block '{}' by {:.4g} m2", model.blocks[second.index()].name,
                                    model.blocks[first.index()].name, area),
                        "move or cut one of the two so that they only touch"});
  }
  std::sort(faults.begin(), faults.end(), [](const auto& x, const auto& y) {
    return std::pair(x.block.value, x.other.value) < std::pair(y.block.value, y.other.value);
  });
  return faults;
}

}  // namespace scree
