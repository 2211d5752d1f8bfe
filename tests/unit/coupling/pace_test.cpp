// Partitioned stages with slow progress: the limit of effort, shorter steps, the end of the run.
#include "coupling/stages/pace.h"

#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::pace_test {
namespace {

using namespace coupling;

TEST(Pace, effort_is_that_of_explicit_steps_and_iterations) {
  RunStats stats;
  stats.unknowns = 60;
  StepReport report;
  report.explicit_steps = 300;
  report.iterations = 12;
  EXPECT_DOUBLE_EQ(effort(report, stats, 40.0), 300.0 * 40.0 + 2.0 * implicit_effort(stats));
}

TEST(Pace, stage_may_take_so_many_times_the_effort_of_implicit_steps) {
  RunStats stats;
  stats.unknowns = 10;
  stats.effort_before = 5e6;
  const double a_step = implicit_effort(stats), allowed = 20.0 * (100.0 + 20.0) * a_step;  // 20 steps are free
  stats.effort = stats.effort_before + 0.999 * allowed;
  EXPECT_FALSE(too_slow(stats, 100.0, 20.0));
  stats.effort = stats.effort_before + 1.001 * allowed;
  EXPECT_TRUE(too_slow(stats, 100.0, 20.0));
  EXPECT_FALSE(too_slow(stats, 100.0, 0.0)) << "no limit";
  EXPECT_FALSE(too_slow(stats, 101.0, 20.0));
}

TEST(Pace, half_the_step_is_cheaper_where_long_iterations_repeat_many_explicit_steps) {
  RunStats stats;
  stats.unknowns = 10;
  StepReport report;
  report.iterations = 13;
  const double of_iterations = effort(report, stats, 40.0);
  report.explicit_steps = static_cast<std::int64_t>(1.1 * of_iterations / 40.0);
  EXPECT_TRUE(shorter_is_cheaper(report, stats, 40.0));
  EXPECT_FALSE(shorter_is_cheaper(report, stats, 35.0)) << "the iterations themselves are most of it";
  report.iterations = 12;
  EXPECT_FALSE(shorter_is_cheaper(report, stats, 80.0)) << "they end soon";
}

/// An implicit block between explicit blocks, with stiff contacts below and above it.
TEST(Pace, stiff_stack_goes_on_in_shorter_steps) {
  Scene scene(50e9, 0.2, 2600.0, 40.0);
  scene.model.joints[0].normal_stiffness = 5e11;
  scene.add("base", rectangle(-1.0, -1.0, 4.0, 0.0), true);
  std::vector<BlockId> blocks;
  blocks.reserve(3);
  for (int i = 0; i < 3; ++i)
    blocks.push_back(scene.add("block " + std::to_string(i), rectangle(0.0, i, 3.0, i + 1.0)));
  scene.stage("nmm", Integrator::partitioned, 0.01, 1e-3, 0.25).partition.explicit_blocks = {blocks[0], blocks[2]};
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const RunStats& stats = run.stats();
  EXPECT_GT(stats.steps, 20);
  EXPECT_EQ(stats.cuts, 0);
  EXPECT_LT(stats.iterations, 21 * stats.steps);  // the first steps are not shortened and take 30 iterations
}

/// Two blocks on a base, one of them explicit.
Scene two_blocks(double allowed) {
  Scene scene(1e9, 0.2, 2600.0, 30.0);
  scene.plan.max_slowdown = allowed;
  scene.add("base", rectangle(-1.0, -0.5, 5.0, 0.0), true);
  scene.add("slow", rectangle(0.0, 0.0, 2.0, 0.5));
  const BlockId fast = scene.add("fast", rectangle(2.0, 0.0, 4.0, 0.5));
  scene.stage("nmm", Integrator::partitioned, 0.1, 1e-3, 0.25).partition.explicit_blocks = {fast};
  return scene;
}

TEST(Pace, stage_that_does_not_get_on_ends_with_its_cause) {
  const Scene scene = two_blocks(1e-3);
  Driver run(scene.model, scene.plan, methods());
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::not_converged);
  EXPECT_NE(end.reason.find("run.max_slowdown"), std::string::npos) << end.reason;
  EXPECT_LT(seconds(run.state().time), 0.05);
}

TEST(Pace, stage_that_gets_on_is_not_touched) {
  const Scene limited = two_blocks(20.0), free = two_blocks(0.0);
  std::uint64_t hash[2];
  for (const Scene* scene : {&limited, &free}) {
    Driver run(scene->model, scene->plan, methods());
    EXPECT_EQ(run.run().status, RunEnd::Status::done);
    hash[scene == &free] = state_hash(run.state());
    EXPECT_GT(run.stats().effort, 0.0);
  }
  EXPECT_EQ(hash[0], hash[1]);
}

}  // namespace
}  // namespace scree::test::pace_test
