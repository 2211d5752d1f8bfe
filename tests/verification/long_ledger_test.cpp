// The energy ledger of a long run with all features: blocks on a shaken slope slide, collide, are damped and weakened,
// and change scheme, method and side repeatedly. 10^5 steps with SCREE_FULL in the environment.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "tests/support/schemes.h"

namespace scree::test::long_ledger_test {
namespace {

using namespace scree::coupling;

TEST(LongLedger, closes_through_shaking_friction_damping_and_every_change) {
  const bool full = std::getenv("SCREE_FULL") != nullptr;
  Scene scene(2e8, 0.2, 2600.0, 28.0);
  JointLaw& law = scene.model.joints[0];
  law.damping = 0.1;
  law.cohesion = 2e3;
  law.residual_friction = 18.0 * kDegree;
  law.weakening_slip = 0.01;
  const Mat2 R = rotation(-22.0 * kDegree);
  const auto turned = [&](const Polygon& p) { return transformed(p, Vec2(0.0, 0.0), R); };
  const BlockId plane = scene.add("plane", turned(rectangle(-3, -1, 40, 0)), true);
  const BlockId lower = scene.add("lower", turned(rectangle(0, 0, 2, 1)));
  scene.add("upper", turned(rectangle(0.3, 1, 1.6, 1.8)));
  const BlockId toe = scene.add("toe", turned(rectangle(2.6, 0, 3.3, 0.7)));
  // The base shakes at 3 Hz with a tenth of g, slowly modulated.
  std::vector<double> t, a;
  const double length = full ? 6.0 : 0.5;
  for (int i = 0; i <= static_cast<int>(200.0 * (length + 0.1)); ++i) {
    t.push_back(0.005 * i);
    a.push_back(0.98 * std::sin(6.0 * std::numbers::pi * t.back()) * std::cos(1.7 * t.back()));
  }
  scene.model.motions.emplace_back(t, a, Vec2(1.0, 0.0));
  for (BlockSupport& s : scene.model.block_supports)
    if (s.block == plane) s.motion = MotionId{0};
  const int rounds = full ? 60 : 5;
  for (int k = 0; k < rounds; ++k) {
    const auto stage = [&](const char* method, Integrator integrator, double part) -> Stage& {
      Stage& s = scene.stage(
          method, integrator, part * length / rounds,
          integrator == Integrator::explicit_ ? std::optional<double>(3e-5) : std::optional<double>(4e-4), 0.6);
      s.damping = k % 2 == 0 ? 2.0 : 0.0;
      return s;
    };
    stage("nmm", Integrator::explicit_, 0.35);
    stage("nmm", Integrator::implicit, 0.1);
    Stage& both = stage("nmm", Integrator::partitioned, 0.15);
    both.partition.explicit_blocks = {toe};
    both.partition.speed = {0.5 + 0.02 * k, 0.3};
    both.rules.push_back({{lower}, "dda", 0.0, false});
    stage("dda", Integrator::implicit, 0.15);
    stage("dda", Integrator::explicit_, 0.25).stiffness_damping = 1e-6;
  }
  scene.plan.output.every = scene.plan.output.history_every = ticks(0.01);
  Driver run(scene.model, scene.plan, methods());
  double worst = 0.0;
  struct : Sink {
    double* worst = nullptr;
    void history(const HistoryView& view) override { *worst = std::max(*worst, view.ledger->relative_closure()); }
  } watch;
  watch.worst = &worst;
  run.add_sink(watch);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const Ledger& ledger = run.state().ledger;
  std::printf("%ld steps, %zu hand-overs, %ld cuts: ledger open by %.1e of the %.3g J moved at worst\n",
              static_cast<long>(run.stats().steps), run.transfers().size(), static_cast<long>(run.stats().cuts), worst,
              ledger.moved());
  for (const Column c : {Column::gravity, Column::prescribed_motion, Column::friction, Column::contact_damping,
                         Column::mass_damping, Column::stiffness_damping, Column::newmark_damping, Column::reservoir}) {
    std::printf("  %s %.3g J\n", info(c).name.data(), ledger[c]);
    EXPECT_NE(ledger[c], 0.0) << info(c).name << " did not take part";
  }
  EXPECT_LT(worst, 1e-9);
  EXPECT_GE(run.stats().steps, full ? 100000 : 5000);
}

TEST(StiffSlide, closes_to_round_off_in_long_steps) {
  // A residual that round-off of stiffness times displacement leaves has a resultant that is the same in every step of
  // a slide. Iterates that were not refined left 9e-11.
  Scene scene(5e11, 0.2, 2600.0, 20.0);
  constexpr double kSlope = 35.0 * kDegree;
  scene.model.gravity = 9.81 * Vec2(-std::sin(kSlope), -std::cos(kSlope));
  scene.add("plane", rectangle(-12, -3, 10, 0), true);
  for (int i = 0; i < 2; ++i) scene.add("block-" + std::to_string(i), rectangle(3 * i, 0, 3 * i + 3, 1));
  scene.stage("nmm", Integrator::implicit, 1.0, 0.02, 0.25);
  scene.plan.audit = true;
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double closure = run.state().ledger.relative_closure();
  std::printf("ledger open by %.1e of the energy moved\n", closure);
  EXPECT_LT(closure, 5e-13);
}

}  // namespace
}  // namespace scree::test::long_ledger_test
