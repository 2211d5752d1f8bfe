// Damped oscillators compared with their closed solutions, and a wave that leaves a bar through a viscous edge.
#include <gtest/gtest.h>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::explicit_damping_test {
namespace {

using namespace coupling;

/// A block on two upright springs: it oscillates at omega = sqrt(2 k/m). Its initial velocity is upward.
struct Bobbing {
  static constexpr double kMass = 2000.0, kSpring = 1e5, kSpeed = 0.05;
  Scene scene{1e10, 0.2, kMass};
  double omega = std::sqrt(2.0 * kSpring / kMass);
  Bobbing() {
    scene.model.gravity = {0.0, 0.0};
    const BlockId id = scene.add("block", rectangle(0, 0, 1, 1));
    for (const double x : {0.0, 1.0}) scene.model.point_supports.push_back({id, {x, 0.5}, false, true, kSpring});
    scene.model.initial_velocities.push_back({id, {0.0, kSpeed}, 0.0});
    scene.model.monitors.push_back({"centre", id, {0.5, 0.5}});
  }
  struct Peaks final : Sink {
    std::vector<double> peak;  // largest |y| between crossings
    double sign = 1.0, largest = 0.0;
    void history(const HistoryView& h) override {
      const double y = h.displacement[1];
      if (y * sign < 0.0) {
        peak.push_back(largest);
        largest = 0.0;
        sign = -sign;
      }
      largest = std::max(largest, std::abs(y));
    }
  };
  /// Peaks of the first half cycles.
  std::vector<double> peaks(const std::string& method, const ExplicitDamping& damping) {
    const double period = 2.0 * std::numbers::pi / omega;
    Stage& s = scene.stage(method, Integrator::explicit_, 5.0 * period, std::nullopt, 0.5);
    s.damping = damping.mass;
    s.damp_rigid_motion = damping.rigid;
    s.stiffness_damping = damping.stiffness;
    s.local_damping = damping.local;
    scene.plan.output.history_every = ticks(period / 2000.0);
    Driver run(scene.model, scene.plan, methods());
    Peaks peaks;
    run.add_sink(peaks);
    EXPECT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-11);
    return peaks.peak;
  }
};

class Oscillator : public testing::TestWithParam<const char*> {};

TEST_P(Oscillator, mass_damping_of_all_motion_decays_by_half_its_rate) {
  Bobbing b;
  const double xi = 0.05, rate = 2.0 * xi * b.omega;
  const std::vector<double> peaks = b.peaks(GetParam(), {.mass = rate, .rigid = true});
  ASSERT_GE(peaks.size(), 8U);
  const double decrement = std::log(peaks[0] / peaks[6]) / 3.0;  // over three whole cycles
  EXPECT_NEAR(decrement / (2.0 * std::numbers::pi * xi / std::sqrt(1.0 - xi * xi)), 1.0, 1e-4);
}

TEST_P(Oscillator, mass_damping_that_spares_rigid_motion_and_rayleigh_damping_leave_it_alone) {
  for (const ExplicitDamping& damping : {ExplicitDamping{.mass = 5.0}, ExplicitDamping{.stiffness = 1e-6}}) {
    Bobbing b;
    if (damping.stiffness > 0.0 && std::string(GetParam()) == "nmm") continue;
    const std::vector<double> peaks = b.peaks(GetParam(), damping);
    ASSERT_GE(peaks.size(), 8U);
    // Only the deformation of the block itself is damped, 2 k/E of the amplitude.
    EXPECT_NEAR(peaks[6] / peaks[0], 1.0, 1e-4);
  }
}

TEST_P(Oscillator, local_damping_takes_the_same_share_of_every_half_cycle) {
  // The block accelerates by 1 - alpha of the force and decelerates by 1 + alpha: A'^2 (1 + alpha) = A^2 (1 - alpha).
  Bobbing b;
  const double alpha = 0.1;
  const std::vector<double> peaks = b.peaks(GetParam(), {.local = alpha});
  ASSERT_GE(peaks.size(), 8U);
  EXPECT_NEAR(peaks[0], Bobbing::kSpeed / (b.omega * std::sqrt(1.0 + alpha)), 1e-3 * peaks[0]);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(peaks[i + 1] / peaks[i], std::sqrt((1.0 - alpha) / (1.0 + alpha)), 2e-3) << i;
}
INSTANTIATE_TEST_SUITE_P(methods, Oscillator, testing::Values("nmm", "dda"));

TEST(Rayleigh, stretching_block_decays_by_half_rate_times_omega_squared) {
  // A free DDA block with nu = 0 stretches along x alone: U'' + omega^2 (U - 1) = 0, omega^2 = 12 E/(rho L^2).
  Scene scene(1e8, 0.0, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0, 0, 2, 1));
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  ByHand hand(scene.model, scene.plan.stages[0]);
  Mat2 stretch = Mat2::Zero();
  stretch(0, 0) = 1e-3;
  hand.move(0, {0.0, 0.0}, stretch);
  const double omega = std::sqrt(12.0 * 1e8 / (2000.0 * 4.0)), xi = 0.05, rate = 2.0 * xi / omega;
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05, {.stiffness = rate});
  integrator.enter(hand.state);
  const int steps = 20000;  // a period
  const double period = 2.0 * std::numbers::pi / omega;
  const Tick h = ticks(period / steps);
  const double damped = omega * std::sqrt(1.0 - xi * xi);
  for (int i = 0; i < 2 * steps; ++i) {
    ASSERT_EQ(integrator.step(hand.state, h).status, StepReport::Status::ok);
    if (i % 500 != 0) continue;
    const double t = seconds(hand.state.time);
    EXPECT_NEAR(hand.state.q[2] - 1.0, 1e-3 / damped * std::exp(-xi * omega * t) * std::sin(damped * t),
                1e-3 / omega * 1e-3);
  }
  integrator.update_ledger(hand.state);
  EXPECT_LT(hand.state.ledger.relative_closure(), 1e-12);
  EXPECT_NEAR(hand.state.ledger[Column::stiffness_damping] / (0.5 * 4000.0 / 3.0 * 1e-6),
              1.0 - std::exp(-4.0 * std::numbers::pi * 2.0 * xi), 1e-2);
}

/// Energy in a bar at a time when a pulse should have left it at the far end, as a fraction of the work of the load.
double left_in_bar(bool viscous) {
  Scene scene(1e9, 0.0, 2500.0);  // nu = 0: plane waves travel at sqrt(E/rho)
  scene.model.gravity = {0.0, 0.0};
  const double length = 8.0, height = 0.5, c = std::sqrt(1e9 / 2500.0), pulse = 2.5 / c;
  const BlockId id = scene.add("bar", rectangle(0, 0, length, height));
  TimeFunction f;
  f.shape = TimeFunction::Shape::sine_squared;
  f.duration = pulse;
  scene.model.functions.push_back(f);
  scene.model.tractions.push_back({{id, {0, 3}, 0.0, 1.0}, Vec2(1e4, 0.0), FunctionId{0}});
  if (viscous) scene.model.viscous_edges.push_back({{id, {0, 1}, 0.0, 1.0}});
  scene.stage("nmm", Integrator::explicit_, pulse + 1.3 * length / c, std::nullopt, 0.125);
  Driver run(scene.model, scene.plan, methods());
  EXPECT_EQ(run.run().status, RunEnd::Status::done);
  const Ledger& ledger = run.state().ledger;
  EXPECT_LT(ledger.relative_closure(), 1e-11);
  EXPECT_GT(ledger[Column::loads], 0.01);
  EXPECT_EQ(ledger[Column::viscous_edges] > 0.0, viscous);
  // The impulse of the pulse is not zero and makes the bar drift; a plane wave carries that energy away, too.
  return ledger.energy() / ledger[Column::loads];
}

TEST(ViscousEdge, takes_a_pressure_wave_out_of_a_bar) {
  const double with = left_in_bar(true), without = left_in_bar(false);
  std::printf("pressure wave: %.2e of its energy left with a viscous edge, %.3f without\n", with, without);
  EXPECT_LT(with, 0.01);
  EXPECT_GT(without, 0.99);
}

}  // namespace
}  // namespace scree::test::explicit_damping_test
