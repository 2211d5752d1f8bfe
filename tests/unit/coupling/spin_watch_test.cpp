// The warning of a spin that implicit steps damp: the loss it states is that of a run; no warning without the cause.
#include "coupling/stages/spin_watch.h"

#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::spin_watch_test {
namespace {

using namespace coupling;

struct Warnings final : Sink {
  std::vector<std::string> spins;
  void event(const Event& e) override {
    if (e.kind == EventKind::warning && e.text.find("rad/s") != std::string::npos) spins.push_back(e.text);
  }
};

/// A free square of 1 m that turns without weight.
struct Spun {
  Warnings warnings;
  double kept = 0.0;  // fraction of the kinetic energy

  Spun(const char* method, Integrator integrator, double rate, double duration,
       NewmarkScheme newmark = Stage().newmark) {
    Scene scene(1e9, 0.2, 2600.0);
    scene.model.gravity = {0.0, 0.0};
    const BlockId id = scene.add("plate", rectangle(0, 0, 1, 1));
    scene.model.initial_velocities.push_back({id, Vec2(0.0, 0.0), rate});
    Stage& stage = scene.stage(method, integrator, duration,
                               integrator == Integrator::explicit_ ? std::nullopt : std::optional(1e-3));
    stage.newmark = newmark;
    Driver run(scene.model, scene.plan, methods());
    run.add_sink(warnings);
    EXPECT_EQ(run.run().status, RunEnd::Status::done);
    const Setup& setup = run.setup();
    kept = totals_of(setup, run.state(), setup.body(id)).kinetic / (0.5 * 2600.0 / 6.0 * rate * rate);
  }
};

TEST(SpinWatch, part_that_is_told_is_what_a_run_loses) {
  const double rate = 8.0, duration = 0.5;
  const Spun plate("nmm", Integrator::implicit, rate, duration);
  EXPECT_NEAR(plate.kept, 1.0 / (1.0 + rate * rate * 1e-3 * duration), 2e-3);
  EXPECT_NEAR(spin_lost(rate, 1e-3), 1.0 - 1.0 / (1.0 + rate * rate * 1e-3), 1e-15);
  ASSERT_EQ(plate.warnings.spins.size(), 1u);  // once
  const std::string& text = plate.warnings.spins[0];
  EXPECT_NE(text.find("block 'plate' turns by 7."), std::string::npos) << text;
  EXPECT_NE(text.find("steps of 0.001 s"), std::string::npos) << text;
}

TEST(SpinWatch, is_silent_without_the_cause) {
  const double turned = 0.5;                                                            // 4 rad at 8 rad/s
  EXPECT_TRUE(Spun("nmm", Integrator::implicit, 5.0, turned).warnings.spins.empty());   // 2.4 % per second
  EXPECT_TRUE(Spun("nmm", Integrator::implicit, 8.0, 0.05).warnings.spins.empty());     // rotated by 0.4 rad
  EXPECT_TRUE(Spun("nmm", Integrator::explicit_, 8.0, turned).warnings.spins.empty());  // explicit steps keep the spin
  const Spun exact("dda", Integrator::implicit, 8.0, turned);
  EXPECT_TRUE(exact.warnings.spins.empty());
  EXPECT_NEAR(exact.kept, 1.0, 1e-3);
  const Spun undamped("nmm", Integrator::implicit, 8.0, turned, NewmarkScheme::trapezoidal);
  EXPECT_TRUE(undamped.warnings.spins.empty());
  EXPECT_NEAR(undamped.kept, 1.0, 1e-3);
}

TEST(SpinWatch, told_spins_and_pairs_do_not_hide_each_other) {
  ReportedWarnings reported;
  reported.add({3, 3});
  EXPECT_TRUE(reported.has({3, 3}));
  EXPECT_FALSE(reported.has({3, 4}));
  reported.add({3, 4});
  EXPECT_TRUE(reported.has({3, 4}));
  EXPECT_FALSE(reported.has({4, 4}));
}

}  // namespace
}  // namespace scree::test::spin_watch_test
