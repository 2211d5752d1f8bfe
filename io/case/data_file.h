// Files with numbers that a case names.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "io/case/section.h"

namespace scree::io {

/// The file under a key: relative to the folder of the case; a leading "$SCREE_RECORDS/" is that environment variable.
/// @param what  the file holds, for messages: "the recorded motion"
/// @throws CaseError: empty, another variable, variable not set
[[nodiscard]] std::filesystem::path data_path(const Section& s, std::string_view key,
                                              const std::filesystem::path& folder, std::string_view what);

/// All files that a checked document names, as data_path() finds them, in the order of the document; without those
/// whose variable is not set.
[[nodiscard]] std::vector<std::filesystem::path> data_files(const Value& document, const std::filesystem::path& folder);

}  // namespace scree::io
