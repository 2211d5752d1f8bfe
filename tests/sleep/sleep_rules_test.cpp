// Which blocks fall asleep: forces and motions of known size, islands by distance and by bolts.
#include "coupling/stages/sleep_rules.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "coupling/bolts/bolt_rows.h"
#include "tests/support/bolted.h"
#include "tests/support/by_hand.h"

namespace scree::test::sleep_rules_test {
namespace {

using namespace coupling;

/// Blocks of 1 x 1 m in space without gravity, at `x` along a line.
struct Line final : Scene {
  explicit Line(const std::vector<double>& at) : Scene(1e9, 0.2, 2000.0) {
    model.gravity = {0.0, 0.0};
    for (const double x : at) add("b" + std::to_string(model.blocks.size()), rectangle(x, 0.0, x + 1.0, 1.0));
    stage("dda", Integrator::explicit_, 1.0, 1e-4).sleep = 1e-3;
  }
};

constexpr double kDetection = 0.05;

/// The rules on the state of a scene as it begins, evaluated as often as a block has to be at rest.
struct Evaluated {
  explicit Evaluated(const Scene& of) : scene(of), hand(scene.model, scene.plan.stages[0]) {
    integrator = std::make_unique<CentralDifference>(*hand.setup, StepControl{.max_displacement = 0.1}, kDetection);
    integrator->enter(hand.state);
    rules = std::make_unique<SleepRules>(scene.plan.stages[0], *hand.setup, hand.state, kDetection);
  }
  /// Bodies asleep after some checks.
  std::vector<std::size_t> check(int checks = SleepRules::kChecks) {
    for (int i = 0; i < checks; ++i) {
      hand.state.step += SleepRules::kEvery;
      last = rules->evaluate(hand.state, *integrator, hand.state.time + 1);
    }
    std::vector<std::size_t> out;
    for (std::size_t b = 0; b < hand.state.bodies.size(); ++b)
      if (hand.state.sleep.asleep(b)) out.push_back(b);
    return out;
  }
  Scene scene;
  ByHand hand;
  std::unique_ptr<CentralDifference> integrator;
  std::unique_ptr<SleepRules> rules;
  std::optional<SleepRules::Change> last;
};

using Bodies = std::vector<std::size_t>;

TEST(SleepRules, blocks_at_rest_fall_asleep_after_all_their_checks) {
  Evaluated at(Line({0.0, 5.0}));
  EXPECT_EQ(at.check(SleepRules::kChecks - 1), Bodies{});
  EXPECT_EQ(at.check(1), (Bodies{0, 1}));
  ASSERT_TRUE(at.last.has_value());
  EXPECT_EQ(at.last->fell, (Bodies{0, 1}));
}

TEST(SleepRules, a_force_above_the_tolerance_keeps_a_block_awake_and_one_below_does_not) {
  for (const double part : {0.5, 2.0}) {
    Line row({0.0, 5.0});
    row.model.gravity = {0.0, -10.0};
    // The weights are carried but for a part of the tolerance.
    row.model.point_loads.push_back({BlockId{0}, {0.5, 0.5}, {0.0, 2e4 * (1.0 - part * 1e-3)}, {}});
    row.model.point_loads.push_back({BlockId{1}, {5.5, 0.5}, {0.0, 2e4}, {}});
    EXPECT_EQ(Evaluated(row).check(), part < 1.0 ? (Bodies{0, 1}) : (Bodies{1})) << part;
  }
}

TEST(SleepRules, kinetic_energy_is_measured_by_the_elastic_energy) {
  for (const double part : {0.5, 2.0}) {
    Line row({0.0, 5.0});
    // Pressed by p on two sides each: U = A s:e/2 with plane strain, e = (1 + nu)(1 - 2 nu) p/E.
    const double p = 1e5, elastic = p * 1.2 * 0.6 * p / 1e9;
    for (const int b : {0, 1})
      for (std::int32_t e = 0; e < 4; ++e) {
        const Vec2 in[] = {{0.0, p}, {-p, 0.0}, {0.0, -p}, {p, 0.0}};
        row.model.tractions.push_back({{BlockId{b}, {0, e}}, in[e], {}});
      }
    Evaluated at(row);
    // The blocks take the shape that balances the tractions, exactly; then block 0 gets its velocity.
    for (const Body& b : at.hand.setup->bodies()) {
      AffineMotion m;
      m.c = b.centre;
      m.F = (1.0 - 1.2 * 0.6 * p / 1e9) * Mat2::Identity();
      if (b.index == 0) m.vc = {std::sqrt(2.0 * part * part * 1e-6 * elastic / 2000.0), 0.0};
      const auto pool = static_cast<std::size_t>(b.pool);
      at.hand.setup->pool_of(b).place(b.index, m, at.hand.setup->part(std::span<double>(at.hand.state.q), pool),
                                      at.hand.setup->part(std::span<double>(at.hand.state.v), pool));
    }
    EXPECT_EQ(at.check(), part < 1.0 ? (Bodies{0, 1}) : (Bodies{1})) << part;
  }
}

TEST(SleepRules, blocks_within_reach_are_an_island_and_sleep_or_wake_together) {
  // Twice the detection distance is 0.1 m: the first two are an island, the third is not of it.
  Line row({0.0, 1.09, 2.2});
  row.model.gravity = {0.0, -10.0};
  for (const int b : {1, 2}) {
    const double x = b == 1 ? 1.59 : 2.7;
    row.model.point_loads.push_back({BlockId{b}, {x, 0.5}, {0.0, 2e4}, {}});
  }
  EXPECT_EQ(Evaluated(row).check(), (Bodies{2}));  // block 0 falls, and block 1 is near it
  row.model.point_loads.push_back({BlockId{0}, {0.5, 0.5}, {0.0, 2e4}, {}});
  Evaluated all(row);
  EXPECT_EQ(all.check(), (Bodies{0, 1, 2}));
  EXPECT_EQ(all.hand.state.sleep.island, (std::vector<std::int32_t>{0, 0, 2}));
}

TEST(SleepRules, a_held_block_joins_nothing) {
  Line row({0.0, 1.05, 2.1});
  row.model.block_supports.push_back({BlockId{1}, MotionId{}});
  Evaluated at(row);
  EXPECT_EQ(at.check(), (Bodies{0, 2}));
  EXPECT_EQ(at.hand.state.sleep.island, (std::vector<std::int32_t>{0, -1, 2}));
}

TEST(SleepRules, a_bolt_joins_the_blocks_that_it_crosses) {
  Bolted scene(30.0, 1e9);
  scene.model.gravity = {0.0, 0.0};
  for (const double x : {0.0, 1.3, 2.6})
    scene.add("b" + std::to_string(scene.model.blocks.size()), rectangle(x, 0.0, x + 1.0, 1.0));
  scene.bolt(bar({0.5, 0.5}, {1.8, 0.5}));
  scene.stage("dda", Integrator::explicit_, 1.0, 1e-4).sleep = 1e-3;
  Evaluated at(scene);
  at.hand.state.bolts.resize(1);
  install_bolts(*at.hand.setup, at.hand.state);
  EXPECT_EQ(at.check(), (Bodies{0, 1, 2}));
  EXPECT_EQ(at.hand.state.sleep.island, (std::vector<std::int32_t>{0, 0, 2}));
}

TEST(SleepRules, an_island_wakes_where_a_block_comes_within_reach) {
  for (const double gap : {0.11, 0.09}) {
    Line row({0.0, 3.0});
    Evaluated at(row);
    EXPECT_EQ(at.check(), (Bodies{0, 1}));
    // Block 0 is moved beside the other, awake.
    at.hand.state.sleep.island[0] = -1;
    at.hand.state.sleep.calm[0] = 0;
    for (std::size_t i = 0; i < 6; i += 2) at.hand.state.q[i] += i == 0 ? 2.0 - gap : 0.0;
    at.rules = std::make_unique<SleepRules>(at.scene.plan.stages[0], *at.hand.setup, at.hand.state, kDetection);
    EXPECT_EQ(at.check(1), gap > 0.1 ? (Bodies{1}) : (Bodies{})) << gap;
    if (gap < 0.1) {
      EXPECT_EQ(at.last->cause, "block 'b0' comes near");
    }
  }
}

TEST(SleepRules, a_load_wakes_its_block_once_its_function_has_another_value) {
  Line row({0.0, 3.0});
  row.model.gravity = {0.0, -10.0};
  TimeFunction f;
  f.name = "act";
  f.shape = TimeFunction::Shape::table;
  f.time = {0.0, 0.5, 0.6};
  f.table = {1.0, 1.0, 2.0};
  row.model.functions.push_back(f);
  for (const int b : {0, 1}) row.model.point_loads.push_back({BlockId{b}, {3.0 * b + 0.5, 0.5}, {0.0, 2e4}, {}});
  row.model.point_loads[1].function = FunctionId{0};
  Evaluated at(row);
  EXPECT_EQ(at.check(), (Bodies{0, 1}));
  at.hand.state.time = ticks(0.5) - 1;
  EXPECT_EQ(at.check(1), (Bodies{0, 1}));
  at.hand.state.time = ticks(0.5);
  EXPECT_EQ(at.check(1), (Bodies{0}));
  EXPECT_EQ(at.last->cause, "the load of function 'act' changes");
  // A change is not missed where the step turns out longer than foreseen.
  Evaluated late(row);
  EXPECT_EQ(late.check(), (Bodies{0, 1}));
  late.hand.state.time = ticks(1.0);
  EXPECT_EQ(late.check(1), (Bodies{0}));
}

TEST(SleepRules, a_small_island_waits_for_others) {
  std::vector<double> at(30);
  for (std::size_t i = 0; i < at.size(); ++i) at[i] = 3.0 * static_cast<double>(i);
  Line line(at);
  line.model.gravity = {0.0, -10.0};
  // All but the first fall; that one is 1/30 of them.
  line.model.point_loads.push_back({BlockId{0}, {0.5, 0.5}, {0.0, 2e4}, {}});
  Evaluated small(line);
  small.hand.state.sleep.fell = 7;
  const auto steps = static_cast<int>((SleepRules::kPatience + 7 + SleepRules::kEvery - 1) / SleepRules::kEvery);
  EXPECT_EQ(small.check(steps - 1), Bodies{});
  EXPECT_EQ(small.check(1), Bodies{0});
  EXPECT_EQ(small.hand.state.sleep.fell, small.hand.state.step);
  // With a second one they are 1/15.
  line.model.point_loads.push_back({BlockId{1}, {3.5, 0.5}, {0.0, 2e4}, {}});
  EXPECT_EQ(Evaluated(line).check(), (Bodies{0, 1}));
}

TEST(SleepRules, a_block_wakes_where_its_bolt_is_anchored_in_a_driven_block_that_moves) {
  Bolted scene(30.0, 1e9);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0.0, 0.0, 1.0, 1.0));
  scene.add("other", rectangle(0.0, 5.0, 1.0, 6.0));
  scene.add("base", rectangle(4.0, 0.0, 5.0, 1.0), true);
  scene.model.motions.emplace_back(std::vector<double>{0.0, 0.1, 0.2}, std::vector<double>{0.0, 1.0, 0.0},
                                   Vec2(1.0, 0.0), GroundMotion::Setting{0.5});
  scene.model.block_supports[0].motion = MotionId{0};
  scene.bolt(bar({0.5, 0.5}, {4.5, 0.5}));
  scene.stage("dda", Integrator::explicit_, 1.0, 1e-4).sleep = 1e-3;
  Evaluated at(scene);
  at.hand.state.bolts.resize(1);
  install_bolts(*at.hand.setup, at.hand.state);
  at.rules = std::make_unique<SleepRules>(at.scene.plan.stages[0], *at.hand.setup, at.hand.state, kDetection);
  EXPECT_EQ(at.check(), (Bodies{0, 1}));
  at.hand.state.time = ticks(0.52);
  EXPECT_EQ(at.check(1), Bodies{1});
  EXPECT_EQ(at.last->cause, "block 'base', joined by a bolt, moves");
}

TEST(SleepRules, blocks_fall_asleep_on_a_base_whose_recorded_motion_is_over) {
  Scene scene(1e9, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0.0, 0.01, 1.0, 1.01));
  scene.add("base", rectangle(-1.0, -1.0, 2.0, 0.0), true);
  std::vector<double> time, acceleration;
  for (int i = 0; i <= 100; ++i) {
    time.push_back(0.01 * i);
    acceleration.push_back(3.0 * std::sin(2.0 * std::numbers::pi * time.back()));
  }
  scene.model.motions.emplace_back(time, acceleration, Vec2(1.0, 0.0), GroundMotion::Setting{0.5});
  scene.model.block_supports[0].motion = MotionId{0};
  scene.stage("dda", Integrator::explicit_, 5.0, 1e-4).sleep = 1e-3;
  Evaluated moving(scene), at(scene);
  moving.hand.state.time = ticks(1.0);
  EXPECT_EQ(moving.check(), Bodies{});
  const double left = at.hand.setup->ground_velocity(MotionId{0}, 3.0).norm();
  std::printf("velocity that the record leaves: %.1e m/s\n", left);
  EXPECT_GT(left, 0.0);  // the sum of its accelerations is round-off, not 0
  EXPECT_LT(left, 1e-14);
  at.hand.state.time = ticks(3.0);
  EXPECT_EQ(at.check(), Bodies{0});
}

TEST(SleepRules, are_evaluated_once_a_step) {
  Evaluated at(Line({0.0}));
  at.hand.state.step = 0;
  for (int i = 0; i < 2 * SleepRules::kChecks; ++i) (void)at.rules->evaluate(at.hand.state, *at.integrator, 1);
  EXPECT_EQ(at.hand.state.sleep.calm[0], 1);
}

TEST(SleepRules, nothing_falls_asleep_while_strengths_change) {
  Line row({0.0});
  row.plan.stages[0].strength = {{JointId{0}}, StrengthPlan::Part::all, 1.0, 2.0};
  EXPECT_EQ(Evaluated(row).check(), Bodies{});
  row.plan.stages[0].strength.to = 1.0;
  EXPECT_EQ(Evaluated(row).check(), Bodies{0});
}

}  // namespace
}  // namespace scree::test::sleep_rules_test
