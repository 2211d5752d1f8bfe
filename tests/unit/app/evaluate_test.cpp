#include "app/verify/evaluate.h"

#include <gtest/gtest.h>

#include "app/verify/report.h"
#include "io/results/file_error.h"
#include "tests/unit/app/folder.h"

namespace scree::app::evaluate_test {
namespace {

constexpr const char* kCase = R"(title = "Free fall"
[model]
gravity = [0, -10]
[material.rock]
density = 2000.0
young = 1e7
poisson = 0.2
[[block]]
name = "stone"
polygon = [[0, 0], [1, 0], [1, 1], [0, 1]]
material = "rock"
[[monitor]]
name = "middle"
block = "stone"
point = [0.5, 0.5]
[[stage]]
name = "fall"
method = "dda"
integrator = "explicit"
dt = 1e-3
duration = 0.1
[output]
history_every = 0.01
)";

constexpr const char* kVariants = R"([[variant]]
name = "fall"
repeats = 2
[[variant]]
name = "shorter steps"
set = ["stage.0.dt=5e-4"]
[[variant]]
name = "too long steps"
set = ["stage.0.dt=0.05", "output.history_every=0.05"]
[[variant]]
name = "long"
set = ["stage.0.duration=0.2"]
tier = "full"
[[variant]]
name = "longest"
set = ["stage.0.duration=0.3"]
tier = "exhaustive"
)";

/// A quantity of the middle's uy at the end.
std::string end_of(const std::string& variant, double reference) {
  return "[[quantity]]\nname = \"" + variant +
         "\"\nmeasure = \"monitor\"\nof = \"middle\"\ncomponent = \"uy\"\nvariant = \"" + variant +
         "\"\nreference = " + std::to_string(reference) + "\nabsolute = 1e-9\nreason = \"g t^2/2\"\n";
}

class Evaluate : public ::testing::Test {
 protected:
  Evaluate() { folder_.put("case.toml", kCase); }
  CaseReport evaluate(const std::string& quantities, Tier tier = Tier::quick) {
    folder_.put("expected.toml", kVariants + quantities);
    return evaluate_case(folder_.path(), tier);
  }
  Folder folder_;
};

TEST_F(Evaluate, rows_hold_what_was_found) {
  const CaseReport report = evaluate(end_of("fall", -0.05) + end_of("shorter steps", -0.06));
  ASSERT_EQ(report.rows.size(), 2U);
  EXPECT_TRUE(report.rows[0].pass);
  EXPECT_FALSE(report.rows[1].pass);
  EXPECT_NEAR(report.rows[1].found, -0.05, 1e-9);
  EXPECT_EQ(report.failed(), 1);
  EXPECT_EQ(report.title, "Free fall");
}

TEST_F(Evaluate, position_in_survey_coordinates_is_as_the_case_counts) {
  std::string text = kCase;
  for (const auto& [near, far] :
       {std::pair("[[0, 0], [1, 0], [1, 1], [0, 1]]", "[[5e5, 4e6], [500001, 4e6], [500001, 4000001], [5e5, 4000001]]"),
        {"[0.5, 0.5]", "[500000.5, 4000000.5]"}})
    text.replace(text.find(near), std::string(near).size(), far);
  folder_.put("case.toml", text);
  const CaseReport report = evaluate(
      "[[quantity]]\nname = \"y\"\nmeasure = \"monitor\"\nof = \"middle\"\ncomponent = \"y\"\nvariant = \"fall\"\n"
      "reference = 4000000.45\nabsolute = 1e-9\nreason = \"g t^2/2\"\n" +
      end_of("fall", -0.05));
  for (const auto& row : report.rows) EXPECT_TRUE(row.pass) << row.found;
}

TEST_F(Evaluate, only_what_the_tier_needs_is_run) {
  const std::string all = end_of("fall", -0.05) + end_of("long", -0.2) + end_of("longest", -0.45);
  EXPECT_EQ(evaluate(all).notes.size(), 1U);
  const CaseReport full = evaluate(all, Tier::full);
  EXPECT_EQ(full.notes.size(), 2U);
  EXPECT_EQ(full.failed(), 0);
  const CaseReport exhaustive = evaluate(all, Tier::exhaustive);
  EXPECT_EQ(exhaustive.notes.size(), 3U);
  EXPECT_EQ(exhaustive.failed(), 0);
}

TEST_F(Evaluate, refused_run_fails_its_rows_but_for_the_refusal_itself) {
  const CaseReport report = evaluate(end_of("too long steps", -0.05) +
                                     "[[quantity]]\nname=\"r\"\nmeasure=\"refused\"\nvariant=\"too long "
                                     "steps\"\nreference=1\nabsolute=0\nreason=\"a\"\n");
  EXPECT_FALSE(report.rows[0].pass);
  EXPECT_NE(report.rows[0].trouble.find("above the certified stable one"), std::string::npos);
  EXPECT_TRUE(report.rows[1].pass);
}

TEST_F(Evaluate, quantity_whose_variable_is_not_set_is_skipped_and_says_so) {
  const std::string variants = std::string(kVariants) +
                               "[[variant]]\nname = \"recorded\"\nneeds = \"SCREE_TEST_RECORDS\"\n"
                               "set = ['stage.0.duration=0.05']\n";
  folder_.put("expected.toml", variants + end_of("recorded", -0.0125) + end_of("fall", -0.05));
  ASSERT_EQ(unsetenv("SCREE_TEST_RECORDS"), 0);
  const CaseReport without = evaluate_case(folder_.path(), Tier::quick);
  ASSERT_EQ(without.rows.size(), 2U);
  EXPECT_TRUE(without.rows[0].skipped);
  EXPECT_EQ(without.rows[0].trouble, "SCREE_TEST_RECORDS is not set");
  EXPECT_TRUE(without.rows[1].pass);
  EXPECT_EQ(without.failed(), 0);
  EXPECT_EQ(without.skipped(), 1);
  EXPECT_NE(terminal_text(without).find("skipped"), std::string::npos);
  ASSERT_EQ(setenv("SCREE_TEST_RECORDS", "anywhere", 1), 0);
  const CaseReport with = evaluate_case(folder_.path(), Tier::quick);
  ASSERT_EQ(unsetenv("SCREE_TEST_RECORDS"), 0);
  EXPECT_EQ(with.skipped(), 0);
  EXPECT_TRUE(with.rows[0].pass);
}

TEST_F(Evaluate, same_state_is_of_equal_runs_alone) {
  const auto same = [](const std::string& variant, const std::string& against, int wanted) {
    return "[[quantity]]\nname = \"" + variant + " and " + against + "\"\nmeasure = \"same_state\"\nvariant = \"" +
           variant + "\"\nagainst = \"" + against + "\"\nreference = " + std::to_string(wanted) +
           "\nabsolute = 0\nreason = \"bits\"\n[[quantity]]\nname = \"clock\"\nmeasure = \"wall_time\"\nvariant = \"" +
           variant + "\"\nat_least = 1e-9\nat_most = 60\nreason = \"it took time\"\n";
  };
  folder_.put("expected.toml", std::string(kVariants) +
                                   "[[variant]]\nname = \"two threads\"\nset = ['run.threads=2']\n" +
                                   same("two threads", "fall", 1) + same("shorter steps", "fall", 0));
  const CaseReport report = evaluate_case(folder_.path(), Tier::quick);
  ASSERT_EQ(report.rows.size(), 4U);
  EXPECT_EQ(report.failed(), 0);
}

TEST_F(Evaluate, overrides_that_do_not_fit_the_case_are_its_errors) {
  folder_.put("expected.toml", "[[variant]]\nname = \"a\"\nset = [\"stage.0.dtt=1\"]\n" + end_of("a", 0.0));
  EXPECT_THROW((void)evaluate_case(folder_.path(), Tier::quick), io::CaseError);
}

TEST_F(Evaluate, unknown_study_and_number_are_refused) {
  const std::string quantity = "[[quantity]]\nname=\"a\"\nmeasure=\"study\"\nof=\"nothing\"\nat_most=1\nreason=\"b\"\n";
  folder_.put("expected.toml", "title=\"t\"\nstudy=\"sdoff\"\n" + quantity);
  try {
    (void)evaluate_case(folder_.path(), Tier::quick);
    FAIL();
  } catch (const io::CaseError& e) {
    EXPECT_NE(e.hint.find("\"sdof\""), std::string::npos);
  }
  folder_.put("expected.toml", "title=\"t\"\nstudy=\"sdof\"\n" + quantity);
  try {
    (void)evaluate_case(folder_.path(), Tier::quick);
    FAIL();
  } catch (const io::CaseError& e) {
    EXPECT_EQ(e.line, 6);
    EXPECT_NE(e.allowed.find("explicit_limit"), std::string::npos);
  }
}

CaseReport strange_report() {
  CaseReport report;
  report.name = "odd";
  report.title = "a < b | c & d";
  report.rows.push_back({"x | y", "why \"so\"", ">= 1", 0.5, false, {}});
  report.rows.push_back({"gone", "", "<= 1", 0.0, false, "the run <did> not end"});
  report.plots.push_back({"A plot", "x", "y", {{"s", {0.0, 1.0}, {1.0, 2.0}}}});
  return report;
}

TEST(Report, markup_in_texts_stays_text) {
  const std::string markdown = markdown_report({strange_report()}, true), html = html_report({strange_report()}, true);
  EXPECT_NE(markdown.find("x \\| y"), std::string::npos);
  EXPECT_NE(html.find("a &lt; b | c &amp; d"), std::string::npos);
  EXPECT_NE(html.find("&quot;so&quot;"), std::string::npos);
  EXPECT_EQ(html.find("<did>"), std::string::npos);
  for (const std::string* text : {&markdown, &html}) {
    EXPECT_NE(text->find("1 cases, 2 quantities, 2 failed"), std::string::npos);
    EXPECT_NE(text->find("odd-1.png"), std::string::npos);
  }
  EXPECT_EQ(markdown_report({strange_report()}, false).find("png"), std::string::npos);
  EXPECT_NE(terminal_text(strange_report()).find("FAIL"), std::string::npos);
}

TEST(Report, folder_holds_tables_and_plots) {
  const Folder folder;
  write_report({strange_report()}, folder.path() / "new" / "report");
  EXPECT_NE(folder.text("new/report/cases.md").find("## odd"), std::string::npos);
  EXPECT_NE(folder.text("new/report/cases.html").find("<h2 id=\"odd\">"), std::string::npos);
  EXPECT_EQ(folder.text("new/report/odd-1.png").substr(1, 3), "PNG");
}

TEST(Report, table_is_of_the_kind_that_its_name_says) {
  const Folder folder;
  write_table({strange_report()}, folder.path() / "t.md");
  write_table({strange_report()}, folder.path() / "t.html");
  EXPECT_EQ(folder.text("t.md").substr(0, 2), "# ");
  EXPECT_EQ(folder.text("t.html").substr(0, 9), "<!doctype");
  write_table({strange_report()}, folder.path() / "t.csv");
  EXPECT_EQ(folder.text("t.csv"),
            "case,quantity,wanted,found,verdict\nodd,\"x | y\",\">= 1\",0.5,FAIL\nodd,\"gone\",\"<= 1\",,FAIL\n");
  EXPECT_THROW(write_table({strange_report()}, folder.path() / "t.txt"), io::FileError);
  EXPECT_THROW(write_table({strange_report()}, folder.path() / "none" / "t.md"), io::FileError);
}

}  // namespace
}  // namespace scree::app::evaluate_test
