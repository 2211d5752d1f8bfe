// Bolts in complete runs: restart from a checkpoint, momenta, change of method, partitioned stages, the step bound.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/support/bolted.h"

namespace scree::test::bolt_runs_test {
namespace {

using namespace coupling;

/// Two blocks beside a wall, thrown away from it, on a bolt that is bonded in the wall, slips, yields and shears.
struct Thrown : Bolted {
  BlockId near, far;
  Thrown() {
    model.gravity = {0.0, 0.0};
    add("wall", rectangle(-3, 0, 0, 2), true);
    near = add("near", rectangle(0, 0, 1, 2));
    far = add("far", rectangle(1, 0, 2.5, 2));
    Bolt b = bar({2.0, 1.1}, {-2.0, 0.8});
    b.bond_length = 2.0;
    b.bond_stiffness = 100e6;
    b.bond_strength = 60e3;
    b.yield = 100e3;
    b.pretension = 20e3;
    b.shear_stiffness = 20e6;
    b.shear_strength = 20e3;
    bolt(b);
    model.initial_velocities.push_back({far, {0.4, 0.2}, 0.05});
  }
};

class BoltRuns : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(All, BoltRuns,
                         testing::Values(Way{"dda", Integrator::explicit_}, Way{"dda", Integrator::implicit},
                                         Way{"nmm", Integrator::explicit_}, Way{"nmm", Integrator::implicit}),
                         [](const auto& of) { return of.param.name(); });

TEST_P(BoltRuns, goes_on_from_a_checkpoint_to_the_same_bits) {
  Thrown scene;
  scene.go(GetParam(), 0.03, 5e-4);
  KeepOne keeper(23);
  Driver whole(scene.model, scene.plan, methods());
  whole.set_keeper(keeper);
  ASSERT_EQ(whole.run().status, RunEnd::Status::done);
  ASSERT_EQ(keeper.kept.size(), 1U);
  EXPECT_GT(whole.state().bolts[0].dissipated, 0.0);
  Driver rest(scene.model, scene.plan, methods());
  rest.continue_from(keeper.kept[0]);
  ASSERT_EQ(rest.run().status, RunEnd::Status::done);
  EXPECT_EQ(state_hash(rest.state()), state_hash(whole.state()));
}

TEST_P(BoltRuns, ledger_closes_and_momentum_goes_to_the_wall_alone) {
  Thrown scene;
  scene.model.block_supports.clear();  // all three blocks free: momenta are conserved
  scene.go(GetParam(), 0.05, 5e-4);
  scene.run();
  scene.expect_closed();
  Vec2 momentum(0.0, 0.0);
  double turn = 0.0;
  for (std::int32_t b = 0; b < 3; ++b) {
    const BodyTotals t = totals_of(*scene.driver, BlockId{b});
    momentum += t.momentum;
    turn += t.angular_momentum;
  }
  const double mass = 1.5 * 2.0 * 2600.0, inertia = mass * (1.5 * 1.5 + 4.0) / 12.0;
  const Vec2 first = mass * Vec2(0.4, 0.2);
  const double first_turn = cross(Vec2(1.75, 1.0), first) + inertia * 0.05;
  EXPECT_LT((momentum - first).norm(), 1e-9 * first.norm());
  // Implicit steps use the directions at their start: the angular momentum is kept to first order in the step.
  EXPECT_NEAR(turn / first_turn, 1.0, GetParam().is_explicit() ? 1e-9 : 2e-3);
}

TEST(BoltStages, force_stays_where_blocks_change_method) {
  Bolted scene;
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-4, 0, 0, 1), true);
  const BlockId block = scene.add("block", rectangle(0.5, 0, 2.5, 1));
  scene.model.point_loads.push_back({block, {1.5, 0.5}, {50e3, 0.0}, FunctionId{}});
  scene.bolt(bar({1.5, 0.5}, {-1.5, 0.5}));
  scene.model.materials[0].young = 1e9;  // so soft that the mesh bends under the plate
  scene.rest({"nmm", Integrator::implicit}, 2.0, 1e-2, 0.3);
  scene.go({"dda", Integrator::implicit}, 0.02, 1e-3);
  scene.go({"nmm", Integrator::explicit_}, 0.02, 1e-3, 0.4);
  std::vector<double> force;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.state->stage > 0) force.push_back(view.state->bolts[0].force[0]);
  };
  scene.sink = &watch;
  scene.plan.output.every = ticks(1e-3);
  scene.run();
  EXPECT_GT(force.size(), 30U);
  for (const double f : force) EXPECT_NEAR(f / 50e3, 1.0, 1e-2);
  scene.expect_closed();
}

TEST(BoltStages, bolt_is_installed_with_its_stage_where_blocks_are_then) {
  Bolted scene;
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-4, 0, 0, 1), true);
  const BlockId block = scene.add("block", rectangle(0.5, 0, 2.5, 1));
  scene.model.initial_velocities.push_back({block, {0.1, 0.0}, 0.0});
  Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  b.stage = StageId{1};
  scene.bolt(b);
  scene.go({"dda", Integrator::implicit}, 0.1);
  scene.go({"dda", Integrator::implicit}, 0.001, 1e-4);
  scene.run();
  EXPECT_NEAR(scene.memory().rest[0], 3.01, 1e-9);
  EXPECT_GT(scene.memory().force[0], 0.0);
  EXPECT_EQ(scene.driver->state().ledger[Column::bolt_tension], 0.0);
}

/// One of the blocks explicit, the other, both or none: the motion is the same.
TEST(BoltStages, partitioned_stage_moves_as_others_do) {
  std::vector<double> moved;
  for (const int sides : {0, 1, 2, 3}) {
    Thrown scene;
    scene.go({"dda", sides == 0 ? Integrator::implicit : Integrator::partitioned}, 0.03, 2e-4);
    Stage& stage = scene.plan.stages[0];
    if (sides == 1 || sides == 3) stage.partition.explicit_blocks.push_back(scene.near);
    if (sides == 2 || sides == 3) stage.partition.explicit_blocks.push_back(scene.far);
    scene.run();
    EXPECT_GT(scene.memory().dissipated, 0.0);
    scene.expect_closed();
    moved.push_back(centre_of(*scene.driver, scene.far).x() - 1.75);
  }
  for (const double m : moved) EXPECT_NEAR(m / moved[0], 1.0, 0.02);
}

TEST(BoltBound, stiff_bolt_shortens_the_explicit_step_to_what_it_bears) {
  // A rigid-like block on a spring k to a held wall, along the line of its centre: h = 2 sqrt(m/k).
  Bolted scene(30.0, 1e7);
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-4, 0, 0, 1), true);
  scene.add("block", rectangle(0.5, 0, 2.5, 1));
  Bolt b = bar({1.5, 0.5}, {-0.5, 0.5});
  b.stiffness = 2e12;
  scene.bolt(b);
  scene.go({"dda", Integrator::explicit_}, 1.0);
  Driver run(scene.model, scene.plan, methods());
  Watched told(EventKind::stage_step);
  run.add_sink(told);
  (void)run.run(1e-6);
  ASSERT_EQ(told.lines.size(), 1U);
  EXPECT_NE(told.lines[0].find("bolts"), std::string::npos) << told.lines[0];
  const double h = 0.8 * 2.0 / std::sqrt(1e12 / 5200.0);
  double step = 0.0;
  ASSERT_EQ(std::sscanf(told.lines[0].c_str() + told.lines[0].find("steps of ") + 9, "%lf", &step), 1);
  EXPECT_NEAR(step / h, 1.0, 0.01) << told.lines[0];
}

}  // namespace
}  // namespace scree::test::bolt_runs_test
