// A cell lists every segment near its points; the cost of a segment depends only on its length within the extent.
#include "model/cell_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <random>

namespace scree::cell_grid_test {
namespace {

TEST(CellGrid, points_of_segments_find_them_within_the_extent_and_outside) {
  std::mt19937_64 random(11);
  for (const double spread : {0.5, 3.0, 1e3, 1e8}) {
    CellGrid grid({{-1.0, 2.0}, {9.0, 7.0}}, 400);
    std::uniform_real_distribution<double> part(-spread, spread);
    std::vector<std::array<Vec2, 2>> segments;
    for (std::int32_t i = 0; i < 400; ++i) {
      const Vec2 centre(4.0 + 5.0 * part(random) / spread, 4.5 + 3.0 * part(random) / spread);
      Vec2 a = centre + Vec2(part(random), part(random)), b = centre + Vec2(part(random), part(random));
      if (i % 5 == 0) b.x() = a.x();
      if (i % 7 == 0) b.y() = a.y();
      if (i % 11 == 0) b = a;
      segments.push_back({a, b});
      grid.insert(a, b, 1e-9 * std::max(1.0, spread), i);
    }
    std::uniform_real_distribution<double> along(0.0, 1.0);
    for (std::int32_t i = 0; i < 400; ++i)
      for (int k = 0; k < 50; ++k) {
        const auto& [a, b] = segments[static_cast<std::size_t>(i)];
        const auto found = grid.at(a + along(random) * (b - a));
        EXPECT_NE(std::find(found.begin(), found.end(), i), found.end()) << i << ", spread " << spread;
      }
  }
}

TEST(CellGrid, a_segment_stays_in_the_cells_that_it_crosses) {
  CellGrid grid({{0.0, 0.0}, {10.0, 10.0}}, 10000);
  grid.insert(Vec2(-1e9, -1e9 + 0.05), Vec2(1e9, 1e9 + 0.05), 0.0, 0);  // a diagonal
  grid.insert(Vec2(-1e9, 20.0), Vec2(1e9, 20.0), 0.0, 1);               // misses the extent
  int holds[2] = {0, 0};
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j)
      for (const std::int32_t item : grid.at(Vec2(0.1 * i + 0.05, 0.1 * j + 0.05))) ++holds[item];
  EXPECT_GE(holds[0], 100);
  EXPECT_LE(holds[0], 450);  // about three per column
  EXPECT_LE(holds[1], 101);  // the upper row
}

TEST(CellGrid, time_of_a_segment_does_not_grow_with_its_length_outside) {
  CellGrid grid({{0.0, 0.0}, {1.0, 1.0}}, 1 << 18);
  const auto begin = std::chrono::steady_clock::now();
  for (std::int32_t i = 0; i < 100; ++i) grid.insert(Vec2(-1e12, 0.3), Vec2(1e12, 0.6), 0.0, i);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  EXPECT_LT(took.count(), 5.0);  // stepping along the whole segment cell by cell would take days
}

}  // namespace
}  // namespace scree::cell_grid_test
