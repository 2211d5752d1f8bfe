#include "io/case/case_error.h"

#include <fmt/format.h>

namespace scree::io {
namespace {

/// Control characters as TOML escapes: a case file cannot write to the terminal through an error.
std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned>(static_cast<unsigned char>(c));
    if (c == '\n')
      out += "\\n";
    else if (c == '\t')
      out += "\\t";
    else if (byte < 0x20u || byte == 0x7fu)
      out += fmt::format("\\u{:04X}", byte);
    else
      out += c;
  }
  return out;
}

}  // namespace

CaseError::CaseError(std::string_view file_name, Place place, Fault fault)
    : file(place.from_set ? std::string("--set") : std::string(file_name)),
      line(place.line),
      column(place.column),
      problem(escaped(fault.problem)),
      key(escaped(fault.key)),
      value(escaped(fault.value)),
      allowed(escaped(fault.allowed)),
      hint(escaped(fault.hint)) {
  message = escaped(file);
  if (line > 0) message += fmt::format(":{}:{}", line, column);
  message += ": error: " + problem;
  if (!key.empty() && !value.empty())
    message += fmt::format(" (key `{}`, value {})", key, value);
  else if (!key.empty())
    message += fmt::format(" (key `{}`)", key);
  else if (!value.empty())
    message += fmt::format(" (value {})", value);
  if (!allowed.empty()) message += "\n  allowed: " + allowed;
  if (!hint.empty()) message += "\n  hint: " + hint;
}

std::string in_quotes(std::string_view text, std::size_t most) {
  const bool cut = text.size() > most;
  std::size_t end = cut ? most : text.size();
  while (cut && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // not within a character
  std::string marked;
  for (const char c : text.substr(0, end)) {
    if (c == '"' || c == '\\') marked += '\\';
    marked += c;
  }
  return '"' + escaped(marked) + (cut ? "...\"" : "\"");
}

}  // namespace scree::io
