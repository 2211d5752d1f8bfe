// Strengths divided by a factor.
#include "coupling/bodies/joint_laws.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace scree::coupling::joint_laws_test {
namespace {

JointLaw full_law() {
  JointLaw law;
  law.name = "clay";
  law.friction = 0.6;
  law.residual_friction = 0.4;
  law.cohesion = 30e3;
  law.residual_cohesion = 5e3;
  law.tensile_strength = 10e3;
  law.dilation = 0.2;
  law.weakening_slip = 0.01;
  law.normal_stiffness = 1e9;
  law.damping = 0.3;
  return law;
}

TEST(JointLaws, all_strengths_are_divided_and_nothing_else) {
  const JointLaw law = full_law(), half = divided(law, 2.0);
  EXPECT_NEAR(std::tan(half.friction), 0.5 * std::tan(0.6), 1e-15);
  EXPECT_NEAR(std::tan(*half.residual_friction), 0.5 * std::tan(0.4), 1e-15);
  EXPECT_NEAR(std::tan(half.dilation), 0.5 * std::tan(0.2), 1e-15);
  EXPECT_EQ(half.cohesion, 15e3);
  EXPECT_EQ(half.residual_cohesion, 2.5e3);
  EXPECT_EQ(half.tensile_strength, 5e3);
  EXPECT_EQ(half.weakening_slip, law.weakening_slip);
  EXPECT_EQ(half.normal_stiffness, law.normal_stiffness);
  EXPECT_EQ(half.damping, law.damping);
  EXPECT_EQ(half.name, "clay");
  const JointLaw same = divided(law, 1.0);
  EXPECT_EQ(same.friction, law.friction);
  EXPECT_EQ(same.dilation, law.dilation);
}

TEST(JointLaws, friction_or_cohesion_alone) {
  const JointLaw phi = divided(full_law(), 2.0, StrengthPlan::Part::friction),
                 c = divided(full_law(), 2.0, StrengthPlan::Part::cohesion);
  EXPECT_NEAR(std::tan(phi.friction), 0.5 * std::tan(0.6), 1e-15);
  EXPECT_EQ(phi.cohesion, 30e3);
  EXPECT_EQ(phi.tensile_strength, 10e3);
  EXPECT_EQ(c.friction, 0.6);
  EXPECT_EQ(c.dilation, 0.2);
  EXPECT_EQ(c.cohesion, 15e3);
}

TEST(JointLaws, a_bond_that_never_fails_stays) {
  JointLaw law = full_law();
  law.tensile_strength = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(std::isinf(divided(law, 3.0).tensile_strength));
}

TEST(JointLaws, without_weakening_is_the_peak) {
  const JointLaw law = without_weakening(full_law());
  EXPECT_FALSE(law.residual_friction);
  EXPECT_EQ(law.residual_cohesion, law.cohesion);
  EXPECT_EQ(law.friction, 0.6);
  EXPECT_EQ(law.friction_law, nullptr);
}

TEST(JointLaws, chosen_laws_follow_the_factor_from_the_models_strength) {
  std::vector<JointLaw> model{full_law(), full_law()};
  model[1].name = "rock";
  JointLaws laws(model);
  const StrengthPlan plan{{JointId{0}}, StrengthPlan::Part::all, 1.0, 4.0};
  laws.divide(plan, 2.0);
  laws.divide(plan, 3.0);  // not on top of the 2
  EXPECT_NEAR(laws.tan_friction(0), std::tan(0.6) / 3.0, 1e-15);
  EXPECT_NEAR(std::tan(laws[0].friction), laws.tan_friction(0), 1e-15);
  EXPECT_EQ(laws[1].friction, 0.6);
  EXPECT_EQ(laws.tan_friction(1), std::tan(0.6));
  laws.divide(plan, 1.0);
  EXPECT_EQ(laws[0].cohesion, 30e3);
}

TEST(JointLaws, the_factor_grows_by_equal_ratios) {
  const StrengthPlan plan{{JointId{0}}, StrengthPlan::Part::all, 1.0, 4.0};
  EXPECT_EQ(strength_factor(plan, 0.0), 1.0);
  EXPECT_NEAR(strength_factor(plan, 0.5), 2.0, 1e-15);
  EXPECT_EQ(strength_factor(plan, 1.0), 4.0);
  EXPECT_EQ(strength_factor(plan, 7.0), 4.0);
}

}  // namespace
}  // namespace scree::coupling::joint_laws_test
