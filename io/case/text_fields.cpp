#include "io/case/text_fields.h"

#include <charconv>
#include <cmath>

namespace scree::io {

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

bool read_number(std::string_view text, double& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
  if (read.ec == std::errc::result_out_of_range) value = std::nan("");  // a number, but not a finite one of ours
  return read.ec != std::errc::invalid_argument && read.ptr == text.data() + text.size();
}

}  // namespace scree::io
