// Histories of loads: values, ends, and areas under the curves.
#include "model/time_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace scree::time_function_test {
namespace {

using Shape = TimeFunction::Shape;
constexpr double kPi = std::numbers::pi;

TimeFunction made(Shape shape, double amplitude, double start, double duration, double frequency = 0.0) {
  TimeFunction f;
  f.shape = shape, f.amplitude = amplitude, f.start = start, f.duration = duration, f.frequency = frequency;
  return f;
}

TimeFunction table(std::vector<double> time, std::vector<double> value, double amplitude = 1.0, double start = 0.0) {
  TimeFunction f = made(Shape::table, amplitude, start, 0.0);
  f.time = std::move(time), f.table = std::move(value);
  return f;
}

/// Area under f between two times, by Simpson's rule in equal steps.
double area(const TimeFunction& f, double from, double to, int steps) {
  const double h = (to - from) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double t = from + h * i;
    sum += f.value(t) + 4.0 * f.value(t + 0.5 * h) + f.value(t + h);
  }
  return sum * h / 6.0;
}

TEST(TimeFunction, every_shape_is_zero_before_its_start) {
  const double start = 0.25, before = std::nextafter(start, 0.0);
  for (const Shape shape : {Shape::constant, Shape::ramp, Shape::sine, Shape::half_sine, Shape::sine_squared}) {
    const TimeFunction f = made(shape, 3.0, start, 0.5, 2.0);
    EXPECT_EQ(f.value(before), 0.0) << static_cast<int>(shape);
    EXPECT_EQ(f.value(-1e9), 0.0) << static_cast<int>(shape);
    EXPECT_NE(f.value(start + 0.1), 0.0) << static_cast<int>(shape);
  }
  EXPECT_EQ(table({0.0, 1.0}, {5.0, 6.0}, 1.0, start).value(before), 0.0);
}

TEST(TimeFunction, constant_holds_from_its_start_on) {
  const TimeFunction f = made(Shape::constant, -2.5, 0.25, 0.0);
  for (const double t : {0.25, 0.3, 1e6}) EXPECT_EQ(f.value(t), -2.5);
}

TEST(TimeFunction, ramp_rises_straight_and_stays) {
  const TimeFunction f = made(Shape::ramp, 4.0, 0.5, 2.0);
  EXPECT_EQ(f.value(0.5), 0.0);
  EXPECT_EQ(f.value(1.0), 1.0);  // exact: all are binary fractions
  EXPECT_EQ(f.value(2.0), 3.0);
  EXPECT_EQ(f.value(2.5), 4.0);
  EXPECT_EQ(f.value(1e6), 4.0);
  EXPECT_NEAR(f.value(std::nextafter(2.5, 0.0)), 4.0, 1e-14);  // no jump at the end
}

TEST(TimeFunction, sine_runs_on_without_a_duration_and_stops_after_one) {
  const TimeFunction on = made(Shape::sine, 2.0, 0.1, 0.0, 5.0), pulse = made(Shape::sine, 2.0, 0.1, 0.2, 5.0);
  EXPECT_EQ(on.value(0.1), 0.0);
  EXPECT_NEAR(on.value(0.15), 2.0, 1e-14);   // a quarter of the period of 0.2 s
  EXPECT_NEAR(on.value(0.25), -2.0, 1e-14);  // three quarters
  EXPECT_NEAR(on.value(100.15), 2.0, 1e-11);
  EXPECT_EQ(pulse.value(0.15), on.value(0.15));
  EXPECT_EQ(pulse.value(0.35), 0.0);
  EXPECT_NE(on.value(0.35), 0.0);
}

TEST(TimeFunction, pulses_peak_in_the_middle_are_symmetric_and_end) {
  for (const Shape shape : {Shape::half_sine, Shape::sine_squared}) {
    const TimeFunction f = made(shape, 3.0, 1.0, 0.5);
    EXPECT_EQ(f.value(1.0), 0.0);
    EXPECT_NEAR(f.value(1.25), 3.0, 1e-15);
    EXPECT_EQ(f.value(1.5), 0.0);
    EXPECT_EQ(f.value(7.0), 0.0);
    for (const double s : {0.03125, 0.125, 0.1875}) EXPECT_NEAR(f.value(1.0 + s), f.value(1.5 - s), 1e-14);
  }
  EXPECT_NEAR(made(Shape::half_sine, 1.0, 0.0, 1.0).value(1.0 / 6.0), 0.5, 1e-15);
  EXPECT_NEAR(made(Shape::sine_squared, 1.0, 0.0, 1.0).value(1.0 / 6.0), 0.25, 1e-15);
}

// The slope of sine_squared vanishes at both ends, that of half_sine is pi/duration.
TEST(TimeFunction, sine_squared_begins_and_ends_smoothly) {
  constexpr double kHair = 1e-6;
  const TimeFunction smooth = made(Shape::sine_squared, 1.0, 0.0, 1.0), kinked = made(Shape::half_sine, 1.0, 0.0, 1.0);
  EXPECT_LT(smooth.value(kHair) / kHair, 2.0 * kPi * kPi * kHair);
  EXPECT_LT(smooth.value(1.0 - kHair) / kHair, 2.0 * kPi * kPi * kHair);
  EXPECT_NEAR(kinked.value(kHair) / kHair, kPi, 1e-9);
}

TEST(TimeFunction, table_is_straight_between_points_and_keeps_its_last_value) {
  const TimeFunction f = table({0.5, 1.0, 3.0}, {2.0, -2.0, 6.0}, 0.5, 10.0);
  EXPECT_EQ(f.value(10.25), 0.0);  // before the first point
  EXPECT_EQ(f.value(10.5), 1.0);
  EXPECT_EQ(f.value(10.75), 0.0);
  EXPECT_EQ(f.value(11.0), -1.0);
  EXPECT_EQ(f.value(12.0), 1.0);
  EXPECT_EQ(f.value(13.0), 3.0);
  EXPECT_EQ(f.value(1e6), 3.0);
}

TEST(TimeFunction, table_holds_its_points_exactly) {
  std::vector<double> time, value;
  for (int i = 0; i < 200; ++i) {
    time.push_back(0.01 * i * (1.0 + 0.001 * i));
    value.push_back(std::cos(7.0 * i));
  }
  const TimeFunction f = table(time, value);
  for (std::size_t i = 0; i < time.size(); ++i) EXPECT_EQ(f.value(time[i]), value[i]) << i;
}

// Reference: formulas of the areas. Simpson's rule is exact for straight lines with kinks at its steps and of fourth
// order for the sines: the error with 1000 steps is below 1e-12 of the area.
TEST(TimeFunction, areas_are_those_of_the_formulas) {
  const double amplitude = 3.0, duration = 0.8, start = 0.2;
  const auto whole = [&](Shape shape, double frequency = 0.0) {
    return area(made(shape, amplitude, start, duration, frequency), start, start + duration, 1000);
  };
  const double unit = amplitude * duration;
  EXPECT_NEAR(whole(Shape::constant), unit, 1e-12);
  EXPECT_NEAR(whole(Shape::ramp), unit / 2.0, 1e-12);
  EXPECT_NEAR(whole(Shape::half_sine), unit * 2.0 / kPi, 1e-11);
  EXPECT_NEAR(whole(Shape::sine_squared), unit / 2.0, 1e-11);
  const double frequency = 1.7, turn = 2.0 * kPi * frequency;
  EXPECT_NEAR(whole(Shape::sine, frequency), amplitude * (1.0 - std::cos(turn * duration)) / turn, 1e-11);
  EXPECT_NEAR(area(table({0.0, 0.25, 1.0}, {0.0, 4.0, 2.0}, 0.5), 0.0, 2.0, 800), 0.5 * (0.5 + 2.25 + 2.0), 1e-12);
}

TEST(TimeFunction, amplitude_scales_and_start_shifts) {
  for (const Shape shape : {Shape::constant, Shape::ramp, Shape::sine, Shape::half_sine, Shape::sine_squared}) {
    const TimeFunction one = made(shape, 1.0, 0.0, 0.5, 3.0), other = made(shape, -4.0, 0.25, 0.5, 3.0);
    for (const double s : {0.0625, 0.25, 0.4375, 0.75}) EXPECT_EQ(other.value(0.25 + s), -4.0 * one.value(s));
  }
}

}  // namespace
}  // namespace scree::time_function_test
