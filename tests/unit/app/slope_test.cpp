// The classical numbers against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/slope/slope_report.h"
#include "io/case/case_error.h"
#include "tests/unit/app/folder.h"

namespace scree::app::slope_test {
namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180.0, kG = kStandardGravity;

/// Straight lines between values of a function at equal steps.
template <class Function>
Samples sampled(double duration, std::size_t steps, Function f) {
  Samples s;
  for (std::size_t i = 0; i <= steps; ++i) {
    const double t = duration * static_cast<double>(i) / static_cast<double>(steps);
    s.time.push_back(t);
    s.acceleration.push_back(f(t));
  }
  return s;
}

/// Displacement of Newmark's block under one cycle of A sin w t: slip from w t1 = asin(a_c/A) until the velocity,
///   v = A/w (cos w t1 - cos w t) - a_c (t - t1), is back at zero; d its integral.   [mm]
double sine_slide(double amplitude, double yield, double frequency) {
  const double w = 2.0 * kPi * frequency, t1 = std::asin(yield / amplitude) / w;
  const auto v = [&](double t) { return amplitude / w * (std::cos(w * t1) - std::cos(w * t)) - yield * (t - t1); };
  double low = (kPi - w * t1) / w, high = t1 + 1.0 / frequency;  // v is largest at the first
  for (int i = 0; i < 200; ++i) (v(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  const double t2 = low, s = t2 - t1;
  return 1e3 *
         (amplitude / w * (std::cos(w * t1) * s - (std::sin(w * t2) - std::sin(w * t1)) / w) - 0.5 * yield * s * s);
}

TEST(SlidingBlock, a_cycle_of_a_sine_is_the_closed_form) {
  // g = 9.80665, 1 Hz, 0.5 g: the figures of the case library's specification.
  for (const auto& [yield, millimetres] : {std::pair{0.1, 445.572}, {0.25, 157.211}, {0.4, 23.3246}}) {
    EXPECT_NEAR(sine_slide(0.5 * kG, yield * kG, 1.0), millimetres, 1e-5 * millimetres);
    const auto sine = [](double t) { return 0.5 * kG * std::sin(2.0 * kPi * t); };
    const BlockSlide slide =
        slide_of(sampled(2.0, 40000, [&](double t) { return t <= 1.0 ? sine(t) : 0.0; }), yield * kG);
    EXPECT_NEAR(1e3 * slide.displacement, millimetres, 2e-6 * millimetres + 1e-5);
    EXPECT_EQ(slide.slips, 1);
  }
}

TEST(SlidingBlock, error_falls_with_the_square_of_the_step) {
  const auto error = [](std::size_t steps) {
    const Samples s = sampled(1.5, steps, [](double t) { return t <= 1.0 ? 0.5 * kG * std::sin(2.0 * kPi * t) : 0.0; });
    return std::abs(1e3 * slide_of(s, 0.25 * kG).displacement - sine_slide(0.5 * kG, 0.25 * kG, 1.0));
  };
  const double order = std::log2(error(300) / error(600));
  EXPECT_NEAR(order, 2.0, 0.2);
}

TEST(SlidingBlock, a_rectangular_pulse_is_exact) {
  // a for T, then nothing: d = (a - a_c) T^2/2 + v^2/(2 a_c), v = (a - a_c) T; the flanks have no width to speak of.
  const double a = 5.0, a_c = 2.0, T = 0.7, v = (a - a_c) * T, e = 1e-12;
  const Samples pulse{{0.0, 1.0, 1.0 + e, 1.0 + T, 1.0 + T + e, 4.0}, {0.0, 0.0, a, a, 0.0, 0.0}};
  const BlockSlide slide = slide_of(pulse, a_c);
  EXPECT_NEAR(slide.displacement, 0.5 * (a - a_c) * T * T + 0.5 * v * v / a_c, 1e-10);
  EXPECT_NEAR(slide.peak_velocity, v, 1e-10);
  EXPECT_EQ(slide.slips, 1);
  const Samples cut{{0.0, e, T}, {0.0, a, a}};  // the record ends while it slides
  EXPECT_NEAR(slide_of(cut, a_c).displacement, slide.displacement, 1e-10);
  EXPECT_EQ(slide_of(reversed(pulse), a_c).displacement, 0.0);
  EXPECT_NEAR(slide_of(pulse, a_c, 1.3).displacement, 1.3 * slide.displacement, 1e-10);  // linear in the excess
  EXPECT_THROW((void)slide_of(pulse, 0.0), std::invalid_argument);
}

TEST(Jibson2007, equations_by_hand) {
  const std::vector<RegressionResult> r = jibson_2007({0.1, 0.4, 6.9, 2.0});
  ASSERT_EQ(r.size(), 4U);
  // r = 0.25: log 0.75 = -0.124939, log 0.25 = -0.602060, log 2 = 0.301030
  EXPECT_NEAR(std::log10(r[0].median), 0.215 - 2.341 * 0.1249387 + 1.438 * 0.6020600, 1e-6);
  EXPECT_NEAR(std::log10(r[1].median), -2.710 - 2.335 * 0.1249387 + 1.478 * 0.6020600 + 0.424 * 6.9, 1e-6);
  EXPECT_NEAR(std::log10(r[2].median), 0.561 * 0.3010300 + 3.833 * 0.6020600 - 1.474, 1e-6);
  EXPECT_NEAR(std::log10(r[3].median), 2.401 * 0.3010300 + 3.481 - 3.230, 1e-6);
  const double sigma[] = {0.510, 0.454, 0.616, 0.656};
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(r[i].equation, static_cast<int>(i) + 6);
    EXPECT_EQ(r[i].sigma, sigma[i]);
    EXPECT_NEAR(r[i].upper / r[i].median, std::pow(10.0, sigma[i]), 1e-9);
    EXPECT_EQ(r[i].outside, "");
  }
}

TEST(Jibson2007, says_where_it_is_beyond_its_data) {
  const std::vector<RegressionResult> weak = jibson_2007({0.5, 0.4, 8.1, 2.0});
  ASSERT_EQ(weak.size(), 4U);
  EXPECT_EQ(weak[0].median, 0.0);
  EXPECT_NE(weak[0].outside.find("does not slide"), std::string::npos);
  EXPECT_NE(weak[1].outside.find("M = 8.1"), std::string::npos);
  EXPECT_NE(weak[3].outside.find("a_c = 0.5"), std::string::npos);
  EXPECT_EQ(jibson_2007({0.1, {}, 6.0, {}}).size(), 0U);
}

TEST(ResponseSpectrum, steady_sine_and_step) {
  // At resonance the steady response to a sine is 1/(2 z) times the static one, a_0/w^2.
  const double T = 0.5, w = 2.0 * kPi / T, z = 0.05;
  const Samples sine = sampled(60.0, 240000, [&](double t) { return std::sin(w * t); });
  const Response r = response_spectrum(sine, {T}, z).front();
  EXPECT_NEAR(r.displacement, 1.0 / (2.0 * z) / (w * w), 1e-4 / (w * w));
  EXPECT_NEAR(r.pseudo_acceleration, w * w * r.displacement, 1e-12);
  EXPECT_NEAR(r.acceleration, std::hypot(1.0, 2.0 * z) / (2.0 * z), 1e-3);  // |1 + 2 z i| over 2 z
  // A step of acceleration without damping: twice the static displacement.
  const Response step = response_spectrum({{0.0, 10.0}, {1.0, 1.0}}, {T}, 0.0).front();
  EXPECT_NEAR(step.displacement, 2.0 / (w * w), 0.02 / (w * w));
  EXPECT_NEAR(step.velocity, 1.0 / w, 0.02 / w);
}

TEST(ResponseSpectrum, steps_do_not_change_it) {
  const auto f = [](double t) { return 0.2 - std::abs(std::fmod(t, 0.4) - 0.2); };  // straight between steps of 0.2 s
  const std::vector<double> periods = spectrum_periods(0.05, 5.0, 7);
  const std::vector<Response> fine = response_spectrum(sampled(4.0, 2000, f), periods, 0.05),
                              coarse = response_spectrum(sampled(4.0, 20, f), periods, 0.05);
  for (std::size_t i = 0; i < periods.size(); ++i)
    EXPECT_NEAR(coarse[i].displacement, fine[i].displacement, 0.013 * fine[i].displacement) << periods[i];
  // a very stiff oscillator follows the ground, a very soft one stays where it is
  const Response stiff = response_spectrum(sampled(4.0, 2000, f), {0.001}, 0.05).front();
  EXPECT_NEAR(stiff.acceleration, 0.2, 0.002);
  EXPECT_THROW((void)response_spectrum({{0.0, 1.0}, {0.0, 1.0}}, {0.0}, 0.05), std::invalid_argument);
}

TEST(PlaneFailure, dry_block_and_cohesion_by_hand) {
  PlaneSlide s;
  s.dip = 30.0 * kDegree;
  s.friction = 35.0 * kDegree;
  s.weight = 1e6;
  s.length = 10.0;
  EXPECT_NEAR(s.factor(), std::tan(s.friction) / std::tan(s.dip), 1e-12);
  EXPECT_NEAR(s.yield(), std::tan(s.friction - s.dip), 1e-12);  // cohesionless: tan(phi - a)
  EXPECT_NEAR(s.factor(s.yield()), 1.0, 1e-12);
  EXPECT_NEAR(s.critical(), (s.factor() - 1.0) * 0.5, 1e-12);
  EXPECT_NEAR(s.amplification(), std::cos(s.friction - s.dip) / std::cos(s.friction), 1e-12);
  s.cohesion = 20e3;
  EXPECT_NEAR(s.factor(), (20e3 * 10.0 + 1e6 * std::cos(s.dip) * std::tan(s.friction)) / 5e5, 1e-12);
  EXPECT_NEAR(s.factor(s.yield(0.1), 0.1), 1.0, 1e-12);
  s.uplift = 2e6;  // it floats: only cohesion is left
  EXPECT_NEAR(s.factor(), 20e3 * 10.0 / 5e5, 1e-12);
  s.dip = 0.0;
  EXPECT_TRUE(std::isinf(s.factor()));
}

TEST(PlaneFailure, slope_with_tension_crack_is_its_polygon) {
  PlaneSlope p;
  p.height = 30.0;
  p.face = 60.0 * kDegree;
  p.dip = 35.0 * kDegree;
  p.unit_weight = 26e3;
  p.crack = 8.0;
  p.water = 5.0;
  const PlaneSlide s = p.slide();
  // corners: toe, foot of the crack, its top, crest
  const double xb = (p.height - p.crack) / std::tan(p.dip), xc = p.height / std::tan(p.face);
  const double x[] = {0.0, xb, xb, xc}, y[] = {0.0, p.height - p.crack, p.height, p.height};
  double area = 0.0;
  for (int i = 0; i < 4; ++i) area += 0.5 * (x[i] * y[(i + 1) % 4] - x[(i + 1) % 4] * y[i]);
  EXPECT_NEAR(s.weight, p.unit_weight * area, 1e-6);
  EXPECT_NEAR(s.length, std::hypot(xb, p.height - p.crack), 1e-12);
  EXPECT_NEAR(s.thrust, 0.5 * 9810.0 * 25.0, 1e-9);
  EXPECT_NEAR(s.uplift, 0.5 * 9810.0 * 5.0 * s.length, 1e-9);
  p.crack = 20.0;  // deeper than the plane under the crest, 30 (1 - tan 35/tan 60) = 17.9 m
  EXPECT_THROW((void)p.slide(), std::invalid_argument);
  p.crack = 8.0;
  p.water = 9.0;
  EXPECT_THROW((void)p.slide(), std::invalid_argument);
}

TEST(SlopeReport, numbers_of_a_record_and_json) {
  const Folder folder;
  std::string text = "time,acceleration_g\n";
  for (int i = 0; i <= 2000; ++i)
    text +=
        std::to_string(1e-3 * i) + "," + std::to_string(i <= 1000 ? 0.5 * std::sin(2.0 * kPi * 1e-3 * i) : 0.0) + "\n";
  folder.put("sine.csv", text);
  SlopeQuestion q;
  q.yield = 0.25;
  q.records = {folder.path() / "sine.csv"};
  EXPECT_THROW((void)slope_numbers(q), io::CaseError);  // no unit
  q.unit = "g";
  const SlopeNumbers n = slope_numbers(q);
  ASSERT_TRUE(n.records.at(0).along);
  EXPECT_NEAR(n.records[0].along->forward.displacement, 0.157211, 1e-5);
  EXPECT_NEAR(n.records[0].facts.arias, kPi / (2.0 * kG) * 0.25 * kG * kG * 0.5, 1e-4);
  EXPECT_NEAR(n.records[0].duration_5_95, 0.7411, 0.001);  // x - sin x = 0.2 pi at x = 4 pi t, on either side
  const nlohmann::json json = nlohmann::json::parse(slope_json(q, n));
  EXPECT_NEAR(json["records"][0]["newmark"]["displacement_m"]["forward"].get<double>(), 0.157211, 1e-5);
  EXPECT_EQ(json["records"][0]["regressions"].size(), 3U);
  q.pga = 1.0;
  EXPECT_NEAR(slope_numbers(q).records[0].facts.pga, kG, 1e-6);
}

TEST(SlopeReport, shared_records_have_the_catalogues_pga_and_arias) {
  const char* folder = std::getenv("SCREE_RECORDS");
  if (!folder || !*folder) GTEST_SKIP() << "SCREE_RECORDS is not set";
  const struct {
    const char* file;
    double pga, arias;
  } catalogue[] = {{"coyote-lake-1979-gilroy2-140.csv", 0.339, 0.512},
                   {"coyote-lake-1979-gilroy6-230.csv", 0.434, 0.774},
                   {"coyote-lake-1979-coyote-dam-250.csv", 0.279, 0.359},
                   {"imperial-valley-1940-el-centro-180.csv", 0.313, 1.703}};
  for (const auto& row : catalogue) {
    SlopeQuestion q;
    q.unit = "g";
    q.records = {std::filesystem::path(folder) / row.file};
    if (!std::filesystem::exists(q.records[0])) GTEST_SKIP() << q.records[0];
    const RecordNumbers r = slope_numbers(q).records.at(0);
    EXPECT_NEAR(r.facts.pga / kG, row.pga, 0.0005);
    EXPECT_NEAR(r.facts.arias, row.arias, 0.0005);
  }
}

}  // namespace
}  // namespace scree::app::slope_test
