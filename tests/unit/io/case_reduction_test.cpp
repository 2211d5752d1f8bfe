// [reduction]: the stages that replace those of the case.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_reduction_test {
namespace {

using coupling::Integrator;
using coupling::Stage;

Case reduced(std::vector<std::string> set) {
  set.insert(set.begin(), "reduction={factor=1.5}");
  return read("good_case.toml", set);
}

TEST(Reduction, stages_are_rest_reduction_settling_hold) {
  const Case before = read("good_case.toml"), c = reduced({"reduction.hold=2.0", "reduction.limit=0.01"});
  const std::vector<Stage>& s = c.plan.stages;
  ASSERT_EQ(s.size(), 4U);
  EXPECT_TRUE(s[0].rest);
  EXPECT_GT(s[0].rest_force, 0.0);
  EXPECT_EQ(s[0].strength.to, 1.0);
  EXPECT_EQ(s[1].name, "reduction");
  EXPECT_EQ(s[1].strength.from, 1.0);
  EXPECT_EQ(s[1].strength.to, 1.5);
  EXPECT_TRUE(s[1].rest);
  EXPECT_EQ(s[2].name, "settling");
  EXPECT_EQ(s[2].strength.from, 1.5);
  EXPECT_EQ(s[3].name, "hold");
  EXPECT_FALSE(s[3].rest);
  EXPECT_EQ(s[3].duration, ticks(2.0));
  EXPECT_EQ(s[3].end.displacement, 0.01);
  EXPECT_GT(s[3].end.force_below, 0.0);
  EXPECT_EQ(s[3].strength.joints.size(), c.model.joints.size());
  EXPECT_TRUE(c.plan.output.contacts);
  EXPECT_EQ(before.model.gravity, c.model.gravity);
  // the factor changes by at most 1 % per step: a 20-fold factor takes more steps than one of 1.5
  const Case far = reduced({"reduction.factor=20", "reduction.integrator=\"implicit\"", "reduction.dt=0.01"});
  EXPECT_NEAR(seconds(far.plan.stages[1].duration), 0.01 * std::ceil(std::log(20.0) / 0.01), 1e-9);
}

TEST(Reduction, without_a_factor_only_the_rest_is_left) {
  const Case c = read("good_case.toml", {"reduction={start=0.25}"});
  ASSERT_EQ(c.plan.stages.size(), 1U);
  EXPECT_EQ(c.plan.stages[0].strength.from, 0.25);
  EXPECT_EQ(c.plan.stages[0].strength.to, 0.25);
}

TEST(Reduction, stages_to_rest_of_the_case_stay) {
  const std::string rest =
      "stage=[{name=\"a\", method=\"dda\", integrator=\"implicit\", dt=1e-3, duration=1, rest=true},"
      "{name=\"b\", method=\"dda\", integrator=\"implicit\", dt=2e-3, duration=1, rest=true, rest_force=1e-7},"
      "{name=\"c\", method=\"dda\", integrator=\"implicit\", dt=1e-3, duration=9}]";
  const Case c = reduced({rest});
  ASSERT_EQ(c.plan.stages.size(), 5U);
  EXPECT_EQ(c.plan.stages[0].name, "a");
  EXPECT_EQ(c.plan.stages[1].name, "b");
  EXPECT_EQ(c.plan.stages[1].rest_force, 1e-7);
  EXPECT_EQ(*c.plan.stages[1].dt, 2e-3);
  EXPECT_EQ(c.plan.stages[0].rest_force, 0.0);
  EXPECT_EQ(c.plan.stages[2].integrator, Integrator::implicit);
  EXPECT_EQ(c.plan.stages[2].method, "dda");
}

TEST(Reduction, stages_to_rest_take_other_steps) {
  const std::string rest =
      "stage=[{name=\"a\", method=\"dda\", integrator=\"implicit\", dt=1e-3, duration=3, rest=true, rest_steps=100, "
      "rest_force=1e-5}]";
  const Case c = reduced({rest, "reduction.rest_integrator=\"explicit\""});
  ASSERT_EQ(c.plan.stages.size(), 4U);
  const Stage& a = c.plan.stages[0];
  EXPECT_EQ(a.integrator, Integrator::explicit_);
  EXPECT_FALSE(a.dt);
  EXPECT_EQ(a.rest_steps, 0);
  EXPECT_EQ(a.rest_force, 1e-5);
  EXPECT_EQ(a.duration, ticks(3.0));
  for (const Stage& s : c.plan.stages) EXPECT_EQ(s.integrator, Integrator::explicit_);  // as the last stage to rest
  const Case mixed = reduced(
      {rest, "reduction.rest_integrator=\"explicit\"", "reduction.integrator=\"implicit\"", "reduction.dt=2e-3"});
  EXPECT_EQ(mixed.plan.stages[0].integrator, Integrator::explicit_);
  EXPECT_EQ(mixed.plan.stages[1].integrator, Integrator::implicit);
  const std::string fast = "stage=[{name=\"a\", method=\"dda\", integrator=\"explicit\", duration=3, rest=true}]";
  const Case back = reduced({fast, "reduction.rest_integrator=\"implicit\"", "reduction.dt=2e-3"});
  EXPECT_EQ(back.plan.stages[0].integrator, Integrator::implicit);
  EXPECT_EQ(*back.plan.stages[0].dt, 2e-3);
}

TEST(Reduction, peak_takes_weakening_away_and_as_is_leaves_it) {
  const std::string weak =
      "joint.plane={friction_deg=30, residual_friction_deg=20, cohesion=1e4, residual_cohesion=1e3}";
  const Case peak = reduced({weak}), as_is = reduced({weak, "reduction.strength=\"as-is\""});
  EXPECT_FALSE(peak.model.joints.back().residual_friction);
  EXPECT_EQ(peak.model.joints.back().residual_cohesion, 1e4);
  EXPECT_TRUE(as_is.model.joints.back().residual_friction);
  EXPECT_EQ(as_is.model.joints.back().residual_cohesion, 1e3);
}

TEST(Reduction, gravity_is_tilted_by_k_h) {
  const Case c = reduced({"reduction.k_h=-0.2"});
  EXPECT_NEAR(c.model.gravity.x(), -0.2 * 9.81, 1e-12);
  EXPECT_NEAR(c.model.gravity.y(), -9.81, 1e-12);
}

TEST(Reduction, motions_and_later_loads_are_left_out) {
  const Case c = read("full_case.toml", {"reduction={factor=1.5}"});
  EXPECT_TRUE(c.model.motions.empty());
  for (const BlockSupport& s : c.model.block_supports) EXPECT_FALSE(s.motion.valid());
  const Case later = read("full_case.toml", {"reduction={factor=1.5}", "point_load.1.start=\"runout\""});
  EXPECT_EQ(later.model.point_loads.size() + 1, c.model.point_loads.size());
}

}  // namespace
}  // namespace scree::io::test::case_reduction_test
