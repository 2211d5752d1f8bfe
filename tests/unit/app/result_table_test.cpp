#include "app/sweep/result_table.h"

#include <gtest/gtest.h>

#include <limits>

#include "app/sweep/sweep_plots.h"
#include "io/results/file_error.h"
#include "tests/unit/app/folder.h"

namespace scree::app::result_table_test {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

Parameters parameters(const std::vector<std::string>& options) { return parameter_grid(options); }

ResultTable example() {
  ResultTable table;
  table.title = "a case";
  table.parameters = parameter_columns(parameters({"joint.clay.friction_deg=20:30:3"}));
  table.outcomes = {{RunOutcome::State::done, "done", ""},
                    {RunOutcome::State::failed, "not_converged", "t = 1 s, \"late\""},
                    {RunOutcome::State::done, "done", ""}};
  table.state_hashes = {"00ab", "", "00cd"};
  table.farthest_blocks = {"a,b", "", "c"};
  table.results = {{"toe.u", "m", "size of the last displacement", {0.1, kNone, 0.30000000000000004}},
                   {"steps", "1", "steps made", {5.0, 3.0, 5.0}}};
  return table;
}

TEST(UnitOfKey, is_that_of_the_schema_for_names_and_numbers_of_items) {
  EXPECT_EQ(unit_of_key("joint.clay.friction_deg"), "deg");
  EXPECT_EQ(unit_of_key("joint.\"a.b\".friction_deg"), "deg");
  EXPECT_EQ(unit_of_key("stage.0.dt"), "s");
  EXPECT_EQ(unit_of_key("stage.slide.dt"), "s");
  EXPECT_EQ(unit_of_key("no.such.key"), "");
}

TEST(ParameterColumns, numbers_with_units_become_those_of_the_schema) {
  const auto time = parameter_columns(parameters({"stage.0.dt=5 ms,0.01"}));
  EXPECT_EQ(time[0].numbers, (std::vector<double>{0.005, 0.01}));
  EXPECT_EQ(time[0].units, "s");
  const auto word = parameter_columns(parameters({"stage.0.method=dda,nmm"}));
  EXPECT_FALSE(word[0].is_number());
  EXPECT_EQ(word[0].texts, (std::vector<std::string>{"dda", "nmm"}));
  EXPECT_EQ(word[0].units, "");
}

TEST(CsvText, has_units_in_the_heading_and_numbers_that_read_back) {
  EXPECT_EQ(csv_text(example()),
            "run,joint.clay.friction_deg [deg],outcome,reason,toe.u [m],steps [1],farthest_block,state_hash\n"
            "1,20,done,,0.1,5,\"a,b\",00ab\n"
            "2,25,not_converged,\"t = 1 s, \"\"late\"\"\",,3,,\n"
            "3,30,done,,0.30000000000000004,5,c,00cd\n");
}

TEST(SweepPlots, one_parameter_gives_points_of_results_that_differ_between_runs_that_are_done) {
  const std::vector<NamedPlot> plots = sweep_plots(example());
  ASSERT_EQ(plots.size(), 1U);
  EXPECT_EQ(plots[0].name, "toe.u");
  EXPECT_EQ(plots[0].plot.x_label, "joint.clay.friction_deg [deg]");
  EXPECT_EQ(plots[0].plot.y_label, "toe.u [m]");
  ASSERT_EQ(plots[0].plot.series.size(), 1U);
  EXPECT_EQ(plots[0].plot.series[0].x, (std::vector<double>{20.0, 30.0}));
}

TEST(SweepPlots, two_parameters_give_a_curve_for_each_value_of_the_second) {
  ResultTable table;
  table.parameters = parameter_columns(parameters({"a.b=1,2", "c.d=5:7:3"}));
  table.outcomes.assign(6, {RunOutcome::State::done, "done", ""});
  table.results = {{"x", "m", "x", {1, 2, 3, 4, 5, 6}}};
  const std::vector<NamedPlot> plots = sweep_plots(table);
  ASSERT_EQ(plots.size(), 1U);
  ASSERT_EQ(plots[0].plot.series.size(), 2U);
  EXPECT_EQ(plots[0].plot.x_label, "c.d");
  EXPECT_EQ(plots[0].plot.series[1].name, "2");
  EXPECT_EQ(plots[0].plot.series[1].y, (std::vector<double>{4, 5, 6}));
}

SweepRecord record(const std::vector<std::string>& options) {
  SweepRecord r;
  r.case_sha256 = "00";
  r.parameters = parameter_grid(options);
  return r;
}

std::string refusal(const std::filesystem::path& path, const SweepRecord& wanted) {
  try {
    (void)SweepFolder::open(path, wanted);
  } catch (const io::FileError& e) {
    return e.reason;
  }
  return {};
}

TEST(SweepFolder, same_sweep_goes_on_and_another_is_refused_with_what_differs) {
  const Folder folder;
  const std::filesystem::path path = folder.path() / "s";
  EXPECT_EQ(refusal(path, record({"a=1,2"})), "");
  EXPECT_EQ(refusal(path, record({"a=1,2"})), "");
  EXPECT_NE(refusal(path, record({"a=1,3"})).find("its parameters have other values"), std::string::npos);
  EXPECT_NE(refusal(path, record({"b=1,2"})).find("its parameters are others"), std::string::npos);
  SweepRecord other = record({"a=1,2"});
  other.case_sha256 = "11";
  EXPECT_NE(refusal(path, other).find("its case file had another text"), std::string::npos);
  other = record({"a=1,2"});
  other.files["record.csv"] = "22";
  EXPECT_NE(refusal(path, other).find("a file that its case names"), std::string::npos);
  other = record({"a=1,2"});
  other.until = 2.0;
  EXPECT_NE(refusal(path, other).find("--until"), std::string::npos);
}

TEST(SweepFolder, folder_with_other_files_is_not_touched) {
  const Folder folder;
  folder.put("thesis.txt", "years");
  EXPECT_NE(refusal(folder.path(), record({"a=1,2"})).find("files in it that are not of a sweep"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "sweep.json"));
}

TEST(RunOutcome, is_told_by_the_summary_of_the_same_case_and_parameters) {
  const Folder folder;
  const std::vector<std::string> set{"a=1"};
  const auto outcome = [&] { return run_outcome(folder.path(), folder.path() / "no.log", set, "00"); };
  EXPECT_EQ(outcome().state, RunOutcome::State::absent);
  folder.put("run.vtkhdf", "");
  EXPECT_EQ(outcome().state, RunOutcome::State::started);
  folder.put("summary.json", R"({"status": "done", "case_sha256": "00", "set": ["a=1"], "reason": ""})");
  EXPECT_EQ(outcome().state, RunOutcome::State::done);
  folder.put("summary.json", R"({"status": "interrupted", "case_sha256": "00", "set": ["a=1"], "reason": ""})");
  EXPECT_EQ(outcome().state, RunOutcome::State::started);
  folder.put("summary.json", R"({"status": "not_converged", "case_sha256": "00", "set": ["a=1"], "reason": "why"})");
  EXPECT_EQ(outcome().state, RunOutcome::State::failed);
  EXPECT_EQ(outcome().reason, "why");
  folder.put("summary.json", R"({"status": "done", "case_sha256": "00", "set": ["a=2"], "reason": ""})");
  EXPECT_THROW((void)outcome(), io::FileError);
  folder.put("summary.json", R"({"status": "done", "case_sha256": "01", "set": ["a=1"], "reason": ""})");
  EXPECT_THROW((void)outcome(), io::FileError);
  folder.put("summary.json", "{\"status\": \"do");
  EXPECT_EQ(outcome().state, RunOutcome::State::started);
}

}  // namespace
}  // namespace scree::app::result_table_test
