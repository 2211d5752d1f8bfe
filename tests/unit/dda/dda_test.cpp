// Formulas of DDA: matrices, forces and updates, compared with their definitions up to round-off.
#include <gtest/gtest.h>

#include <Eigen/Dense>

#include "dda/dda_pool.h"

namespace scree::dda::dda_test {
namespace {

TEST(ShiMatrix, agrees_with_the_step_gradient) {
  Vec6 D;
  D << 0.1, -0.2, 0.03, 0.01, -0.02, 0.05;
  const Vec2 r(1.5, -0.7);
  EXPECT_NEAR((shi_matrix(r) * D - (D.head<2>() + step_gradient(D) * r)).norm(), 0.0, 1e-16);
  EXPECT_NEAR((rates_of(D.head<2>(), step_gradient(D)) - D).norm(), 0.0, 1e-16);
}

TEST(MassMatrix, kinetic_energy_equals_the_affine_one) {
  Mat2 S, G;
  S << 2.0, 0.3, 0.3, 1.0;
  G << 0.2, -1.0, 0.7, 0.4;
  const Vec6 rate = rates_of({1.0, 2.0}, G);
  EXPECT_NEAR(0.5 * rate.dot(mass_matrix(3.0, S) * rate), 0.5 * 3.0 * 5.0 + 0.5 * (G * S * G.transpose()).trace(),
              1e-14);
}

TEST(InternalForce, is_minus_the_derivative_along_the_unknowns_and_none_on_rotation) {
  const Elasticity law{1.1, 0.8};
  Mat2 F = rotation(0.5) * (Mat2::Identity() + (Mat2() << 0.1, 0.02, 0.02, -0.05).finished());
  const Vec6 f = internal_force(2.0, law, F, Mat2::Zero());
  EXPECT_EQ(f(2), 0.0);
  for (int k = 2; k < 6; ++k) {
    Vec6 D = Vec6::Zero();
    D(k) = 1e-6;
    const auto energy = [&](double sign) {
      return 2.0 * elastic_response(law, (Mat2::Identity() + sign * step_gradient(D)) * F, Mat2::Zero()).energy;
    };
    EXPECT_NEAR(f(k), -(energy(1.0) - energy(-1.0)) / 2e-6, 1e-8);
  }
}

TEST(ExactUpdate, spin_keeps_edges_and_rate_to_round_off) {
  AffineState s{{0, 0}, {0, 0}, Mat2::Identity(), 2.0 * quarter_turn()};
  const double h = 1e-2;
  for (int i = 0; i < 10000; ++i) {
    Vec6 D = Vec6::Zero(), rate = rates_of(s.vc, s.Fdot * s.F.inverse());
    D(2) = h * rate(2);
    s = exact_update(s, D, rate);
  }
  EXPECT_NEAR(s.F.col(0).norm(), 1.0, 1e-12);
  EXPECT_NEAR(s.F.col(1).norm(), 1.0, 1e-12);
  const Mat2 G = s.Fdot * s.F.inverse();
  EXPECT_NEAR(0.5 * (G(1, 0) - G(0, 1)), 2.0, 2e-12);
}

// A turn by r0 lengthens every edge by the factor sqrt(1 + r0^2): I + r0 W is a similarity, det(I + r0 W) = 1 + r0^2.
TEST(FirstOrderUpdate, a_turn_makes_edges_longer_by_the_secant) {
  for (const double r0 : {1e-3, 1e-2, 0.1}) {
    AffineState s{{0, 0}, {0, 0}, Mat2::Identity(), 2.0 * quarter_turn()};
    const int steps = 1000;
    for (int i = 0; i < steps; ++i) {
      Vec6 D = Vec6::Zero();
      D(2) = r0;
      s = first_order_update(s, D, rates_of(s.vc, s.Fdot * s.F.inverse()));
    }
    const double expected = std::pow(1.0 + r0 * r0, 0.5 * steps);
    EXPECT_NEAR(s.F.col(0).norm() / expected, 1.0, 1e-12) << r0;
    EXPECT_NEAR(s.F.col(1).norm() / expected, 1.0, 1e-12) << r0;
    EXPECT_NEAR(s.F.col(0).dot(s.F.col(1)), 0.0, 1e-12 * expected * expected) << r0;
    const Mat2 G = s.Fdot * s.F.inverse();
    EXPECT_NEAR(0.5 * (G(1, 0) - G(0, 1)), 2.0, 2e-12) << r0;
  }
}

}  // namespace
}  // namespace scree::dda::dda_test
