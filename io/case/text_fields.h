// Lines of a text file, and the fields of a line with columns.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace scree::io {

/// The lines of a text one after another; a byte order mark before the first line is skipped.
class TextLines {
 public:
  explicit TextLines(std::string_view text);

  /// The next line without its '\n' (a '\r' before it stays); nothing after the last.
  [[nodiscard]] std::optional<std::string_view> next();
  /// Number of the line that next() returned last, from 1; 0 before the first.
  [[nodiscard]] int row() const { return row_; }

 private:
  std::string_view rest_;
  int row_ = 0;
};

struct Field {
  std::string_view text;
  int column;  // from 1
};

/// Fields of a line without its comment ('#' to the end), separated by commas, semicolons or white space.
[[nodiscard]] std::vector<Field> fields_of(std::string_view line);

}  // namespace scree::io
