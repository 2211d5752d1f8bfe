// Shared by the tests of the case reader.
#pragma once

#include <fmt/format.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "io/case/read_case.h"

namespace scree::io::test {

inline const std::vector<std::string> kMethods = {"nmm", "dda"};
inline const std::string kFolder = SCREE_SOURCE_DIR "/tests/unit/io/";
inline const std::string kFaults = SCREE_SOURCE_DIR "/tests/fault/cases/";

inline std::string bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::logic_error("the test case has no " + from);
  return text.replace(at, from.size(), to);
}

inline Case read(const std::string& name, const std::vector<std::string>& overrides = {}) {
  return read_case(kFolder + name, overrides, kMethods);
}
inline Case read_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return read_case_text(text, kFolder + "in_memory.toml", overrides, kMethods);
}

/// The error of reading a text; an error without message where there is none.
inline CaseError error_of_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_text(text, overrides);
  } catch (const CaseError& e) {
    return e;
  }
  return {"no error", {}, {}};
}
inline CaseError error_of_file(const std::string& path, const std::vector<std::string>& overrides = {}) {
  try {
    (void)read_case(path, overrides, kMethods);
  } catch (const CaseError& e) {
    return e;
  }
  return {"no error", {}, {}};
}

/// Everything that a case says to the rest of the program, as text.
std::string dump(const Case& c);

}  // namespace scree::io::test
