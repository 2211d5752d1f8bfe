// Unbalanced force of blocks under forces, couples and supports, against values by hand.
#include "coupling/stages/force_balance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::force_balance_test {
namespace {

using namespace coupling;

ForceBalance::Result measured(const Scene& scene) {
  ByHand hand(scene.model, scene.plan.stages[0]);
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05);
  integrator.enter(hand.state);
  return ForceBalance(*hand.setup, hand.state).measure(hand.state, integrator);
}

Scene block(const char* method) {
  Scene scene(1e8, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  scene.add("other", rectangle(10.0, 0.0, 11.0, 1.0));
  scene.add("block", rectangle(0.0, 0.0, 2.0, 3.0));
  scene.stage(method, Integrator::explicit_, 1.0, std::nullopt, 0.5);
  return scene;
}

TEST(ForceBalance, force_of_an_affine_block_is_that_on_its_centre) {
  Scene scene = block("dda");
  scene.model.point_loads.push_back({BlockId{1}, {1.0, 1.5}, {300.0, -700.0}, {}});
  const ForceBalance::Result r = measured(scene);
  EXPECT_NEAR(r.force, 700.0, 1e-9);
  EXPECT_NEAR(r.ratio, 1.0, 1e-12);
  EXPECT_EQ(r.body, BodyIndex{1});
}

TEST(ForceBalance, moment_on_an_affine_block_counts_as_a_force_at_its_root_area) {
  // A couple: 100 N at the top against 100 N at the bottom, 3 m apart. On the gradient's columns that is 300 N m.
  Scene scene = block("dda");
  scene.model.point_loads.push_back({BlockId{1}, {1.0, 3.0}, {100.0, 0.0}, {}});
  scene.model.point_loads.push_back({BlockId{1}, {1.0, 0.0}, {-100.0, 0.0}, {}});
  const ForceBalance::Result r = measured(scene);
  EXPECT_NEAR(r.force, 300.0 / std::sqrt(6.0), 1e-9);
  EXPECT_EQ(r.body, BodyIndex{1});
}

TEST(ForceBalance, what_is_left_is_measured_by_the_largest_single_force) {
  Scene scene = block("dda");
  scene.model.blocks.erase(scene.model.blocks.begin());
  scene.model.gravity = {0.0, -10.0};
  const double weight = 2000.0 * 6.0 * 10.0;
  for (const double part : {1.0, 0.75}) {
    scene.model.point_loads.assign(1, {BlockId{0}, {1.0, 1.5}, {0.0, part * weight}, {}});
    const ForceBalance::Result r = measured(scene);
    EXPECT_NEAR(r.force, (1.0 - part) * weight, 1e-9 * weight);
    EXPECT_NEAR(r.ratio, 1.0 - part, 1e-12);
  }
}

TEST(ForceBalance, round_off_in_a_model_that_is_free_of_stress_is_rest) {
  for (const char* method : {"dda", "nmm"}) {
    Scene scene = block(method);
    scene.model.point_loads.push_back({BlockId{1}, {1.0, 1.5}, {1e-8, 0.0}, {}});  // a strain of 1e-16
    const ForceBalance::Result r = measured(scene);
    EXPECT_GT(r.force, 1e-10) << method;
    EXPECT_LT(r.ratio, 1e-6) << method;  // the smallest rest_force used in practice
  }
}

TEST(ForceBalance, loads_are_those_of_the_present_time) {
  Scene scene = block("dda");
  TimeFunction ramp;
  ramp.name = "ramp";
  ramp.shape = TimeFunction::Shape::ramp;
  ramp.duration = 2.0;
  scene.model.functions.push_back(ramp);
  scene.model.point_loads.push_back({BlockId{1}, {1.0, 1.5}, {800.0, 0.0}, FunctionId{0}});
  for (const double t : {0.0, 0.5, 2.0}) {
    ByHand hand(scene.model, scene.plan.stages[0]);
    hand.state.time = ticks(t);
    CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05);
    integrator.enter(hand.state);
    EXPECT_NEAR(ForceBalance(*hand.setup, hand.state).measure(hand.state, integrator).force, 400.0 * t, 1e-9)
        << t << " s";
  }
}

}  // namespace
}  // namespace scree::test::force_balance_test
