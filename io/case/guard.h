// What is checked in the bytes of a case file before the TOML parser sees them.
#pragma once

#include <string_view>

namespace scree::io {

inline constexpr std::size_t kLargestCase = std::size_t{16} << 20;  // bytes
inline constexpr int kDeepest = 64;                                 // parts of a dotted key and open brackets together

/// Refuses a text that is empty, larger than kLargestCase, not UTF-8, or nested deeper than kDeepest. The parser calls
/// itself for every level, and the tables it makes free themselves the same way: without a bound a header of many
/// thousand dotted parts ends the program.
/// @throws CaseError
void guard(std::string_view text, std::string_view file);

}  // namespace scree::io
