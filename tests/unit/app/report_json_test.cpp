#include "app/verify/report_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>

#include "app/verify/report.h"
#include "io/results/file_error.h"
#include "tests/unit/app/folder.h"

namespace scree::app::report_json_test {
namespace {

std::vector<CaseReport> two_reports() {
  CaseReport one;
  one.name = "beam";
  one.title = "A \"beam\" \\ of µm";
  one.wall = 0.1 + 0.2;
  one.notes = {"first: 3 steps", "second\nline"};
  one.rows.push_back({"deflection [m]", "Euler", "0.5 +- 0.01", 1.0 / 3.0, true, "", false});
  one.rows.push_back({"needs a record", "-", ">= 0", 0.0, false, "SCREE_RECORDS is not set", true});
  one.rows.push_back({"not a number", "-", ">= 0", std::numeric_limits<double>::quiet_NaN(), false, "", false});
  io::LinePlot plot;
  plot.title = "Deflection";
  plot.x_label = "x [m]";
  plot.y_label = "u [m]";
  plot.log_y = true;
  plot.series.push_back({"found", {0.0, 1e-300, 3.0}, {1.0, 2.0, 1e300}, true, false});
  plot.series.push_back({"Euler", {}, {}, false, true});
  one.plots.push_back(plot);
  CaseReport none;
  none.name = "empty";
  return {one, none};
}

std::vector<CaseReport> read_back(const std::vector<CaseReport>& reports) {
  const Folder folder;
  write_table(reports, folder.path() / "table.json");
  return read_json_report(folder.path() / "table.json");
}

TEST(ReportJson, gives_every_field_back_to_the_last_bit) {
  const std::vector<CaseReport> before = two_reports(), after = read_back(before);
  ASSERT_EQ(after.size(), 2U);
  EXPECT_EQ(after[1].name, "empty");
  EXPECT_EQ(after[0].title, before[0].title);
  EXPECT_EQ(after[0].notes, before[0].notes);
  EXPECT_EQ(after[0].wall, before[0].wall);
  ASSERT_EQ(after[0].rows.size(), 3U);
  EXPECT_EQ(after[0].rows[0].found, 1.0 / 3.0);
  EXPECT_TRUE(after[0].rows[0].pass);
  EXPECT_TRUE(after[0].rows[1].skipped);
  EXPECT_EQ(after[0].rows[1].trouble, "SCREE_RECORDS is not set");
  EXPECT_TRUE(std::isnan(after[0].rows[2].found));
  ASSERT_EQ(after[0].plots.size(), 1U);
  const io::LinePlot& plot = after[0].plots[0];
  EXPECT_EQ(plot.y_label, "u [m]");
  EXPECT_FALSE(plot.log_x);
  EXPECT_TRUE(plot.log_y);
  ASSERT_EQ(plot.series.size(), 2U);
  EXPECT_EQ(plot.series[0].x, before[0].plots[0].series[0].x);
  EXPECT_EQ(plot.series[0].y, before[0].plots[0].series[0].y);
  EXPECT_TRUE(plot.series[0].points);
  EXPECT_TRUE(plot.series[1].dashed);
  // What is made of either is the same text.
  EXPECT_EQ(markdown_report(after, true), markdown_report(before, true));
  EXPECT_EQ(csv_report(after), csv_report(before));
  EXPECT_EQ(terminal_text(after[0]), terminal_text(before[0]));
}

TEST(ReportJson, other_files_are_refused) {
  const Folder folder;
  EXPECT_THROW((void)read_json_report(folder.path() / "none.json"), io::FileError);
  const std::string whole = json_report(two_reports());
  for (const std::string& text :
       {std::string("{"), std::string("[1]"), std::string("[{\"name\": 3}]"), whole.substr(0, whole.size() / 2)}) {
    std::ofstream(folder.path() / "wrong.json") << text;
    EXPECT_THROW((void)read_json_report(folder.path() / "wrong.json"), io::FileError) << text;
  }
}

}  // namespace
}  // namespace scree::app::report_json_test
