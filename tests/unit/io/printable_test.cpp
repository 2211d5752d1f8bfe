// Untrusted text is printed without control sequences for the terminal.
#include "io/text/printable.h"

#include <gtest/gtest.h>

#include "io/case/case_error.h"
#include "io/case/document.h"
#include "io/results/file_error.h"

namespace scree::io::printable_test {
namespace {

TEST(Printable, controls_marks_of_direction_and_bad_bytes_are_escaped) {
  EXPECT_EQ(printable("a\x1b[31m\a\r\x7f"), "a\\u001B[31m\\u0007\\u000D\\u007F");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "\\u009B31m");
  EXPECT_EQ(printable("\x9b"
                      "31m\xff"),
            "\\x9B31m\\xFF");
  EXPECT_EQ(printable("\u061c\u200e\u200f\u2028\u202a\u202e\u2066\u2069"),
            "\\u061C\\u200E\\u200F\\u2028\\u202A\\u202E\\u2066\\u2069");
  EXPECT_EQ(printable("\xed\xa0\x80\xc0\x9b"), "\\xED\\xA0\\x80\\xC0\\x9B");
}

TEST(Printable, other_texts_are_themselves) {
  EXPECT_EQ(printable("Böschung, 斜面, 𝛔 ~ \u00a0\n\ta"), "Böschung, 斜面, 𝛔 ~ \u00a0\n\ta");
  EXPECT_EQ(printable_line("a\n\tb"), "a\\n\\tb");
  EXPECT_EQ(printable(""), "");
}

TEST(Printable, errors_show_texts_so) {
  EXPECT_STREQ(FileError("a\n\x1b]0;x\a", "gone").what(), "a\\n\\u001B]0;x\\u0007: gone");
  EXPECT_EQ(in_quotes("\xc2\x9b\u202e"), "\"\\u009B\\u202E\"");
}

TEST(CaseTexts, that_would_steer_a_terminal_are_refused_with_their_place) {
  for (const char* text : {"\\u001b[31m", "\\u009b1m", "\\u202e", "\\n", "\u2066"}) {
    try {
      (void)parse_document(std::string("a = 1\nb = { c = [\"fine\", \"") + text + "\"] }\n", "case.toml");
      FAIL() << text;
    } catch (const CaseError& e) {
      EXPECT_EQ(e.line, 2) << e.what();
      EXPECT_EQ(e.column, 20) << e.what();
      EXPECT_EQ(printable(e.what()), e.what());
      EXPECT_FALSE(e.hint.empty() || e.allowed.empty() || e.value.empty());
    }
  }
  EXPECT_THROW((void)parse_document("\"a\\u0007\" = 1", "case.toml"), CaseError);
  EXPECT_THROW((void)parse_set_value("\"\\u202e\"", 1, 5), CaseError);
  EXPECT_NO_THROW((void)parse_document("a = \"Böschung\"", "case.toml"));
}

}  // namespace
}  // namespace scree::io::printable_test
