// A recorded acceleration as a motion: exact at any time, independent of the time steps.
#include "model/ground_motion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace scree::ground_motion_test {
namespace {

/// Irregular times and accelerations in [-1, 1]. Times are multiples of 2^-20 s, so that their sums are exact.
struct Random {
  explicit Random(unsigned seed, std::size_t samples = 40) {
    std::mt19937 generator(seed);
    const auto uniform = [&generator] { return static_cast<double>(generator()) / 4294967296.0; };
    double t = -0.75;
    for (std::size_t i = 0; i < samples; ++i) {
      time.push_back(t);
      acceleration.push_back(2.0 * uniform() - 1.0);
      t += std::ldexp(std::floor(std::ldexp(0.01 + 0.1 * uniform(), 20)), -20);
    }
  }
  std::vector<double> time, acceleration;
};

TEST(GroundMotion, linear_acceleration_is_integrated_exactly_at_any_time) {
  const GroundMotion m({0.0, 1.0, 3.0}, {0.0, 2.0, -2.0}, {1.0, 0.0});  // a = 2t, then 4 - 2t
  EXPECT_NEAR(m.velocity(0.5).x(), 0.25, 1e-15);
  EXPECT_NEAR(m.displacement(0.5).x(), 0.125 / 3.0, 1e-15);
  EXPECT_NEAR(m.velocity(2.0).x(), 2.0, 1e-15);
  EXPECT_NEAR(m.velocity(3.0).x(), 1.0, 1e-15);
  EXPECT_NEAR(m.displacement(5.0).x(), m.displacement(3.0).x() + 2.0, 1e-14);
  EXPECT_EQ(m.displacement(-1.0).x(), 0.0);
}

// Simpson's rule is exact for the quadratic velocity and for the cubic displacement.
TEST(GroundMotion, velocity_and_displacement_are_the_integrals_within_every_step) {
  for (const Between between : {Between::linear, Between::constant}) {
    const Random r(7);
    const GroundMotion m(r.time, r.acceleration, {1.0, 0.0}, {r.time.front(), between, ""});
    for (std::size_t i = 0; i + 1 < r.time.size(); ++i)
      for (const double part : {0.1, 0.5, 0.9}) {
        const double t0 = r.time[i], h = part * (r.time[i + 1] - t0);
        const double inner = std::nextafter(t0 + h, t0);
        const auto simpson = [&](auto value) {
          return h / 6.0 * (value(t0) + 4.0 * value(t0 + h / 2.0) + value(inner));
        };
        EXPECT_NEAR(m.velocity(t0 + h).x() - m.velocity(t0).x(),
                    simpson([&](double t) { return m.acceleration(t).x(); }), 1e-14);
        EXPECT_NEAR(m.displacement(t0 + h).x() - m.displacement(t0).x(),
                    simpson([&](double t) { return m.velocity(t).x(); }), 1e-14);
      }
  }
}

TEST(GroundMotion, constant_pieces_follow_the_thesis) {
  const GroundMotion m({0.0, 1.0, 3.0}, {1.0, -2.0, 50.0}, {1.0, 0.0}, {0.0, Between::constant, ""});
  // v += a0 h, d += v h + a0 h^2/2; the last sample has no effect.
  EXPECT_DOUBLE_EQ(m.velocity(1.0).x(), 1.0);
  EXPECT_DOUBLE_EQ(m.displacement(1.0).x(), 0.5);
  EXPECT_DOUBLE_EQ(m.velocity(2.0).x(), -1.0);
  EXPECT_DOUBLE_EQ(m.displacement(2.0).x(), 0.5);
  EXPECT_DOUBLE_EQ(m.velocity(3.0).x(), -3.0);
  EXPECT_DOUBLE_EQ(m.acceleration(1.5).x(), -2.0);
}

TEST(GroundMotion, start_moves_the_whole_motion_in_time) {
  const Random r(3);
  const GroundMotion early(r.time, r.acceleration, {0.6, 0.8}, {0.0, Between::linear, ""});
  const GroundMotion late(r.time, r.acceleration, {0.6, 0.8}, {2.5, Between::linear, ""});
  EXPECT_EQ(late.velocity(std::nextafter(2.5, 0.0)).norm(), 0.0);
  for (double t = 0.0; t < 4.0; t += 0.03125) {  // sums of these times with 2.5 are exact, as is their difference
    EXPECT_EQ(late.displacement(t + 2.5), early.displacement(t));
    EXPECT_EQ(late.velocity(t + 2.5), early.velocity(t));
    EXPECT_EQ(late.acceleration(t + 2.5), early.acceleration(t));
  }
}

// The result does not depend on earlier evaluations at other times: the motion has no state.
TEST(GroundMotion, displacement_does_not_depend_on_the_time_steps) {
  const Random r(11);
  const GroundMotion m(r.time, r.acceleration, {1.0, 0.0}, {0.0, Between::linear, ""});
  const double end = 3.0;
  std::vector<double> ends;
  for (const int steps : {1, 7, 1000}) {
    double last = 0.0;
    for (int i = 1; i <= steps; ++i) last = m.displacement(end * i / steps).x();
    ends.push_back(last);
  }
  EXPECT_EQ(ends[0], ends[1]);
  EXPECT_EQ(ends[0], ends[2]);
}

TEST(GroundMotion, facts_of_a_triangle_are_those_by_hand) {
  // a from 2 to -2 in 1 s: v = 2t - 2t^2, largest 1/2 at the middle, zero at the end; d = 1 - 2/3.
  const MotionFacts f = GroundMotion({0.0, 1.0}, {2.0, -2.0}, {0.0, 1.0}).facts();
  EXPECT_DOUBLE_EQ(f.duration, 1.0);
  EXPECT_DOUBLE_EQ(f.pga, 2.0);
  EXPECT_DOUBLE_EQ(f.pgv, 0.5);
  EXPECT_DOUBLE_EQ(f.final_velocity, 0.0);
  EXPECT_DOUBLE_EQ(f.final_displacement, 1.0 / 3.0);
  EXPECT_DOUBLE_EQ(f.arias, std::numbers::pi / (2.0 * 9.80665) * 4.0);  // trapezoidal rule: both ends have a^2 = 4
}

TEST(GroundMotion, arias_of_a_sine_is_its_integral) {
  constexpr int kSteps = 1000;
  std::vector<double> time, a;
  for (int i = 0; i <= kSteps; ++i) {
    time.push_back(i * 0.01);
    a.push_back(3.0 * std::sin(2.0 * std::numbers::pi * time.back()));
  }
  // int_0^10 9 sin^2 = 45; the trapezoidal rule is exact for whole periods.
  EXPECT_NEAR(GroundMotion(time, a, {1.0, 0.0}).facts().arias, std::numbers::pi / (2.0 * 9.80665) * 45.0, 1e-11);
}

TEST(GroundMotion, samples_that_do_not_fit_are_refused) {
  EXPECT_THROW(GroundMotion({0.0}, {1.0}, {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(GroundMotion({0.0, 1.0}, {1.0}, {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(GroundMotion({0.0, 0.0}, {1.0, 1.0}, {1.0, 0.0}), std::invalid_argument);
  EXPECT_THROW(GroundMotion({0.0, std::nan("")}, {1.0, 1.0}, {1.0, 0.0}), std::invalid_argument);
}

}  // namespace
}  // namespace scree::ground_motion_test
