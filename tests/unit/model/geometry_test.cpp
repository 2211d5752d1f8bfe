// Moments of polygons, elastic response and overlap of blocks, compared with hand calculations and differences.
#include "model/geometry.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "model/elasticity.h"
#include "model/model.h"
#include "model/planar.h"

namespace scree::geometry_test {
namespace {

Polygon square_with_hole() {
  Polygon p{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {{{1, 0.5}, {2, 0.5}, {2, 1.5}, {1, 1.5}}}};
  orient(p);
  return p;
}

TEST(Moments, rectangle_with_hole_equals_hand_calculation) {
  const Moments m = moments(square_with_hole());
  EXPECT_DOUBLE_EQ(m.area, 7.0);
  EXPECT_NEAR(m.centroid.x(), (8.0 * 2.0 - 1.5) / 7.0, 1e-15);
  EXPECT_NEAR(m.centroid.y(), 1.0, 1e-15);
  EXPECT_NEAR(m.second(1, 1), 4.0 * 8.0 / 12.0 - 1.0 / 12.0, 1e-14);
}

TEST(Moments, triangulation_of_gives_the_same_area_and_centroid) {
  const Moments whole = moments(square_with_hole());
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  for (const Ring& r : triangulate(square_with_hole())) {
    const Moments m = moments({r, {}});
    area += m.area;
    first += m.area * m.centroid;
  }
  EXPECT_NEAR(area, whole.area, 1e-13);
  EXPECT_NEAR((first / area - whole.centroid).norm(), 0.0, 1e-13);
}

TEST(Moments, far_from_the_origin_lose_nothing) {
  const Moments near = moments(square_with_hole());
  const Moments far = moments(transformed(square_with_hole(), {1e6, -1e6}, Mat2::Identity()));
  EXPECT_NEAR((far.second - near.second).norm(), 0.0, 1e-8);
}

TEST(ElasticResponse, piola_stress_is_the_gradient_of_the_energy) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> u(-0.2, 0.2);
  for (int k = 0; k < 20; ++k) {
    Mat2 F = rotation(3.0 * u(generator));
    Mat2 s0;
    s0 << u(generator), u(generator), 0.0, u(generator);
    s0(1, 0) = s0(0, 1);
    for (int i = 0; i < 4; ++i) F.data()[i] += u(generator);
    const Elasticity law{1.3, 0.9};
    const Mat2 P = elastic_response(law, F, s0).P;
    for (int i = 0; i < 4; ++i) {
      Mat2 plus = F, minus = F;
      const double h = 1e-6;
      plus.data()[i] += h;
      minus.data()[i] -= h;
      const double slope =
          (elastic_response(law, plus, s0).energy - elastic_response(law, minus, s0).energy) / (2.0 * h);
      EXPECT_NEAR(P.data()[i], slope, 1e-9);  // error of the central difference: h^2 and round-off/h
    }
    const Mat2 torque = P * F.transpose();
    EXPECT_NEAR(torque(0, 1), torque(1, 0), 1e-14);
  }
}

TEST(ElasticResponse, strain_of_kirchhoff_inverts_the_law) {
  const Elasticity law = Elasticity::from(1e9, 0.3, Plane::stress);
  Mat2 e;
  e << 0.01, -0.004, -0.004, 0.02;
  const Mat2 kirchhoff = law.stress(e) * (Mat2::Identity() + e);
  EXPECT_NEAR((strain_of_kirchhoff(law, kirchhoff, Mat2::Zero()) - e).norm(), 0.0, 1e-15);
  Mat2 s0;
  s0 << -3e7, 1e7, 1e7, 2e7;  // initial stress; the reference is the co-rotational response of U = I + e
  const Mat2 U = Mat2::Identity() + e, with = elastic_response(law, U, s0).P * U.transpose();
  EXPECT_NEAR((strain_of_kirchhoff(law, with, s0) - e).norm(), 0.0, 1e-14);
}

TEST(CheckGeometry, overlap_is_found_and_touching_is_fine) {
  Model model;
  const auto add = [&](double x0, double x1) {
    Block b;
    b.name = std::string(1, static_cast<char>('a' + model.blocks.size()));
    b.polygon = {{{x0, 0}, {x1, 0}, {x1, 1}, {x0, 1}}, {}};
    model.blocks.push_back(b);
  };
  add(0, 1);
  add(1, 2);
  EXPECT_TRUE(check_geometry(model).empty());
  add(1.9, 3);
  const auto faults = check_geometry(model);
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].block, BlockId{2});
  EXPECT_EQ(faults[0].other, BlockId{1});
}

}  // namespace
}  // namespace scree::geometry_test
