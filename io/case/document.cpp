#include "io/case/document.h"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <sstream>

#include "io/case/guard.h"
#include "io/text/printable.h"

// toml++ is slow to compile: only this file includes it. Some invalid texts, "[=a]" for example, fail its assertions;
// without the assertions it reports the error correctly.
#define TOML_ASSERT(condition) static_assert(true)
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#endif
#include <toml++/toml.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

namespace scree::io {
namespace {

Place place_of(const toml::source_region& region) {
  return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column), false};
}

bool before(const Place& a, const Place& b) { return std::pair(a.line, a.column) < std::pair(b.line, b.column); }

Value convert(const toml::node& node) {
  Value out{place_of(node.source()), false};
  if (const auto* table = node.as_table()) {
    Table members;
    for (const auto& [key, value] : *table)
      members.push_back({std::string(key.str()), place_of(key.source()), convert(value)});
    std::stable_sort(members.begin(), members.end(),
                     [](const Member& a, const Member& b) { return before(a.place, b.place); });
    out.data = std::move(members);
  } else if (const auto* array = node.as_array()) {
    Array items;
    items.reserve(array->size());
    for (const toml::node& item : *array) items.push_back(convert(item));
    out.data = std::move(items);
  } else if (const auto* text = node.as_string()) {
    out.data = text->get();
  } else if (const auto* whole = node.as_integer()) {
    out.data = whole->get();
  } else if (const auto* number = node.as_floating_point()) {
    out.data = number->get();
  } else if (const auto* truth = node.as_boolean()) {
    out.data = truth->get();
  } else {
    std::ostringstream moment;
    if (const auto* date = node.as_date()) moment << date->get();
    if (const auto* time = node.as_time()) moment << time->get();
    if (const auto* both = node.as_date_time()) moment << both->get();
    out.data = Moment{moment.str()};
  }
  return out;
}

void shift(Value& value, int option, int columns) {
  value.place = {option, value.place.column + columns, true};
  if (auto* items = value.as<Array>())
    for (Value& item : *items) shift(item, option, columns);
  if (auto* members = value.as<Table>())
    for (Member& m : *members) {
      m.place = {option, m.place.column + columns, true};
      shift(m.value, option, columns);
    }
}

[[noreturn]] void refuse(std::string_view file, const Place& place, std::string_view text) {
  throw CaseError(file, place,
                  {"the text contains a control character or an invisible character", "", in_quotes(text),
                   "one line without control characters and marks of writing direction",
                   "remove the characters that are shown escaped"});
}

/// Titles, names and paths are shown on terminals and in pictures. A title may have several lines.
void check_texts(const Value& value, std::string_view file, bool of_title = false) {
  if (const auto* text = value.as<std::string>();
      text && (of_title ? printable(*text) : printable_line(*text)) != *text)
    refuse(file, value.place, *text);
  if (const auto* items = value.as<Array>())
    for (const Value& item : *items) check_texts(item, file);
  if (const auto* members = value.as<Table>())
    for (const Member& m : *members) {
      if (printable_line(m.key) != m.key) refuse(file, m.place, m.key);
      check_texts(m.value, file, m.key == "title");
    }
}

}  // namespace

namespace {

/// toml++ reports a failed allocation as an error of the text: a text that can be parsed at a second attempt is valid.
/// @throws toml::parse_error, std::bad_alloc
toml::table parsed(std::string_view text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    static_cast<void>(toml::parse(text));
  }
  throw std::bad_alloc();
}

}  // namespace

Value parse_document(std::string_view text, std::string_view file) {
  Value root;
  try {
    root = convert(parsed(text));
  } catch (const toml::parse_error& e) {
    throw CaseError(file, place_of(e.source()),
                    {"the text is not TOML: " + std::string(e.description()), "", "", "TOML 1.0",
                     "texts need quotation marks, lists need commas, and each key may be given once"});
  }
  check_texts(root, file);
  return root;
}

Value parse_set_value(std::string_view value, int option, int columns) {
  constexpr std::string_view kKey = "x=";
  const int offset = columns - static_cast<int>(kKey.size());
  const auto moved = [&](const CaseError& e) {
    Fault fault{e.problem, "", in_quotes(value), e.allowed, e.hint};
    if (fault.hint.empty() || e.problem.starts_with("the text is not TOML"))
      fault.hint = "texts need quotation marks that the shell keeps: --set 'stage.0.method=\"dda\"'";
    return CaseError("--set", {option, std::max(1, e.column + offset), true}, std::move(fault));
  };
  const std::string text = std::string(kKey) + std::string(value);
  Value root;
  try {
    guard(text, "--set");
    root = parse_document(text, "--set");
  } catch (const CaseError& e) {
    throw moved(e);
  }
  if (root.as<Table>()->size() != 1)
    throw moved(
        CaseError("--set", {1, 3, true}, {"more than one value", "", "", "one TOML value", "give --set once per key"}));
  Value out = std::move(root.as<Table>()->front().value);
  shift(out, option, offset);
  return out;
}

}  // namespace scree::io
