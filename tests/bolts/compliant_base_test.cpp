// A column on a compliant base: the velocity of an upgoing wave doubles at the free top, and the reflected wave leaves
// through the base.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "tests/support/schemes.h"

namespace scree::test::compliant_base_test {
namespace {

using namespace coupling;

constexpr double kYoung = 2e8, kDensity = 2000.0, kHeight = 16.0, kWidth = 1.0, kPulse = 0.05, kSpeed = 0.1;

/// Acceleration of a velocity pulse kSpeed sin^2(pi t/kPulse).
GroundMotion pulse(const Vec2& direction, double factor) {
  std::vector<double> t, a;
  for (int i = 0; i <= 1000; ++i) {
    t.push_back(kPulse * i / 1000.0);
    a.push_back(factor * kSpeed * std::numbers::pi / kPulse *
                std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 1000.0));
  }
  GroundMotion::Setting setting;
  setting.name = "pulse";
  return {t, a, direction, setting};
}

/// With Poisson's ratio 0 a vertical motion between free sides is a pressure wave of speed sqrt(E/rho); a horizontal
/// motion, with rollers that hold the sides vertically, is a shear wave of speed sqrt(E/2 rho).
class CompliantBase : public testing::TestWithParam<std::tuple<Integrator, bool, bool>> {};
INSTANTIATE_TEST_SUITE_P(waves, CompliantBase,
                         testing::Combine(testing::Values(Integrator::explicit_, Integrator::implicit), testing::Bool(),
                                          testing::Bool()));

TEST_P(CompliantBase, wave_doubles_at_the_free_top_and_leaves_through_the_base) {
  const auto [integrator, shear, outcrop] = GetParam();
  if (integrator == Integrator::implicit && outcrop) GTEST_SKIP() << "the same force as of the upgoing wave";
  Scene scene(kYoung, 0.0, kDensity);
  scene.model.gravity = {0.0, 0.0};
  const BlockId block = scene.add("column", rectangle(0.0, 0.0, kWidth, kHeight));
  const Vec2 along = shear ? Vec2(1.0, 0.0) : Vec2(0.0, 1.0);
  scene.model.motions.push_back(pulse(along, outcrop ? 2.0 : 1.0));
  scene.model.viscous_edges.push_back({{block, {0, 0}, 0.0, 1.0}, MotionId{0}, outcrop ? 0.5 : 1.0});
  if (shear)
    for (double y = 0.0; y <= kHeight; y += 0.25)
      for (const double x : {0.0, kWidth}) scene.model.point_supports.push_back({block, {x, y}, false, true, 1e10});
  const double speed = std::sqrt(kYoung / (shear ? 2.0 * kDensity : kDensity)), travel = kHeight / speed;
  scene.model.monitors.push_back({"top", block, {0.5 * kWidth, kHeight}});
  scene.model.monitors.push_back({"middle", block, {0.5 * kWidth, 0.5 * kHeight}});
  Stage& stage = scene.stage("nmm", integrator, 2.0 * travel + 1.6 * kPulse, std::nullopt, 0.5);
  if (integrator == Integrator::implicit) stage.dt = 2e-5;
  scene.plan.output.history_every = ticks(2e-4);
  scene.plan.output.every = stage.duration;
  struct Look final : Sink {
    void history(const HistoryView& h) override {
      top = std::max(top, Vec2(h.velocity[0], h.velocity[1]).dot(along));
      middle = std::max(middle, h.time < middle_until ? Vec2(h.velocity[2], h.velocity[3]).dot(along) : 0.0);
      if (h.time > over)
        for (std::size_t k = 0; k < 4; k += 2)
          left = std::max(left, std::abs(Vec2(h.velocity[k], h.velocity[k + 1]).dot(along)));
    }
    Vec2 along;
    double top = 0.0, middle = 0.0, left = 0.0, over = 0.0, middle_until = 0.0;
  } look;
  look.along = along;
  look.middle_until = travel;
  look.over = 2.0 * travel + 1.2 * kPulse;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(look);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_NEAR(look.top / (2.0 * kSpeed), 1.0, 0.02);
  EXPECT_NEAR(look.middle / kSpeed, 1.0, 0.02);
  EXPECT_LT(look.left, 0.02 * kSpeed);
  const Ledger& ledger = run.state().ledger;
  EXPECT_LT(std::abs(ledger.closure()), 1e-9 * ledger.moved());
  // The incoming wave brings rho c v^2 per area and second; all of it has left again.
  const double brought = kDensity * speed * kSpeed * kSpeed * 0.375 * kPulse * kWidth;
  std::printf("top %.4f middle %.4f left %.5f of the upgoing wave; energy left %.2e of %.3f J\n", look.top / kSpeed,
              look.middle / kSpeed, look.left / kSpeed, ledger.held() / brought, brought);
  EXPECT_LT(ledger.held(), 4e-4 * 2.0 * brought);
}

}  // namespace
}  // namespace scree::test::compliant_base_test
