// Conversion of trees to text: values in messages, and the resolved case.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/case/document.h"

namespace scree::io {

const Value* Value::find(std::string_view key) const {
  if (const auto* members = as<Table>())
    for (const Member& m : *members)
      if (m.key == key) return &m.value;
  return nullptr;
}
Value* Value::find(std::string_view key) { return const_cast<Value*>(std::as_const(*this).find(key)); }

namespace {

constexpr std::size_t kUncut = static_cast<std::size_t>(-1);

std::string number_text(double number) {
  if (!std::isfinite(number)) return std::isnan(number) ? "nan" : number < 0 ? "-inf" : "inf";
  std::string text = fmt::format("{}", number);  // the shortest that reads back exactly
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

bool bare(std::string_view key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}
std::string key_text(std::string_view key) { return bare(key) ? std::string(key) : in_quotes(key, kUncut); }

/// Appends the value on one line; stops early once the text is longer than `most`.
void append(std::string& out, const Value& value, std::size_t most) {
  if (const auto* truth = value.as<bool>()) out += *truth ? "true" : "false";
  if (const auto* whole = value.as<std::int64_t>()) out += std::to_string(*whole);
  if (const auto* number = value.as<double>()) out += number_text(*number);
  if (const auto* text = value.as<std::string>()) out += in_quotes(*text, most);
  if (const auto* moment = value.as<Moment>()) out += moment->text;
  if (const auto* items = value.as<Array>()) {
    out += '[';
    for (std::size_t i = 0; i < items->size() && out.size() <= most; ++i) {
      if (i > 0) out += ", ";
      append(out, (*items)[i], most);
    }
    out += ']';
  }
  if (const auto* members = value.as<Table>()) {
    out += "{ ";
    for (std::size_t i = 0; i < members->size() && out.size() <= most; ++i) {
      out += (i > 0 ? ", " : "") + key_text((*members)[i].key) + " = ";
      append(out, (*members)[i].value, most);
    }
    out += " }";
  }
}

bool is_table_list(const Value& value) {
  const auto* items = value.as<Array>();
  return items && !items->empty() &&
         std::all_of(items->begin(), items->end(), [](const Value& v) { return v.as<Table>(); });
}

void append_table(std::string& out, const Table& table, const std::string& path) {
  for (const Member& m : table)
    if (!m.value.as<Table>() && !is_table_list(m.value)) {
      out += key_text(m.key) + " = ";
      append(out, m.value, kUncut);
      out += '\n';
    }
  for (const Member& m : table) {
    const std::string inner = (path.empty() ? "" : path + ".") + key_text(m.key);
    if (const auto* members = m.value.as<Table>()) {
      out += fmt::format("\n[{}]\n", inner);
      append_table(out, *members, inner);
    } else if (is_table_list(m.value)) {
      for (const Value& item : *m.value.as<Array>()) {
        out += fmt::format("\n[[{}]]\n", inner);
        append_table(out, *item.as<Table>(), inner);
      }
    }
  }
}

}  // namespace

std::string shown(const Value& value) {
  constexpr std::size_t kMost = 72;
  if (value.as<Table>()) return "a table";
  std::string out;
  append(out, value, kMost);
  if (out.size() <= kMost + 8 || value.as<std::string>()) return out;
  std::size_t end = kMost;
  while (end > 0 && (static_cast<unsigned char>(out[end]) & 0xC0u) == 0x80u) --end;
  return out.substr(0, end) + " ...";
}

std::string to_toml(const Value& root) {
  std::string out;
  if (const auto* table = root.as<Table>()) append_table(out, *table, "");
  return out;
}

}  // namespace scree::io
