// Fields of a line of a text file with columns.
#pragma once

#include <string_view>
#include <vector>

namespace scree::io {

struct Field {
  std::string_view text;
  int column;  // from 1
};

/// Fields of a line without its comment ('#' to the end). Commas and semicolons separate, so does white space.
[[nodiscard]] std::vector<Field> fields_of(std::string_view line);

/// Reads a whole field as a decimal number; one beyond the range of double gives nan. False where it is no number.
[[nodiscard]] bool read_number(std::string_view text, double& value);

}  // namespace scree::io
