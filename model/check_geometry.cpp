// What must hold for polygons to be blocks.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/model.h"
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
        return fault(fmt::format("corner ({:g}, {:g}) is given twice", ring[i].x(), ring[i].y()),
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

  // Overlaps: candidates by a sweep in x, then the common area against a sliver of width 1e-9 of the extent.
  std::vector<std::int32_t> order(model.blocks.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](auto a, auto b) {
    return std::pair(boxes[std::size_t(a)].lo.x(), a) < std::pair(boxes[std::size_t(b)].lo.x(), b);
  });
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Box& a = boxes[std::size_t(order[i])];
    for (std::size_t j = i + 1; j < order.size() && boxes[std::size_t(order[j])].lo.x() < a.hi.x(); ++j) {
      const Box& b = boxes[std::size_t(order[j])];
      if (b.lo.y() >= a.hi.y() || a.lo.y() >= b.hi.y()) continue;
      const BlockId first{std::min(order[i], order[j])}, second{std::max(order[i], order[j])};
      const double area = overlap_area(model.blocks[first.index()].polygon, model.blocks[second.index()].polygon);
      if (area > 1e-9 * extent * (a.hi - a.lo).cwiseMin(b.hi - b.lo).maxCoeff())
        faults.push_back({second, first,
                          fmt::format("block '{}' overlaps block '{}' by {:.4g} m2", model.blocks[second.index()].name,
                                      model.blocks[first.index()].name, area),
                          "move or cut one of the two so that they only touch"});
    }
  }
  std::sort(faults.begin(), faults.end(), [](const auto& x, const auto& y) {
    return std::pair(x.block.value, x.other.value) < std::pair(y.block.value, y.other.value);
  });
  return faults;
}

}  // namespace scree
