#include "io/case/guard.h"

#include <fmt/format.h>

#include <vector>

#include "io/case/case_error.h"
#include "io/text/printable.h"

namespace scree::io {
namespace {

/// Scans the text for the parts of TOML that matter here: strings, comments, brackets and the dots of keys.
class Scanner {
 public:
  Scanner(std::string_view text, std::string_view file) : text_(text), file_(file) {}

  void run() {
    if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
    while (!rest().empty()) {
      const char c = rest().front();
      if (c == '\n') {
        end_line();
      } else if (c == '#') {
        while (!rest().empty() && rest().front() != '\n') step();
      } else if (c == '"' || c == '\'') {
        string(c);
      } else {
        if (c == '[' || c == '{') open(c);
        if (c == ']' || c == '}') close();
        if (c == ',') dots_.back() = 0;
        if (c == '.') ++dots_.back(), check();
        if (c != ' ' && c != '\t') line_begins_ = false;
        const std::size_t from = at_;
        step();
        if (at_ - from > 1) bare(text_.substr(from, at_ - from));
      }
    }
  }

 private:
  [[nodiscard]] std::string_view rest() const { return text_.substr(at_); }

  void step() {
    const std::size_t n = utf8_length(rest());
    if (n == 0)
      throw CaseError(file_, {line_, column_},
                      {"the file is not UTF-8 text", "",
                       fmt::format("byte 0x{:02X}", static_cast<unsigned>(static_cast<unsigned char>(text_[at_]))),
                       "UTF-8", "save the file as UTF-8; a case file is plain text"});
    if (text_[at_] == '\n')
      ++line_, column_ = 1;
    else
      ++column_;
    at_ += n;
  }

  /// TOML forbids this, and toml++ 3.3 has undefined behaviour when it tests whether the character is a blank.
  [[noreturn]] void bare(std::string_view wide) const {
    throw CaseError(file_, {line_, column_ - 1},
                    {"this character stands outside quotation marks and comments", "", in_quotes(wide),
                     "letters, digits and signs of ASCII", "put names with other letters into quotation marks"});
  }

  void string(char quote) {
    const std::string three(3, quote);
    line_begins_ = false;
    const bool multiline = rest().starts_with(three);
    for (int i = 0; i < (multiline ? 3 : 1); ++i) step();
    while (!rest().empty()) {
      if (multiline ? rest().starts_with(three) : rest().front() == quote) {
        for (int i = 0; i < (multiline ? 3 : 1); ++i) step();
        for (int i = 0; multiline && i < 2 && rest().starts_with(quote); ++i) step();  // extra quotes at the end
        return;
      }
      if (!multiline && rest().front() == '\n') return;  // the parser reports that the string does not end
      if (quote == '"' && rest().front() == '\\') {
        step();
        if (rest().empty()) return;
      }
      step();
    }
  }

  void end_line() {
    if (dots_.size() == 1 || header_) dots_.assign(1, 0), header_ = false;
    line_begins_ = true;
    step();
  }

  void open(char c) {
    if (c == '[' && line_begins_ && dots_.size() == 1) header_ = true;  // ends with its line even if not closed
    dots_.push_back(0);
    check();
  }

  void close() {
    if (dots_.size() > 1) dots_.pop_back();
    dots_.back() = 0;
  }

  void check() {
    // Called at every new dot and bracket, so that the sum stays small.
    int depth = static_cast<int>(dots_.size()) - 1;
    for (const int d : dots_) depth += d;
    if (depth > kDeepest)
      throw CaseError(file_, {line_, column_},
                      {fmt::format("keys and brackets nest deeper than {} levels", kDeepest), "", "",
                       fmt::format("at most {} dotted parts and open brackets together", kDeepest),
                       "no key of a case file needs more than four; quote a name that holds dots"});
  }

  std::string_view text_, file_;
  std::size_t at_ = 0;
  int line_ = 1, column_ = 1;
  std::vector<int> dots_{0};  // dots of the item being read (key and value), outside brackets and within each open one
  bool header_ = false, line_begins_ = true;
};

}  // namespace

void guard(std::string_view text, std::string_view file) {
  if (text.size() > kLargestCase)
    throw CaseError(
        file, {},
        {fmt::format("the file has {} bytes", text.size()), "", "", fmt::format("at most {} bytes", kLargestCase),
         "a case file is a description; put recorded motions into CSV files of their own"});
  Scanner(text, file).run();
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
    throw CaseError(file, {1, 1},
                    {"the case file is empty", "", "", "a TOML text with at least one [[block]] and one [[stage]]",
                     "`scree schema` lists every key"});
}

}  // namespace scree::io
