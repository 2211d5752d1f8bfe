#include "io/text/printable.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::io {
namespace {

unsigned byte(std::string_view text, std::size_t i) {
  return i < text.size() ? static_cast<unsigned>(static_cast<unsigned char>(text[i])) : 0U;
}

/// Code point of the character that a text begins with.   @pre utf8_length(text) > 0
unsigned code_point(std::string_view text, std::size_t length) {
  unsigned code = length == 1 ? byte(text, 0) : byte(text, 0) & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) code = (code << 6U) | (byte(text, i) & 0x3FU);
  return code;
}

bool is_plain(unsigned code) {
  if (code < 0x20U || (code >= 0x7FU && code < 0xA0U)) return false;
  if (code == 0x061CU || code == 0x200EU || code == 0x200FU) return false;  // marks of direction
  return !(code >= 0x2028U && code <= 0x202EU) && !(code >= 0x2066U && code <= 0x2069U);
}

std::string escaped(std::string_view text, bool on_one_line) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = utf8_length(text), plain = plain_length(text);
    if (plain > 0 || (!on_one_line && (text[0] == '\n' || text[0] == '\t')))
      out += text.substr(0, length);
    else if (text[0] == '\n')
      out += "\\n";
    else if (text[0] == '\t')
      out += "\\t";
    else if (length > 0)
      out += fmt::format("\\u{:04X}", code_point(text, length));
    else
      out += fmt::format("\\x{:02X}", byte(text, 0));
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace

std::size_t utf8_length(std::string_view text) {
  if (text.empty()) return 0;
  const unsigned a = byte(text, 0);
  if (a < 0x80U) return 1;
  const std::size_t length = a >= 0xC2U && a <= 0xDFU   ? 2
                             : a >= 0xE0U && a <= 0xEFU ? 3
                             : a >= 0xF0U && a <= 0xF4U ? 4
                                                        : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(text, i) & 0xC0U) != 0x80U) return 0;
  const bool overlong = (a == 0xE0U && byte(text, 1) < 0xA0U) || (a == 0xF0U && byte(text, 1) < 0x90U);
  const bool no_scalar = (a == 0xEDU && byte(text, 1) > 0x9FU) || (a == 0xF4U && byte(text, 1) > 0x8FU);
  return overlong || no_scalar ? 0 : length;
}

std::size_t plain_length(std::string_view text) {
  const std::size_t length = utf8_length(text);
  return length > 0 && is_plain(code_point(text, length)) ? length : 0;
}

std::string printable_line(std::string_view text) { return escaped(text, true); }
std::string printable(std::string_view text) { return escaped(text, false); }

}  // namespace scree::io
