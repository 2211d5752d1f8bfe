// Files with numbers that a case names.
#pragma once

#include <filesystem>
#include <string_view>

#include "io/case/section.h"

namespace scree::io {

/// The file under a key: relative to the folder of the case; a leading "$SCREE_RECORDS/" is that environment variable.
/// @param what  the file holds, for messages: "the recorded motion"
/// @throws CaseError: empty, another variable, variable not set
[[nodiscard]] std::filesystem::path data_path(const Section& s, std::string_view key,
                                              const std::filesystem::path& folder, std::string_view what);

}  // namespace scree::io
