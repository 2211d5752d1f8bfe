// The certified step against the step from which the scheme grows, in runs of 3000 steps.
#include <gtest/gtest.h>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::explicit_bound_test {
namespace {

using namespace coupling;

/// A free DDA block: six unknowns, and an exact bound of its own stiffness.
struct Small {
  Scene scene{1e7, 0.2, 2000.0};
  Small() {
    scene.model.gravity = {0.0, 0.0};
    scene.add("block", rectangle(0, 0, 1.4, 1));
    scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  }
  double bound(const ExplicitDamping& damping, std::string* binding = nullptr) {
    ByHand hand(scene.model, scene.plan.stages[0]);
    CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05, damping);
    integrator.enter(hand.state);
    return integrator.stable_step(hand.state, binding);
  }
  /// Kinetic energy after 3000 steps of `h` over the initial one, which is of a tiny velocity in every mode.
  double growth(const ExplicitDamping& damping, double h) {
    ByHand hand(scene.model, scene.plan.stages[0]);
    Mat2 gradient;
    gradient << 1.0, 0.4, 0.3, -0.7;
    hand.move(0, {0.0, 0.0}, 1e-9 * gradient);
    const double before = hand.kinetic();
    CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05, damping);
    integrator.enter(hand.state);
    for (int i = 0; i < 3000; ++i)
      if (integrator.step(hand.state, ticks(h)).status != StepReport::Status::ok) return 1e300;
    return hand.kinetic() / before;
  }
};

TEST(ExplicitBound, of_an_undamped_block_is_where_it_begins_to_grow) {
  Small small;
  const double h = small.bound({});
  EXPECT_LT(small.growth({}, 0.999 * h), 100.0);
  EXPECT_GT(small.growth({}, 1.002 * h), 1e6);
}

TEST(ExplicitBound, with_rayleigh_damping_is_where_it_begins_to_grow) {
  Small small;
  const double free = small.bound({});
  for (const double part : {0.02, 0.2, 1.0}) {  // relative to the undamped step
    const ExplicitDamping damping{.stiffness = part * free};
    const double h = small.bound(damping);
    EXPECT_LT(h, free);
    EXPECT_LT(small.growth(damping, 0.999 * h), 100.0) << part;
    EXPECT_GT(small.growth(damping, 1.002 * h), 1e6) << part;
  }
}

TEST(ExplicitBound, with_viscous_edges_is_safe_and_needed) {
  Small small;
  const double free = small.bound({});
  for (std::int32_t e = 0; e < 4; ++e) small.scene.model.viscous_edges.push_back({{BlockId{0}, {0, e}, 0.0, 1.0}});
  std::string binding;
  const double h = small.bound({}, &binding);
  EXPECT_LT(h, 0.9 * free);
  EXPECT_NE(binding.find("viscous edges"), std::string::npos) << binding;
  EXPECT_LT(small.growth({}, 0.999 * h), 1.0);
  EXPECT_GT(small.growth({}, free), 1e6);  // the bound without them is not stable
}

TEST(ExplicitBound, local_damping_shortens_it) {
  Small small;
  const double h = small.bound({.local = 0.5});
  EXPECT_NEAR(h, small.bound({}) / std::sqrt(1.5), 1e-12 * h);
  EXPECT_LT(small.growth({.local = 0.5}, 0.999 * h), 100.0);
}

TEST(ExplicitBound, step_above_it_is_refused_with_what_binds_it) {
  Scene scene(1e9, 0.2, 2000.0);
  scene.add("base", rectangle(-2, -1, 4, 0), true);
  const BlockId id = scene.add("crate", rectangle(0, 0, 1, 1));
  scene.model.joints[0].penalty = 1e12;
  const auto refused = [](const Scene& s) -> std::string {
    Driver run(s.model, s.plan, methods());
    try {
      run.run();
    } catch (const PlanError& e) {
      return e.what();
    }
    return "accepted";
  };
  scene.stage("dda", Integrator::explicit_, 0.01, 1e-3).stiffness_damping = 1e-4;
  EXPECT_NE(refused(scene).find("block 'crate' ("), std::string::npos) << refused(scene);
  EXPECT_NE(refused(scene).find("% contacts, the stiffest with block 'base'"), std::string::npos) << refused(scene);
  scene.model.joints[0].penalty = 1e6;
  EXPECT_NE(refused(scene).find("% its stiffness-proportional damping"), std::string::npos) << refused(scene);
  scene.plan.stages[0].stiffness_damping = 0.0;
  PointSupport support{id, {0.5, 1.0}, true, true, 1e13};
  scene.model.point_supports.push_back(support);
  EXPECT_NE(refused(scene).find("% point supports"), std::string::npos) << refused(scene);
  scene.model.point_supports.clear();
  EXPECT_NE(refused(scene).find("% its own stiffness"), std::string::npos) << refused(scene);
}

TEST(ExplicitLoss, of_a_block_turned_inside_out_keeps_the_last_good_state) {
  Scene scene(1e6, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  scene.add("sound", rectangle(5, 0, 6, 1));
  scene.add("crushed", rectangle(0, 0, 1, 1));
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  ByHand hand(scene.model, scene.plan.stages[0]);
  Mat2 squeeze = Mat2::Zero();
  squeeze(0, 0) = -2000.0;  // far beyond the speed that the elastic energy could stop
  hand.move(1, {0.0, 0.0}, squeeze);
  CentralDifference integrator(*hand.setup, {.max_displacement = 10.0}, 0.05, {.mass = 5.0, .stiffness = 1e-6});
  integrator.enter(hand.state);
  const Tick h = ticks(1e-5);
  StepReport report;
  State before = hand.state;
  for (int i = 0; i < 1000 && report.status == StepReport::Status::ok; ++i) {
    before = hand.state;
    report = integrator.step(hand.state, h);
  }
  EXPECT_EQ(report.status, StepReport::Status::non_finite);
  EXPECT_EQ(report.body, BodyIndex{1});
  EXPECT_NE(report.cause.find("inside out"), std::string::npos) << report.cause;
  EXPECT_NE(report.cause.find("t = "), std::string::npos) << report.cause;
  EXPECT_GT(hand.state.step, 10);
  EXPECT_EQ(state_hash(hand.state), state_hash(before));
  // The ledger is that of the last good state too.
  integrator.update_ledger(hand.state);
  EXPECT_LT(hand.state.ledger.relative_closure(), 1e-12);
  // A repeated step fails again, and again changes nothing.
  before = hand.state;
  EXPECT_EQ(integrator.step(hand.state, h).status, StepReport::Status::non_finite);
  EXPECT_EQ(state_hash(hand.state), state_hash(before));
}

TEST(ExplicitLoss, ends_a_run_with_block_time_and_cause_and_a_readable_last_frame) {
  Scene scene(1e6, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("crushed", rectangle(0, 0, 1, 1));
  for (const std::int32_t e : {1, 3})
    scene.model.tractions.push_back({{id, {0, e}, 0.0, 1.0}, {e == 1 ? -2e7 : 2e7, 0.0}, {}});
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt).control.max_displacement = 1.0;
  scene.plan.detection = 2.0;
  struct Last final : Sink {
    bool finite = false;
    void end(const RunEnd&, const FrameView& f) override {
      finite = !f.position.empty();
      for (const double x : f.position) finite = finite && std::isfinite(x);
      for (const double s : f.stress) finite = finite && std::isfinite(s);
    }
  } last;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(last);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::non_finite);
  for (const char* part : {"block 'crushed'", "t = ", "stage 'dda0'", "inside out", "likely causes"})
    EXPECT_NE(end.reason.find(part), std::string::npos) << end.reason;
  EXPECT_TRUE(last.finite);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

}  // namespace
}  // namespace scree::test::explicit_bound_test
