// The direction with the largest total length of lines, compared with known directions.
#include "model/main_direction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scree::main_direction_test {
namespace {

Vec2 towards(double deg, double length) {
  const double a = deg * std::numbers::pi / 180.0;
  return length * Vec2(std::cos(a), std::sin(a));
}

TEST(MainDirection, is_that_of_the_longest_line_of_the_part_with_most_length) {
  MainDirection main;
  main.add(towards(10.0, 5.0));
  main.add(towards(70.0, 3.0));
  main.add(towards(250.2, 3.5));  // the same axis, in the same sector as 70 degrees
  EXPECT_LT((main.along() - towards(250.2, 1.0)).norm(), 1e-15);
  EXPECT_NEAR(main.share(), 6.5 / 11.5, 1e-15);
}

TEST(MainDirection, joins_both_ends_of_the_half_turn) {
  MainDirection main;
  main.add(towards(179.8, 2.0));
  main.add(towards(0.2, 2.0));
  main.add(towards(90.0, 3.0));
  EXPECT_NEAR(main.share(), 4.0 / 7.0, 1e-15);
  EXPECT_NEAR(std::abs(main.along().x()), std::cos(0.2 * std::numbers::pi / 180.0), 1e-15);
}

TEST(MainDirection, without_lines_is_the_x_axis) { EXPECT_EQ(MainDirection().along(), Vec2(1.0, 0.0)); }

}  // namespace
}  // namespace scree::main_direction_test
