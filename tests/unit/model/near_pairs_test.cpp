// Pairs of blocks that may touch, compared with a test of all pairs, and a bound on their number.
#include "model/near_pairs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "model/touching.h"

namespace scree::near_pairs_test {
namespace {

Block block(const Polygon& polygon) {
  Block b;
  b.polygon = polygon;
  return b;
}

Polygon box(double x0, double y0, double x1, double y1) { return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}; }

TEST(NearPairs, none_that_overlaps_or_touches_is_left_out) {
  std::mt19937 random(3);
  const auto number = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
  };
  for (int round = 0; round < 20; ++round) {
    std::vector<Block> blocks;
    blocks.reserve(70);
    for (int i = 0; i < 60; ++i)
      blocks.push_back(block(transformed(box(0, 0, number(0.1, 20.0), number(0.1, 1.0)),
                                         Vec2(number(0, 20), number(0, 20)), rotation(0.3 + number(-0.1, 0.1)))));
    for (int i = 0; i < 5; ++i) {  // two rows of blocks that touch exactly
      blocks.push_back(block(box(i, -5, i + 1, -4)));
      blocks.push_back(block(box(i, -4, i + 1, -3)));
    }
    const auto pairs = near_pairs(blocks, std::vector<double>(blocks.size(), 1e-9));
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end()));
    for (std::int32_t i = 0; i < std::ssize(blocks); ++i)
      for (std::int32_t j = i + 1; j < std::ssize(blocks); ++j) {
        const Ring &a = blocks[static_cast<std::size_t>(i)].polygon.outer,
                   &b = blocks[static_cast<std::size_t>(j)].polygon.outer;
        bool meet = false;
        for (std::size_t k = 0; k < 4; ++k)
          for (std::size_t l = 0; l < 4; ++l) {
            const Vec2 d = a[(k + 1) % 4] - a[k], e = b[(l + 1) % 4] - b[l];
            meet = meet || (cross(d, b[l] - a[k]) * cross(d, b[(l + 1) % 4] - a[k]) <= 0.0 &&
                            cross(e, a[k] - b[l]) * cross(e, a[(k + 1) % 4] - b[l]) <= 0.0);
          }
        meet = meet || contains({a, {}}, b[0]) || contains({b, {}}, a[0]);
        // Collinear edges may be far apart: the boxes must overlap too.
        const Box p = bounds({a, {}}), q = bounds({b, {}});
        meet = meet && (p.lo.array() <= q.hi.array()).all() && (q.lo.array() <= p.hi.array()).all();
        const bool found = std::binary_search(pairs.begin(), pairs.end(), std::pair(i, j));
        EXPECT_TRUE(found || !meet) << i << " " << j;
      }
  }
}

TEST(NearPairs, strips_between_parallel_joints_have_their_neighbours_only) {
  for (const int n : {100, 200, 400}) {
    std::vector<Block> blocks;
    blocks.reserve(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) blocks.push_back(block(transformed(box(0, i, 1000, i + 1), Vec2(0, 0), rotation(0.5))));
    EXPECT_LE(near_pairs(blocks, std::vector<double>(blocks.size(), 1e-6)).size(), static_cast<std::size_t>(2 * n));
  }
}

}  // namespace
}  // namespace scree::near_pairs_test
