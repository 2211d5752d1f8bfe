// Affine maps fitted to outlines, and lengths of outlines.
#include "model/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "model/outline.h"
#include "model/perimeter.h"

namespace scree::body_test {
namespace {

Polygon with_hole() { return {{{0, 0}, {4, 0}, {5, 3}, {0, 3}}, {{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}}; }

TEST(AffineFit, finds_the_map_of_an_outline_with_holes) {
  std::mt19937_64 random(61);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    Mat2 F;
    F << unit(random), unit(random), unit(random), unit(random);
    const Vec2 c(unit(random), unit(random));
    const Polygon from = with_hole();
    Polygon to = from;
    for (Vec2& x : to.outer) x = c + F * x;
    for (Vec2& x : to.holes[0]) x = c + F * x;
    const AffineMotion map = affine_fit(from, to);
    EXPECT_LE((map.F - F).norm(), 1e-13);
    EXPECT_LE((map.c - c).norm(), 1e-13);
    EXPECT_EQ(map.vc, Vec2(0.0, 0.0));
    EXPECT_EQ(map.Fdot, Mat2(Mat2::Zero()));
  }
}

TEST(AffineFit, leaves_the_least_squares) {
  const Polygon from = with_hole();
  Polygon to = from;
  to.outer[2] += Vec2(0.3, -0.2);
  const AffineMotion map = affine_fit(from, to);
  const auto squares = [&](const AffineMotion& m) {
    double sum = 0.0;
    for (std::size_t r = 0; r < from.rings(); ++r)
      for (std::size_t i = 0; i < from.ring(r).size(); ++i)
        sum += (m.c + m.F * from.ring(r)[i] - to.ring(r)[i]).squaredNorm();
    return sum;
  };
  const double least = squares(map);
  for (int k = 0; k < 6; ++k)
    for (const double by : {-1e-3, 1e-3}) {
      AffineMotion other = map;
      (k < 2 ? other.c[k] : other.F((k - 2) / 2, k % 2)) += by;
      EXPECT_GT(squares(other), least);
    }
}

TEST(Perimeter, is_that_of_all_rings) {
  EXPECT_DOUBLE_EQ(perimeter(with_hole()), 4.0 + std::sqrt(10.0) + 5.0 + 3.0 + 4.0);
  EXPECT_DOUBLE_EQ(perimeter({{{0, 0}, {3, 0}, {0, 4}}, {}}), 12.0);
}

TEST(Outline, interior_angles_of_a_polygon_sum_up) {
  constexpr double kPi = 3.14159265358979323846;
  EXPECT_NEAR(interior_angle({0, 1}, {0, 0}, {1, 0}), 0.5 * kPi, 1e-15);
  EXPECT_NEAR(interior_angle({1, 0}, {0, 0}, {0, 1}), 1.5 * kPi, 1e-15);  // a notch
  EXPECT_NEAR(interior_angle({-1, 0}, {0, 0}, {1, 0}), kPi, 1e-15);
  const Polygon p = with_hole();
  const Boundary b = affine_boundary(p, 3, [](const Vec2&) { return Row{}; });
  ASSERT_EQ(b.nodes.size(), 8U);
  ASSERT_EQ(b.segments.size(), 8U);
  double outer = 0.0, hole = 0.0;
  for (const Boundary::Corner& c : b.corners) (c.ring == 0 ? outer : hole) += c.angle;
  EXPECT_NEAR(outer, 2.0 * kPi, 1e-13);       // (n - 2) pi
  EXPECT_NEAR(hole, 4.0 * 1.5 * kPi, 1e-13);  // (n + 2) pi, angles measured in the solid
  for (const Boundary::Segment& s : b.segments) EXPECT_EQ(s.cell, 3);
  EXPECT_EQ(b.segments[3].b, 0);  // rings close
  EXPECT_EQ(b.segments[7].b, 4);
}

}  // namespace
}  // namespace scree::body_test
