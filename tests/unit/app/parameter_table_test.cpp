#include "app/sweep/parameter_table.h"

#include <gtest/gtest.h>

#include "app/sweep/csv_text.h"
#include "io/case/case_error.h"
#include "tests/unit/app/folder.h"

namespace scree::app::parameter_table_test {
namespace {

using Texts = std::vector<std::string>;

io::CaseError fault(const std::string& text) {
  try {
    (void)parameter_table(text, "runs.csv");
  } catch (const io::CaseError& e) {
    return e;
  }
  ADD_FAILURE() << "no error";
  return {"", {}, {}};
}

TEST(ParameterTable, one_run_a_row_with_values_as_spreadsheets_write_them) {
  const Parameters table = parameter_table(
      "\xEF\xBB\xBF# of the third series\r\n"
      "joint.clay.friction_deg,stage.0.dt , title\r\n"
      "20, 5 ms,\"one, \"\"two\"\"\"\r\n"
      "\r\n"
      "25,0.001,three\r\n",
      "runs.csv");
  ASSERT_EQ(table.runs.size(), 2U);
  EXPECT_EQ(table.overrides(1),
            (Texts{"joint.clay.friction_deg=20", "stage.0.dt=\"5 ms\"", R"(title="one, \"two\"")"}));
  EXPECT_EQ(table.overrides(2), (Texts{"joint.clay.friction_deg=25", "stage.0.dt=0.001", "title=\"three\""}));
  EXPECT_EQ(table.runs[1][1].origin.line, 5);
  EXPECT_EQ(table.runs[1][1].origin.column, 4);
}

TEST(ParameterTable, last_line_needs_no_end) { EXPECT_EQ(parameter_table("a\n1\n2", "t").runs.size(), 2U); }

TEST(ParameterTable, faults_name_line_and_column) {
  const io::CaseError narrow = fault("a,b\n1,2\n3\n");
  EXPECT_EQ(narrow.problem, "the row has 1 fields");
  EXPECT_EQ(narrow.message.substr(0, 13), "runs.csv:3:1:");
  EXPECT_EQ(narrow.allowed, "2 fields, as the heading has");
  EXPECT_EQ(fault("a,b\n1,2,3\n").column, 5);
  const io::CaseError empty = fault("a,b\n1,\n");
  EXPECT_EQ(empty.problem, "the value is missing");
  EXPECT_EQ(empty.line, 2);
  EXPECT_EQ(empty.column, 3);
  EXPECT_EQ(fault("a,,c\n1,2,3\n").problem, "a key is missing in the heading");
  EXPECT_EQ(fault("a,b,a\n1,2,3\n").column, 5);
  EXPECT_EQ(fault("").problem, "the table is empty");
  EXPECT_EQ(fault("a,b\n").problem, "the table has keys and no runs");
  EXPECT_EQ(fault("a\n\"1\n2\n").problem, "the quotation mark is not closed");
  EXPECT_EQ(fault("a\n\"1\" 2\n").column, 5);
}

TEST(ParameterTable, missing_file_is_an_error_of_that_file) {
  const Folder folder;
  EXPECT_THROW((void)read_parameter_table(folder.path() / "none.csv"), io::CaseError);
}

TEST(CsvField, reads_back_as_it_was) {
  for (const std::string text : {"plain", "a,b", "say \"yes\"", "# no comment", "two\nlines"}) {
    const auto records = csv_records("x," + csv_field(text) + "\n", "t");
    ASSERT_EQ(records.size(), 1U) << text;
    EXPECT_EQ(records[0][1].text, text);
  }
}

}  // namespace
}  // namespace scree::app::parameter_table_test
