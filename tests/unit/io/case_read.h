// Shared by the tests of the case reader.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

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

/// The error that an action throws; an error without message if it throws none.
template <class Action>
CaseError error_in(const Action& action) {
  try {
    action();
  } catch (const CaseError& e) {
    return e;
  }
  return {"no error", {}, {}};
}
inline CaseError error_of_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
  return error_in([&] { (void)read_text(text, overrides); });
}
inline CaseError error_of_file(const std::string& path, const std::vector<std::string>& overrides = {}) {
  return error_in([&] { (void)read_case(path, overrides, kMethods); });
}

inline bool holds(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Compares line, column and key of an error exactly, and expects parts of value, problem, allowed and hint.
template <class Wrong>
void expect_told(const CaseError& e, const Wrong& w) {
  EXPECT_EQ(e.line, w.line) << e.what();
  EXPECT_EQ(e.column, w.column) << e.what();
  EXPECT_EQ(e.key, w.key) << e.what();
  EXPECT_TRUE(holds(e.value, w.value)) << e.what();
  EXPECT_TRUE(holds(e.problem, w.problem)) << e.what();
  EXPECT_TRUE(holds(e.allowed, w.allowed)) << e.what();
  EXPECT_TRUE(holds(e.hint, w.hint)) << e.what();
  EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
}

/// All data that the rest of the program receives from a case, as text.
std::string dump(const Case& c);

}  // namespace scree::io::test
