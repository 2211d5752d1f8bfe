// Untrusted texts in a form that a terminal, a log or a picture can show safely.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace scree::io {

/// Length of the UTF-8 character that a text begins with; 0 if there is none (also for overlong forms and surrogates).
/// @source [RFC3629], table of section 4
[[nodiscard]] std::size_t utf8_length(std::string_view text);

/// Like utf8_length, but 0 also for characters that control a terminal or change the reading order: controls (C0, DEL,
/// C1), separators of lines and paragraphs, and marks of writing direction.
[[nodiscard]] std::size_t plain_length(std::string_view text);

/// A text on one line: characters for which plain_length is 0 are shown as \n, \t, \u001B or, if they are not UTF-8,
/// \xFF. A text without such characters is returned unchanged.
[[nodiscard]] std::string printable_line(std::string_view text);

/// Like printable_line, but line ends and tabs are kept.
[[nodiscard]] std::string printable(std::string_view text);

}  // namespace scree::io
