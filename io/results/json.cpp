#include "io/results/json.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "io/text/printable.h"
#include "model/check.h"

namespace scree::io {

std::string json_quoted(std::string_view text) {
  std::string out = "\"";
  while (!text.empty()) {
    const std::size_t length = utf8_length(text);
    if (text[0] == '"' || text[0] == '\\') out += '\\';
    out += length == 0 ? "\\ufffd" : printable_line(text.substr(0, length));
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
