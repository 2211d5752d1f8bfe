#include "io/case/check_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include "io/case/schema.h"
#include "io/case/suggest.h"
#include "io/case/unit.h"

namespace scree::io {
namespace {

std::string joined(std::string_view path, std::string_view key) {
  return path.empty() ? std::string(key) : fmt::format("{}.{}", path, key);
}
std::string joined(std::string_view path, std::size_t index) { return joined(path, std::to_string(index)); }

std::string type_name(const Value& value) {
  if (value.as<bool>()) return "true or false";
  if (value.as<std::int64_t>()) return "a whole number";
  if (value.as<double>()) return "a decimal number";
  if (value.as<std::string>()) return "a text";
  if (value.as<Moment>()) return "a date or time";
  if (value.as<Array>()) return "a list";
  return "a table";
}

/// The key that corresponds to a usual symbol or to a key of an earlier version; empty: none.
std::string_view key_of_symbol(std::string_view symbol) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kSymbols{{{"phi", "friction_deg"},
                                                                                    {"friction_angle", "friction_deg"},
                                                                                    {"c", "cohesion"},
                                                                                    {"E", "young"},
                                                                                    {"modulus", "young"},
                                                                                    {"nu", "poisson"},
                                                                                    {"rho", "density"},
                                                                                    {"psi", "dilation_deg"},
                                                                                    {"kn", "normal_stiffness"},
                                                                                    {"ks", "shear_stiffness"},
                                                                                    {"timestep", "dt"},
                                                                                    {"time_step", "dt"},
                                                                                    {"vertices", "polygon"},
                                                                                    {"points", "polygon"},
                                                                                    {"others", "slow_blocks"}}};
  for (const auto& [name, key] : kSymbols)
    if (name == symbol) return key;
  return {};
}

/// Meaning of a key, for hints: "density: Mass density."
std::string about(const Key& key) { return fmt::format("{}: {}", last_part(key.path), key.meaning); }

/// Allowed values of a single number of the key; for a key that holds points, of a coordinate.
std::string allowed_number(const Key& key) {
  Key one = key;
  if (key.type == Type::point || key.type == Type::line || key.type == Type::ring || key.type == Type::rings)
    one.type = Type::number;
  return allowed_text(one);
}

class Checker {
 public:
  explicit Checker(std::string_view file) : file_(file) {}

  /// @param row   path in the key table: "block[]"     @param path  as the user would write it: "block.0"
  void table(Value& value, std::string_view row, const std::string& path) const {
    for (Member& m : *value.as<Table>()) {
      const Key* key = find_key(joined(row, m.key));
      if (!key || parent_of(key->path) != row) unknown(m, row, path);  // a quoted key may hold dots
      check(m.value, *key, joined(path, m.key));
    }
    for (const Key& key : schema()) {
      if (parent_of(key.path) != row || value.find(last_part(key.path))) continue;
      if (key.required) missing(value, key, path);
      if (auto fallback = default_of(key, value.place))
        value.as<Table>()->push_back({std::string(last_part(key.path)), value.place, std::move(*fallback)});
    }
  }

 private:
  [[noreturn]] void fail(const Value& at, const std::string& path, std::string problem, std::string allowed,
                         std::string hint) const {
    throw CaseError(file_, at.place, {std::move(problem), path, shown(at), std::move(allowed), std::move(hint)});
  }

  [[noreturn]] void unknown(const Member& m, std::string_view row, const std::string& path) const {
    std::vector<std::string> known;
    for (const Key& key : schema())
      if (parent_of(key.path) == row) known.emplace_back(last_part(key.path));
    const std::string where = row.empty() ? "at the top of the case file" : fmt::format("in [{}]", path);
    std::string hint = row == "method" ? "name the library that has this method: --load LIBRARY" : "";
    for (const Key& key : schema())  // the right key in the wrong table
      if (hint.empty() && last_part(key.path) == m.key)
        hint = fmt::format("a key of that name belongs to {}", key.path);
    if (hint.empty()) hint = "`scree schema` lists every key";
    if (const std::string_view meant = key_of_symbol(m.key);
        std::find(known.begin(), known.end(), meant) != known.end())
      hint = fmt::format("did you mean {}?", in_quotes(meant));
    else
      hint = did_you_mean(m.key, known, hint);
    throw CaseError(file_, m.place,
                    {fmt::format("unknown key {} {}", in_quotes(m.key), where), joined(path, m.key), shown(m.value),
                     listed(known), std::move(hint)});
  }

  [[noreturn]] void missing(const Value& in, const Key& key, const std::string& path) const {
    const std::string_view name = last_part(key.path);
    const std::string full = joined(path, name);
    if (key.type == Type::table_list || key.type == Type::named_tables)
      throw CaseError(file_, {1, 1},
                      {fmt::format("the case has no {}", name), full, "", "at least one " + header_text(key),
                       fmt::format("add {}: {}", header_text(key), key.meaning)});
    throw CaseError(file_, in.place,
                    {fmt::format("the key {} is missing", in_quotes(name)), full, "", allowed_text(key),
                     fmt::format("add {} = ... here: {}", name, key.meaning)});
  }

  [[nodiscard]] static std::optional<Value> default_of(const Key& key, Place place) {
    if (key.type == Type::table) {
      if (key.fallback.starts_with('(')) return std::nullopt;  // the table has an effect when present, even if empty
      bool has_defaults = false;
      for (const Key& inner : schema()) {  // not made if it has required keys, or no defaults
        if (parent_of(inner.path) != key.path) continue;
        if (inner.required) return std::nullopt;
        has_defaults = has_defaults || !(inner.fallback.empty() || inner.fallback.starts_with('('));
      }
      if (!has_defaults) return std::nullopt;
      Value empty{place, Table{}};
      Checker("").table(empty, key.path, "");
      return empty;
    }
    if (key.fallback.empty() || key.fallback.starts_with('(')) return std::nullopt;
    Value root = parse_document(fmt::format("x = {}", key.fallback), "");
    Value value = std::move(root.as<Table>()->front().value);
    put_place(value, place);
    return value;
  }
  static void put_place(Value& value, Place place) {
    value.place = place;
    if (auto* items = value.as<Array>())
      for (Value& item : *items) put_place(item, place);
  }

  void check(Value& value, const Key& key, const std::string& path) const {
    switch (key.type) {
      case Type::table:
        if (!value.as<Table>()) wrong_type(value, key, path);
        return table(value, key.path, path);
      case Type::named_tables:
        return named_tables(value, key, path);
      case Type::table_list:
        return table_list(value, key, path);
      case Type::boolean:
        if (!value.as<bool>()) wrong_type(value, key, path);
        return;
      case Type::integer:
        return integer(value, key, path);
      case Type::number:
        return number(value, key, path);
      case Type::number_or_auto:
      case Type::number_or_unlimited:
        if (const auto* text = value.as<std::string>(); text && *text == word_for_number(key.type)) return;
        return number(value, key, path);
      case Type::number_or_stage:
        if (const auto* text = value.as<std::string>();
            text && std::holds_alternative<UnitFault>(in_unit(*text, key.unit)))
          return name(value, key, path);
        return number(value, key, path);
      case Type::text:
        if (!value.as<std::string>()) wrong_type(value, key, path);
        return;
      case Type::name:
        return name(value, key, path);
      case Type::choice:
        return choice(value, key, path);
      case Type::names:
        return names(value, key, path);
      case Type::point:
        return point(value, key, path);
      case Type::line:
        return points(value, key, path, 2);
      case Type::ring:
        return points(value, key, path, 3);
      case Type::rings:
        return rings(value, key, path);
    }
  }

  [[noreturn]] void wrong_type(const Value& value, const Key& key, const std::string& path) const {
    std::string hint = fmt::format("{} was given here. {}", type_name(value), about(key));
    if (value.as<std::string>() && (key.type == Type::integer || key.type == Type::boolean))
      hint = "write it without quotation marks";
    if (key.type == Type::table_list && value.as<Table>()) hint = "write two brackets: " + header_text(key);
    if (key.type == Type::table && value.as<Array>()) hint = "write one bracket: " + header_text(key);
    fail(value, path, "wrong type", allowed_text(key), hint);
  }

  [[noreturn]] void out_of_range(const Value& value, double number, const Key& key, const std::string& path) const {
    const bool too_small = number < key.range.high;  // a finite number out of range is below or above it
    fail(value, path, "the value is out of range", allowed_number(key),
         fmt::format("give a {} value{}. {}", too_small ? "larger" : "smaller",
                     key.unit.empty() ? "" : fmt::format(", or check that it is in {}", key.unit), about(key)));
  }

  void named_tables(Value& value, const Key& key, const std::string& path) const {
    if (!value.as<Table>()) wrong_type(value, key, path);
    for (Member& m : *value.as<Table>()) {
      const std::string inner = joined(path, m.key);
      if (const std::string fault = name_fault(m.key); !fault.empty())
        throw CaseError(file_, m.place, {fault, inner, in_quotes(m.key), "a name", "choose a short printable name"});
      if (!m.value.as<Table>()) wrong_type(m.value, key, inner);
      table(m.value, std::string(key.path) + ".NAME", inner);
    }
    if (key.required && value.as<Table>()->empty())
      fail(value, path, "there is none", allowed_text(key), fmt::format("add {}: {}", header_text(key), key.meaning));
  }

  void table_list(Value& value, const Key& key, const std::string& path) const {
    auto* items = value.as<Array>();
    if (!items) wrong_type(value, key, path);
    if (key.required && items->empty())
      fail(value, path, "the list is empty", allowed_text(key),
           fmt::format("add {}: {}", header_text(key), key.meaning));
    for (std::size_t i = 0; i < items->size(); ++i) {
      if (!(*items)[i].as<Table>()) wrong_type((*items)[i], key, joined(path, i));
      table((*items)[i], std::string(key.path) + "[]", joined(path, i));
    }
  }

  void integer(const Value& value, const Key& key, const std::string& path) const {
    const auto* whole = value.as<std::int64_t>();
    if (!whole) wrong_type(value, key, path);
    if (!key.range.holds(static_cast<double>(*whole))) out_of_range(value, static_cast<double>(*whole), key, path);
  }

  void number(Value& value, const Key& key, const std::string& path) const {
    const std::string as_written = shown(value);
    double number = 0.0;
    if (const auto* whole = value.as<std::int64_t>()) {
      number = static_cast<double>(*whole);
    } else if (const auto* real = value.as<double>()) {
      number = *real;
    } else if (const auto* text = value.as<std::string>()) {
      auto read = in_unit(*text, key.unit);
      if (const auto* fault = std::get_if<UnitFault>(&read)) {
        std::string hint = fault->hint;
        if (const auto word = word_for_number(key.type); !word.empty()) hint += fmt::format(", or \"{}\"", word);
        fail(value, path, fault->problem, allowed_number(key), std::move(hint));
      }
      number = std::get<double>(read);
    } else {
      wrong_type(value, key, path);
    }
    if (!std::isfinite(number))
      fail(value, path, "the number is not finite", allowed_number(key), "give a finite number");
    if (!key.range.holds(number)) out_of_range(value, number, key, path);
    value.data = number;
  }

  void name(const Value& value, const Key& key, const std::string& path) const {
    const auto* text = value.as<std::string>();
    if (!text) wrong_type(value, key, path);
    if (const std::string fault = name_fault(*text); !fault.empty())
      fail(value, path, fault, allowed_text(key), "choose a short printable name");
  }

  void choice(const Value& value, const Key& key, const std::string& path) const {
    const auto* text = value.as<std::string>();
    if (!text) wrong_type(value, key, path);
    std::vector<std::string> choices(1);
    for (const char c : key.choices) c == '|' ? choices.emplace_back() : choices.back() += c;
    for (const std::string& c : choices)
      if (c == *text) return;
    fail(value, path, "not one of the choices", allowed_text(key), did_you_mean(*text, choices, key.meaning));
  }

  void names(const Value& value, const Key& key, const std::string& path) const {
    const auto* items = value.as<Array>();
    if (!items) wrong_type(value, key, path);
    for (std::size_t i = 0; i < items->size(); ++i)
      if (!(*items)[i].as<std::string>()) wrong_type((*items)[i], key, joined(path, i));
  }

  void point(Value& value, const Key& key, const std::string& path) const {
    auto* items = value.as<Array>();
    if (!items) wrong_type(value, key, path);
    if (items->size() != 2)
      fail(value, path, fmt::format("a point has two coordinates, not {}", items->size()), "[x, y]", "write [x, y]");
    for (std::size_t i = 0; i < 2; ++i) number((*items)[i], key, joined(path, i));
  }

  void points(Value& value, const Key& key, const std::string& path, std::size_t least) const {
    auto* items = value.as<Array>();
    if (!items) wrong_type(value, key, path);
    for (std::size_t i = 0; i < items->size(); ++i) point((*items)[i], key, joined(path, i));
    if (items->size() < least)
      fail(value, path,
           least == 3 ? fmt::format("a ring of {} points encloses nothing", items->size())
                      : fmt::format("a line of {} points has no length", items->size()),
           allowed_text(key), std::string(key.meaning));
  }

  void rings(Value& value, const Key& key, const std::string& path) const {
    auto* items = value.as<Array>();
    if (!items) wrong_type(value, key, path);
    for (std::size_t i = 0; i < items->size(); ++i) points((*items)[i], key, joined(path, i), 3);
  }

  std::string_view file_;
};

}  // namespace

std::string name_fault(std::string_view name) {
  constexpr std::size_t kLongest = 64;
  if (name.empty()) return "the name is empty";
  if (name.size() > kLongest) return fmt::format("the name has {} bytes, more than {}", name.size(), kLongest);
  for (const char c : name)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) return "the name holds a control character";
  if (name.find('/') != std::string_view::npos) return "the name holds a slash, which separates groups in result files";
  if (name == "." || name == "..") return "the name is that of a folder";
  return "";
}

void check_document(Value& root, std::string_view file) { Checker(file).table(root, "", ""); }

}  // namespace scree::io
