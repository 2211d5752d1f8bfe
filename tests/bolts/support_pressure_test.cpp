// The support pressure of a hole is released in steps: displacement of the wall against Lame for the same annulus.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "tests/support/circle.h"
#include "tests/support/schemes.h"

namespace scree::test::support_pressure_test {
namespace {

using namespace coupling;

constexpr double kIn = 1.0, kOut = 3.0, kStress = 2e6, kYoung = 2e9, kPoisson = 0.25;
constexpr int kCorners = 72;

TEST(SupportPressure, wall_moves_in_as_lame_says_at_every_part_released) {
  // In-situ stress -p everywhere, p on the outside, (1 - lambda) p on the wall:
  //   u(a) = -lambda p a (1 + nu)/E [(1 - 2 nu) a^2 + b^2]/(b^2 - a^2), plane strain.
  Scene scene(kYoung, kPoisson, 2600.0);
  scene.model.gravity = {0.0, 0.0};
  InitialStress in_situ;
  in_situ.stress = -kStress * Mat2::Identity();
  scene.model.materials[0].initial_stress = in_situ;
  const BlockId rock = scene.add("rock", {circle(kOut, kCorners, false), {circle(kIn, kCorners, true)}});
  // lambda = 0, 0.5 and 1 at the ends of the stages.
  TimeFunction release;
  release.name = "release";
  release.shape = TimeFunction::Shape::table;
  release.time = {0.0, 1.0, 2.0, 3.0, 4.0, 5.0};
  release.table = {1.0, 1.0, 0.5, 0.5, 0.0, 0.0};
  scene.model.functions.push_back(release);
  const Polygon& polygon = scene.model.blocks[0].polygon;
  for (std::int32_t ring = 0; ring < 2; ++ring)
    for (std::int32_t e = 0; e < kCorners; ++e) {
      const Ring& r = polygon.ring(static_cast<std::size_t>(ring));
      const auto i = static_cast<std::size_t>(e);
      const Vec2 d = (r[(i + 1) % r.size()] - r[i]).normalized();
      const Vec2 outward(d.y(), -d.x());
      scene.model.tractions.push_back(
          {{rock, {ring, e}, 0.0, 1.0}, -kStress * outward, ring == 0 ? FunctionId{} : FunctionId{0}});
    }
  // Supports without reaction: they prevent drift, and rotation under loads of fixed direction.
  scene.model.point_supports.push_back({rock, {-2.0, 0.0}, false, true, 1e9});
  scene.model.point_supports.push_back({rock, {2.0, 0.0}, false, true, 1e9});
  scene.model.point_supports.push_back({rock, {0.0, 2.0}, true, false, 1e9});
  for (int k = 0; k < 8; ++k) {
    const double angle = std::numbers::pi / 4.0 * k + 0.1;
    scene.model.monitors.push_back({"wall", rock, 1.0005 * kIn * Vec2(std::cos(angle), std::sin(angle))});
  }
  Stage& stage = scene.stage("nmm", Integrator::implicit, 5.0, 0.5, 0.09);
  stage.rest = true;
  scene.plan.output.history_every = ticks(1.0);
  scene.plan.output.every = ticks(5.0);
  struct Look final : Sink {
    void history(const HistoryView& h) override {
      double sum = 0.0;
      for (std::size_t k = 0; k < 8; ++k) {
        const Vec2 x(h.position[2 * k], h.position[2 * k + 1]), u(h.displacement[2 * k], h.displacement[2 * k + 1]);
        sum -= u.dot((x - u).normalized()) / 8.0;
      }
      inward.push_back(sum);
    }
    std::vector<double> inward;
  } look;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  ASSERT_EQ(look.inward.size(), 6U);
  const double whole = kStress * kIn * (1.0 + kPoisson) / kYoung * ((1.0 - 2.0 * kPoisson) * kIn * kIn + kOut * kOut) /
                       (kOut * kOut - kIn * kIn);
  std::printf("inward %.6f %.6f of %.6f m: %.4f %.4f of Lame\n", look.inward[3], look.inward[5], whole,
              look.inward[3] / (0.5 * whole), look.inward[5] / whole);
  EXPECT_LT(std::abs(look.inward[1]), 1e-3 * whole);
  EXPECT_NEAR(look.inward[3] / (0.5 * whole), 1.0, 0.01);
  EXPECT_NEAR(look.inward[5] / whole, 1.0, 0.01);
  EXPECT_LT(std::abs(run.state().ledger.closure()), 1e-9 * run.state().ledger.moved());
}

}  // namespace
}  // namespace scree::test::support_pressure_test
