#include "app/sweep/csv_text.h"

#include "io/case/case_error.h"

namespace scree::app {
namespace {

/// Reads a text once, counting lines and columns.
class Scanner {
 public:
  Scanner(std::string_view text, const std::string& name) : rest_(text), name_(&name) {
    constexpr std::string_view kMark = "\xEF\xBB\xBF";
    if (rest_.starts_with(kMark)) rest_.remove_prefix(kMark.size());
  }

  [[nodiscard]] bool at_end() const { return rest_.empty(); }
  /// Skips a line that is empty or a comment.
  bool skip_line() {
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    if (const std::size_t first = line.find_first_not_of(" \t\r");
        first != std::string_view::npos && line[first] != '#')
      return false;
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++line_, column_ = 1;
    return true;
  }
  std::vector<CsvField> record() {
    std::vector<CsvField> fields;
    do fields.push_back(field());
    while (take(','));
    if (take('\r')) (void)take('\r');
    if (!at_end() && !take('\n'))
      fail(line_, column_, "there is more after the closing quotation mark", "a comma or the end of the line",
           "write a quotation mark inside a field twice");
    return fields;
  }

 private:
  [[noreturn]] void fail(int line, int column, std::string problem, std::string allowed, std::string hint) const {
    throw io::CaseError(*name_, {line, column}, {std::move(problem), "", "", std::move(allowed), std::move(hint)});
  }
  bool take(char c) {
    if (rest_.empty() || rest_.front() != c) return false;
    rest_.remove_prefix(1);
    if (c == '\n')
      ++line_, column_ = 1;
    else
      ++column_;
    return true;
  }
  void skip_blanks() {
    while (take(' ') || take('\t')) {
    }
  }
  CsvField field() {
    skip_blanks();
    CsvField out{"", line_, column_};
    if (take('"')) {
      quoted(out);
      skip_blanks();
      return out;
    }
    const std::size_t end = std::min(rest_.find_first_of(",\n"), rest_.size());
    std::string_view text = rest_.substr(0, end);
    rest_.remove_prefix(end);
    column_ += static_cast<int>(end);
    while (!text.empty() && std::string_view(" \t\r").find(text.back()) != std::string_view::npos)
      text.remove_suffix(1);
    out.text = text;
    return out;
  }
  /// The field after its opening quotation mark.
  void quoted(CsvField& out) {
    while (!at_end()) {
      if (take('"')) {
        if (!take('"')) return;
        out.text += '"';
      } else {
        out.text += rest_.front();
        take(rest_.front());
      }
    }
    fail(out.line, out.column, "the quotation mark is not closed", "fields as of RFC 4180",
         "close it, or write it twice");
  }

  std::string_view rest_;
  const std::string* name_;
  int line_ = 1, column_ = 1;
};

}  // namespace

std::vector<std::vector<CsvField>> csv_records(std::string_view text, const std::string& name) {
  std::vector<std::vector<CsvField>> records;
  Scanner scanner(text, name);
  while (!scanner.at_end())
    if (!scanner.skip_line()) records.push_back(scanner.record());
  return records;
}

std::string csv_field(std::string_view text) {
  if (text.find_first_of(",\"\r\n#") == std::string_view::npos) return std::string(text);
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

}  // namespace scree::app
