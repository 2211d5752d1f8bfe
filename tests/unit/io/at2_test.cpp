// Reading of PEER .AT2 records. All texts are synthetic; a damaged record gives one clear error or a valid record.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "io/case/number_text.h"
#include "io/case/record.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::at2_test {
namespace {

const std::string kTitle = "PEER STRONG MOTION DATABASE RECORD\nNOWHERE 01/01/00 00:00, MADE UP, 090\n";
const std::string kUnits = "ACCELERATION TIME HISTORY IN UNITS OF G\n";
const std::string kCounts = "NPTS=  4, DT= .00500 SEC\n";

Record read(const std::string& text) { return read_at2(text, "a.AT2"); }
CaseError error_of(const std::string& text) {
  return error_in([&] { (void)read(text); });
}

TEST(At2, both_headers_and_their_spellings_are_read) {
  for (const char* counts :
       {"NPTS=  4, DT= .00500 SEC", "NPTS=4,DT=.005SEC", "NPTS=   4, DT=   .0050 SEC,", "npts = 4 dt = 5.0E-3",
        "4 0.00500 NPTS, DT", "    4    .0050    NPTS, DT   ", "4, 0.005, NPTS, DT", "NPTS= 4, DT= 5.D-03 SEC"}) {
    const Record r = read(kTitle + kUnits + counts + "\n 1. -2. 3.5\n .25\n");
    EXPECT_EQ(r.acceleration, (std::vector<double>{1.0, -2.0, 3.5, 0.25})) << counts;
    EXPECT_EQ(r.time, (std::vector<double>{0.0, 0.005, 2 * 0.005, 3 * 0.005})) << counts;
    EXPECT_EQ(r.unit, "g");
  }
}

TEST(At2, numbers_run_together_split_at_their_sign) {
  struct {
    const char* text;
    std::vector<double> numbers;
  } const rows[] = {{"1.234-5.678", {1.234, -5.678}},
                    {"-.1234567E-01-.2345678E-02-.3E+00", {-.1234567e-1, -.2345678e-2, -.3}},
                    {"1.5D-3+2.5d1", {1.5e-3, 25.0}},
                    {"1.234-105-2.5+003", {1.234e-105, -2500.0}},  // exponent of three digits without its letter
                    {"1.234-10-2.", {1.234, -10.0, -2.0}},
                    {"0.5-105.", {0.5, -105.0}},
                    {"3-4", {3.0, -4.0}},
                    {"1e-400 -1D-999", {0.0, -0.0}}};
  for (const auto& row : rows) {
    const Record r = read(kUnits + fmt::format("NPTS= {}, DT= .01\n", row.numbers.size()) + row.text);
    EXPECT_EQ(r.acceleration, row.numbers) << row.text;
  }
}

TEST(At2, line_ends_marks_and_blank_lines_are_fine) {
  const std::vector<double> numbers = {1.0, 2.0, 3.0, 4.0};
  const std::string plain = kTitle + kUnits + kCounts + " 1. 2.\n\n 3.\t4.\n\n";
  std::string windows;
  for (const char c : plain) {
    if (c == '\n') windows += '\r';
    windows += c;
  }
  EXPECT_EQ(read(windows).acceleration, numbers);
  EXPECT_EQ(read(windows + "\x1A\r\n").acceleration, numbers);  // DOS end-of-file mark
  EXPECT_EQ(read("\xEF\xBB\xBF" + kCounts + "1. 2. 3. 4.").acceleration, numbers);
}

TEST(At2, unit_is_read_from_its_line) {
  struct {
    const char *line, *unit;
  } const units[] = {{"ACCELERATION TIME SERIES IN UNITS OF G", "g"},
                     {"ACCELERATION TIME HISTORY IN UNITS OF G. FILTER POINTS: HP=0.12 Hz LP=23.0 Hz", "g"},
                     {"Acceleration in units of cm/s/s", "cm/s2"},
                     {"IN UNITS OF CM/SEC/SEC", "cm/s2"},
                     {"IN UNITS OF CM/SEC**2", "cm/s2"},
                     {"IN UNITS OF cm/s^2", "cm/s2"},
                     {"IN UNITS OF GAL", "cm/s2"},
                     {"UNITS: (m/s2)", "m/s2"},
                     {"no word of it", ""}};
  for (const auto& u : units) EXPECT_EQ(read(fmt::format("{}\n{}1. 2. 3. 4.", u.line, kCounts)).unit, u.unit) << u.line;
}

TEST(At2, errors_have_line_column_and_value) {
  const std::string head = kTitle + kUnits;
  struct {
    std::string text;
    int line, column;
    const char *value, *problem;
  } const wrong[] = {
      {head + kCounts + " 1. 2.\n 3.\n", 4, 8, "\"4\"", "announces 4 values, the file holds 3"},
      {head + kCounts + " 1. 2.\n 3. 4. 5.\n", 6, 8, "\"5.\"", "goes on after the 4 values"},
      {head + kCounts + " 1. 2.\n 3. x4.\n", 6, 5, "\"x4.\"", "not a number"},
      {head + kCounts + " 1. 2.x\n", 5, 5, "\"2.x\"", "not a number"},
      {head + kCounts + " 1.2.3\n", 5, 2, "\"1.2.3\"", "not a number"},
      {head + kCounts + " 1.E\n", 5, 2, "\"1.E\"", "not a number"},
      {head + kCounts + " 1.,2.\n", 5, 2, "\"1.,2.\"", "not a number"},
      {head + kCounts + " 1.-x\n", 5, 4, "\"-x\"", "not a number"},
      {head + kCounts + " ********\n", 5, 2, "\"********\"", "not a number"},
      {head + kCounts + " 1. NaN\n", 5, 5, "\"NaN\"", "not finite"},
      {head + kCounts + " 1. -Infinity\n", 5, 5, "\"-Infinity\"", "not finite"},
      {head + kCounts + " 1. 1.E400\n", 5, 5, "\"1.E400\"", "not finite"},
      {head + " 1. 2. 3. 4.\n", 1, 1, "\"PEER STRONG MOTION DATABASE RECORD\"", "no header"},
      {"", 1, 1, "\"\"", "no header"},
      {head + "NPTS= many, DT= .005\n1.", 4, 7, "\"many\"", "NPTS is not"},
      {head + "NPTS= -4, DT= .005\n1.", 4, 7, "\"-4\"", "NPTS is not"},
      {head + "NPTS= 4.5, DT= .005\n1.", 4, 7, "\"4.5\"", "NPTS is not"},
      {head + "NPTS= 1, DT= .005\n1.", 4, 7, "\"1\"", "NPTS is not"},
      {head + "NPTS= 99999999999999999999, DT= .005\n1.", 4, 7, "\"99999999999999999999\"", "NPTS is not"},
      {head + "NPTS= 4, DT= 0.\n1.", 4, 14, "\"0.\"", "DT is not"},
      {head + "NPTS= 4, DT= -.005\n1.", 4, 14, "\"-.005\"", "DT is not"},
      {head + "NPTS= 4, DT= 1E999\n1.", 4, 14, "\"1E999\"", "DT is not"},
      {head + "NPTS= 4, DT= .005x\n1.", 4, 14, "\".005x\"", "DT is not"},
      {head + "NPTS= 4, DT=\n1.", 4, 13, "\"\"", "DT is not"},
      {head + "NPTS= 4\n1.", 4, 1, "\"NPTS\"", "no DT"},
      {head + "4 NPTS, DT\n1.", 4, 1, "\"4\"", "one number before NPTS"},
      {"VELOCITY TIME HISTORY IN UNITS OF CM/SEC\n" + kCounts, 1, 35, "\"CM/SEC\"", "velocities"},
      {"DISPLACEMENT IN UNITS OF CM\n" + kCounts, 1, 26, "\"CM\"", "displacements"},
      {"IN UNITS OF FT/S/S\n" + kCounts, 1, 13, "\"FT/S/S\"", "unit of the accelerations is not known"}};
  for (const auto& w : wrong) {
    const CaseError e = error_of(w.text);
    EXPECT_EQ(e.file, "a.AT2") << w.text;
    EXPECT_EQ(e.line, w.line) << w.text << e.what();
    EXPECT_EQ(e.column, w.column) << w.text << e.what();
    EXPECT_EQ(e.value, w.value) << w.text << e.what();
    EXPECT_NE(e.problem.find(w.problem), std::string::npos) << w.text << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
  }
}

/// Reads any text and expects either a record with the properties that Record states, or one clear error.
/// @return whether it was a record
bool reads_or_says_why(const std::string& text) {
  bool fine = false;
  for (const bool peer : {true, false}) try {
      const Record r = peer ? read_at2(text, "a") : read_columns(text, "a", Gaps::refuse);
      fine |= peer;
      EXPECT_GE(r.time.size(), 2u);
      EXPECT_EQ(r.time.size(), r.acceleration.size());
      for (std::size_t i = 0; i < r.time.size(); ++i) {
        EXPECT_TRUE(std::isfinite(r.time[i]) && std::isfinite(r.acceleration[i]));
        if (i > 0) {
          EXPECT_GT(r.time[i], r.time[i - 1]);
        }
      }
    } catch (const CaseError& e) {
      const std::string message = e.what();
      EXPECT_TRUE(e.line >= 1 && e.column >= 1) << message;
      EXPECT_FALSE(e.problem.empty() || e.allowed.empty() || e.hint.empty()) << message;
      for (const char c : message)
        EXPECT_TRUE(c == '\n' || static_cast<unsigned char>(c) >= 0x20u) << "control character in " << message;
      EXPECT_LT(message.size(), 1000u);
    }
  return fine;
}

std::string good_record() {
  std::string text = kTitle + kUnits + "NPTS=  60, DT= .00500 SEC\n";
  for (int i = 0; i < 60; ++i) text += fmt::format("{:15.7E}{}", 0.3 * std::sin(i), i % 5 == 4 ? "\n" : "");
  return text;
}

TEST(RecordFuzz, truncated_records_are_read_or_explained) {
  const std::string text = good_record();
  ASSERT_TRUE(reads_or_says_why(text));
  std::size_t whole = 0;
  for (std::size_t n = 0; n < text.size(); ++n) whole += reads_or_says_why(text.substr(0, n)) ? 1u : 0u;
  // Only a cut within the last number that leaves a shorter number cannot be detected.
  EXPECT_LE(whole, 15u);
}

TEST(RecordFuzz, mutated_records_are_read_or_explained) {
  std::mt19937 generator(20);
  const std::string text = good_record();
  const std::string likely = "0123456789.+-eEdD ,;#=\n\r\t*NPTSDT\x1A";
  std::size_t read = 0;
  for (int run = 0; run < 20000; ++run) {
    std::string changed = text;
    const unsigned edits = 1u + generator() % 4u;
    for (unsigned k = 0; k < edits; ++k) {
      const std::size_t at = generator() % changed.size();
      const char c = generator() % 2u ? likely[generator() % likely.size()] : static_cast<char>(generator() % 256u);
      switch (generator() % 3u) {
        case 0:
          changed[at] = c;
          break;
        case 1:
          changed.insert(at, 1, c);
          break;
        default:
          changed.erase(at, 1u + generator() % 30u);
      }
      if (changed.empty()) changed = c;
    }
    read += reads_or_says_why(changed) ? 1u : 0u;
  }
  EXPECT_GT(read, 1000u);   // a changed digit often gives another valid record
  EXPECT_LT(read, 19000u);  // other changes give errors
}

TEST(RecordFuzz, random_bytes_are_read_or_explained) {
  std::mt19937 generator(21);
  for (int run = 0; run < 5000; ++run) {
    std::string text(generator() % 200u, '\0');
    const unsigned range = run % 2 == 0 ? 256u : 0u;
    const std::string some = "0123456789.+-eE \n,;#";
    for (char& c : text) c = range ? static_cast<char>(generator() % range) : some[generator() % some.size()];
    (void)reads_or_says_why(text);
    (void)reads_or_says_why(kCounts + text);
  }
}

TEST(NumberText, is_all_of_the_text_or_none) {
  EXPECT_EQ(number_of_text("1.5D-3"), 1.5e-3);
  EXPECT_EQ(number_of_text("+2"), 2.0);
  EXPECT_EQ(number_of_text("-1e-999"), -0.0);
  EXPECT_EQ(number_of_text("-1e999"), -HUGE_VAL);
  EXPECT_EQ(number_of_text("0." + std::string(400, '0') + "1e500"), 1e99);
  EXPECT_TRUE(std::isnan(number_of_text("nan").value_or(0.0)));
  for (const char* none : {"", "+", "+-1", "1x", " 1", "1 ", "0x10", "1e", "d", "1,5"})
    EXPECT_FALSE(number_of_text(none).has_value()) << none;
}

}  // namespace
}  // namespace scree::io::test::at2_test
