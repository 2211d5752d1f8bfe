// Recorded accelerations in two columns.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "io/case/record.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test {
namespace {

class RecordFile : public testing::Test {
 protected:
  RecordFile()
      : path_(std::filesystem::temp_directory_path() /
              fmt::format("scree_record_{}_{}.csv", ::getpid(), testing::UnitTest::GetInstance()->random_seed())) {}
  ~RecordFile() override {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
  }
  Record read(const std::string& text, double factor = 1.0) {
    std::ofstream(path_, std::ios::binary) << text;
    return read_record(path_, factor);
  }
  CaseError error_of(const std::string& text) {
    try {
      (void)read(text);
    } catch (const CaseError& e) {
      return e;
    }
    return {"no error", {}, {}};
  }
  std::filesystem::path path_;
};

TEST_F(RecordFile, separators_comments_and_headings_are_read) {
  const Record expected{{0.0, 0.5, 1.0}, {1.0, -2.0, 3e-1}};
  for (const char* text : {"0,1\n0.5,-2\n1,3e-1\n", "t;a\n0;1\n0.5;-2\n1;.3\n", "# a\n0 1\n 0.5\t-2 # b\n\n1 0.3",
                           "time [s], acceleration [g]\r\n0, 1\r\n0.5, -2\r\n1, +0.3\r\n",
                           "\xEF\xBB\xBF"
                           "0,1\n0.5,-2\n1,0.3"}) {
    const Record r = read(text);
    EXPECT_EQ(r.time, expected.time) << text;
    EXPECT_EQ(r.acceleration, expected.acceleration) << text;
  }
}

TEST_F(RecordFile, factor_scales_accelerations_only) {
  const Record r = read("0,1\n1,2\n", 9.80665);
  EXPECT_EQ(r.time, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(r.acceleration, (std::vector<double>{9.80665, 2.0 * 9.80665}));
}

TEST_F(RecordFile, errors_have_line_and_column) {
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
                     {"0;1\n0,5;1,2\n", 2, 5, "4 columns"}};
  for (const auto& w : wrong) {
    const CaseError e = error_of(w.text);
    EXPECT_EQ(e.file, path_.string());
    EXPECT_EQ(e.line, w.line) << w.text << e.what();
    EXPECT_EQ(e.column, w.column) << w.text << e.what();
    EXPECT_NE(e.problem.find(w.problem), std::string::npos) << w.text << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
  }
}

TEST_F(RecordFile, that_is_missing_says_so) {
  try {
    (void)read_record(path_ / "nowhere.csv", 1.0);
    FAIL();
  } catch (const CaseError& e) {
    EXPECT_EQ(e.problem, "the record does not exist");
  }
}

}  // namespace
}  // namespace scree::io::test
