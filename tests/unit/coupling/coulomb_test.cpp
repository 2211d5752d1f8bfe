// Return mapping: limit, tangent, energy identity and symmetry at random states, and on both sides of the limit.
#include "coupling/contact/law/coulomb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace scree::coupling::coulomb_test {
namespace {

TEST(Coulomb, return_mapping_at_random_states) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> unit(-1.0, 1.0), decade(5.0, 12.0);
  int slips = 0;
  for (int i = 0; i < 10000; ++i) {
    const double kt = std::pow(10.0, decade(random)), e = 1e-3 * unit(random),
                 limit = kt * 1e-3 * std::abs(unit(random)), scale = kt * std::max(std::abs(e), 1e-5);
    const CoulombStep step = return_mapping(kt, e, limit);
    slips += step.slip != 0.0 ? 1 : 0;
    EXPECT_LE(std::abs(step.force), limit * (1.0 + 1e-15));
    EXPECT_NEAR(step.force, -kt * step.stretch, 1e-15 * scale);
    EXPECT_NEAR(step.stretch + step.slip, e, 1e-15 * 1e-3);
    EXPECT_LE(step.force * step.slip, 0.0);  // friction never drives
    // Energy: what the predictor stores is kept, dissipated, or the slider's excess over the limit.
    EXPECT_NEAR(tangential_spring_energy(kt, e),
                tangential_spring_energy(kt, step.stretch) + step.dissipated + tangential_spring_energy(kt, step.slip),
                4e-16 * kt * e * e + 1e-15 * kt * step.stretch * step.stretch);
    // Tangent at a fixed limit.
    const double h = 1e-7 * std::abs(e);
    const CoulombStep more = return_mapping(kt, e + h, limit), less = return_mapping(kt, e - h, limit);
    if ((more.slip != 0.0) == (less.slip != 0.0)) {
      EXPECT_NEAR(step.tangent, -(more.force - less.force) / (2.0 * h), 1e-7 * kt);
    }
    // Where it sticks the force is the derivative of the energy.
    if (step.slip == 0.0) {
      const double d = 1e-4 * std::abs(e);
      EXPECT_NEAR(step.force, -(tangential_spring_energy(kt, e + d) - tangential_spring_energy(kt, e - d)) / (2.0 * d),
                  1e-7 * scale);
    }
    const CoulombStep mirror = return_mapping(kt, -e, limit);
    EXPECT_EQ(mirror.force, -step.force);
    EXPECT_EQ(mirror.slip, -step.slip);
    EXPECT_EQ(mirror.dissipated, step.dissipated);
  }
  EXPECT_GT(slips, 2000);
  EXPECT_LT(slips, 8000);
}

TEST(Coulomb, both_sides_of_the_limit) {
  constexpr double kt = 1 << 20;
  const double at = 0.5;  // k_t e is exact
  const double limit = kt * at;
  const CoulombStep sticks = return_mapping(kt, at, limit), slips = return_mapping(kt, std::nextafter(at, 1.0), limit);
  EXPECT_EQ(sticks.slip, 0.0);
  EXPECT_EQ(sticks.tangent, kt);
  EXPECT_GT(slips.slip, 0.0);
  EXPECT_EQ(slips.tangent, 0.0);
  EXPECT_EQ(slips.force, sticks.force);  // continuous
  EXPECT_EQ(return_mapping(kt, 1e3, std::numeric_limits<double>::infinity()).slip, 0.0);
  EXPECT_EQ(return_mapping(kt, 0.0, 0.0).slip, 0.0);
  EXPECT_EQ(return_mapping(kt, 0.25, 0.0).stretch, 0.0);
}

TEST(Coulomb, is_idempotent) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 10000; ++i) {
    const CoulombStep once = return_mapping(1 << 25, unit(random), 1e6 * std::abs(unit(random)));
    const CoulombStep twice = return_mapping(1 << 25, once.stretch, std::abs(once.force));
    EXPECT_EQ(twice.slip, 0.0);
    EXPECT_EQ(twice.force, once.force);
  }
}

}  // namespace
}  // namespace scree::coupling::coulomb_test
