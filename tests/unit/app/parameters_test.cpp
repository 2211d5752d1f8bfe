#include "app/sweep/parameters.h"

#include <gtest/gtest.h>

#include "io/case/case_error.h"

namespace scree::app::parameters_test {
namespace {

std::vector<std::string> values(const std::string& option) {
  const std::vector<std::string> options{option};
  std::vector<std::string> out;
  for (const auto& run : parameter_grid(options).runs) out.push_back(run.front().toml);
  return out;
}

/// The error of a grid, or a failure.
io::CaseError fault(const std::vector<std::string>& options) {
  try {
    (void)parameter_grid(options);
  } catch (const io::CaseError& e) {
    return e;
  }
  ADD_FAILURE() << "no error";
  return {"", {}, {}};
}

using Texts = std::vector<std::string>;

TEST(ParameterGrid, range_includes_both_ends_without_rounding_noise) {
  EXPECT_EQ(values("a.b=0:1:11"), (Texts{"0", "0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"}));
  EXPECT_EQ(values("a.b=16:8:3"), (Texts{"16", "12", "8"}));
  EXPECT_EQ(values("a.b=0.1:0.2:3"), (Texts{"0.1", "0.15", "0.2"}));
}

TEST(ParameterGrid, list_keeps_toml_and_quotes_words) {
  EXPECT_EQ(values("a=1,2.5,1e-3"), (Texts{"1", "2.5", "1e-3"}));
  EXPECT_EQ(values("a=dda, 5 ms,true"), (Texts{"\"dda\"", "\"5 ms\"", "true"}));
  EXPECT_EQ(values("a=[1, 0],[0, 1]"), (Texts{"[1, 0]", "[0, 1]"}));
  EXPECT_EQ(values("a=\"x,y\",'p:q'"), (Texts{"\"x,y\"", "'p:q'"}));
  EXPECT_EQ(toml_of("a \"b\" \\"), R"("a \"b\" \\")");
}

TEST(ParameterGrid, several_options_make_all_combinations_the_last_fastest) {
  const Texts options{"x=1,2", "y=3:5:3"};
  const Parameters grid = parameter_grid(options);
  ASSERT_EQ(grid.runs.size(), 6U);
  EXPECT_EQ(grid.overrides(1), (Texts{"x=1", "y=3"}));
  EXPECT_EQ(grid.overrides(2), (Texts{"x=1", "y=4"}));
  EXPECT_EQ(grid.overrides(6), (Texts{"x=2", "y=5"}));
}

TEST(ParameterGrid, key_in_quotation_marks_may_hold_an_equals_sign) {
  const Texts options{"joint.\"a=b\".friction_deg=1,2"};
  EXPECT_EQ(parameter_grid(options).overrides(2), Texts{"joint.\"a=b\".friction_deg=2"});
}

TEST(ParameterGrid, values_know_their_column) {
  const Texts options{"key=10,200"};
  const Parameters grid = parameter_grid(options);
  EXPECT_EQ(grid.runs[1][0].origin.file, "--param");
  EXPECT_EQ(grid.runs[1][0].origin.line, 1);
  EXPECT_EQ(grid.runs[1][0].origin.column, 8);
}

TEST(ParameterGrid, wrong_options_are_refused_at_their_column) {
  EXPECT_EQ(fault({"key"}).problem, "the equals sign is missing");
  EXPECT_EQ(fault({"=1,2"}).problem, "the key is missing");
  EXPECT_EQ(fault({"key="}).problem, "the values are missing");
  EXPECT_EQ(fault({"key=1,,2"}).problem, "a value is missing");
  EXPECT_EQ(fault({"key=1,,2"}).column, 7);
  EXPECT_EQ(fault({"key=1:2"}).problem, "a range has three parts");
  EXPECT_EQ(fault({"key=1:x:3"}).column, 7);
  EXPECT_EQ(fault({"key=1:2:1"}).problem, "this is no number of values");
  EXPECT_EQ(fault({"key=1:2:2.5"}).problem, "this is no number of values");
  EXPECT_EQ(fault({"key=1:inf:3"}).problem, "this end of a range is not a finite number");
  const io::CaseError twice = fault({"a=1,2", "a=3,4"});
  EXPECT_EQ(twice.problem, "the key is given twice");
  EXPECT_EQ(twice.line, 2);
}

TEST(ParameterGrid, too_many_runs_are_refused_before_they_fill_the_memory) {
  EXPECT_NE(fault({"a=0:1:100000", "b=0:1:100000"}).problem.find("100000 x 100000"), std::string::npos);
}

TEST(RunName, has_four_digits_or_as_many_as_needed) {
  EXPECT_EQ(run_name(7, 64), "0007");
  EXPECT_EQ(run_name(7, 10000), "00007");
}

}  // namespace
}  // namespace scree::app::parameters_test
