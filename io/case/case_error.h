// The error of a case file: its place, what was found, what is allowed, and how to correct it.
#pragma once

#include <exception>
#include <string>
#include <string_view>

namespace scree::io {

/// A spot in the case file (lines and columns count from 1), or in a `--set` option (then `line` is its number).
struct Place {
  int line = 0, column = 0;  // 0: the file as a whole
  bool from_set = false;
};

/// What is wrong. Fields that do not apply are empty.
struct Fault {
  std::string problem;  // one line, without a full stop
  std::string key{};    // dotted, lists by number from 0: "block.0.polygon"
  std::string value{};  // as TOML, shortened
  std::string allowed{};
  std::string hint{};
};

/// FILE:LINE:COL: error: PROBLEM (key `KEY`, value VALUE)
///   allowed: ALLOWED
///   hint: HINT
struct CaseError : std::exception {
  /// @param file_name  of the file that contains `place`; for options of the command line "--set" is used instead
  CaseError(std::string_view file_name, Place place, Fault fault);
  [[nodiscard]] const char* what() const noexcept override { return message.c_str(); }

  std::string file;
  int line = 0, column = 0;
  std::string problem, key, value, allowed, hint;  // control characters escaped
  std::string message;                             // in the form above
};

/// A text in double quotes, control characters escaped, cut after `most` bytes.
[[nodiscard]] std::string in_quotes(std::string_view text, std::size_t most = 80);

}  // namespace scree::io
