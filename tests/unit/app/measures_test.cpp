#include "app/verify/measures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "app/verify/reference.h"
#include "tests/unit/app/folder.h"

namespace scree::app::measures_test {
namespace {

constexpr int kSamples = 101;  // of a second

/// A run that never was: one monitor "a" moving as amplitude sin(2 pi t) along x, "b" at rest at (3, 4) from its start.
RunRecord made_up(double amplitude) {
  RunRecord run;
  MonitorHistory a{"a", {}, {}, {}, {}}, b{"b", {}, {}, {}, {}};
  for (int i = 0; i < kSamples; ++i) {
    const double t = 0.01 * i, u = amplitude * std::sin(2.0 * std::numbers::pi * t);
    run.time.push_back(t);
    a.displacement.emplace_back(u, 0.0);
    a.position.emplace_back(1.0 + u, 2.0);
    a.velocity.emplace_back(2.0 * std::numbers::pi * amplitude * std::cos(2.0 * std::numbers::pi * t), 0.0);
    a.stress.emplace_back(-1e6 * u, t, 5.0);
    b.displacement.emplace_back(3.0, 4.0);
    b.position.emplace_back(4.0, 6.0);
    b.velocity.emplace_back(0.0, 0.0);
    b.stress.push_back(Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
  }
  run.monitors = {a, b};
  run.moved = {Vec2(0.0, 0.0), Vec2(0.3, -0.4), Vec2(2.0, 0.0)};
  run.stats.steps = 40;
  run.stepping = amplitude;
  run.stepping_implicit = 0.5 * amplitude * amplitude;
  return run;
}

class Measures : public ::testing::Test {
 protected:
  Quantity quantity(const std::string& keys) {
    const std::string text =
        "[[variant]]\nname=\"one\"\n[[variant]]\nname=\"two\"\n[[variant]]\nname=\"four\"\n"
        "[[quantity]]\nname=\"q\"\nreason=\"r\"\nat_most=1\n" +
        keys;
    return read_expected_text(text, folder_.path() / "expected.toml").quantities.front();
  }
  double value(const std::string& keys) { return measure(quantity(keys), runs_, plots_); }

  Folder folder_;
  RunRecords runs_{{"one", made_up(1.0)}, {"two", made_up(2.0)}, {"four", made_up(4.0)}};
  std::vector<io::LinePlot> plots_;
};

TEST_F(Measures, monitor_gives_components_and_statistics) {
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\""), 0.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nstatistic=\"max\""), 1.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nstatistic=\"min\""), -1.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"sxx\"\nstatistic=\"peak\""), 1e6, 1e-6);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"syy\""), 1.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"sxy\""), 5.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"b\"\ncomponent=\"u\""), 5.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"b\"\ncomponent=\"y\""), 6.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"v\""), 2.0 * std::numbers::pi, 1e-12);
}

TEST_F(Measures, window_leaves_other_samples_out) {
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nstatistic=\"max\"\nfrom=0.5"), 0.0, 1e-12);
  EXPECT_NEAR(value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nuntil=0.25"), 1.0, 1e-12);
  EXPECT_THROW((void)value("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nfrom=2"), io::CaseError);
}

TEST_F(Measures, stress_that_was_not_recorded_is_an_error_not_a_number) {
  EXPECT_THROW((void)value("measure=\"monitor\"\nof=\"b\"\ncomponent=\"sxx\""), io::CaseError);
}

TEST_F(Measures, over_divides_by_the_other_variant) {
  EXPECT_DOUBLE_EQ(value("measure=\"stepping_time\"\nvariant=\"four\"\nover=\"one\""), 4.0);
  EXPECT_DOUBLE_EQ(value("measure=\"stepping_time\"\nof=\"implicit\"\nvariant=\"four\"\nover=\"one\""), 16.0);
}

TEST_F(Measures, history_error_is_relative_to_the_peak_of_the_reference) {
  std::string csv = "# made here\ntime [s], ux [m], twice\n";
  for (int i = 0; i < kSamples; ++i) {
    const double u = 1.1 * std::sin(2.0 * std::numbers::pi * 0.01 * i);
    csv += std::to_string(0.01 * i) + ", " + std::to_string(u) + ", " + std::to_string(2.0 * u) + "\n";
  }
  folder_.put("r.csv", csv);
  const std::string base = "measure=\"history_error\"\nof=\"a\"\ncomponent=\"ux\"\nfile=\"r.csv\"\n";
  EXPECT_NEAR(value(base), 0.1 / 1.1, 1e-5);
  EXPECT_NEAR(value(base + "variant=\"two\"\ncolumn=\"twice\""), 0.2 / 2.2, 1e-5);
  EXPECT_EQ(plots_.size(), 2U);
  EXPECT_THROW((void)value(base + "column=\"thrice\""), io::CaseError);
}

TEST_F(Measures, history_error_compares_variants) {
  EXPECT_NEAR(value("measure=\"history_error\"\nof=\"a\"\ncomponent=\"ux\"\nvariant=\"one\"\nagainst=\"four\""), 0.75,
              1e-12);
}

constexpr const char* kHarmonic = "measure=\"harmonic\"\nof=\"a\"\ncomponent=\"ux\"\n";

TEST_F(Measures, harmonic_is_the_size_of_the_fourier_integral) {
  // Of sin(2 pi t) over its second: 1/2 at 1 Hz, nothing at 2 Hz, and 4/(3 pi) at 1/2 Hz.
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=1"), 0.5, 1e-12);
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=2"), 0.0, 1e-12);
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=0.5"), 4.0 / (3.0 * std::numbers::pi), 1e-3);
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=1\nvariant=\"four\""), 2.0, 1e-12);
}

TEST_F(Measures, crossing_divides_the_energy_of_the_waves_at_an_interface) {
  // 1 arrives, 0.6 of it comes back, 0.5 goes on, and 0.3 comes from behind; z = 2.
  RunRecord& run = runs_.at("one");
  for (std::size_t i = 0; i < run.time.size(); ++i) {
    const double phase = 2.0 * std::numbers::pi * run.time[i], in = std::sin(phase), back = 0.6 * std::cos(phase),
                 on = 0.5 * std::sin(phase + 1.0), again = 0.3 * std::cos(phase + 2.0);
    run.monitors[0].velocity[i].y() = in + back;
    run.monitors[0].stress[i].z() = 2.0 * (back - in);
    run.monitors[1].velocity[i].y() = on + again;
    run.monitors[1].stress[i].z() = 2.0 * (again - on);
  }
  const std::string base =
      "measure=\"crossing\"\nof=\"a\"\nbehind=\"b\"\ncomponent=\"vy\"\nstress=\"sxy\"\nimpedance=2\npart=";
  EXPECT_NEAR(value(base + "\"transmitted\""), 0.5, 1e-12);
  EXPECT_NEAR(value(base + "\"reflected\""), 0.6, 1e-12);
  EXPECT_NEAR(value(base + "\"absorbed\""), std::sqrt(1.0 + 0.09 - 0.36 - 0.25), 1e-12);
  EXPECT_NEAR(value(base + "\"reflected\"\nfrom=0.25\nuntil=0.75"), 0.6, 1e-12);
}

TEST_F(Measures, harmonic_counts_the_window_only) {
  // |int sin w e^(-iwt)| over the first half second is 1/4; the phase of the rest must not come in.
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=1\nuntil=0.5"), 0.25, 1e-3);
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=1\nfrom=0.5"), 0.25, 1e-3);
}

TEST_F(Measures, harmonic_of_a_difference_is_over_what_was_sent_in) {
  const std::string base = std::string(kHarmonic) + "frequency=1\nvariant=\"four\"\n";
  EXPECT_NEAR(value(base + "over=\"two\""), 2.0, 1e-12);
  EXPECT_NEAR(value(base + "minus=\"one\""), 1.5, 1e-12);
  EXPECT_NEAR(value(base + "minus=\"one\"\nover=\"one\""), 3.0, 1e-12);
  EXPECT_NEAR(value(base + "minus=\"one\"\nover=\"two\""), 1.5, 1e-12);
}

TEST_F(Measures, harmonic_knows_shift_in_time_from_change_of_size) {
  // cos - sin is sqrt(2) times as large, not zero: a difference of histories, not of sizes.
  for (std::size_t i = 0; i < runs_.at("two").time.size(); ++i)
    runs_.at("two").monitors[0].displacement[i].x() = std::cos(2.0 * std::numbers::pi * runs_.at("two").time[i]);
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=1\nvariant=\"two\"\nminus=\"one\"\nover=\"one\""),
              std::sqrt(2.0), 1e-12);
}

TEST_F(Measures, harmonic_reads_the_other_run_at_its_own_times) {
  RunRecord& two = runs_.at("two");  // every other sample, which 1 Hz still allows
  RunRecord thinned = two;
  thinned.time.clear();
  thinned.monitors[0].displacement.clear();
  for (std::size_t i = 0; i < two.time.size(); i += 2) {
    thinned.time.push_back(two.time[i]);
    thinned.monitors[0].displacement.push_back(two.monitors[0].displacement[i]);
  }
  two = thinned;
  EXPECT_NEAR(value(std::string(kHarmonic) + "frequency=1\nvariant=\"four\"\nminus=\"two\""), 1.0, 1e-3);
}

TEST_F(Measures, harmonic_of_a_difference_to_a_shorter_run_is_refused) {
  RunRecord& two = runs_.at("two");
  two.time.resize(51);
  two.monitors[0].displacement.resize(51);
  const std::string base = std::string(kHarmonic) + "frequency=1\nvariant=\"four\"\nminus=\"two\"\n";
  EXPECT_THROW((void)value(base), io::CaseError);
  EXPECT_NEAR(value(base + "until=0.5"), 0.5, 1e-3);
}

TEST_F(Measures, harmonic_of_too_few_samples_is_refused_at_the_frequency) {
  EXPECT_NO_THROW((void)value(std::string(kHarmonic) + "frequency=4.9"));
  try {
    (void)value(std::string(kHarmonic) + "frequency=5.1");
    FAIL();
  } catch (const io::CaseError& e) {
    EXPECT_EQ(e.line, 14);
    EXPECT_EQ(e.column, 11);
    EXPECT_NE(e.hint.find("history_every"), std::string::npos);
  }
}

TEST_F(Measures, profile_error_takes_each_monitor_s_value) {
  folder_.put("p.csv", "monitor, x, u\na, 0.5, 0.5\nb, 1.5, 10\n");
  EXPECT_NEAR(value("measure=\"profile_error\"\ncomponent=\"u\"\nfile=\"p.csv\""), 0.5, 1e-12);  // b: 5 for 10
  folder_.put("p.csv", "monitor, x, u\nc, 0.5, 0.5\n");
  EXPECT_THROW((void)value("measure=\"profile_error\"\ncomponent=\"u\"\nfile=\"p.csv\""), io::CaseError);
}

TEST_F(Measures, order_is_the_slope_of_the_errors) {
  // |value - exact| = 1, 2, 4 at sizes 1, 2, 4: first order; at sizes 1, sqrt 2, 2: second.
  const std::string base =
      "measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nstatistic=\"max\"\nvariants=[\"one\",\"two\",\"four\"]\n";
  EXPECT_NEAR(value(base + "sizes=[1, 2, 4]"), 1.0, 1e-10);
  EXPECT_NEAR(value(base + "sizes=[1, 1.4142135623730951, 2]"), 2.0, 1e-10);
  EXPECT_NEAR(value(base + "sizes=[1, 2, 4]\nexact=-1"), std::log(2.5) / std::log(4.0), 0.02);
  EXPECT_EQ(plots_.size(), 3U);
}

TEST_F(Measures, blocks_are_counted_by_distance) {
  EXPECT_EQ(value("measure=\"blocks_moved_above\"\nof=0.4"), 2.0);
  EXPECT_EQ(value("measure=\"blocks_moved_below\"\nof=0.4"), 1.0);
}

TEST_F(Measures, blocks_difference_compares_vectors_over_the_farthest) {
  const std::string base = "measure=\"blocks_difference\"\nvariant=\"one\"\nagainst=\"two\"\n";
  runs_.at("two").moved = {Vec2(0.0, 0.0), Vec2(0.3, 0.4), Vec2(4.0, 0.0)};
  EXPECT_DOUBLE_EQ(value(base), 0.5);                // 2 m of 4 m
  EXPECT_DOUBLE_EQ(value(base + "below=4"), 1.6);    // 0.8 m of 0.5 m: as long, another way
  EXPECT_DOUBLE_EQ(value(base + "above=0.5"), 0.5);  // both
  EXPECT_THROW((void)value(base + "above=5"), io::CaseError);
  runs_.at("two").moved.pop_back();
  EXPECT_THROW((void)value(base), io::CaseError);
}

TEST_F(Measures, latest_hand_over_counts) {
  coupling::TransferRow row;
  for (const auto& [time, kinetic] : {std::pair{1.0, 7.0}, {2.0, 3.0}, {2.0, 4.5}}) {
    row.time = time;
    row.after.kinetic = kinetic;
    row.before.kinetic = 10.0;
    row.energy_error = time == 1.0 ? 0.0 : 0.2;
    row.angular_error = 1e-3 * time;
    runs_.at("one").transfers.push_back(row);
  }
  EXPECT_DOUBLE_EQ(value("measure=\"kinetic_at_handover\""), 7.5);
  EXPECT_DOUBLE_EQ(value("measure=\"transfer_energy_error\""), 0.2);
  EXPECT_DOUBLE_EQ(value("measure=\"transfer_momentum_error\""), 2e-3);
}

TEST_F(Measures, refusal_counts_as_a_number) {
  EXPECT_EQ(value("measure=\"refused\""), 0.0);
  runs_.at("one").refused = "too large a step";
  EXPECT_EQ(value("measure=\"refused\""), 1.0);
  EXPECT_FALSE(runs_.at("one").done());
}

TEST_F(Measures, names_are_checked_before_anything_runs) {
  Model model;
  model.monitors.push_back({"a", BlockId{0}, {0.0, 0.0}});
  coupling::Plan plan;
  plan.stages.emplace_back().name = "shake";
  const auto fault = [&](const std::string& keys) -> std::string {
    try {
      check_names(quantity(keys), model, plan);
    } catch (const io::CaseError& e) {
      return e.message;
    }
    return "";
  };
  EXPECT_EQ(fault("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\""), "");
  EXPECT_NE(
      fault("measure=\"monitor\"\nof=\"aa\"\ncomponent=\"ux\"").find("expected.toml:12:4: error: unknown monitor"),
      std::string::npos);
  EXPECT_NE(fault("measure=\"monitor\"\nof=\"a\"\ncomponent=\"uz\"").find("unknown component"), std::string::npos);
  EXPECT_NE(fault("measure=\"monitor\"\nof=\"a\"\ncomponent=\"ux\"\nstatistic=\"mean\"").find("unknown statistic"),
            std::string::npos);
  EXPECT_EQ(fault(std::string(kHarmonic) + "frequency=5"), "");
  EXPECT_NE(fault("measure=\"harmonic\"\nof=\"aa\"\ncomponent=\"ux\"\nfrequency=5").find("unknown monitor"),
            std::string::npos);
  EXPECT_NE(fault(std::string(kHarmonic) + "frequency=0").find("expected.toml:14:11: error: a frequency of 0 Hz"),
            std::string::npos);
  EXPECT_NE(fault("measure=\"drift_in_stage\"\nof=\"shape\"").find("unknown stage"), std::string::npos);
  EXPECT_NE(fault("measure=\"stepping_time\"\nof=\"implict\"").find("unknown kind of steps"), std::string::npos);
  EXPECT_NE(fault("measure=\"history_error\"\nof=\"a\"\ncomponent=\"ux\"").find("file or against"), std::string::npos);
}

TEST(Reference, faults_are_placed) {
  const Folder folder;
  const auto fault = [&](const std::string& text) {
    folder.put("t.csv", text);
    try {
      (void)read_reference(folder.path() / "t.csv");
    } catch (const io::CaseError& e) {
      return std::pair(e.line, e.column);
    }
    return std::pair(-1, -1);
  };
  EXPECT_EQ(fault("time, u\n0, 1\n1, 2\n"), std::pair(-1, -1));
  EXPECT_EQ(fault("time, u\n0, 1\n1, x\n"), std::pair(3, 3));
  EXPECT_EQ(fault("# c\ntime, u\n0, 1, 2\n"), std::pair(3, 1));
  EXPECT_EQ(fault("time, u\n0, nan\n"), std::pair(2, 3));
  EXPECT_EQ(fault("time, u\n").first, 0);
  EXPECT_EQ(fault("").first, 0);
}

TEST(Reference, interpolation_is_straight_and_stays_at_the_ends) {
  const std::vector<double> x{0.0, 1.0, 3.0}, y{0.0, 2.0, -2.0};
  EXPECT_EQ(interpolated(x, y, -1.0), 0.0);
  EXPECT_EQ(interpolated(x, y, 0.5), 1.0);
  EXPECT_EQ(interpolated(x, y, 2.0), 0.0);
  EXPECT_EQ(interpolated(x, y, 9.0), -2.0);
}

}  // namespace
}  // namespace scree::app::measures_test
