#include "coupling/integrate/newmark_theory.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "model/dense_algebra.h"

namespace scree::coupling::newmark_theory_test {
namespace {

const NewmarkTheory kImplicit{0.5, 1.0}, kTrapezoidal{0.25, 0.5}, kExplicit{0.0, 0.5};

TEST(NewmarkTheory, amplification_satisfies_the_scheme) {
  for (const NewmarkTheory& s : {kImplicit, kTrapezoidal, kExplicit, NewmarkTheory{0.3, 0.7}})
    for (const double Omega : {0.1, 1.0, 1.9, 7.0}) {
      const Vec2 z(0.3, -0.8), next = s.amplification(Omega) * z;
      const double a = -Omega * Omega * z.x(), b = -Omega * Omega * next.x();  // h^2 times the accelerations
      EXPECT_NEAR(next.x(), z.x() + z.y() + (0.5 - s.beta) * a + s.beta * b, 1e-12 * (1.0 + Omega * Omega));
      EXPECT_NEAR(next.y(), z.y() + (1.0 - s.gamma) * a + s.gamma * b, 1e-12 * (1.0 + Omega * Omega));
    }
}

TEST(NewmarkTheory, spectral_radius_equals_that_of_a_general_solver) {
  for (const NewmarkTheory& s : {kImplicit, kTrapezoidal, kExplicit, NewmarkTheory{0.6, 1.0}})
    for (const double Omega : {0.05, 0.7, 1.99, 2.5, 3.9, 4.1, 30.0}) {
      const Mat2 A = s.amplification(Omega);
      const double general = eigenvalues(A).cwiseAbs().maxCoeff();
      EXPECT_NEAR(spectral_radius(A), general, 1e-10 * general) << s.beta << ' ' << s.gamma << ' ' << Omega;
    }
}

TEST(NewmarkTheory, damping_peaks_are_the_thesis_s) {
  const std::pair<double, double> printed[] = {
      {0.50, 0.2845}, {0.52, 0.2659}, {0.54, 0.2518}, {0.60, 0.2222}, {1.00, 0.1457}};
  for (const auto& [beta, xi] : printed)  // four digits; at 0.54 [Qu2013] prints 0.2519 for 0.25178
    EXPECT_NEAR((NewmarkTheory{beta, 1.0}.largest_damping(30.0).value), xi, 5.1e-5) << beta;
}

TEST(NewmarkTheory, spectral_radius_is_least_at_the_bifurcation) {
  EXPECT_DOUBLE_EQ(kImplicit.bifurcation(), 4.0);
  EXPECT_NEAR(spectral_radius(kImplicit.amplification(4.0)), 1.0 / 3.0, 1e-7);  // double root: square root of round-off
  for (const double Omega : {3.5, 3.9, 4.1, 4.5})
    EXPECT_GT(spectral_radius(kImplicit.amplification(Omega)), 1.0 / 3.0 + 1e-3);
  EXPECT_TRUE(std::isinf(kTrapezoidal.bifurcation()));
}

TEST(NewmarkTheory, central_difference_is_stable_up_to_two) {
  EXPECT_DOUBLE_EQ(kExplicit.stability_limit(), 2.0);
  EXPECT_NEAR(spectral_radius(kExplicit.amplification(1.999)), 1.0, 1e-12);
  EXPECT_GT(spectral_radius(kExplicit.amplification(2.001)), 1.05);
  EXPECT_TRUE(std::isinf(kImplicit.stability_limit()));
  const NewmarkTheory between{0.1, 0.6};
  const double limit = between.stability_limit();
  EXPECT_LT(spectral_radius(between.amplification(0.999 * limit)), 1.0);
  EXPECT_GT(spectral_radius(between.amplification(1.001 * limit)), 1.0);
}

TEST(NewmarkTheory, period_errors_have_their_known_leading_terms) {
  const double Omega = 0.01, w2 = Omega * Omega;
  EXPECT_NEAR(period_error(kExplicit.amplification(Omega), Omega), -w2 / 24.0, 1e-8);
  EXPECT_NEAR(period_error(kTrapezoidal.amplification(Omega), Omega), w2 / 12.0, 1e-8);
  EXPECT_TRUE(std::isnan(period_error(kImplicit.amplification(5.0), 5.0)));
}

TEST(NewmarkTheory, damping_measure_is_a_quarter_of_omega_where_small) {
  EXPECT_NEAR(damping_measure(kImplicit.amplification(1e-3), 1e-3), 0.25e-3, 1e-9);
  EXPECT_EQ(damping_measure(kTrapezoidal.amplification(0.5), 0.5), 0.0);
}

}  // namespace
}  // namespace scree::coupling::newmark_theory_test
