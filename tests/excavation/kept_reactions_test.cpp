// A column under its weight: a compliant base replaces the block that held it, whose reaction is kept. The column must
// neither sink nor reflect waves at its base, and its top must have twice the upgoing velocity (theory of the rod).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/support/schemes.h"

namespace scree::test::kept_reactions_test {
namespace {

using namespace coupling;

constexpr double kYoung = 2e8, kDensity = 2000.0, kHeight = 16.0, kWidth = 1.0, kPulse = 0.05, kSpeed = 0.1;

/// Acceleration of a velocity pulse kSpeed sin^2(pi t/kPulse) upward, from the beginning of the second stage on.
GroundMotion pulse(double factor) {
  std::vector<double> t, a;
  for (int i = 0; i <= 1000; ++i) {
    t.push_back(kPulse * i / 1000.0);
    a.push_back(factor * kSpeed * std::numbers::pi / kPulse *
                std::sin(2.0 * std::numbers::pi * static_cast<double>(i) / 1000.0));
  }
  GroundMotion::Setting setting;
  setting.name = "pulse";
  setting.stage = StageId{1};
  return {t, a, Vec2(0.0, 1.0), setting};
}

/// With Poisson's ratio 0 a vertical motion between free sides is a pressure wave of speed sqrt(E/rho).
class KeptReactions : public testing::TestWithParam<Integrator> {
 protected:
  struct Found {
    double settled = 0.0, top = 0.0, left = 0.0, sunk = 0.0;  // of the top [m], [m/s], [m/s], [m]
  };
  struct Look final : Sink {
    void history(const HistoryView& h) override {
      const double v = h.velocity[1];
      if (h.time <= begin) {
        found.settled = h.displacement[1];
        return;
      }
      found.top = std::max(found.top, v);
      if (h.time > over) found.left = std::max(found.left, std::abs(v));
      found.sunk = found.settled - h.displacement[1];
    }
    double begin = 0.0, over = 0.0;
    Found found;
  };
  /// @param factor  scale of the pulse
  Found run(double factor) const {
    Scene scene(kYoung, 0.0, kDensity);
    scene.model.gravity = {0.0, -9.81};
    const BlockId bed = scene.add("bed", rectangle(-1.0, -1.0, kWidth + 1.0, 0.0), true);
    const BlockId column = scene.add("column", rectangle(0.0, 0.0, kWidth, kHeight));
    scene.model.motions.push_back(pulse(factor));
    scene.model.viscous_edges.push_back({{column, {0, 0}, 0.0, 1.0}, MotionId{0}, 1.0});
    scene.model.monitors.push_back({"top", column, {0.5 * kWidth, kHeight}});
    const double travel = kHeight / std::sqrt(kYoung / kDensity);
    Stage& rest = scene.stage("nmm", Integrator::implicit, 2.0, 0.1, 0.5);
    rest.rest = true;
    Stage& wave = scene.stage("nmm", GetParam(), 2.0 * travel + 1.6 * kPulse, std::nullopt, 0.5);
    if (GetParam() == Integrator::implicit) wave.dt = 5e-5;
    wave.construction.absent = {bed};
    wave.construction.release = 0.0;
    scene.plan.output.history_every = ticks(2e-4);
    scene.plan.output.every = wave.duration;
    Look look;
    look.begin = seconds(rest.duration) + 1e-9;
    look.over = look.begin + 2.0 * travel + 1.2 * kPulse;
    Driver driver(scene.model, scene.plan, methods());
    driver.add_sink(look);
    const RunEnd end = driver.run();
    EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
    const Ledger& ledger = driver.state().ledger;
    EXPECT_LT(std::abs(ledger.closure()), 1e-11 * ledger.moved());
    return look.found;
  }
};
INSTANTIATE_TEST_SUITE_P(Excavation, KeptReactions, testing::Values(Integrator::explicit_, Integrator::implicit));

TEST_P(KeptReactions, column_neither_sinks_nor_reflects_and_its_top_has_twice_the_upgoing_velocity) {
  const Found still = run(0.0), shaken = run(1.0);
  const double weight = kDensity * 9.81 * kHeight,  // on dashpots alone it sinks at weight over rho c
      sinks = weight / std::sqrt(kYoung * kDensity) * (2.0 * kHeight / std::sqrt(kYoung / kDensity) + 1.6 * kPulse);
  std::printf("sunk %.2e m of %.3f m on dashpots alone; top %.4f of the upgoing wave, left %.5f\n", still.sunk, sinks,
              shaken.top / kSpeed, shaken.left / kSpeed);
  EXPECT_LT(std::abs(still.sunk), 1e-6 * sinks);
  EXPECT_NEAR(shaken.top / (2.0 * kSpeed), 1.0, 0.02);
  EXPECT_LT(shaken.left, 0.02 * kSpeed);
}

}  // namespace
}  // namespace scree::test::kept_reactions_test
