// Friction that falls with the slip rate against its closed form, and the memory of friction laws.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "coupling/contact/law/friction_evolution.h"
#include "coupling/contact/law/friction_laws.h"
#include "coupling/contact/law/joint_strength.h"
#include "tests/support/scene.h"

namespace scree::coupling::velocity_weakening_test {
namespace {

constexpr double kPeak = 0.7;                                   // tan phi
constexpr std::array<double, 3> kConstants = {10.0, 0.5, 0.2};  // fast angle [deg], velocity [m/s], slip [m]
const double kLost = std::tan(10.0 * test::kDegree) - kPeak;

double after(const FrictionLaw& law, double slip, double step, double change) {
  std::array<FrictionRow, 1> row = {{{slip, change}}};
  law.evolve(kPeak, kConstants, step, row);
  return row[0].change;
}

TEST(VelocityWeakening, a_steady_slide_tends_to_the_friction_of_its_speed) {
  const FrictionLaw law = velocity_weakening();
  for (const double v : {1e-4, 0.1, 0.5, 3.0, 50.0}) {
    double change = 0.0;
    for (int i = 0; i < 40; ++i) change = after(law, 0.2, 0.2 / v, change);
    EXPECT_NEAR(change, kLost * v / (v + 0.5), 1e-14) << v;
  }
  EXPECT_NEAR(after(law, 100.0, 1e-9, 0.0), kLost, 1e-10);
}

TEST(VelocityWeakening, follows_over_the_slip_and_not_over_steps) {
  const FrictionLaw law = velocity_weakening();
  const double v = 1.5, way = 0.13, whole = after(law, way, way / v, 0.0);
  double change = 0.0;
  for (int i = 0; i < 100; ++i) change = after(law, way / 100.0, way / 100.0 / v, change);
  EXPECT_NEAR(change, whole, 1e-14);
  const double steady = kLost * v / (v + 0.5);
  EXPECT_NEAR((whole - steady) / (0.0 - steady), std::exp(-way / 0.2), 1e-14);
}

TEST(VelocityWeakening, at_rest_nothing_changes_and_friction_comes_back_in_a_slide_that_slows) {
  const FrictionLaw law = velocity_weakening();
  EXPECT_EQ(after(law, 0.0, 1e-3, -0.3), -0.3);
  EXPECT_GT(after(law, 1e-3, 10.0, -0.3), -0.3);
  EXPECT_NEAR(after(law, 5.0, 5e6, -0.3), kLost * 1e-6 / (1e-6 + 0.5), 1e-10);  // exp(-25) is left
}

TEST(VelocityWeakening, keeps_tan_phi_between_that_of_a_fast_slide_and_the_peak) {
  const FrictionLaw law = velocity_weakening();
  std::mt19937 rng(3);
  std::uniform_real_distribution<double> decade(-9.0, 3.0), part(0.0, 1.0);
  for (int i = 0; i < 10000; ++i) {
    const double before = kLost * part(rng), now = after(law, std::pow(10.0, decade(rng)), 1e-3, before);
    ASSERT_LE(now, 0.0);
    ASSERT_GE(now, kLost * (1.0 + 1e-15));
  }
  EXPECT_NEAR(law.least(kPeak, kConstants), kPeak + kLost, 1e-15);
}

TEST(VelocityWeakening, refuses_friction_that_grows) {
  const FrictionLaw law = velocity_weakening();
  EXPECT_EQ(law.fault(kPeak, kConstants), "");
  EXPECT_NE(law.fault(0.1, kConstants).find("fast_friction_deg is 10, above the friction_deg of the joint, 5.71"),
            std::string::npos)
      << law.fault(0.1, kConstants);
}

/// Joint 0 without a law, joint 1 with it.
std::vector<JointLaw> joints(const FrictionLaw& law) {
  std::vector<JointLaw> out(2);
  out[0].friction = out[1].friction = std::atan(kPeak);
  out[1].friction_law = &law;
  out[1].friction_constants.assign(kConstants.begin(), kConstants.end());
  return out;
}

TEST(FrictionEvolution, changes_the_points_of_its_joint_by_the_slip_of_the_step) {
  const FrictionLaw law = velocity_weakening();
  const std::vector<JointLaw> laws = joints(law);
  FrictionEvolution evolution(laws);
  std::vector<ContactMemory> points(3);
  points[0].joint = 0;
  points[1].joint = points[2].joint = 1;
  for (ContactMemory& m : points) m.slip = 0.3;
  points[2].slip_known = 0.25;
  points[2].friction_change = -0.1;
  evolution.advance(0.01, points);
  EXPECT_EQ(points[0].friction_change, 0.0);
  EXPECT_EQ(points[1].friction_change, after(law, 0.3, 0.01, 0.0));
  EXPECT_EQ(points[2].friction_change, after(law, 0.3 - 0.25, 0.01, -0.1));
  EXPECT_NEAR(friction_coefficient(laws[1], points[1]), kPeak + points[1].friction_change, 1e-15);
  EXPECT_EQ(friction_coefficient(laws[0], points[0]), std::tan(std::atan(kPeak)));
  const double then = points[1].friction_change;
  evolution.advance(0.01, points);  // no further slip
  EXPECT_EQ(points[1].friction_change, then);
}

TEST(FrictionLaws, are_registered_before_they_are_used) {
  EXPECT_EQ(friction_laws().front().name, "velocity_weakening");
  FrictionLaw late = velocity_weakening();
  late.name = "late";
  EXPECT_THROW(register_friction_law(late), std::logic_error);
}

}  // namespace
}  // namespace scree::coupling::velocity_weakening_test
