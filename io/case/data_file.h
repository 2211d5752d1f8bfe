// Files of numbers that are named in a case.
#pragma once

#include <filesystem>
#include <string_view>
#include <vector>

#include "io/case/section.h"

namespace scree::io {

/// The file under a key: relative to the folder of the case; a leading "$SCREE_RECORDS/" is that environment variable.
/// @param what  contents of the file, for messages: "the recorded motion"
/// @throws CaseError: empty, another variable, variable not set
[[nodiscard]] std::filesystem::path data_path(const Section& s, std::string_view key,
                                              const std::filesystem::path& folder, std::string_view what);

/// All files named in a checked document, with paths as from data_path(), in the order of the document. Files whose
/// environment variable is not set are left out.
[[nodiscard]] std::vector<std::filesystem::path> data_files(const Value& document, const std::filesystem::path& folder);

}  // namespace scree::io
