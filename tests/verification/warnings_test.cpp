// Warnings of a run: at its start, at its end, and after a continuation from a checkpoint.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::warnings_test {
namespace {

using namespace coupling;

struct Told final : Sink {
  std::vector<std::pair<double, std::string>> warnings;
  void event(const Event& e) override {
    if (e.kind == EventKind::warning) warnings.emplace_back(e.time, e.text);
  }
};

bool has(const std::vector<Warning>& warnings, const std::string& part) {
  return std::any_of(warnings.begin(), warnings.end(),
                     [&](const Warning& w) { return w.text.find(part) != std::string::npos; });
}

/// A box that is thrown at 1 m/s over a held base, without gravity.
Scene thrown() {
  Scene scene;
  scene.model.gravity.setZero();
  scene.add("base", rectangle(0, 0, 4, 1), true);
  const BlockId box = scene.add("box", rectangle(1, 2, 2, 3));
  scene.model.initial_velocities.push_back({box, {1.0, 0.0}, 0.0});
  return scene;
}

Scene partitioned(double speed) {
  Scene scene = thrown();
  Stage& stage = scene.stage("dda", Integrator::partitioned, 0.02, 1e-3);
  stage.partition.speed = {speed, 0.5 * speed};
  return scene;
}

Scene switched(double hold) {
  Scene scene = thrown();
  Stage& stage = scene.stage("nmm", Integrator::explicit_, 0.02, {}, 0.5);
  stage.change.used = true;
  stage.change.kinetic = stage.change.elastic = 0.5;
  stage.change.hold = ticks(hold);
  return scene;
}

TEST(IdleRules, of_a_partition_are_told_at_the_end) {
  for (const double speed : {0.5, 2.0}) {
    const Scene scene = partitioned(speed);
    Driver run(scene.model, scene.plan, methods());
    Told told;
    run.add_sink(told);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_EQ(has(run.warnings(), "explicit_speed"), speed > 1.0);
    ASSERT_EQ(told.warnings.size(), speed > 1.0 ? 1U : 0U);
    for (const auto& [time, text] : told.warnings) EXPECT_DOUBLE_EQ(time, 0.02) << text;
  }
}

TEST(IdleRules, of_methods_are_told_at_the_end) {
  for (const double hold : {0.005, 1.0}) {
    const Scene scene = switched(hold);
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_EQ(has(run.warnings(), "never fired"), hold > 0.02) << hold;
  }
}

TEST(IdleRules, of_a_stage_that_is_not_over_are_not_told) {
  const Scene scene = partitioned(2.0);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run(0.01).status, RunEnd::Status::done);
  EXPECT_TRUE(run.warnings().empty());
}

struct Kept final : Keeper {
  std::vector<Checkpoint> all;
  bool due(std::int64_t step) override { return step == 10; }
  void keep(const Checkpoint& c) override { all.push_back(c); }
};

TEST(IdleRules, that_fired_before_a_checkpoint_are_not_told_after_it) {
  Scene scene = partitioned(0.5);
  scene.plan.stages[0].damping = 1.0;  // without effect, hence a warning at the start
  Kept kept;
  Driver whole(scene.model, scene.plan, methods());
  whole.set_keeper(kept);
  ASSERT_EQ(whole.run().status, RunEnd::Status::done);
  ASSERT_EQ(whole.warnings().size(), 1U);
  ASSERT_GE(kept.all.size(), 2U);
  const auto middle =
      std::find_if(kept.all.begin(), kept.all.end(), [](const Checkpoint& c) { return c.state.step == 10; });
  ASSERT_NE(middle, kept.all.end());
  Driver rest(scene.model, scene.plan, methods());
  Told told;
  rest.add_sink(told);
  rest.continue_from(*middle);
  ASSERT_EQ(rest.run().status, RunEnd::Status::done);
  EXPECT_EQ(rest.warnings().size(), 1U) << "what was warned of before is kept";
  EXPECT_TRUE(told.warnings.empty());
}

}  // namespace
}  // namespace scree::test::warnings_test
