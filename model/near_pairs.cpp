#include "model/near_pairs.h"

#include <algorithm>

#include "model/geos.h"
#include "model/main_direction.h"

namespace scree {
namespace {

/// Main direction of the outlines of the blocks.
Vec2 main_direction(std::span<const Block> blocks) {
  MainDirection main;
  for (const Block& b : blocks)
    for (std::size_t r = 0; r < b.polygon.rings(); ++r) {
      const Ring& ring = b.polygon.ring(r);
      for (std::size_t i = 0; i < ring.size(); ++i) main.add(ring[(i + 1) % ring.size()] - ring[i]);
    }
  return main.along();
}

/// Box of a block in axes along d, grown by a margin.
Box box_along(const Block& block, const Vec2& d, double margin) {
  Box box;
  bool first = true;
  for (const Vec2& p : block.polygon.outer) {
    const Vec2 x(d.dot(p), cross(d, p));
    box = first ? Box{x, x} : Box{box.lo.cwiseMin(x), box.hi.cwiseMax(x)};
    first = false;
  }
  return {box.lo - Vec2(margin, margin), box.hi + Vec2(margin, margin)};
}

bool overlap(const Box& a, const Box& b) {
  return (a.lo.array() <= b.hi.array()).all() && (b.lo.array() <= a.hi.array()).all();
}

}  // namespace

std::vector<std::pair<std::int32_t, std::int32_t>> near_pairs(std::span<const Block> blocks,
                                                              std::span<const double> margin) {
  const Vec2 d = main_direction(blocks);
  std::vector<Box> upright, turned;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    upright.push_back(box_along(blocks[i], Vec2(1.0, 0.0), margin[i]));
    turned.push_back(box_along(blocks[i], d, margin[i]));
  }
  const Geos geos;
  std::vector<std::int32_t> index(blocks.size());
  std::vector<Geos::Geometry> boxes;
  constexpr std::size_t kChildren = 10;
  const auto free_tree = [&](GEOSSTRtree* t) { GEOSSTRtree_destroy_r(geos.get(), t); };
  const std::unique_ptr<GEOSSTRtree, decltype(free_tree)> tree(GEOSSTRtree_create_r(geos.get(), kChildren), free_tree);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    index[i] = static_cast<std::int32_t>(i);
    boxes.push_back(geos.own(geos.line(turned[i].lo, turned[i].hi), "box"));
    GEOSSTRtree_insert_r(geos.get(), tree.get(), boxes.back().get(), &index[i]);
  }
  geos.check("tree of boxes");
  std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
  std::vector<std::int32_t> found;
  const auto take = [](void* item, void* list) {
    static_cast<std::vector<std::int32_t>*>(list)->push_back(*static_cast<std::int32_t*>(item));
  };
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    found.clear();
    GEOSSTRtree_query_r(geos.get(), tree.get(), boxes[i].get(), take, &found);
    std::sort(found.begin(), found.end());
    for (const std::int32_t j : found)
      if (j > index[i] && overlap(upright[i], upright[static_cast<std::size_t>(j)])) pairs.emplace_back(index[i], j);
  }
  geos.check("search for near boxes");
  return pairs;
}

}  // namespace scree
