// Times of stages: a load or motion that begins with a stage changes nothing before it, and output and audits change no
// result.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::stage_times_test {
namespace {

using namespace coupling;

class StageTimes : public testing::TestWithParam<Scheme> {};

constexpr double kLength = 0.01, kStep = 1e-4;  // durations of a stage and of a step [s]

/// A free block without weight, two stages, and an acceleration of 3 m/s2 times a function.
Scene pushed(const Scheme& scheme, TimeFunction push) {
  Scene scene;
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0, 0, 1, 1));
  push.name = "push";
  scene.model.functions.push_back(push);
  scene.model.body_accelerations.push_back({{}, {3.0, 0.0}, FunctionId{0}});
  for (int i = 0; i < 2; ++i) scene.stage(scheme.method, scheme.integrator, kLength, kStep, 0.5);
  return scene;
}

/// v = a t from the beginning of the second stage. A load that acted early would add half an explicit step, or a whole
/// implicit one, in the first stage.
TEST_P(StageTimes, load_that_begins_where_a_stage_does_belongs_to_it) {
  TimeFunction by_clock, by_stage;
  by_clock.start = kLength;
  by_stage.stage = StageId{1};
  for (const TimeFunction& push : {by_clock, by_stage}) {
    const Scene scene = pushed(GetParam(), push);
    Driver run(scene.model, scene.plan, methods());
    double before = -1.0;
    Watch watch;
    watch.see = [&](const FrameView& view) {
      if (view.stage == 0) before = totals_of(run, BlockId{0}).momentum.norm();
    };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const BodyTotals after = totals_of(run, BlockId{0});
    EXPECT_LT(before, 1e-20);  // round-off of a mesh at rest; half a step of the load would be 0.4 N s
    EXPECT_NEAR(after.momentum.x() / after.mass, 3.0 * kLength, 1e-12 * 3.0 * kLength);  // sums of 100 steps
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-10);
  }
}

TEST_P(StageTimes, offset_counts_from_the_stage) {
  TimeFunction push;
  push.stage = StageId{1};
  push.start = 0.25 * kLength;
  const Scene scene = pushed(GetParam(), push);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const BodyTotals after = totals_of(run, BlockId{0});
  // Within a stage the force is evaluated at the ends of steps: up to half a step of it may be added or missing.
  EXPECT_NEAR(after.momentum.x() / after.mass, 3.0 * 0.75 * kLength, 1.01 * 3.0 * kStep);
}

/// A block that comes to rest on its base long before the stage's limit of time, and a base that then moves.
Scene shaken(StageId stage, double start) {
  Scene scene(1e8, 0.2, 2600.0, 40.0);
  scene.add("base", rectangle(-2, -1, 3, 0), true);
  scene.add("block", rectangle(0, 0, 1, 0.6));
  scene.model.motions.push_back(
      {{0.0, 0.01, 0.03, 0.04}, {0.0, 1.0, -1.0, 0.0}, {1.0, 0.0}, {start, Between::linear, "quake", stage}});
  scene.model.block_supports[0].motion = MotionId{0};
  Stage& rest = scene.stage("dda", Integrator::implicit, 3.0, 0.01);
  rest.rest = true;
  rest.rest_force = 1e-3;
  scene.stage("dda", Integrator::explicit_, 0.05, {}).name = "shaking";
  return scene;
}

TEST(StageTimes, motion_moves_its_stage_whenever_that_begins) {
  const Scene scene = shaken(StageId{1}, 0.0);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_LT(run.state().stage_begin[1], ticks(1.0));  // rest was reached early
  const Vec2 moved = centre_of(run, BlockId{0}) - Vec2(0.5, -0.5), meant = scene.model.motions[0].displacement(0.05);
  ASSERT_GT(meant.norm(), 1e-4);
  EXPECT_LT((moved - meant).norm(), 1e-14);
  EXPECT_GT(std::abs(run.state().ledger[Column::prescribed_motion]), 1e-3);
}

TEST(StageTimes, motion_that_is_no_more_met_after_an_early_end_is_refused) {
  const Scene scene = shaken(StageId{}, 3.0);
  Driver run(scene.model, scene.plan, methods());
  try {
    (void)run.run();
    FAIL() << "it ran";
  } catch (const PlanError& e) {
    const std::string said = e.what();
    for (const char* part : {"the motion 'quake' begins at 3 s", "an earlier stage has ended early",
                             "it acts in no stage", "start = \"shaking\""})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
}

/// Hash of the final state of a run with the given output, history and audit.
std::uint64_t hash_of(Scene scene, double every, double history_every, bool audit) {
  scene.plan.output.every = ticks(every);
  scene.plan.output.history_every = ticks(history_every);
  scene.plan.audit = audit;
  Driver run(scene.model, scene.plan, methods());
  Watch watch;
  watch.see = [](const FrameView&) {};
  run.add_sink(watch);
  EXPECT_EQ(run.run().status, RunEnd::Status::done);
  return state_hash(run.state());
}

void expect_same_however_looked_at(const Scene& scene) {
  const std::uint64_t expected = hash_of(scene, 1.0, 1.0, false);
  EXPECT_EQ(hash_of(scene, 0.0031, 0.0031, false), expected);
  EXPECT_EQ(hash_of(scene, 0.0031, 0.00017, false), expected);
  EXPECT_EQ(hash_of(scene, 1.0, 1.0, true), expected);
}

/// A block that falls on another one, which slides.
Scene falling() {
  Scene scene(1e8, 0.2, 2600.0, 20.0);
  scene.add("base", rectangle(-2, -1, 3, 0), true);
  scene.add("low", rectangle(0, 0, 1, 0.5));
  scene.add("high", rectangle(0.2, 0.502, 0.9, 0.9));
  scene.model.initial_velocities.push_back({BlockId{1}, {0.3, 0.0}, 0.0});
  return scene;
}

TEST_P(StageTimes, steps_do_not_depend_on_who_looks) {
  Scene scene = falling();
  const Scheme scheme = GetParam();
  scene.stage(scheme.method, scheme.integrator, 0.05, scheme.implicit() ? std::optional<double>(7e-4) : std::nullopt,
              0.5);
  expect_same_however_looked_at(scene);
}

TEST(StageTimes, steps_of_partitioned_stages_do_not_depend_on_who_looks) {
  for (const bool slow_explicit : {false, true}) {
    Scene scene = falling();
    Stage& stage = scene.stage("nmm", Integrator::partitioned, 0.03, slow_explicit ? 2e-5 : 7e-4, 0.5);
    stage.partition.explicit_blocks = {BlockId{2}};
    stage.partition.slow_explicit = slow_explicit;
    expect_same_however_looked_at(scene);
  }
}

TEST(StageTimes, implicit_rest_does_not_depend_on_who_looks) {
  Scene scene = falling();
  scene.model.initial_velocities.clear();
  scene.stage("dda", Integrator::implicit, 0.2, 0.01).rest = true;
  expect_same_however_looked_at(scene);
}

TEST(StageTimes, run_that_is_cut_by_until_ends_a_step_later_at_most) {
  Scene scene = falling();
  scene.stage("dda", Integrator::implicit, 0.1, 0.003);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run(0.05).status, RunEnd::Status::done);
  EXPECT_GE(run.state().time, ticks(0.05));
  EXPECT_LT(run.state().time, ticks(0.053));
}

INSTANTIATE_TEST_SUITE_P(Schemes, StageTimes, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return of.param.name; });

}  // namespace
}  // namespace scree::test::stage_times_test
