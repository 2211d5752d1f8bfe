// Recovered stress for pictures: linear fields are kept, alternating element stresses vanish, blocks do not mix.
#include "io/pictures/recovered_stress.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>

namespace scree::io::recovered_stress_test {
namespace {

/// n x n squares of side 1, each of two triangles; every cell has its own points.
void add_grid(StoredFrame& f, int n, double x0, int block, const std::function<double(const Vec2&, int)>& stress) {
  if (f.offsets.empty()) f.offsets.push_back(0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int half = 0; half < 2; ++half) {
        const Vec2 at(x0 + i, j);
        const std::array<Vec2, 3> corners = half == 0 ? std::array<Vec2, 3>{at, at + Vec2(1, 0), at + Vec2(1, 1)}
                                                      : std::array<Vec2, 3>{at, at + Vec2(1, 1), at + Vec2(0, 1)};
        for (const Vec2& p : corners) {
          f.connectivity.push_back(static_cast<std::int64_t>(f.position.size() / 2));
          f.position.insert(f.position.end(), {p.x(), p.y()});
          f.displacement.insert(f.displacement.end(), {0.0, 0.0});
        }
        f.offsets.push_back(static_cast<std::int64_t>(f.connectivity.size()));
        f.block.push_back(block);
        const Vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
        f.stress.insert(f.stress.end(), {stress(middle, half), 2.0, -stress(middle, half)});
      }
}

TEST(RecoveredStress, a_plane_is_kept_where_its_cells_surround_a_point) {
  StoredFrame f;
  const auto plane = [](const Vec2& x) { return 3.0 + 2.0 * x.x() - x.y(); };
  add_grid(f, 8, 0.0, 0, [&](const Vec2& x, int) { return plane(x); });
  const std::vector<double> s = recovered_stress(f);
  ASSERT_EQ(s.size(), 3 * f.connectivity.size());
  for (std::size_t i = 0; i < f.connectivity.size(); ++i) {
    const Vec2 x(f.position[2 * i], f.position[2 * i + 1]);
    const bool inside = x.minCoeff() > 0.5 && x.maxCoeff() < 7.5;
    // Tolerance at the rim: the value stays between the stresses of the cells around, with centres 2/3 of a side away.
    EXPECT_NEAR(s[3 * i], plane(x), inside ? 1e-12 : 2.0);
    EXPECT_NEAR(s[3 * i + 1], 2.0, 1e-12);
    EXPECT_NEAR(s[3 * i + 2], -s[3 * i], 1e-12);
  }
}

TEST(RecoveredStress, a_checkerboard_goes) {
  StoredFrame f;
  add_grid(f, 8, 0.0, 0, [](const Vec2&, int half) { return half == 0 ? 1.0 : -1.0; });
  const std::vector<double> s = recovered_stress(f);
  for (std::size_t i = 0; i < f.connectivity.size(); ++i) {
    const Vec2 x(f.position[2 * i], f.position[2 * i + 1]);
    const bool inside = x.minCoeff() > 0.5 && x.maxCoeff() < 7.5;
    EXPECT_NEAR(s[3 * i], 0.0, inside ? 0.05 : 1.0) << x.transpose();
    EXPECT_LE(std::abs(s[3 * i]), 1.0);
  }
}

TEST(RecoveredStress, blocks_and_the_faces_of_an_open_crack_do_not_mix) {
  for (const bool crack : {false, true}) {
    StoredFrame f;
    add_grid(f, 4, 0.0, 0, [](const Vec2&, int) { return 1.0; });
    const std::size_t first = f.connectivity.size();
    add_grid(f, 4, 4.0, crack ? 0 : 1, [](const Vec2&, int) { return 5.0; });
    if (crack)
      for (std::size_t p = first; p < f.position.size() / 2; ++p) {
        f.position[2 * p] += 0.01;
        f.displacement[2 * p] += 0.01;
      }
    const std::vector<double> s = recovered_stress(f);
    for (std::size_t i = 0; i < f.connectivity.size(); ++i) EXPECT_NEAR(s[3 * i], i < first ? 1.0 : 5.0, 1e-12);
  }
}

TEST(RecoveredStress, a_block_of_one_cell_keeps_its_stress) {
  StoredFrame f;
  f.offsets = {0, 5};
  f.connectivity = {0, 1, 2, 3, 4};
  f.position = {0, 0, 2, 0, 1, 1, 2, 2, 0, 2};
  f.displacement.assign(10, 0.0);
  f.block = {0};
  f.stress = {1.0, -2.0, 0.5};
  const std::vector<double> s = recovered_stress(f);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_DOUBLE_EQ(s[3 * i], 1.0);
    EXPECT_DOUBLE_EQ(s[3 * i + 1], -2.0);
  }
}

}  // namespace
}  // namespace scree::io::recovered_stress_test
