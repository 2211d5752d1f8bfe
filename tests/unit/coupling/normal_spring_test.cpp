// Normal spring: force against the derivative of the energy, tangent against the derivative of the force, at random
// gaps and on both sides of the kink.
#include "coupling/contact/law/normal_spring.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace scree::coupling::normal_spring_test {
namespace {

TEST(NormalSpring, force_is_minus_the_derivative_of_its_energy_and_tangent_that_of_the_force) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> gap(-1e-3, 1e-3), decade(5.0, 12.0);
  for (int i = 0; i < 10000; ++i) {
    const NormalSpring s{std::pow(10.0, decade(random)), i % 2 == 0};
    const double g = gap(random), h = 1e-4 * std::abs(g);
    const double force = -(s.energy(g + h) - s.energy(g - h)) / (2.0 * h);
    EXPECT_NEAR(s.force(g), force, 1e-7 * s.k * std::abs(g));
    EXPECT_NEAR(s.tangent(g), -(s.force(g + h) - s.force(g - h)) / (2.0 * h), 1e-7 * s.k);
  }
}

TEST(NormalSpring, both_sides_of_the_kink) {
  for (const bool bonded : {false, true}) {
    const NormalSpring s{1e9, bonded};
    for (const double h : {1e-3, 1e-9, 1e-300}) {
      EXPECT_EQ(s.force(-h), 1e9 * h);
      EXPECT_EQ(s.tangent(-h), 1e9);
      EXPECT_EQ(s.force(h), bonded ? -1e9 * h : 0.0);
      EXPECT_EQ(s.tangent(h), bonded ? 1e9 : 0.0);
      EXPECT_EQ(s.energy(h), bonded ? 0.5e9 * h * h : 0.0);
    }
    EXPECT_EQ(s.force(0.0), 0.0);
  }
}

}  // namespace
}  // namespace scree::coupling::normal_spring_test
