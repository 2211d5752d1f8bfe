// Pressure under a piezometric line and its resultant on a stretch, compared with sums over many small pieces.
#include "model/joint_water.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace scree::joint_water_test {
namespace {

const JointWater kKinked{{{0.0, 2.0}, {4.0, 5.0}, {6.0, 1.0}, {9.0, 3.0}}, 9810.0};

TEST(JointWater, pressure_is_hydrostatic_under_the_line_and_level_beyond_it) {
  EXPECT_DOUBLE_EQ(water_pressure(kKinked, {2.0, 3.0}), 9810.0 * 0.5);
  EXPECT_DOUBLE_EQ(water_pressure(kKinked, {4.0, 0.0}), 9810.0 * 5.0);
  EXPECT_EQ(water_pressure(kKinked, {6.0, 1.5}), 0.0);
  EXPECT_DOUBLE_EQ(water_pressure(kKinked, {-100.0, 0.0}), 9810.0 * 2.0);
  EXPECT_DOUBLE_EQ(water_pressure(kKinked, {100.0, -1.0}), 9810.0 * 4.0);
}

TEST(JointWater, force_of_a_half_full_crack_is_that_of_the_triangle) {
  const JointWater water{{{-1.0, 2.5}, {1.0, 2.5}}, 1000.0};
  // u = w (2.5 - y) on 0 <= y <= 4: resultant w 2.5^2/2, its moment about y = 0 w 2.5^3/6.
  const double low = water_force(water, {0.0, 0.0}, {0.0, 4.0}), high = water_force(water, {0.0, 4.0}, {0.0, -4.0});
  EXPECT_NEAR(low + high, 1000.0 * 2.5 * 2.5 / 2.0, 1e-9);
  EXPECT_NEAR(4.0 * high, 1000.0 * 2.5 * 2.5 * 2.5 / 6.0, 1e-9);
  EXPECT_EQ(water_force(water, {0.0, 3.0}, {0.0, 1.0}), 0.0);
}

TEST(JointWater, force_is_the_weighted_integral_whatever_the_stretch_crosses) {
  std::mt19937_64 random(17);
  const auto draw = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random() >> 11) * 0x1p-53);
  };
  int wet = 0;
  for (int k = 0; k < 200; ++k) {
    const Vec2 from(draw(-3, 12), draw(-1, 6)), way(k % 10 == 0 ? 0.0 : draw(-8, 8), draw(-5, 5));
    const double length = way.norm();
    constexpr int kPieces = 20000;
    double sum = 0.0;
    for (int i = 0; i < kPieces; ++i) {
      const double r = (i + 0.5) / kPieces;
      sum += water_pressure(kKinked, from + r * way) * (1.0 - r);
    }
    sum *= length / kPieces;
    // Error of the midpoint rule: h^2/24 times the second derivative, and less than u' h^2 at a kink.
    EXPECT_NEAR(water_force(kKinked, from, way), sum, 1e-7 * 9810.0 * length * length) << k;
    wet += sum > 0.0 ? 1 : 0;
  }
  EXPECT_GT(wet, 100);
}

}  // namespace
}  // namespace scree::joint_water_test
