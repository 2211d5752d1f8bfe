// A whole text file, with a bound on its size.
#pragma once

#include <filesystem>
#include <string>

namespace scree::io {

/// @param what  for messages: "case file", "record"     @param most  bytes
/// @throws CaseError without line and column: missing, not a file, unreadable, too large
[[nodiscard]] std::string read_text_file(const std::filesystem::path& file, const char* what, std::size_t most);

}  // namespace scree::io
