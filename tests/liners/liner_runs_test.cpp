// Liners in complete runs: momenta, energies, restart from a checkpoint, partitioned stages, rupture, the step bound.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/support/lined.h"

namespace scree::test::liner_runs_test {
namespace {

using namespace coupling;

class LinerRuns : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(All, LinerRuns, testing::ValuesIn(kWays), [](const auto& of) { return of.param.name(); });

/// Three blocks in a row, with a liner along their tops and down the side of the last, which is thrown up and away.
struct Thrown : Lined {
  BlockId near, far;
  explicit Thrown(double strength = Bolt::kNever, double rupture = Bolt::kNever, bool held = true) {
    model.gravity = {0.0, 0.0};
    add("wall", rectangle(-3, 0, 0, 2), held);
    near = add("near", rectangle(0.05, 0, 1, 2));
    far = add("far", rectangle(1.05, 0, 2.5, 2));
    Bolt b = lining({{-1.0, 2.0}, {2.5, 2.0}, {2.5, 0.5}}, 0.25);
    b.yield = b.crushing = strength;
    b.rupture_strain = rupture;
    line(b);
    model.initial_velocities.push_back({far, {0.4, 0.2}, 0.05});
  }
};

TEST_P(LinerRuns, momenta_stay_and_the_ledger_closes) {
  Thrown scene(Bolt::kNever, Bolt::kNever, false);
  scene.go(GetParam(), 0.02, 2e-4);
  scene.run();
  scene.expect_closed();
  Vec2 momentum(0.0, 0.0);
  double turn = 0.0;
  for (std::int32_t b = 0; b < 3; ++b) {
    const BodyTotals t = totals_of(*scene.driver, BlockId{b});
    momentum += t.momentum;
    turn += t.angular_momentum;
  }
  const double mass = 1.45 * 2.0 * 2600.0, inertia = mass * (1.45 * 1.45 + 4.0) / 12.0;
  const Vec2 first = mass * Vec2(0.4, 0.2);
  const double first_turn = cross(Vec2(1.775, 1.0), first) + inertia * 0.05;
  std::printf("%s: momentum off by %.1e, angular by %.1e\n", GetParam().name().c_str(),
              (momentum - first).norm() / first.norm(), turn / first_turn - 1.0);
  EXPECT_LT((momentum - first).norm(), 1e-9 * first.norm());
  // Implicit steps use the directions at their start: the angular momentum is kept to first order in the step.
  EXPECT_NEAR(turn / first_turn, 1.0, GetParam().is_explicit() ? 1e-9 : 2e-3);
  EXPECT_GT(scene.memory().energy, 0.0);
}

TEST_P(LinerRuns, goes_on_from_a_checkpoint_to_the_same_bits) {
  Thrown scene(0.5e6 * 0.1);
  scene.go(GetParam(), 0.01, 2e-4);
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

TEST_P(LinerRuns, tears_where_it_crosses_the_joint_and_tells) {
  Thrown scene(0.5e6 * 0.1, 1e-3);
  scene.go(GetParam(), 0.02, 1e-4);
  Watched told(EventKind::bolt_broken);
  scene.sink = &told;
  const Driver& run = scene.run();
  ASSERT_GE(told.lines.size(), 1U);
  EXPECT_NE(told.lines[0].find("liner 'liner' breaks between"), std::string::npos) << told.lines[0];
  EXPECT_NE(told.lines[0].find("from its beginning"), std::string::npos) << told.lines[0];
  const BoltMemory& m = scene.memory();
  for (std::size_t s = 0; s < m.broken.size(); ++s) {
    if (m.broken[s] != 0) {
      EXPECT_EQ(m.force[s], 0.0);
    }
  }
  EXPECT_GT(run.state().ledger[Column::bolt_yield], 0.0);
  scene.expect_closed();
}

/// One of the blocks explicit, the other, both or none: the motion is the same.
TEST(LinerStages, partitioned_stage_moves_as_others_do) {
  std::vector<double> moved;
  for (const int sides : {0, 1, 2, 3}) {
    Thrown scene;
    scene.go({"dda", sides == 0 ? Integrator::implicit : Integrator::partitioned}, 0.01, 5e-5);
    Stage& stage = scene.plan.stages[0];
    if (sides == 1 || sides == 3) stage.partition.explicit_blocks.push_back(scene.near);
    if (sides == 2 || sides == 3) stage.partition.explicit_blocks.push_back(scene.far);
    scene.run();
    EXPECT_GT(scene.memory().energy, 0.0);
    scene.expect_closed();
    moved.push_back(centre_of(*scene.driver, scene.far).x() - 1.775);
  }
  for (const double m : moved) EXPECT_NEAR(m / moved[0], 1.0, 0.02);
}

TEST(LinerStages, thrust_and_moments_stay_where_blocks_change_method) {
  Lined scene;
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-2, 0, 0, 1), true);
  const BlockId block = scene.add("block", rectangle(0.5, 0, 2.5, 1));
  scene.model.point_loads.push_back({block, {1.5, 1.0}, {100e3, 0.0}, FunctionId{}});
  scene.line(lining({{-1.0, 1.0}, {2.0, 1.0}}, 0.5));
  scene.rest({"dda", Integrator::implicit}, 50.0, 1.0);
  scene.go({"nmm", Integrator::implicit}, 0.01, 1e-3, 0.5);
  scene.run();
  EXPECT_NEAR(scene.memory().force[2] / 100e3, 1.0, 0.02);
  scene.expect_closed();
}

/// Explicit steps chosen by the bound stay below the limit of stability, for bending alone and for stretch.
TEST(LinerBound, counts_stretch_and_bending) {
  const auto step_of = [](double stiffness, double bending) {
    Lined scene(30.0, 1e7);
    scene.model.gravity = {0.0, 0.0};
    scene.add("wall", rectangle(-4, 0, 0, 1), true);
    scene.add("block", rectangle(0.5, 0, 2.5, 1));
    Bolt b = lining({{-1.0, 1.0}, {2.0, 1.0}}, 0.5);
    b.stiffness = stiffness;
    b.bending = bending;
    scene.line(b);
    scene.go({"dda", Integrator::explicit_}, 1.0);
    Driver run(scene.model, scene.plan, methods());
    Watched told(EventKind::stage_step);
    run.add_sink(told);
    (void)run.run(1e-6);
    EXPECT_EQ(told.lines.size(), 1U);
    double step = 0.0;
    EXPECT_EQ(std::sscanf(told.lines[0].c_str() + told.lines[0].find("steps of ") + 9, "%lf", &step), 1);
    return step;
  };
  const double soft = step_of(1.0, 1.0);
  EXPECT_NEAR(step_of(4e12, 1.0) / step_of(1e12, 1.0), 0.5, 1e-3);
  EXPECT_NEAR(step_of(1.0, 4e12) / step_of(1.0, 1e12), 0.5, 1e-3);
  EXPECT_LT(step_of(1.0, 1e12), 0.1 * soft);
}

}  // namespace
}  // namespace scree::test::liner_runs_test
