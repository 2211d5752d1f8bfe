// Rules that end a stage before its duration, compared with motions whose time is known in closed form.
#include <gtest/gtest.h>

#include <cstdio>

#include "tests/support/schemes.h"

namespace scree::test::end_rules_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81;

/// Records the events, frames and steps of a run that concern its stages.
struct Told final : Sink {
  std::vector<double> rule, end;         // times [s]
  std::vector<std::string> why;          // of rules
  std::vector<double> frames, end_time;  // of frames [s]
  double before = 0.0, last = 0.0;       // the last two steps of the first stage [s]
  void event(const Event& e) override {
    if (e.kind == EventKind::stage_end) end.push_back(e.time);
    if (e.kind != EventKind::stage_rule) return;
    rule.push_back(e.time);
    why.push_back(e.text);
  }
  void frame(const FrameView& view) override {
    frames.push_back(view.time);
    end_time.push_back(view.end_time);
  }
  void step(double time, const RunStats&, const Ledger&) override {
    if (!end.empty()) return;
    before = last;
    last = time;
  }
};

/// A block on a plane at 30 degrees with 10 degrees of friction; a = g (sin - cos tan phi).
class EndBySlope : public testing::TestWithParam<Scheme> {
 protected:
  static constexpr double kPhi = 10.0;
  Scene slope(double friction) const {
    Scene scene(5e10, 0.2, 2600.0, friction);
    const Mat2 R = rotation(-30.0 * kDegree);
    scene.add("plane", transformed(rectangle(-5, -2, 30, 0), Vec2(0, 0), R), true);
    scene.add("slider", transformed(rectangle(0, 0, 1, 1), Vec2(0, 0), R));
    return scene;
  }
};

TEST_P(EndBySlope, slip_is_reached_when_sqrt_2s_over_a_has_passed) {
  const Scheme scheme = GetParam();
  Scene scene = slope(kPhi);
  const std::optional<double> dt = scheme.implicit() ? std::optional<double>(5e-4) : std::nullopt;
  scene.stage(scheme.method, scheme.integrator, 2.0, dt, 0.5).end.slip = 1.0;
  scene.stage(scheme.method, scheme.integrator, 2.0, dt, 0.5).end.slip =
      1.0;  // another metre, measured from the end of the first stage
  scene.plan.output.every = scene.plan.output.history_every = ticks(0.1);
  Driver run(scene.model, scene.plan, methods());
  Told told;
  run.add_sink(told);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(told.rule.size(), 2U);
  const double a = kGravity * (std::sin(30.0 * kDegree) - std::cos(30.0 * kDegree) * std::tan(kPhi * kDegree));
  const double first = std::sqrt(2.0 / a), second = std::sqrt(4.0 / a);
  std::printf("%s: %.5f s and %.5f s, %.5f and %.5f by Coulomb; %s\n", scheme.name, told.rule[0], told.rule[1], first,
              second, told.why[0].c_str());
  // The tolerance covers one step and the time until the springs are stretched to Coulomb's limit.
  EXPECT_NEAR(told.rule[0] / first, 1.0, 1e-3);
  EXPECT_NEAR(told.rule[1] / second, 1.0, 1e-3);
  EXPECT_NE(told.why[0].find("(slip = 1)"), std::string::npos);
  EXPECT_EQ(told.rule, told.end) << "the stage ends with the step that the rule came true in";
  EXPECT_EQ(seconds(run.state().time), told.rule[1]);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  // The end time in frames: that of the plan at first, then the earlier one.
  EXPECT_EQ(told.end_time.front(), 4.0);
  EXPECT_EQ(told.end_time.back(), told.rule[1]);
  EXPECT_EQ(std::count(told.frames.begin(), told.frames.end(), told.rule[0]), 2) << "end and beginning of stages";
}

TEST_P(EndBySlope, kinetic_energy_falls_below_a_fraction_of_its_peak_as_friction_stops_the_block) {
  const Scheme scheme = GetParam();
  Scene scene(5e10, 0.2, 2600.0, 20.0);
  scene.add("plane", rectangle(-5, -2, 30, 0), true);
  const BlockId slider = scene.add("slider", rectangle(0, 0, 2, 0.5));
  const double speed = 3.0, fraction = 0.01;
  scene.model.initial_velocities.push_back({slider, {speed, 0.0}, 0.0});
  Stage& stage = scene.stage(scheme.method, scheme.integrator, 5.0,
                             scheme.implicit() ? std::optional<double>(5e-4) : std::nullopt, 0.5);
  stage.end.kinetic_below = fraction;
  const double hold = 0.02;  // once below the fraction, the kinetic energy only falls
  stage.end.hold = ticks(hold);
  Driver run(scene.model, scene.plan, methods());
  Told told;
  run.add_sink(told);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(told.rule.size(), 1U);
  const double expected = speed * (1.0 - std::sqrt(fraction)) / (kGravity * std::tan(20.0 * kDegree)) + hold;
  std::printf("%s: %.5f s, %.5f expected; %s\n", scheme.name, told.rule[0], expected, told.why[0].c_str());
  EXPECT_NEAR(told.rule[0] / expected, 1.0, 1e-3);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(schemes, EndBySlope,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"nmm_implicit", "nmm", Integrator::implicit},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

class EndOfFall : public testing::TestWithParam<Scheme> {};

/// Free fall: the centre of mass is at g t^2/2, exactly in explicit steps.
TEST_P(EndOfFall, displacement_ends_the_stage_with_the_first_step_beyond) {
  const Scheme scheme = GetParam();
  Scene scene(1e8);
  scene.add("faller", rectangle(0, 0, 1, 0.6));
  scene.add("other", rectangle(5, 0, 6, 0.6), true);
  scene
      .stage(scheme.method, scheme.integrator, 3.0, scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt, 0.3)
      .end.displacement = 2.0;
  Driver run(scene.model, scene.plan, methods());
  Told told;
  run.add_sink(told);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(told.rule.size(), 1U);
  const double fallen = 0.3 - centre_of(run, BlockId{0}).y(), exact = std::sqrt(4.0 / kGravity);
  std::printf("%s: %.6f s, %.6f exactly, fallen %.6f m, step %.1e s; %s\n", scheme.name, told.rule[0], exact, fallen,
              told.last - told.before, told.why[0].c_str());
  EXPECT_GE(fallen, 2.0 - 1e-12);
  if (scheme.implicit()) {
    EXPECT_NEAR(told.rule[0], exact, 2e-3);  // first order: the step that ends the stage, and a lag of one step
  } else {
    EXPECT_GE(told.rule[0], exact - 1e-12);
    EXPECT_LT(told.before, exact);
  }
}

INSTANTIATE_TEST_SUITE_P(schemes, EndOfFall, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return std::string(of.param.name); });

/// A damped stack settles; its kinetic energy passes zero at each reversal, so that the end depends on `hold`.
TEST(EndRules, hold_waits_until_a_settling_stack_has_come_to_rest) {
  const auto run_with = [](double kinetic, double force, double hold, double* kept) {
    Scene scene(1e8, 0.2, 2600.0);
    scene.add("base", rectangle(-1, -1, 2.2, 0), true);
    for (int i = 0; i < 2; ++i) scene.add("b" + std::to_string(i), rectangle(0, i, 1.2, i + 1));
    Stage& s = scene.stage("nmm", Integrator::explicit_, 4.0, std::nullopt, 0.5);
    s.damping = 10.0;
    s.damp_rigid_motion = true;
    s.end.kinetic_below = kinetic;
    s.end.force_below = force;
    s.end.hold = ticks(hold);
    Driver run(scene.model, scene.plan, methods());
    Told told;
    run.add_sink(told);
    EXPECT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_EQ(told.rule.size(), 1U);
    *kept = run.state().ledger[Column::kinetic];
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
    return told.rule.empty() ? 4.0 : told.rule[0];
  };
  double turning = 0.0, rested = 0.0, balanced = 0.0;
  const double at_turn = run_with(1e-3, 0.0, 0.0, &turning), at_rest = run_with(1e-3, 0.0, 0.1, &rested),
               in_balance = run_with(0.0, 1e-2, 0.1, &balanced);
  std::printf("kinetic energy at %.3f s (no hold), %.3f s, forces at %.3f s\n", at_turn, at_rest, in_balance);
  EXPECT_LT(at_turn, 0.1);  // half a period of the stack
  EXPECT_GT(at_rest, 0.2);
  EXPECT_GT(in_balance, 0.2);
}

}  // namespace
}  // namespace scree::test::end_rules_test
