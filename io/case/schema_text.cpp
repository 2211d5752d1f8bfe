// The key table as text.
#include <fmt/format.h>

#include <cmath>

#include "io/case/schema.h"

namespace scree::io {
namespace {

bool is_section(const Key& key) {
  return key.type == Type::table || key.type == Type::named_tables || key.type == Type::table_list;
}

std::string unit_text(const Key& key) { return key.unit.empty() ? "" : fmt::format(" [{}]", key.unit); }

std::string choices_text(std::string_view choices) {
  std::string out = "\"";
  for (const char c : choices) out += c == '|' ? std::string("\" or \"") : std::string(1, c);
  return out + '"';
}

std::string presence(const Key& key) {
  if (key.required) return is_section(key) ? "at least one" : "required";
  if (key.fallback.empty()) return "optional";
  return fmt::format("default {}", key.fallback);
}

std::string in_cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

}  // namespace

std::string header_text(const Key& key) {
  if (key.type == Type::named_tables) return fmt::format("[{}.NAME]", key.path);
  std::string path;
  for (const char c : key.path)
    if (c != '[' && c != ']') path += c;
  return key.type == Type::table_list ? fmt::format("[[{}]]", path) : fmt::format("[{}]", path);
}

std::string Range::text() const {
  const bool below = std::isfinite(high), above = std::isfinite(low);
  if (above && below)
    return fmt::format("{:g} {} value {} {:g}", low, low_open ? "<" : "<=", high_open ? "<" : "<=", high);
  if (above) return fmt::format("{} {:g}", low_open ? ">" : ">=", low);
  if (below) return fmt::format("{} {:g}", high_open ? "<" : "<=", high);
  return "";
}

std::string_view word_for_number(Type type) {
  if (type == Type::number_or_auto) return "auto";
  return type == Type::number_or_unlimited ? "unlimited" : "";
}

std::string allowed_text(const Key& key) {
  const std::string range = key.range.text().empty() ? "" : ", " + key.range.text();
  switch (key.type) {
    case Type::table:
      return "a table " + header_text(key);
    case Type::named_tables:
    case Type::table_list:
      return "tables " + header_text(key);
    case Type::boolean:
      return "true or false";
    case Type::integer:
      return "whole number" + range;
    case Type::number:
      return "number" + unit_text(key) + range;
    case Type::number_or_auto:
    case Type::number_or_unlimited:
      return fmt::format("\"{}\" or number{}{}", word_for_number(key.type), unit_text(key), range);
    case Type::number_or_stage:
      return fmt::format("number{}{}, or name of a stage", unit_text(key), range);
    case Type::text:
      return "text";
    case Type::name:
      return "name";
    case Type::choice:
      return choices_text(key.choices);
    case Type::names:
      return "list of names";
    case Type::point:
      return "[x, y]" + unit_text(key) + range;
    case Type::line:
      return "list of at least 2 points [x, y]" + unit_text(key) + range;
    case Type::ring:
      return "list of at least 3 points [x, y]" + unit_text(key) + range;
    case Type::rings:
      return "list of lists of at least 3 points [x, y]" + unit_text(key) + range;
  }
  return "";
}

std::string schema_text() {
  std::string out;
  for (const Key& key : schema()) {
    if (is_section(key)) {
      out += fmt::format("\n{}  ({})\n    {}\n", header_text(key), presence(key), key.meaning);
    } else {
      out +=
          fmt::format("  {}  {}  ({})\n      {}\n", last_part(key.path), allowed_text(key), presence(key), key.meaning);
    }
  }
  return out;
}

std::string schema_markdown() {
  constexpr std::string_view kHead = "\n| key | value | if absent | meaning |\n|---|---|---|---|\n";
  std::string out = "\n## Top of the file\n";
  bool in_table = false;
  for (const Key& key : schema()) {
    if (is_section(key)) {
      out += fmt::format("\n## `{}`\n\n{} ({})\n", header_text(key), key.meaning, presence(key));
      in_table = false;
    } else {
      if (!in_table) out += kHead;
      in_table = true;
      out += fmt::format("| `{}` | {} | {} | {} |\n", last_part(key.path), in_cell(allowed_text(key)),
                         in_cell(presence(key)), in_cell(key.meaning));
    }
  }
  return out;
}

}  // namespace scree::io
