// A TOML text as a tree in which every value carries its place. The only interface to the TOML parser.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "io/case/case_error.h"

namespace scree::io {

struct Value;
struct Member;
using Array = std::vector<Value>;
using Table = std::vector<Member>;  // in the order of the file
struct Moment {
  std::string text;  // dates and times: TOML has them, case files do not
};

struct Value {
  Place place;
  std::variant<bool, std::int64_t, double, std::string, Moment, Array, Table> data;

  template <class T>
  [[nodiscard]] const T* as() const;
  template <class T>
  [[nodiscard]] T* as();
  /// Member of a table; nullptr if there is none, or if this is not a table.
  [[nodiscard]] const Value* find(std::string_view key) const;
  [[nodiscard]] Value* find(std::string_view key);
};

struct Member {
  std::string key;
  Place place;  // of the key
  Value value;
};

/// The tree of a TOML text.
/// @pre guard(text) has passed      @throws CaseError with the place at which the parser stopped
[[nodiscard]] Value parse_document(std::string_view text, std::string_view file);

/// Parses a value alone, the right-hand side of `key = VALUE`.
/// @param columns  number of columns before the value in the option;  option  number of the option, from 1
[[nodiscard]] Value parse_set_value(std::string_view value, int option, int columns);

/// A value as TOML on one line, shortened if it is long; "a table" for a table.
[[nodiscard]] std::string shown(const Value& value);

/// A tree of tables as a TOML text that reads back to the same values (double precision exactly).
[[nodiscard]] std::string to_toml(const Value& root);

// ---------------------------------------------------------------------------------------------------------------

template <class T>
const T* Value::as() const {
  return std::get_if<T>(&data);
}
template <class T>
T* Value::as() {
  return std::get_if<T>(&data);
}

}  // namespace scree::io
