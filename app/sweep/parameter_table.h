// The parameters of a sweep from a table: one column per key, one row per run.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "app/sweep/parameters.h"

namespace scree::app {

/// Reads comma-separated values, whose first row contains the keys. A field is a TOML value, or a text without
/// quotation marks of its own (dda; 5 ms).
/// @param name  of the file, for errors
/// @throws CaseError with file, line and column: no keys, no runs, rows of another length, empty fields, a key twice
[[nodiscard]] Parameters parameter_table(std::string_view text, const std::string& name);
/// @throws CaseError, also where the file cannot be read
[[nodiscard]] Parameters read_parameter_table(const std::filesystem::path& file);

}  // namespace scree::app
