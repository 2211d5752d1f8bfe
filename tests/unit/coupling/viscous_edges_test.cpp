// Edges that absorb waves: the impedance of the rock, rho c_p across an edge and rho c_s along it.
#include "coupling/integrate/viscous_edges.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::viscous_edges_test {
namespace {

using namespace coupling;

constexpr double kYoung = 2e8, kPoisson = 0.25, kDensity = 2400.0;
// Plane strain: c_p^2 = E (1 - nu)/(rho (1 + nu)(1 - 2 nu)), c_s^2 = E/(2 rho (1 + nu)).
const double kPressure =
    kDensity * std::sqrt(kYoung * (1.0 - kPoisson) / (kDensity * (1.0 + kPoisson) * (1.0 - 2.0 * kPoisson)));
const double kShear = kDensity * std::sqrt(kYoung / (2.0 * kDensity * (1.0 + kPoisson)));

Scene block(const char* method, double width, double height, double turn = 0.0) {
  Scene scene(kYoung, kPoisson, kDensity);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", transformed(rectangle(0.0, 0.0, width, height), Vec2(0.0, 0.0), rotation(turn)));
  scene.stage(method, Integrator::explicit_, 1.0, std::nullopt, 0.5);
  return scene;
}

class ViscousEdge : public testing::TestWithParam<const char*> {};

TEST_P(ViscousEdge, resists_with_the_impedance_of_pressure_waves_across_and_of_shear_waves_along) {
  const double length = 1.3, turn = 0.4;
  Scene scene = block(GetParam(), 2.0, length, turn);
  scene.model.viscous_edges.push_back({{BlockId{0}, {0, 1}, 0.0, 1.0}});  // its right side
  ByHand hand(scene.model, scene.plan.stages[0]);
  const Vec2 across = rotation(turn) * Vec2(1.0, 0.0), along = rotation(turn) * Vec2(0.0, 1.0);
  for (const auto& [direction, impedance] : {std::pair(across, kPressure), std::pair(along, kShear)}) {
    hand.move(0, 0.02 * direction, Mat2::Zero());
    ViscousEdges edges(*hand.setup, dashpots(*hand.setup, hand.state));
    std::vector<double> f(hand.state.q.size(), 0.0);
    edges.add({hand.state.q, hand.state.v, 0.0}, f);
    Vec2 sum(0.0, 0.0);
    const auto t = hand.setup->pool(0).translation(0);
    for (std::size_t k = 0; k < t.size(); ++k) sum += t[k] * Vec2(f[2 * k], f[2 * k + 1]);
    EXPECT_NEAR((sum + 0.02 * impedance * length * direction).norm(), 0.0, 1e-9 * impedance);
  }
}
INSTANTIATE_TEST_SUITE_P(methods, ViscousEdge, testing::Values("nmm", "dda"));

/// Dashpots all around a flying affine block exert a uniform drag and cause no strain: v' = -r v with
/// r = 2 (Z_p H + Z_s W)/m, by explicit and by implicit steps.
TEST(ViscousEdges, all_around_slow_a_flying_block_down_exponentially) {
  const double W = 2.0, H = 0.7, rate = 2.0 * (kPressure * H + kShear * W) / (kDensity * W * H), time = 0.7 / rate;
  for (const Integrator integrator : {Integrator::explicit_, Integrator::implicit}) {
    Scene scene = block("dda", W, H);
    for (std::int32_t e = 0; e < 4; ++e) scene.model.viscous_edges.push_back({{BlockId{0}, {0, e}, 0.0, 1.0}});
    scene.model.initial_velocities.push_back({BlockId{0}, {0.1, 0.0}, 0.0});
    Stage& stage = scene.plan.stages[0];
    stage.integrator = integrator;
    stage.dt = time / 500.0;
    stage.duration = ticks(time);
    scene.plan.output.every = scene.plan.output.history_every = stage.duration;
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_NEAR(totals_of(run, BlockId{0}).momentum.x() / (kDensity * W * H * 0.1), std::exp(-0.7), 2e-3);
    const double left = std::exp(-1.4), taken = 0.5 * kDensity * W * H * 0.01 * (1.0 - left);
    EXPECT_NEAR(run.state().ledger[Column::viscous_edges] / taken, 1.0, 5e-3);
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  }
}

}  // namespace
}  // namespace scree::test::viscous_edges_test
