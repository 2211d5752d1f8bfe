#include "app/sweep/checked_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <set>

#include "io/case/case_error.h"
#include "io/case/read_case.h"
#include "io/results/file_error.h"
#include "io/results/regular_file.h"
#include "io/results/sha256.h"

namespace scree::app {
namespace {

std::string digest(const std::filesystem::path& file) {
  io::require_regular(file);
  std::ifstream in(file, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
  if (!in.is_open() || in.bad()) throw io::FileError(file, "cannot read the file that the case names");
  return io::sha256(bytes);
}

/// The error at the place where the user wrote the key or the value, and the run that has it.
io::CaseError at_origin(const io::CaseError& e, std::size_t common, const Parameters& parameters, std::size_t run) {
  Origin at{e.file, e.line, e.column};
  const auto line = static_cast<std::size_t>(std::max(e.line, 0));
  if (e.file == "--set" && line > common && line <= common + parameters.keys.size()) {
    const std::size_t k = line - common - 1;
    const ParameterKey& key = parameters.keys[k];
    const int before = static_cast<int>(key.name.size()) + 1;  // key and equals sign
    at = key.origin;
    if (e.column > before) {
      at = parameters.runs[run - 1][k].origin;
      at.column += e.column - before - 1;
    }
  }
  io::CaseError moved(at.file, {at.line, at.column}, {e.problem, e.key, e.value, e.allowed, e.hint});
  if (e.line > 0 || run > 1)  // what is wrong with the file as a whole has nothing to do with the first run
    moved.message += fmt::format("\n  in run {} of the sweep: {}", run, fmt::join(parameters.overrides(run), ", "));
  return moved;
}

}  // namespace

CheckedCase check_runs(const std::filesystem::path& case_file, const std::vector<std::string>& set,
                       const Parameters& parameters, std::span<const std::size_t> runs,
                       std::span<const std::string> methods, const io::Notice& notice) {
  CheckedCase out;
  std::set<std::filesystem::path> files;
  for (const std::size_t run : runs) {
    std::vector<std::string> overrides = set;
    for (std::string& option : parameters.overrides(run)) overrides.push_back(std::move(option));
    try {
      const io::Case c = io::read_case(case_file, overrides, methods, notice);
      if (out.sha256.empty()) out.title = c.model.title, out.sha256 = io::sha256(c.text);
      files.insert(c.files.begin(), c.files.end());
    } catch (const io::CaseError& e) {
      throw at_origin(e, set.size(), parameters, run);
    }
  }
  for (const std::filesystem::path& file : files) out.files[file.string()] = digest(file);
  return out;
}

}  // namespace scree::app
