#include "io/case/text_fields.h"

namespace scree::io {

TextLines::TextLines(std::string_view text) : rest_(text) {
  if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
}

std::optional<std::string_view> TextLines::next() {
  if (rest_.empty()) return std::nullopt;
  ++row_;
  const std::size_t end = rest_.find('\n');
  const std::string_view line = rest_.substr(0, end);
  rest_ = end == std::string_view::npos ? std::string_view{} : rest_.substr(end + 1);
  return line;
}

std::vector<Field> fields_of(std::string_view line) {
  line = line.substr(0, line.find('#'));
  std::vector<Field> fields;
  const auto space = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  std::size_t i = 0;
  bool after_comma = false;
  while (i < line.size()) {
    if (space(line[i])) {
      ++i;
    } else if (line[i] == ',' || line[i] == ';') {
      if (after_comma || fields.empty())
        fields.push_back({line.substr(i, 0), static_cast<int>(i) + 1});  // an empty field
      after_comma = true;
      ++i;
    } else {
      std::size_t end = i;
      while (end < line.size() && !space(line[end]) && line[end] != ',' && line[end] != ';') ++end;
      fields.push_back({line.substr(i, end - i), static_cast<int>(i) + 1});
      after_comma = false;
      i = end;
    }
  }
  return fields;
}

}  // namespace scree::io
