// Every key of a case file, declared once: the reader checks with this table and `scree schema` prints it.
#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>

namespace scree::io {

enum class Type {
  table,         // [path]
  named_tables,  // [path.NAME]
  table_list,    // [[path]]
  boolean,
  integer,
  number,
  number_or_auto,       // or the text "auto"
  number_or_unlimited,  // or the text "unlimited"
  number_or_stage,      // or the name of a stage
  text,
  name,    // text that names something: not empty, printable, no slash
  choice,  // text out of a list
  names,   // list of texts
  point,   // [x, y]
  line,    // list of at least two points
  ring,    // list of at least three points
  rings    // list of rings
};

struct Range {
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  bool low_open = false, high_open = false;  // the bound itself is not allowed
  [[nodiscard]] bool holds(double value) const;
  [[nodiscard]] std::string text() const;  // "> 0", "0 <= value < 90"; empty: any
};

struct Key {
  std::string_view path;  // "material.NAME.density", "block[].polygon"
  Type type = Type::text;
  std::string_view unit{};      // of numbers, points and rings; texts with a unit are converted to it
  Range range{};                // of every number in the value
  std::string_view fallback{};  // value when absent, as TOML; or words in brackets: the reader determines it
  bool required = false;
  std::string_view choices{};  // of a choice, separated by |
  std::string_view meaning{};
};

/// All keys, section by section, in the order of the documentation.
[[nodiscard]] std::span<const Key> schema();

/// The text that may stand in place of a number: "auto", "unlimited"; empty: none.
[[nodiscard]] std::string_view word_for_number(Type type);

/// The row of the table with this path; nullptr if there is none.
[[nodiscard]] const Key* find_key(std::string_view path);
/// The part after the last dot: "density".
[[nodiscard]] std::string_view last_part(std::string_view path);
/// The path of the table that contains a key: "material.NAME" (lists as "block[]"); empty at the top.
[[nodiscard]] std::string_view parent_of(std::string_view path);

/// Heading of a table: "[model]", "[material.NAME]", "[[block]]".
[[nodiscard]] std::string header_text(const Key& key);
/// Allowed values: "number > 0 [kg/m3]".
[[nodiscard]] std::string allowed_text(const Key& key);

/// The whole table, for a terminal (`scree schema`) and as Markdown (docs/case-file.md).
[[nodiscard]] std::string schema_text();
[[nodiscard]] std::string schema_markdown();

}  // namespace scree::io
