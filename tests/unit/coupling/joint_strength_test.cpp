// Strength of one contact point: peak, residual, and what lies between.
#include "coupling/contact/law/joint_strength.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::coupling::joint_strength_test {
namespace {

constexpr double kPeak = 0.6, kResidual = 0.25;  // angles [rad]

JointLaw law() {
  JointLaw out;
  out.friction = kPeak;
  out.residual_friction = kResidual;
  out.cohesion = 5e4;
  out.residual_cohesion = 8e3;
  out.tensile_strength = 2e4;
  return out;
}
ContactMemory point(double share) {
  ContactMemory m;
  m.tributary = share;
  m.bonded = 1;
  return m;
}

TEST(JointStrength, friction_falls_linearly_with_slip_to_the_residual) {
  JointLaw l = law();
  l.weakening_slip = 0.04;
  ContactMemory m = point(0.5);
  const double peak = std::tan(kPeak), residual = std::tan(kResidual);
  for (const auto& [slip, part] :
       {std::pair(0.0, 0.0), std::pair(0.01, 0.25), std::pair(0.04, 1.0), std::pair(3.0, 1.0)}) {
    m.slip = slip;
    EXPECT_NEAR(friction_coefficient(l, m), peak + part * (residual - peak), 1e-15) << slip;
  }
  m.slip = 0.0;
  m.failed = 1;  // the cohesion is gone, and friction follows the slip
  EXPECT_EQ(friction_coefficient(l, m), peak);
}

TEST(JointStrength, without_a_weakening_slip_friction_falls_at_the_first_failure) {
  const JointLaw l = law();
  ContactMemory m = point(0.5);
  EXPECT_EQ(friction_coefficient(l, m), std::tan(kPeak));
  mark_failed(l, m);
  EXPECT_NEAR(friction_coefficient(l, m), std::tan(kResidual), 1e-15);
}

TEST(JointStrength, without_a_residual_angle_friction_stays) {
  JointLaw l = law();
  l.residual_friction.reset();
  ContactMemory m = point(0.5);
  m.slip = 10.0;
  mark_failed(l, m);
  EXPECT_EQ(friction_coefficient(l, m), std::tan(kPeak));
}

TEST(JointStrength, shear_limit_is_coulombs_line_down_to_nothing) {
  const JointLaw l = law();
  ContactMemory m = point(0.5);
  EXPECT_DOUBLE_EQ(friction_limit(l, m, 1e4), 0.5 * 5e4 + 1e4 * std::tan(kPeak));
  EXPECT_DOUBLE_EQ(friction_limit(l, m, -1e4), 0.5 * 5e4 - 1e4 * std::tan(kPeak));
  EXPECT_EQ(friction_limit(l, m, -1e6), 0.0);
  mark_failed(l, m);
  EXPECT_DOUBLE_EQ(friction_limit(l, m, 1e4), 0.5 * 8e3 + 1e4 * std::tan(kResidual));
}

TEST(JointStrength, only_a_bond_is_pulled) {
  const JointLaw l = law();
  ContactMemory m = point(0.5);
  EXPECT_DOUBLE_EQ(tension_limit(l, m), 0.5 * 2e4);
  mark_failed(l, m);
  EXPECT_EQ(m.bonded, 0);
  EXPECT_EQ(tension_limit(l, m), 0.0);
}

TEST(JointStrength, unlimited_bond_never_fails) {
  JointLaw l = law();
  l.tensile_strength = std::numeric_limits<double>::infinity();
  l.cohesion = 0.0;
  ContactMemory m = point(0.5);
  EXPECT_TRUE(std::isinf(tension_limit(l, m)));
  EXPECT_TRUE(std::isinf(friction_limit(l, m, -1e9)));
  m.bonded = 0;  // a contact that came later
  EXPECT_EQ(tension_limit(l, m), 0.0);
  EXPECT_DOUBLE_EQ(friction_limit(l, m, 1e4), 1e4 * std::tan(kPeak));
}

TEST(JointStrength, failure_is_remembered_where_it_takes_something) {
  const auto remembers = [](const JointLaw& l) {
    ContactMemory m;
    mark_failed(l, m);
    return m.failed != 0;
  };
  JointLaw plain;
  plain.friction = kPeak;
  EXPECT_FALSE(remembers(plain));
  JointLaw cohesive = plain, bonded = plain, weak = plain, slow = plain;
  cohesive.cohesion = 1.0;
  bonded.tensile_strength = 1.0;
  weak.residual_friction = slow.residual_friction = kResidual;
  slow.weakening_slip = 0.01;
  EXPECT_TRUE(remembers(cohesive));
  EXPECT_TRUE(remembers(bonded));
  EXPECT_TRUE(remembers(weak));
  EXPECT_FALSE(remembers(slow));
}

}  // namespace
}  // namespace scree::coupling::joint_strength_test
