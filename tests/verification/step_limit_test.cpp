// The certified explicit step bound in a run: reported, observed, and exceeded only on request.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::step_limit_test {
namespace {

using coupling::Integrator;

struct Events final : coupling::Sink {
  std::vector<std::string> steps, warnings;
  void event(const coupling::Event& e) override {
    if (e.kind == coupling::EventKind::stage_step) steps.push_back(e.text);
    if (e.kind == coupling::EventKind::warning) warnings.push_back(e.text);
  }
};

Scene swinging(std::optional<double> dt) {
  Scene scene(1e9, 0.2, 2000.0);
  scene.model.gravity.setZero();
  const BlockId id = scene.add("plate", rectangle(0, 0, 4, 3));
  scene.model.initial_velocities.push_back({id, {0.0, 0.0}, 1.0});
  scene.stage("nmm", Integrator::explicit_, 0.2, dt, 0.5);
  return scene;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(StepLimit, auto_tells_once_what_binds_it) {
  Scene scene = swinging(std::nullopt);
  Events events;
  coupling::Driver run(scene.model, scene.plan, methods());
  run.add_sink(events);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  ASSERT_EQ(events.steps.size(), 1U);
  EXPECT_TRUE(has(events.steps[0], "block 'plate'")) << events.steps[0];
  EXPECT_TRUE(has(events.steps[0], "element ")) << events.steps[0];
}

TEST(StepLimit, larger_step_is_refused_with_its_bound_and_unstable_when_forced) {
  Scene scene = swinging(5e-3);
  coupling::Driver refused(scene.model, scene.plan, methods());
  try {
    (void)refused.run();
    FAIL() << "taken";
  } catch (const coupling::PlanError& e) {
    EXPECT_TRUE(has(e.what(), "block 'plate'")) << e.what();
    EXPECT_TRUE(has(e.what(), "force_dt")) << e.what();
  }
  scene.plan.stages[0].force_dt = true;
  scene.plan.max_gain = 0.0;  // the limit of energy gain would end the run at once
  Events events;
  coupling::Driver forced(scene.model, scene.plan, methods());
  forced.add_sink(events);
  const coupling::RunEnd end = forced.run();
  // The run is unstable: points soon move too far in a step, which is cut repeatedly.
  EXPECT_GT(forced.stats().cuts, 3) << end.reason;
  ASSERT_EQ(events.warnings.size(), 1U);
  for (const double x : forced.state().q) ASSERT_TRUE(std::isfinite(x));
}

}  // namespace
}  // namespace scree::test::step_limit_test
