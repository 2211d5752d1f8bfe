// Comma-separated values as text: fields with their places, and the writing of a field.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace scree::app {

struct CsvField {
  std::string text;  // without quotation marks; blanks around an unquoted field are left out
  int line = 0, column = 0;
};

/// Records of a text. Lines that are empty or begin with '#' are skipped, and so is a byte order mark before the first.
/// @param name  of the file, for errors   @throws CaseError where quotation marks are not in pairs
/// @source [RFC4180] section 2
[[nodiscard]] std::vector<std::vector<CsvField>> csv_records(std::string_view text, const std::string& name);

/// A text as a field: in quotation marks where a comma, a quotation mark, a '#' or a line end would break the table.
[[nodiscard]] std::string csv_field(std::string_view text);

}  // namespace scree::app
