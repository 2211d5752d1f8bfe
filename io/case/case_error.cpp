#include "io/case/case_error.h"

#include <fmt/format.h>

#include "io/text/printable.h"

namespace scree::io {

// NOLINTNEXTLINE(performance-unnecessary-value-param): callers give it away, and none needs it after
CaseError::CaseError(std::string_view file_name, Place place, Fault fault)
    : file(place.from_set ? std::string("--set") : std::string(file_name)),
      line(place.line),
      column(place.column),
      problem(printable_line(fault.problem)),
      key(printable_line(fault.key)),
      value(printable_line(fault.value)),
      allowed(printable_line(fault.allowed)),
      hint(printable_line(fault.hint)) {
  message = printable_line(file);
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
  while (cut && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0u) == 0x80u) --end;  // not inside a character
  std::string marked;
  for (const char c : text.substr(0, end)) {
    if (c == '"' || c == '\\') marked += '\\';
    marked += c;
  }
  return '"' + printable_line(marked) + (cut ? "...\"" : "\"");
}

}  // namespace scree::io
