// The elastic blocks that sliding is measured by: against a rigid block, and converged.
#include "app/studies/elastic_blocks.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/elasticity.h"

namespace scree::app::elastic_blocks_test {
namespace {

constexpr double kSlope = 30.0 * std::numbers::pi / 180.0, kGravity = 9.81, kRamp = 0.5, kEnd = 1.5;

ElasticBlocks square(double young, int degree) {
  ElasticBlocks e;
  e.shape = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  e.degree = degree;
  e.points = degree == 1 ? 2 : 5;
  e.young = young;
  e.friction_plane = std::tan(20.0 * std::numbers::pi / 180.0);
  e.friction_between = 1.0;
  e.stiffness_plane = e.stiffness_stack = e.stiffness_row =
      Elasticity::from(young, e.poisson, Plane::strain).p_modulus() / 10.0;
  return e;
}

Vec2 gravity(double t) {
  const double g = kGravity * std::min(1.0, t / kRamp);
  return {-g * std::sin(kSlope), -g * std::cos(kSlope)};
}

/// Over the way of a rigid block on the slope, which slides from the beginning.
double excess(const ElasticBlocks& e, double fraction = 0.2) {
  const double net = kGravity * (std::sin(kSlope) - std::cos(kSlope) * e.friction_plane), after = kEnd - kRamp;
  const double rigid = net * (kRamp * kRamp / 6.0 + 0.5 * kRamp * after + 0.5 * after * after);
  double sum = 0.0;
  const std::vector<double> ways = elastic_ways(e, gravity, 0.0, kEnd, fraction);
  for (const double way : ways) sum += way / rigid - 1.0;
  return sum / static_cast<double>(ways.size());
}

TEST(ElasticBlocks, go_over_into_a_rigid_one_as_1_over_E) {
  for (const int degree : {1, 3}) {
    const double soft = excess(square(5e9, degree)), stiff = excess(square(5e10, degree));
    EXPECT_LT(std::abs(stiff), 1e-3) << degree;
    EXPECT_NEAR(soft / stiff, 10.0, 3.0) << degree;
  }
}

TEST(ElasticBlocks, do_not_depend_on_the_step) {
  for (const int degree : {1, 3}) {
    const double coarse = excess(square(5e9, degree), 0.2), fine = excess(square(5e9, degree), 0.1);
    EXPECT_NEAR(coarse / fine, 1.0, 0.02) << degree;
  }
}

TEST(ElasticBlocks, side_by_side_and_on_each_other_slide_as_one) {
  ElasticBlocks row = square(5e10, 1), stack = row;
  row.row = 3;
  stack.stack = 2;
  EXPECT_LT(std::abs(excess(row)), 2e-3);
  EXPECT_LT(std::abs(excess(stack)), 3e-3);
}

TEST(ElasticBlocks, stay_where_friction_holds) {
  ElasticBlocks e = square(5e10, 3);
  e.friction_plane = std::tan(35.0 * std::numbers::pi / 180.0);
  EXPECT_LT(std::abs(elastic_ways(e, gravity, 0.0, kEnd, 0.2).front()), 5e-4);  // its shear
}

}  // namespace
}  // namespace scree::app::elastic_blocks_test
