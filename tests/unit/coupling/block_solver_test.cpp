// Implicit steps of affine bodies with block factors against steps with complete factors; the choice between them.
#include <gtest/gtest.h>

#include <numbers>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::coupling::block_solver_test {
namespace {

using test::rectangle;
using Factor = OpenClose::Factor;

/// Courses of blocks in running bond on a base that is at rest, or shakes with 5 m/s2 at 5 Hz.
test::Scene wall(bool shaken, int courses = 8) {
  test::Scene scene(5e9, 0.2, 2500.0, 25.0);
  scene.add("base", rectangle(-2.0, -1.0, courses + 3.0, 0.0));
  for (int j = 0; j < courses; ++j)
    for (int i = 0; i < courses + (j + 1) % 2; ++i) {
      const double x = i + (j % 2 == 0 ? 0.0 : 0.5);
      scene.add("b", rectangle(x, 0.5 * j, x + 1.0, 0.5 * (j + 1)));
    }
  MotionId motion;
  if (shaken) {
    std::vector<double> time, acceleration;
    for (int i = 0; i <= 500; ++i) {
      time.push_back(2e-3 * i);
      acceleration.push_back(5.0 * std::sin(2.0 * std::numbers::pi * 5.0 * time.back()));
    }
    scene.model.motions.emplace_back(time, acceleration, Vec2(1.0, 0.0));
    motion = MotionId{0};
  }
  scene.model.block_supports.push_back({BlockId{0}, motion});
  scene.stage("dda", Integrator::implicit, 1.0, 1e-3);
  return scene;
}

StepControl wide() {
  StepControl control;
  control.max_displacement = 0.05;
  return control;
}

struct Steps {
  test::ByHand hand;
  Newmark integrator;
  StepReport all;
  Audit audit;

  Steps(const test::Scene& scene, Factor factor, double dynamics = 1.0)
      : hand(scene.model, scene.plan.stages[0]),
        integrator(*hand.setup, wide(), 0.05, ImplicitOptions{.dynamics = dynamics, .factor = factor}) {
    hand.state.ledger.open(std::array{integrator.enter(hand.state)});
    integrator.watch(&audit);
  }
  void take(int steps, double dt = 1e-3) {
    for (int i = 0; i < steps; ++i) {
      const StepReport report = integrator.step(hand.state, ticks(dt));
      ASSERT_EQ(report.status, StepReport::Status::ok) << i << ": " << report.cause;
      all.block_iterations += report.block_iterations;
      all.incomplete_factors += report.incomplete_factors;
      all.factorisations += report.factorisations;
      all.fallbacks += report.fallbacks;
      all.switches += report.switches;
      all.passes += report.passes;
    }
    integrator.update_ledger(hand.state);
  }
};

class BlockSolver : public testing::TestWithParam<bool> {};

TEST_P(BlockSolver, gives_the_motion_of_complete_factors) {
  const test::Scene scene = wall(GetParam());
  Steps blocks(scene, Factor::chosen), complete(scene, Factor::anew);
  const std::vector<double> start = blocks.hand.state.q;
  blocks.take(200);
  complete.take(200);
  EXPECT_GT(blocks.all.block_iterations, 200);
  EXPECT_EQ(blocks.all.factorisations, 0);
  EXPECT_EQ(complete.all.block_iterations, 0);
  double moved = 0.0, apart = 0.0;
  for (std::size_t i = 0; i < start.size(); ++i) {
    moved = std::max(moved, std::abs(complete.hand.state.q[i] - start[i]));
    apart = std::max(apart, std::abs(complete.hand.state.q[i] - blocks.hand.state.q[i]));
  }
  EXPECT_LE(apart, 1e-8 * moved);
  for (Steps* run : {&blocks, &complete}) {
    EXPECT_LE(run->audit.worst(), 1.0) << run->audit.text();
    EXPECT_LE(std::abs(run->hand.state.ledger.closure()), 1e-12 * run->hand.state.ledger.moved());
  }
}

INSTANTIATE_TEST_SUITE_P(Base, BlockSolver, testing::Values(false, true),
                         [](const auto& p) { return p.param ? "shakes" : "rests"; });

TEST(BlockChoice, run_that_goes_on_from_a_copy_has_the_same_bits) {
  const test::Scene scene = wall(true, 5);
  Steps run(scene, Factor::chosen);
  int by_blocks = 0, complete = 0;
  for (int i = 0; i < 12; ++i) {
    // Every fourth step is long and takes more iterations.
    const double dt = i % 4 == 1 ? 0.05 : 1e-3;
    State copy = run.hand.state;
    Newmark other(*run.hand.setup, wide(), 0.05);
    (void)other.enter(copy);
    copy.last_step = run.hand.state.last_step;
    for (int k = 0; k < 4; ++k) {
      const Tick h = ticks(k == 0 ? dt : 1e-3);
      const StepReport report = run.integrator.step(run.hand.state, h);
      (void)other.step(copy, h);
      (report.factorisations > 0 ? complete : by_blocks) += 1;
    }
    ASSERT_EQ(state_hash(copy), state_hash(run.hand.state)) << i;
  }
  EXPECT_GT(by_blocks, 10);
}

TEST(BlockChoice, failed_pivot_falls_back_within_the_pass_and_is_counted) {
  // Only inertia holds a free block: 2 M/h^2 relative to its stiffness is below single precision.
  test::Scene scene(1e12, 0.2, 2500.0);
  scene.model.gravity = Vec2(0.0, 0.0);
  scene.add("b", rectangle(0.0, 0.0, 1.0, 1.0));
  scene.add("c", rectangle(3.0, 0.0, 4.0, 1.0));
  scene.stage("dda", Integrator::implicit, 1.0, 1e-3);
  Steps run(scene, Factor::chosen);
  run.take(1, 1e-3);
  EXPECT_EQ(run.all.fallbacks, 0);
  EXPECT_EQ(run.all.factorisations, 0);
  run.take(1, 1.0);
  EXPECT_EQ(run.all.fallbacks, 1);
  EXPECT_GE(run.all.factorisations, 1);
  EXPECT_EQ(run.hand.state.factored.choice.direct, 1);
  // The next step keeps the complete factor, the step after it uses blocks again.
  const int before = run.all.incomplete_factors;
  run.take(1, 1e-3);
  EXPECT_EQ(run.all.incomplete_factors, before);
  EXPECT_EQ(run.hand.state.factored.choice.direct, 0);
  EXPECT_TRUE(run.hand.state.factored.value.empty());
  run.take(1, 1e-3);
  EXPECT_EQ(run.all.incomplete_factors, before + 1);
  EXPECT_EQ(run.all.fallbacks, 1);
}

}  // namespace
}  // namespace scree::coupling::block_solver_test
