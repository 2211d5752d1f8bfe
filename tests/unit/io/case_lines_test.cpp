// Files of polylines.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/case/line_file.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_lines_test {
namespace {

/// The lines read from a file with this text, or the error.
struct Lines {
  explicit Lines(const std::string& text) {
    // ctest runs the tests of this file in parallel, each in its own process.
    const std::filesystem::path file =
        std::filesystem::path(testing::TempDir()) / ("scree_lines_test_" + std::to_string(::getpid()) + ".csv");
    std::ofstream(file, std::ios::binary) << text;
    try {
      lines = read_lines(file);
    } catch (const CaseError& e) {
      line = e.line, column = e.column, problem = e.problem;
    }
    std::filesystem::remove(file);
  }
  std::vector<FileLine> lines;
  int line = 0, column = 0;
  std::string problem;
};

TEST(LineFile, blank_lines_separate_and_comments_do_not) {
  const Lines f("x, y\n0, 0\n# a comment\n1, 2\n\n \n3;4\n5 6 # end\n");
  ASSERT_EQ(f.lines.size(), 2u) << f.problem;
  EXPECT_EQ(f.lines[0].points, (std::vector<Vec2>{{0, 0}, {1, 2}}));
  EXPECT_EQ(f.lines[0].rows, (std::vector<int>{2, 4}));
  EXPECT_EQ(f.lines[1].points, (std::vector<Vec2>{{3, 4}, {5, 6}}));
}

TEST(LineFile, third_column_separates_where_it_changes) {
  const Lines f("0 0 a\n1 0 a\n1 1 b\n2 2 b\n0 3 a\n1 3 a\n");
  ASSERT_EQ(f.lines.size(), 3u) << f.problem;
  EXPECT_EQ(f.lines[1].points, (std::vector<Vec2>{{1, 1}, {2, 2}}));
}

TEST(LineFile, byte_order_mark_and_windows_line_ends_are_fine) {
  const Lines f(
      "\xEF\xBB\xBF"
      "0,0\r\n1,1\r\n\r\n2,2\r\n3,3\r\n");
  EXPECT_EQ(f.lines.size(), 2u) << f.problem;
}

TEST(LineFile, numbers_are_read_as_in_records) {
  const Lines f("+1.5D-3, 1e-400\n1d0 -2\n");
  ASSERT_EQ(f.lines.size(), 1u) << f.problem;
  EXPECT_EQ(f.lines[0].points, (std::vector<Vec2>{{1.5e-3, 0}, {1, -2}}));
}

TEST(LineFile, faults_are_reported_at_their_place) {
  const struct {
    const char* text;
    int line, column;
    const char* problem;
  } wrong[] = {{"0,0\n1,x\n", 2, 3, "not a number"},
               {"x,y\ny,x\n", 2, 1, "not a number"},
               {"0,0\n1\n", 2, 1, "1 columns"},
               {"0,0\n+-1,1\n", 2, 1, "not a number"},
               {"0,0\n1,-1e400\n", 2, 3, "out of range"},
               {"0,0,a,b\n", 1, 7, "4 columns"},
               {"0,0\n1,nan\n", 2, 3, "out of range"},
               {"0,0\n1e10,1\n", 2, 1, "out of range"},
               {"0,0\n\n1,1\n2,2\n", 1, 1, "one point only"},
               {"# nothing\n", 1, 1, "holds no line"}};
  for (const auto& w : wrong) {
    const Lines f(w.text);
    EXPECT_EQ(f.line, w.line) << w.text;
    EXPECT_EQ(f.column, w.column) << w.text;
    EXPECT_NE(f.problem.find(w.problem), std::string::npos) << w.text << f.problem;
  }
}

}  // namespace
}  // namespace scree::io::test::case_lines_test
