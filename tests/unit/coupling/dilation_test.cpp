// Slip and force of a dilating contact point: the slip against its equation, the two forms against each other.
#include "coupling/contact/law/dilation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling::dilation_test {
namespace {

struct Drawn {
  JointLaw law;
  DilatingTrial trial;
  double cohesion = 0.0, mu = 0.0;
};

Drawn draw(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  Drawn d;
  d.law.friction = 0.2 + 0.8 * unit(random);
  d.law.dilation = d.law.friction * unit(random);
  if (unit(random) < 0.5) d.law.dilation_slip = 2e-3 * unit(random);
  d.mu = std::tan(d.law.friction);
  d.trial.kn = std::pow(10.0, 6.0 + 4.0 * unit(random));
  d.trial.kt = d.trial.kn * (0.1 + unit(random));
  d.trial.per_opening = d.trial.kn * (1.0 + 2.0 * unit(random));
  d.trial.stretch = 1e-3 * (2.0 * unit(random) - 1.0);
  d.trial.pressed = 0.5e-3 * d.trial.kn * (2.0 * unit(random) - 1.0);
  d.trial.before = 2e-3 * unit(random);
  d.cohesion = unit(random) < 0.5 ? 0.0 : 0.2e-3 * d.trial.kt * unit(random);
  return d;
}

TEST(Dilation, slip_solves_its_equation_at_random_states) {
  std::mt19937_64 random(4);
  int inner = 0;
  for (int i = 0; i < 10000; ++i) {
    const Drawn d = draw(random);
    const DilatingTrial& t = d.trial;
    const double slip = dilating_slip(d.law, t, d.cohesion, d.mu), e = std::abs(t.stretch);
    ASSERT_GE(slip, 0.0);
    ASSERT_LE(slip, e);
    const double pressed = t.pressed + t.per_opening * opened_in(d.law, t.before, slip);
    const double limit = d.cohesion + d.mu * std::max(0.0, pressed);
    const double residual = t.kt * (e - slip) - limit, scale = t.kt * e + limit;
    // Unless the spring is within the limit without slip, or the slip takes all of its elongation.
    if (slip > 0.0 && slip < e) {
      ++inner;
      EXPECT_NEAR(residual, 0.0, 1e-12 * scale) << i;
    } else if (slip == 0.0) {
      EXPECT_LE(residual, 1e-12 * scale) << i;
    } else {
      EXPECT_GE(residual, -1e-12 * scale - limit) << i;
    }
  }
  EXPECT_GT(inner, 2000);
}

/// The implicit form, linear in gap and elongation, gives the force that the explicit form finds by its slip.
TEST(Dilation, implicit_force_is_the_explicit_one_at_random_states) {
  std::mt19937_64 random(5);
  int compared = 0;
  for (int i = 0; i < 10000; ++i) {
    Drawn d = draw(random);
    d.trial.per_opening = d.trial.kn;  // without a dashpot
    const double gap = -d.trial.pressed / d.trial.kn;
    const double slip = dilating_slip(d.law, d.trial, d.cohesion, d.mu);
    const double left = std::max(0.0, d.law.dilation_slip.value_or(1e300) - d.trial.before);
    const double force = d.trial.pressed + d.trial.kn * opened_in(d.law, d.trial.before, slip);
    if (slip <= 0.0 || slip >= std::abs(d.trial.stretch) || force <= 0.0) continue;
    Strength strength;
    strength.cohesion = d.cohesion;
    strength.coefficient = d.mu;
    const double direction = d.trial.stretch > 0.0 ? -1.0 : 1.0;
    const DilatingForce f =
        dilating_force(d.law, strength, d.trial.kn, d.trial.kt, direction, slip < left, left < 1e200 ? left : 0.0);
    const double found = -(f.per_gap * gap + f.per_stretch * d.trial.stretch + f.constant);
    EXPECT_NEAR(found, force, 1e-11 * d.trial.kn * 1e-3) << i;
    ++compared;
    // The force is continuous where dilation ends.
    if (left < 1e200 && left > 0.0) {
      const DilatingForce within = dilating_force(d.law, strength, d.trial.kn, d.trial.kt, direction, true, left),
                          after = dilating_force(d.law, strength, d.trial.kn, d.trial.kt, direction, false, left);
      // The elongation at which the slip equals `left`.
      const double opened = std::tan(d.law.dilation) * left, at_end = -d.trial.kn * gap + d.trial.kn * opened;
      if (at_end > 0.0) {
        const double e = -direction * (left + (d.cohesion + d.mu * at_end) / d.trial.kt);
        EXPECT_NEAR(within.per_gap * gap + within.per_stretch * e + within.constant,
                    after.per_gap * gap + after.per_stretch * e + after.constant,
                    1e-11 * d.trial.kn * 1e-3 + 1e-12 * at_end);
      }
    }
  }
  EXPECT_GT(compared, 2000);
}

TEST(Dilation, opening_ends_with_its_slip_and_adds_up) {
  JointLaw law;
  law.friction = 0.6;
  EXPECT_EQ(opened_by_slip(law, 1.0), 0.0);
  law.dilation = 0.3;
  EXPECT_DOUBLE_EQ(opened_by_slip(law, 2e-3), std::tan(0.3) * 2e-3);
  law.dilation_slip = 1e-3;
  EXPECT_DOUBLE_EQ(opened_by_slip(law, 2e-3), std::tan(0.3) * 1e-3);
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> way(0.0, 2e-3);
  for (int i = 0; i < 10000; ++i) {
    const double a = way(random), b = way(random);
    EXPECT_NEAR(opened_by_slip(law, a) + opened_in(law, a, b), opened_by_slip(law, a + b), 1e-18);
    EXPECT_GE(opened_in(law, a, b), 0.0);
  }
}

}  // namespace
}  // namespace scree::coupling::dilation_test
