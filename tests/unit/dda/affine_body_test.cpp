// Shi's unknowns of a block: matrix, mass, stiffness and exact rotation, compared with their definitions.
#include "dda/affine_body.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <random>

namespace scree::dda::affine_body_test {
namespace {

Vec6 drawn(std::mt19937_64& random, double size) {
  std::uniform_real_distribution<double> unit(-size, size);
  Vec6 d;
  for (int i = 0; i < kUnknowns; ++i) d[i] = unit(random);
  return d;
}

TEST(AffineBody, matrix_gives_the_displacement_of_translation_and_gradient) {
  std::mt19937_64 random(71);
  for (int i = 0; i < 1000; ++i) {
    const Vec6 D = drawn(random, 1.0);
    const Vec2 r = Vec2::Random();
    const Vec2 expected = Vec2(D[0], D[1]) + step_gradient(D) * r;
    EXPECT_LE((shi_matrix(r) * D - expected).norm(), 1e-15);
  }
}

TEST(AffineBody, rates_are_the_inverse_of_the_gradient) {
  std::mt19937_64 random(72);
  for (int i = 0; i < 1000; ++i) {
    const Vec6 D = drawn(random, 1.0);
    EXPECT_LE((rates_of(Vec2(D[0], D[1]), step_gradient(D)) - D).norm(), 1e-15);
  }
}

/// Reference: T^T T summed over 2 x 2 Gauss points, which have the first and second moments of the rectangle.
TEST(AffineBody, mass_is_the_integral_of_the_matrix) {
  const double width = 3.0, height = 2.0, density = 2500.0, mass = density * width * height;
  const Mat2 S = Eigen::DiagonalMatrix<double, 2>(mass * width * width / 12.0, mass * height * height / 12.0);
  Mat6 sum = Mat6::Zero();
  const double g = 0.5 / std::sqrt(3.0);  // Gauss points
  for (const double x : {-g * width, g * width})
    for (const double y : {-g * height, g * height}) {
      const Mat26 T = shi_matrix(Vec2(x, y));
      sum += 0.25 * mass * T.transpose() * T;
    }
  const Mat6 M = mass_matrix(mass, S);
  EXPECT_LE((M - sum).norm(), 1e-12 * sum.norm());
  EXPECT_LE((M - M.transpose()).norm(), 0.0);
  EXPECT_GT(M.determinant(), 0.0);
}

TEST(AffineBody, rotation_is_exact_and_a_free_spin_keeps_its_rate) {
  AffineState s{Vec2(1.0, 2.0), Vec2(0.0, 0.0), Mat2::Identity(), Mat2::Zero()};
  Vec6 D = Vec6::Zero(), rate = Vec6::Zero();
  D[2] = 0.3;
  rate[2] = 5.0;
  for (int step = 0; step < 1000; ++step) {
    s = exact_update(s, D, rate);
    EXPECT_NEAR(s.F.determinant(), 1.0, 1e-12);
    EXPECT_LE((s.F.transpose() * s.F - Mat2::Identity()).norm(), 1e-12);
    const Mat2 G = s.Fdot * s.F.inverse();
    EXPECT_NEAR(0.5 * (G(1, 0) - G(0, 1)), 5.0, 1e-10);
  }
  EXPECT_NEAR(std::atan2(s.F(1, 0), s.F(0, 0)), std::remainder(300.0, 2.0 * std::acos(-1.0)), 1e-10);
  EXPECT_EQ(s.c, Vec2(1.0, 2.0));
}

}  // namespace
}  // namespace scree::dda::affine_body_test
