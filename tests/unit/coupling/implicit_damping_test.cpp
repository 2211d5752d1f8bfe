// Numerical damping of implicit steps: the formula against stepped oscillators.
#include "coupling/stages/implicit_damping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coupling/bodies/clocks.h"

namespace scree::coupling::implicit_damping_test {
namespace {

/// Remaining fraction of an amplitude after one second of steps. Two solutions span an area of the phase plane
/// (u, v/w); every step reduces it by the same factor at any phase, the square of that of an amplitude.
double stepped(double frequency, double dt) {
  const double w = 2.0 * std::numbers::pi * frequency;
  double u[2] = {1.0, 0.0}, v[2] = {0.0, w}, left = 1.0;
  const int steps = static_cast<int>(std::lround(1.0 / dt));
  for (int n = 0; n < steps; ++n) {
    const double before = u[0] * v[1] - u[1] * v[0];
    for (int i = 0; i < 2; ++i) {
      const double next = (u[i] + dt * v[i]) / (1.0 + 0.5 * w * w * dt * dt);  // (2/dt^2 + w^2) d = ...: u' of (1/2, 1)
      v[i] = 2.0 * (next - u[i]) / dt - v[i];
      u[i] = next;
    }
    left *= std::sqrt((u[0] * v[1] - u[1] * v[0]) / before);
  }
  return left;
}

TEST(ImplicitDamping, formula_is_what_an_oscillator_loses) {
  for (const auto& [frequency, dt] : {std::pair(1.0, 1e-3), std::pair(5.0, 1e-3), std::pair(5.0, 1e-4),
                                      std::pair(20.0, 1e-3), std::pair(2.0, 0.01)}) {
    const NumericalDamping d = numerical_damping(frequency, dt);
    const double w = 2.0 * std::numbers::pi * frequency;
    EXPECT_NEAR((1.0 - d.per_second) / stepped(frequency, dt), 1.0, 1e-9) << frequency << " " << dt;
    EXPECT_NEAR(-std::log(1.0 - d.per_second), 0.25 * w * w * dt, 0.01 * 0.25 * w * w * dt + 0.1 * w * w * dt * w * dt);
    EXPECT_NEAR(std::pow(1.0 - d.per_period, frequency), 1.0 - d.per_second, 1e-12);
  }
}

TEST(ImplicitDamping, step_that_damps_does) {
  for (const double frequency : {0.5, 5.0, 300.0})
    EXPECT_NEAR(numerical_damping(frequency, step_that_damps(frequency, 0.05)).per_second, 0.05,
                1e-8);  // round-off of r^(1/dt)
}

TEST(ImplicitDamping, stage_tells_driven_frequency_and_ten_covers_and_when_it_is_much) {
  Model model;
  model.materials.push_back({"rock", 2500.0, 1e10, 0.0});
  Block block;
  block.polygon = {{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};
  block.material = MaterialId{0};
  model.blocks.push_back(block);
  Stage stage;
  stage.method = "nmm";
  stage.integrator = Integrator::implicit;
  stage.cover_size = 1.0;
  stage.dt = 1e-3;
  ASSERT_TRUE(stage_damping(model, stage).has_value());
  EXPECT_FALSE(stage_damping(model, stage)->driven.has_value());
  EXPECT_NEAR(stage_damping(model, stage)->wave->frequency, 200.0, 1e-9);  // 2000 m/s over ten covers
  EXPECT_FALSE(damps_much(*stage_damping(model, stage)));                  // no driven frequency, no divided block
  TimeFunction swing;
  swing.name = "swing";
  swing.shape = TimeFunction::Shape::sine;
  swing.frequency = 5.0;
  model.functions.push_back(swing);
  model.body_accelerations.push_back({{}, Vec2(1.0, 0.0), FunctionId{0}});
  EXPECT_TRUE(damps_much(*stage_damping(model, stage)));  // 22 % per second
  stage.dt = 1e-4;
  EXPECT_FALSE(damps_much(*stage_damping(model, stage)));  // 2.4 %
  stage.integrator = Integrator::partitioned;
  stage.partition.explicit_region = {{0, 0}, {5, 0}, {5, 10}, {0, 10}};
  EXPECT_TRUE(damps_much(*stage_damping(model, stage)));  // waves cross its border
  stage.rest = true;
  EXPECT_FALSE(stage_damping(model, stage).has_value());
}

TEST(ImplicitDamping, record_of_a_sine_drives_with_its_frequency) {
  Model model;
  std::vector<double> t, a;
  for (int i = 0; i <= 1000; ++i) {
    t.push_back(0.01 * i);
    a.push_back(std::sin(2.0 * std::numbers::pi * 3.0 * t.back()));
  }
  model.motions.emplace_back(t, a, Vec2(1.0, 0.0));
  model.block_supports.push_back({BlockId{0}, MotionId{0}});
  EXPECT_NEAR(driven_frequency(model), 3.0, 0.2);
  Model compliant = model;  // the motion enters as a wave through a compliant base
  compliant.block_supports.clear();
  compliant.viscous_edges.push_back({{BlockId{0}, {0, 0}, 0.0, 1.0}, MotionId{0}, 1.0});
  EXPECT_EQ(driven_frequency(compliant), driven_frequency(model));
  EXPECT_EQ(driven_frequency(compliant, std::vector<char>{0}), 0.0);
  compliant.viscous_edges[0].motion = {};
  EXPECT_EQ(driven_frequency(compliant), 0.0);
}

TEST(ImplicitDamping, what_is_over_or_to_come_does_not_drive_a_stage) {
  Model model;
  TimeFunction pulse;
  pulse.name = "pulse";
  pulse.shape = TimeFunction::Shape::half_sine;
  pulse.duration = 0.1;  // 5 Hz
  pulse.stage = StageId{1};
  model.functions.push_back(pulse);
  model.body_accelerations.push_back({{}, Vec2(1.0, 0.0), FunctionId{0}});
  Plan plan;
  for (int i = 0; i < 4; ++i) plan.stages.emplace_back().duration = ticks(0.05);
  const double expected[] = {0.0, 5.0, 5.0, 0.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::vector<char> acts = acts_in(model, plan, i);
    EXPECT_EQ(driven_frequency(model, acts), expected[i]) << i;
  }
  // The second stage ended early, for example by a rule: the pulse continues into the last.
  const std::vector<Tick> begins{0, ticks(0.05), ticks(0.07), ticks(0.12)};
  EXPECT_EQ(driven_frequency(model, acts_in(model, plan, 3, begins, ticks(0.17))), 5.0);
}

}  // namespace
}  // namespace scree::coupling::implicit_damping_test
