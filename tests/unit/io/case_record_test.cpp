// Recorded accelerations in two columns, and the choice of the reader of a file.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "io/case/record.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_record_test {
namespace {

Record read(const std::string& text, Gaps gaps = Gaps::refuse) { return read_columns(text, "record.csv", gaps); }
CaseError error_of(const std::string& text) {
  return error_in([&] { (void)read(text); });
}

TEST(RecordColumns, separators_comments_and_headings_are_read) {
  const Record expected{{0.0, 0.5, 1.0}, {1.0, -2.0, 3e-1}};
  const std::string with_mark = std::string("\xEF\xBB\xBF") + "0,1\n0.5,-2\n1,0.3";
  for (const char* text : {"0,1\n0.5,-2\n1,3e-1\n", "t;a\n0;1\n0.5;-2\n1;.3\n", "# a\n0 1\n 0.5\t-2 # b\n\n1 0.3",
                           "time [s], acceleration [g]\r\n0, 1\r\n0.5, -2\r\n1, +0.3\r\n", with_mark.c_str()}) {
    const Record r = read(text);
    EXPECT_EQ(r.time, expected.time) << text;
    EXPECT_EQ(r.acceleration, expected.acceleration) << text;
  }
}

TEST(RecordColumns, exponents_of_fortran_and_tiny_numbers_are_read) {
  EXPECT_EQ(read("0,1.5D-3\n1d0,-2d+1\n2,1e-400\n").acceleration, (std::vector<double>{1.5e-3, -20.0, 0.0}));
}

TEST(RecordColumns, errors_have_line_and_column) {
  struct {
    const char* text;
    int line, column;
    const char* problem;
  } const wrong[] = {{"0,1\n1,x\n", 2, 3, "not a number"},
                     {"0,1\nx,1\n", 2, 1, "not a number"},
                     {"t,a\ns,g\n0,1\n1,1\n", 2, 1, "not a number"},
                     {"0,1\n1,1e\n", 2, 3, "not a number"},
                     {"0,1\n1,nan\n", 2, 3, "not finite"},
                     {"inf,1\n1,1\n", 1, 1, "not finite"},
                     {"0,1\n1,1e400\n", 2, 3, "not finite"},
                     {"0,1\n 0.0,2\n", 2, 2, "does not increase"},
                     {"0,1\n1,2,3\n", 2, 5, "3 columns"},
                     {"0,1\n1\n", 2, 1, "1 columns"},
                     {"0,1\n1,,2\n", 2, 4, "3 columns"},
                     {"0,1\n", 1, 1, "1 rows"},
                     {"", 1, 1, "0 rows"},
                     {"0;1\n0,5;1,2\n", 2, 5, "4 columns"},
                     {"0,1\n+-1,1\n", 2, 1, "not a number"},
                     {"0,1\n1,-1e400\n", 2, 3, "not finite"}};
  for (const auto& w : wrong) {
    const CaseError e = error_of(w.text);
    EXPECT_EQ(e.file, "record.csv");
    EXPECT_EQ(e.line, w.line) << w.text << e.what();
    EXPECT_EQ(e.column, w.column) << w.text << e.what();
    EXPECT_NE(e.problem.find(w.problem), std::string::npos) << w.text << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
  }
}

TEST(RecordColumns, gap_is_refused_at_the_row_after_it) {
  const CaseError e = error_of("t,a\n0.00,1\n0.01,1\n0.02,1\n 0.05,1\n0.06,1\n");
  EXPECT_EQ(e.line, 5) << e.what();
  EXPECT_EQ(e.column, 2) << e.what();
  EXPECT_EQ(e.value, "\"0.05\"");
  EXPECT_EQ(e.problem, "the step from 0.02 s to 0.05 s is not the 0.01 s of the other rows");
  EXPECT_EQ(e.allowed, "0.03, within 0.005 s");
  EXPECT_NE(e.hint.find("resample = 0.01"), std::string::npos) << e.what();
  EXPECT_NE(e.hint.find("split"), std::string::npos) << e.what();
}

TEST(RecordColumns, every_missing_row_is_found_but_at_the_ends) {
  constexpr int kRows = 50;
  for (const double step : {0.005, 0.01, 1.0 / 3.0, 2.0})
    for (int missing = 0; missing < kRows; ++missing) {
      std::string text;
      for (int i = 0; i < kRows; ++i)
        if (i != missing) text += fmt::format("{:.3f}, 1\n", step * i);
      EXPECT_EQ(error_of(text).line, missing == 0 || missing == kRows - 1 ? 0 : missing + 1) << step;
    }
}

TEST(RecordColumns, times_rounded_to_their_decimals_are_no_gaps) {
  std::string thirds, cut_zeros, noise;
  for (int i = 0; i < 400; ++i) {
    thirds += fmt::format("{:.3f} 1\n", i / 300.0);
    cut_zeros += fmt::format("{:g};1\n", i * 0.005);  // as spreadsheets write times: 0.005, 0.01, 0.015
    noise += fmt::format("{:.17g},1\n", i * 0.1);     // 0.30000000000000004
  }
  for (const std::string& text : {thirds, cut_zeros, noise}) EXPECT_EQ(read(text).time.size(), 400u);
}

TEST(RecordColumns, gaps_are_accepted_where_they_are_bridged) {
  EXPECT_EQ(read("0,1\n1,1\n2,1\n5,1\n", Gaps::accept).time, (std::vector<double>{0.0, 1.0, 2.0, 5.0}));
}

class RecordFile : public testing::Test {
 public:
  RecordFile() { std::filesystem::create_directories(folder_); }
  ~RecordFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

 protected:
  std::filesystem::path put(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name, std::ios::binary) << text;
    return folder_ / name;
  }
  std::filesystem::path folder_ = std::filesystem::temp_directory_path() / fmt::format("scree_record_{}", ::getpid());
};

TEST_F(RecordFile, called_at2_in_any_case_is_read_as_peer) {
  const std::string peer = "A\nB\nACCELERATION TIME HISTORY IN UNITS OF G\n2 0.01 NPTS, DT\n 1.0 2.0\n";
  for (const char* name : {"a.AT2", "a.at2", "a.At2"})
    EXPECT_EQ(read_record(put(name, peer), Gaps::refuse).time, (std::vector<double>{0.0, 0.01})) << name;
  EXPECT_EQ(read_record(put("a.txt", "0 1\n1 2\n"), Gaps::refuse).time, (std::vector<double>{0.0, 1.0}));
  try {
    (void)read_record(put("b.txt", peer), Gaps::refuse);
    FAIL();
  } catch (const CaseError& e) {
    EXPECT_NE(e.hint.find(".AT2"), std::string::npos) << e.what();
  }
}

TEST_F(RecordFile, that_is_missing_says_so) {
  try {
    (void)read_record(folder_ / "nowhere.csv", Gaps::refuse);
    FAIL();
  } catch (const CaseError& e) {
    EXPECT_EQ(e.problem, "the record does not exist");
    EXPECT_EQ(e.line, 0);
  }
}

}  // namespace
}  // namespace scree::io::test::case_record_test
