#include "coupling/integrate/open_close.h"

#include <gtest/gtest.h>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::coupling::open_close_test {
namespace {

using test::rectangle;

/// Blocks in running bond, a millimetre apart, that fall on their base.
struct Wall {
  test::Scene scene{1e8, 0.2, 2500.0, 25.0};
  explicit Wall(const std::string& method) {
    scene.add("base", rectangle(-1.0, -1.0, 6.0, 0.0), true);
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 4; ++i) {
        const double x = 1.02 * i + (j % 2 == 0 ? 0.0 : 0.45), y = 0.001 * (1.0 + 0.3 * (i % 3)) + 1.002 * j;
        scene.add("b" + std::to_string(10 * j + i), rectangle(x, y, x + 1.0, y + 1.0));
      }
    scene.stage(method, Integrator::implicit, 1.0, 1e-3, 2.0);
  }
};

struct Fall {
  test::ByHand hand;
  Newmark integrator;
  StepReport all;

  Fall(const Wall& wall, OpenClose::Factor factor, int steps)
      : hand(wall.scene.model, wall.scene.plan.stages[0]),
        integrator(*hand.setup, control(), 0.05, ImplicitOptions{.factor = factor}) {
    hand.state.ledger.open(std::array{integrator.enter(hand.state)});
    for (int i = 0; i < steps; ++i) {
      Tick h = ticks(1e-3);
      StepReport report = integrator.step(hand.state, h);
      for (; report.status != StepReport::Status::ok && h > 1000; report = integrator.step(hand.state, h)) h /= 3;
      EXPECT_EQ(report.status, StepReport::Status::ok) << report.cause;
      all.passes += report.passes;
      all.iterations += report.iterations;
      all.switches += report.switches;
      all.updates += report.updates;
      all.factorisations += report.factorisations;
    }
    integrator.update_ledger(hand.state);
  }
  static StepControl control() {
    StepControl c;
    c.max_displacement = 0.05;
    c.max_passes = 30;
    return c;
  }
};

class OpenCloseUpdates : public testing::TestWithParam<std::string> {};

TEST_P(OpenCloseUpdates, rank_updates_give_the_motion_of_new_factors) {
  const Wall wall(GetParam());
  const Fall with(wall, OpenClose::Factor::updated, 120), without(wall, OpenClose::Factor::anew, 120);
  EXPECT_GT(with.all.updates, 20);
  EXPECT_EQ(without.all.updates, 0);
  EXPECT_LT(with.all.factorisations, without.all.factorisations);
  EXPECT_EQ(with.all.switches, without.all.switches);
  // Whether one more of Newton's iterations follows depends on round-off; it takes one pass.
  EXPECT_EQ(with.all.passes - with.all.iterations, without.all.passes - without.all.iterations);
  EXPECT_NEAR(with.all.iterations, without.all.iterations, 8);
  const auto &q = with.hand.state.q, &reference = without.hand.state.q;
  for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(q[i], reference[i], 1e-9) << i;
}

INSTANTIATE_TEST_SUITE_P(Methods, OpenCloseUpdates, testing::Values("dda", "nmm"),
                         [](const auto& p) { return p.param; });

/// Courses of blocks that touch exactly and are loaded by their whole weight at once.
test::Scene courses() {
  test::Scene scene(1e9, 0.2, 2500.0, 30.0);
  scene.add("base", rectangle(-1.0, -1.0, 8.0, 0.0), true);
  for (int j = 0; j < 6; ++j)
    for (int i = 0; i < 5; ++i) {
      const double x = 1.01 * i + (j % 2 == 0 ? 0.0 : 0.47);
      scene.add("b" + std::to_string(10 * j + i), rectangle(x, 1.0 * j, x + 1.0, 1.0 * (j + 1)));
    }
  scene.stage("dda", Integrator::implicit, 1.0, 1e-3, 2.0);
  return scene;
}

StepControl wide() {
  StepControl control;
  control.max_displacement = 0.05;
  return control;
}

TEST(OpenCloseStates, blocks_that_just_touch_do_not_switch_on_round_off) {
  const test::Scene scene = courses();
  test::ByHand hand(scene.model, scene.plan.stages[0]);
  Newmark integrator(*hand.setup, wide(), 0.05);
  (void)integrator.enter(hand.state);
  // All fall by the same distance in the first step: gaps between blocks are round-off; only the lowest are pressed.
  const StepReport report = integrator.step(hand.state, ticks(1e-3));
  ASSERT_EQ(report.status, StepReport::Status::ok) << report.cause;
  EXPECT_LE(report.passes, 6);
  EXPECT_LE(report.switches, 100);
}

TEST(KeptFactor, settled_blocks_need_no_new_one) {
  const test::Scene scene = courses();
  test::ByHand hand(scene.model, scene.plan.stages[0]);
  Newmark settling(*hand.setup, wide(), 0.05, ImplicitOptions{.dynamics = 0.0});
  (void)settling.enter(hand.state);
  for (int i = 0; i < 40; ++i) ASSERT_EQ(settling.step(hand.state, ticks(0.02)).status, StepReport::Status::ok);
  settling.leave(hand.state);
  EXPECT_TRUE(hand.state.factored.column_start.empty());
  Newmark integrator(*hand.setup, wide(), 0.05, ImplicitOptions{.factor = OpenClose::Factor::kept});
  (void)integrator.enter(hand.state);
  StepReport all;
  for (int i = 0; i < 50; ++i) {
    const StepReport report = integrator.step(hand.state, ticks(1e-3));
    ASSERT_EQ(report.status, StepReport::Status::ok);
    all.factorisations += report.factorisations;
    all.corrections += report.corrections;
  }
  EXPECT_LE(all.factorisations, 3);
  EXPECT_GE(all.corrections, 40);
}

TEST(KeptFactor, run_that_goes_on_from_a_copy_has_the_same_bits) {
  const Wall wall("dda");
  test::ByHand hand(wall.scene.model, wall.scene.plan.stages[0]);
  StepControl control = wide();
  control.max_passes = 30;
  Newmark integrator(*hand.setup, control, 0.05, ImplicitOptions{.factor = OpenClose::Factor::kept});
  (void)integrator.enter(hand.state);
  int kept = 0, used = 0;  // copies with a factor that the next step may use; steps without factorisation
  for (int i = 0; i < 20; ++i) {
    State copy = hand.state;
    kept += copy.factored.column_start.empty() || copy.factored.patience.wait > 0 ? 0 : 1;
    Newmark other(*hand.setup, control, 0.05, ImplicitOptions{.factor = OpenClose::Factor::kept});
    (void)other.enter(copy);
    copy.last_step = hand.state.last_step;  // enter() begins a stage, a restart continues one
    for (int k = 0; k < 6; ++k) {
      const StepReport report = integrator.step(hand.state, ticks(1e-3));
      (void)other.step(copy, ticks(1e-3));
      used += report.factorisations == 0 ? 1 : 0;
    }
    EXPECT_EQ(state_hash(copy), state_hash(hand.state)) << i;
  }
  EXPECT_GT(used, 10);
  EXPECT_GT(kept, 3);
}

}  // namespace
}  // namespace scree::coupling::open_close_test
