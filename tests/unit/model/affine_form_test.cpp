// Force, stiffness and mass of an affine block, compared with central differences of the energy and with definitions.
#include "model/affine_form.h"

#include <gtest/gtest.h>

#include <array>

namespace scree::affine_form_test {
namespace {

ReferenceShape shape() {
  ReferenceShape s;
  s.mass = 2600.0;
  s.area = 1.3;
  s.second << 300.0, 40.0, 40.0, 170.0;
  return s;
}

Eigen::Matrix<double, 6, 6> from_lower(const std::array<double, 21>& lower) {
  Eigen::Matrix<double, 6, 6> A;
  std::size_t at = 0;
  for (int j = 0; j < 6; ++j)
    for (int i = j; i < 6; ++i) A(i, j) = A(j, i) = lower[at++];
  return A;
}

class Form : public testing::TestWithParam<Kinematics> {
 protected:
  const Mat2 initial_ = (Mat2() << -2e6, 4e5, 4e5, -1e6).finished();
  const Mat2 gradient_ = (Mat2() << 0.8, -0.65, 0.62, 0.79).finished();
  const AffineForm form_{shape(), Elasticity::from(1e8, 0.25, Plane::strain), GetParam(), initial_};
};

TEST_P(Form, force_and_stiffness_are_derivatives_of_the_energy) {
  std::array<double, 21> lower{};
  std::array<double, 6> force{};
  (void)form_.linearise(gradient_, Stiffness::exact, lower, force);
  const auto K = from_lower(lower);
  const double h = 1e-6;
  for (std::size_t k = 0; k < 6; ++k) {
    std::array<double, 6> d{};
    d[k] = h;
    const Mat2 dF = form_.gradient(d);
    std::array<double, 6> after{}, before{};
    const double up = form_.linearise(gradient_ + dF, Stiffness::exact, {}, after),
                 down = form_.linearise(gradient_ - dF, Stiffness::exact, {}, before);
    EXPECT_NEAR(force[k], -(up - down) / (2.0 * h), 1e-7 * 1e8) << k;  // round-off of an energy of 1e7 J, divided by h
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(K(static_cast<int>(i), static_cast<int>(k)), -(after[i] - before[i]) / (2.0 * h), 1e-7 * K.norm())
          << i << " " << k;
  }
}

TEST_P(Form, unknowns_and_motion_are_inverse_and_the_mass_gives_the_kinetic_energy) {
  const Vec2 vc(0.3, -1.7);
  const Mat2 G = (Mat2() << 0.2, -3.0, 2.5, -0.4).finished();
  std::array<double, 6> d{};
  form_.unknowns(vc, G, d);
  EXPECT_EQ(AffineForm::translation(d), vc);
  EXPECT_LT((form_.gradient(d) - G).norm(), 1e-15 * G.norm());
  std::array<double, 21> lower{};
  form_.mass(lower);
  const Eigen::Map<const Eigen::Matrix<double, 6, 1>> rate(d.data());
  const double kinetic = 0.5 * shape().mass * vc.squaredNorm() + 0.5 * (G * shape().second * G.transpose()).trace();
  EXPECT_NEAR(0.5 * rate.dot(from_lower(lower) * rate), kinetic, 1e-13 * kinetic);
  // The row of a point applied to the unknowns gives its velocity, vc + G X.
  const Vec2 X(0.7, -0.4);
  const ChartRow row = form_.chart_row(1.0, X);
  Vec2 v = Vec2::Zero();
  for (std::size_t k = 0; k < static_cast<std::size_t>(row.n); ++k)
    v += Vec2(row.tx[k], row.ty[k]) * d[static_cast<std::size_t>(row.dof[k])];
  EXPECT_LT((v - vc - G * X).norm(), 1e-14);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Form, testing::Values(Kinematics::corotational, Kinematics::linear),
                         [](const auto& of) { return of.param == Kinematics::linear ? "linear" : "corotational"; });

}  // namespace
}  // namespace scree::affine_form_test
