// Processing of records (baseline, taper, resampling): exact results where they exist, else the order of convergence.
#include "model/record_processing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace scree::record_processing_test {
namespace {

Samples sampled(const std::function<double(double)>& a, double from, double until, int steps) {
  Samples out;
  for (int i = 0; i <= steps; ++i) {
    out.time.push_back(from + (until - from) * i / steps);
    out.acceleration.push_back(a(out.time.back()));
  }
  return out;
}

/// A shock of 1 s with a nonzero final velocity.
double shock(double t) { return 3.0 * std::sin(20.0 * t) * std::sin(std::numbers::pi * t) + 0.2; }

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  EXPECT_EQ(a.size(), b.size());
  double largest = 0.0;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
  return largest;
}

MotionFacts facts_of(const Samples& s, Between between = Between::linear) {
  return GroundMotion(s.time, s.acceleration, {1.0, 0.0}, {0.0, between, ""}).facts();
}

double mean_square_velocity(const Samples& s, Between between) {
  const std::vector<double> v = integrate(s.time, s.acceleration, between).velocity;
  double sum = 0.0;
  for (std::size_t i = 1; i < v.size(); ++i)
    sum += 0.5 * (s.time[i] - s.time[i - 1]) * (v[i - 1] * v[i - 1] + v[i] * v[i]);
  return sum;
}

constexpr Baseline kDegrees[] = {Baseline::constant, Baseline::linear, Baseline::quadratic};
constexpr Between kBetween[] = {Between::linear, Between::constant};

double power(double t, int degree) { return degree == 0 ? 1.0 : degree == 1 ? t : t * t; }

TEST(Baseline, drift_of_its_degree_is_removed_to_round_off) {
  for (const Between between : kBetween)
    for (const Baseline degree : kDegrees) {
      const auto drift = [&](double t) {
        double sum = 0.0;
        for (int k = 0; k < static_cast<int>(degree); ++k) sum += (0.3 - 0.5 * k) * power(t - 4.0, k);
        return sum;
      };
      const Samples clean = sampled(shock, 5.0, 6.0, 200), drift_alone = sampled(drift, 5.0, 6.0, 200);
      Samples drifting = clean;
      for (std::size_t i = 0; i < clean.time.size(); ++i) drifting.acceleration[i] += drift_alone.acceleration[i];
      // 1e-13: a few hundred roundings of numbers of magnitude 3.
      EXPECT_LT(peak(correct_baseline(drift_alone, degree, between)), 1e-13);
      EXPECT_LT(largest_difference(correct_baseline(drifting, degree, between).acceleration,
                                   correct_baseline(clean, degree, between).acceleration),
                1e-13);
    }
}

TEST(Baseline, drift_above_its_degree_stays) {
  const Samples linear = sampled([](double t) { return t; }, 0.0, 1.0, 100);
  const Samples square = sampled([](double t) { return t * t; }, 0.0, 1.0, 100);
  EXPECT_GT(peak(correct_baseline(linear, Baseline::constant, Between::linear)), 0.1);
  EXPECT_GT(peak(correct_baseline(square, Baseline::linear, Between::linear)), 0.01);
}

TEST(Baseline, ground_ends_at_rest) {
  for (const Between between : kBetween)
    for (const Baseline degree : kDegrees) {
      const Samples s = correct_baseline(sampled(shock, 0.0, 1.0, 200), degree, between);
      EXPECT_NEAR(facts_of(s, between).final_velocity, 0.0, 1e-15);
    }
}

TEST(Baseline, of_the_constant_is_the_final_velocity_over_the_duration) {
  const Samples before = sampled(shock, 0.0, 1.0, 200);
  const Samples after = correct_baseline(before, Baseline::constant, Between::linear);
  const double expected = facts_of(before).final_velocity / 1.0;
  for (std::size_t i = 0; i < before.time.size(); ++i)
    EXPECT_NEAR(before.acceleration[i] - after.acceleration[i], expected, 1e-15);
}

// Any other polynomial of the same degree that also ends at rest gives a larger mean square velocity.
TEST(Baseline, mean_square_of_the_velocity_is_least) {
  const auto irregular = [](const std::function<double(double)>& a) {
    Samples s = sampled(a, 0.0, 1.0, 200);
    for (double& t : s.time) t += t * t;
    return s;
  };
  for (const Between between : kBetween)
    for (const Baseline degree : {Baseline::linear, Baseline::quadratic}) {
      const Samples best = correct_baseline(irregular(shock), degree, between);
      const double least = mean_square_velocity(best, between);
      for (int k = 1; k < static_cast<int>(degree); ++k)
        for (const double size : {-1e-2, 1e-2}) {
          Samples other = best, term = best;
          for (std::size_t i = 0; i < term.time.size(); ++i) term.acceleration[i] = power(term.time[i], k);
          term = correct_baseline(std::move(term), Baseline::constant, between);
          for (std::size_t i = 0; i < other.time.size(); ++i) other.acceleration[i] += size * term.acceleration[i];
          EXPECT_NEAR(facts_of(other, between).final_velocity, 0.0, 1e-15);
          EXPECT_GT(mean_square_velocity(other, between), least * (1.0 + 1e-9));
        }
    }
}

TEST(Baseline, works_on_irregular_and_far_away_times) {
  Samples s = sampled(shock, 0.0, 1.0, 100);
  for (double& t : s.time) t = 1000.0 + t * t + t;
  for (const Baseline degree : kDegrees) {
    Samples drifting = s;
    for (std::size_t i = 0; i < s.time.size(); ++i)
      drifting.acceleration[i] += 0.1 * power(s.time[i] - 1001.0, static_cast<int>(degree) - 1);
    // 1e-12: times near 1000 give the steps of 0.01 with an error of 1e-13, which the fit inherits.
    EXPECT_LT(largest_difference(correct_baseline(drifting, degree, Between::linear).acceleration,
                                 correct_baseline(s, degree, Between::linear).acceleration),
              1e-12);
  }
}

TEST(Taper, is_half_a_cosine_bell_at_either_end) {
  const Samples s = taper(sampled([](double) { return 2.0; }, 1.0, 5.0, 400), 1.0);
  const auto at = [&](double t) { return acceleration_at(s, t, Between::linear); };
  EXPECT_EQ(at(1.0), 0.0);
  EXPECT_NEAR(at(1.5), 1.0, 1e-13);
  EXPECT_NEAR(at(1.25), 1.0 - std::sqrt(0.5), 1e-13);
  EXPECT_EQ(at(2.0), 2.0);
  EXPECT_EQ(at(3.0), 2.0);
  EXPECT_EQ(at(4.0), 2.0);
  EXPECT_NEAR(at(4.75), 1.0 - std::sqrt(0.5), 1e-13);
  EXPECT_EQ(at(5.0), 0.0);
}

TEST(Taper, of_no_length_changes_nothing) {
  const Samples s = sampled(shock, 0.0, 1.0, 50);
  EXPECT_EQ(taper(s, 0.0).acceleration, s.acceleration);
}

TEST(Window, keeps_the_motion_between_its_ends) {
  for (const Between between : kBetween) {
    const Samples s = sampled(shock, 0.0, 1.0, 50);
    const Samples w = window(s, 0.213, 0.777, between);
    EXPECT_EQ(w.time.front(), 0.213);
    EXPECT_EQ(w.time.back(), 0.777);
    const GroundMotion whole(s.time, s.acceleration, {1.0, 0.0}, {0.0, between, ""});
    const GroundMotion part(w.time, w.acceleration, {1.0, 0.0}, {0.213, between, ""});
    for (double t = 0.22; t < 0.777; t += 0.01)
      EXPECT_NEAR(part.velocity(t).x(), whole.velocity(t).x() - whole.velocity(0.213).x(), 1e-14);
  }
}

TEST(Window, of_the_whole_record_is_the_record) {
  const Samples s = sampled(shock, 0.0, 1.0, 50), w = window(s, 0.0, 1.0, Between::linear);
  EXPECT_EQ(w.time, s.time);
  EXPECT_EQ(w.acceleration, s.acceleration);
}

TEST(Resample, finer_steps_keep_the_motion_exactly) {
  const Samples coarse = sampled(shock, 0.0, 1.0, 20), fine = resample(coarse, 0.05 / 7.0, Between::linear);
  ASSERT_EQ(fine.time.size(), 141u);
  const GroundMotion a(coarse.time, coarse.acceleration, {1.0, 0.0}), b(fine.time, fine.acceleration, {1.0, 0.0});
  for (double t = 0.0; t <= 1.5; t += 0.013) {
    EXPECT_NEAR(a.velocity(t).x(), b.velocity(t).x(), 1e-14);
    EXPECT_NEAR(a.displacement(t).x(), b.displacement(t).x(), 1e-14);
  }
}

TEST(Resample, converges_with_the_square_of_the_step) {
  // The shock is not used: its equal beginning and end make the h^2 term of the final displacement vanish.
  const Samples fine = sampled([](double t) { return std::exp(t) * std::sin(20.0 * t); }, 0.0, 1.0, 100000);
  const double exact = facts_of(fine).final_displacement;
  double last = 0.0;
  for (const double dt : {0.02, 0.01, 0.005, 0.0025}) {
    const double error = std::abs(facts_of(resample(fine, dt, Between::linear)).final_displacement - exact);
    if (last > 0.0) {
      EXPECT_NEAR(last / error, 4.0, 0.1);
    }  // ratio 4 for the h^2 term; the next term is h^4
    last = error;
  }
  EXPECT_LT(last, 1e-3 * std::abs(exact));
}

TEST(Resample, steps_divide_the_duration) {
  ASSERT_GT(0.28 / 0.01, 28.0);
  EXPECT_EQ(resample(sampled(shock, 0.0, 0.28, 10), 0.01, Between::linear).time.size(), 29u);
  const Samples s = sampled(shock, 0.0, 0.3, 10);
  const Samples uneven = resample(s, 0.07, Between::linear);
  ASSERT_EQ(uneven.time.size(), 6u);
  EXPECT_NEAR(uneven.time[1], 0.06, 1e-16);
  EXPECT_EQ(uneven.time.back(), s.time.back());
}

TEST(Process, does_nothing_unless_told) {
  const Samples s = sampled(shock, 0.0, 1.0, 50), out = process(s, {});
  EXPECT_EQ(out.time, s.time);
  EXPECT_EQ(out.acceleration, s.acceleration);
}

TEST(Process, scales_to_the_peak_wanted) {
  RecordProcessing how;
  how.pga = 1.7;
  how.baseline = Baseline::linear;
  how.taper = 0.1;
  EXPECT_NEAR(peak(process(sampled(shock, 0.0, 1.0, 200), how)), 1.7, 1e-15);
  how.pga = std::nullopt;
  how.scale = -2.0;
  const Samples twice = process(sampled(shock, 0.0, 1.0, 200), how);
  how.scale = 1.0;
  const Samples once = process(sampled(shock, 0.0, 1.0, 200), how);
  for (std::size_t i = 0; i < once.time.size(); ++i) EXPECT_EQ(twice.acceleration[i], -2.0 * once.acceleration[i]);
}

TEST(Process, ends_at_rest_after_taper_and_window_too) {
  for (const Between between : kBetween) {
    RecordProcessing how;
    how.from = 0.1;
    how.until = 0.87;
    how.resample = 0.003;
    how.taper = 0.2;
    how.baseline = Baseline::quadratic;
    how.pga = 4.0;
    how.between = between;
    const Samples s = process(sampled(shock, 0.0, 1.0, 200), how);
    EXPECT_EQ(s.time.front(), 0.1);
    EXPECT_NEAR(facts_of(s, between).final_velocity, 0.0, 1e-14);
  }
}

TEST(Process, impossible_settings_are_refused_by_name) {
  const Samples s = sampled(shock, 0.0, 1.0, 50);
  struct {
    const char* setting;
    std::function<void(RecordProcessing&)> set;
  } const wrong[] = {{"from", [](auto& h) { h.from = -0.1; }},
                     {"from", [](auto& h) { h.from = 1.0; }},
                     {"from", [](auto& h) { h.from = std::nan(""); }},
                     {"until", [](auto& h) { h.until = 1.1; }},
                     {"until", [](auto& h) { h.from = 0.5, h.until = 0.5; }},
                     {"until", [](auto& h) { h.until = std::nan(""); }},
                     {"resample", [](auto& h) { h.resample = 1.1; }},
                     {"resample", [](auto& h) { h.resample = 1e-8; }},
                     {"resample", [](auto& h) { h.resample = 0.0; }},
                     {"taper", [](auto& h) { h.taper = 0.51; }},
                     {"taper", [](auto& h) { h.taper = -0.1; }},
                     {"baseline", [](auto& h) { h.until = 0.06, h.from = 0.01, h.baseline = Baseline::quadratic; }}};
  for (const auto& w : wrong) {
    RecordProcessing how;
    w.set(how);
    try {
      (void)process(s, how);
      ADD_FAILURE() << w.setting << " is not refused";
    } catch (const ProcessingError& e) {
      EXPECT_STREQ(e.setting, w.setting);
      EXPECT_FALSE(e.problem.empty() || e.allowed.empty() || e.hint.empty());
    }
  }
}

TEST(Process, peak_of_nothing_is_refused) {
  RecordProcessing how;
  how.pga = 1.0;
  EXPECT_THROW((void)process({{0.0, 1.0}, {0.0, 0.0}}, how), ProcessingError);
  how.baseline = Baseline::linear;
  EXPECT_THROW((void)process(sampled([](double t) { return 3.0 + t; }, 0.0, 1.0, 100), how), ProcessingError);
}

}  // namespace
}  // namespace scree::record_processing_test
