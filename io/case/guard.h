// Checks of the bytes of a case file before the TOML parser reads them.
#pragma once

#include <string_view>

namespace scree::io {

inline constexpr std::size_t kLargestCase = std::size_t{16} << 20;  // bytes
inline constexpr int kDeepest = 64;                                 // parts of a dotted key and open brackets together

/// Refuses a text that is empty, larger than kLargestCase, not UTF-8, nested deeper than kDeepest, or has characters
/// other than ASCII outside strings and comments. The parser
/// recurses at every level, and so does the destruction of the tables that it makes: without a bound, a header of many
/// thousand dotted parts terminates the program.
/// @throws CaseError
void guard(std::string_view text, std::string_view file);

}  // namespace scree::io
