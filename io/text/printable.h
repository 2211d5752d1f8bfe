// Texts that may come from anywhere, as a terminal, a log or a picture may show them.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scree::io {

/// Length of the UTF-8 character that a text begins with; 0 where there is none (overlong forms and surrogates too).
/// @source [RFC3629], table of section 4
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// The same, and 0 also for characters that steer a terminal or turn the order of what is read: controls (C0, DEL, C1),
/// separators of lines and paragraphs, and marks of writing direction.
[[nodiscard]] std::size_t plain_length(std::string_view text);

/// A text on one line: what plain_length refuses is shown as \n, \t, \u001B or, where it is no UTF-8, \xFF. Where
/// nothing is refused it is the text itself.
[[nodiscard]] std::string printable_line(std::string_view text);

/// The same, but line ends and tabs stay.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace scree::io
