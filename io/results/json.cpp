#include "io/results/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "model/check.h"

namespace scree::io {

namespace {

/// Length of the UTF-8 sequence that the text begins with, 0 if it is none (RFC 3629).
std::size_t sequence(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(0);
  if (lead < 0x80) return 1;
  const std::size_t length = lead >= 0xc2 && lead < 0xe0   ? 2
                             : lead >= 0xe0 && lead < 0xf0 ? 3
                             : lead >= 0xf0 && lead < 0xf5 ? 4
                                                           : 0;
  if (length == 0 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xc0) != 0x80) return 0;
  const bool overlong = (lead == 0xe0 && byte(1) < 0xa0) || (lead == 0xf0 && byte(1) < 0x90);
  const bool outside = (lead == 0xed && byte(1) >= 0xa0) || (lead == 0xf4 && byte(1) >= 0x90);
  return overlong || outside ? 0 : length;
}

std::string escaped(char c) {
  switch (c) {
    case '"':
      return "\\\"";
    case '\\':
      return "\\\\";
    case '\n':
      return "\\n";
    case '\t':
      return "\\t";
    case '\r':
      return "\\r";
    default:
      return static_cast<unsigned char>(c) < 0x20 ? fmt::format("\\u{:04x}", static_cast<int>(c)) : std::string(1, c);
  }
}

}  // namespace

std::string json_quoted(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = sequence(text);
    if (length == 0) out += "\\ufffd";
    if (length == 1) out += escaped(text.front());
    if (length > 1) out += text.substr(0, length);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out + '"';
}

std::string json_number(double value) { return std::isfinite(value) ? fmt::format("{}", value) : "null"; }

void JsonWriter::begin_value(std::string_view key) {
  if (!open_.empty()) {
    out_ += first_ ? "\n" : ",\n";
    out_.append(2 * open_.size(), ' ');
  }
  first_ = false;
  if (!key.empty()) out_ += json_quoted(key) + ": ";
}

JsonWriter& JsonWriter::raw(std::string_view key, std::string_view value) {
  begin_value(key);
  out_ += value;
  return *this;
}

JsonWriter& JsonWriter::field(std::string_view key, double number) {
  if (not_finite_.empty() && !std::isfinite(number)) not_finite_ = key.empty() ? "an item of a list" : key;
  return raw(key, json_number(number));
}

JsonWriter& JsonWriter::open(char bracket, std::string_view key) {
  begin_value(key);
  out_ += bracket;
  open_ += bracket;
  first_ = true;
  return *this;
}

JsonWriter& JsonWriter::close(char bracket) {
  SCREE_ASSERT(!open_.empty() && open_.back() == (bracket == '}' ? '{' : '['));
  open_.pop_back();
  if (!first_) {
    out_ += '\n';
    out_.append(2 * open_.size(), ' ');
  }
  out_ += bracket;
  first_ = false;
  return *this;
}

std::string JsonWriter::text() const {
  SCREE_ASSERT(open_.empty());
  return out_ + '\n';
}

}  // namespace scree::io
