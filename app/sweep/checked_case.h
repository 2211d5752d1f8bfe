// The case of a sweep, read once with the parameters of every run before any run is made.
#pragma once

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "app/sweep/parameters.h"
#include "io/case/notice.h"

namespace scree::app {

struct CheckedCase {
  std::string title, sha256;                 // of the text of the case file
  std::map<std::string, std::string> files;  // named by the case in any run: path and SHA-256
};

/// Reads the case with the parameters of each of these runs.
/// @param set   key=value of all runs, applied before the parameters
/// @param runs  numbers of the runs, from 1
/// @throws CaseError for the first run that is no valid case: at the value in the table or in --param where that is
///         the cause; the message names the run and its parameters
[[nodiscard]] CheckedCase check_runs(const std::filesystem::path& case_file, const std::vector<std::string>& set,
                                     const Parameters& parameters, std::span<const std::size_t> runs,
                                     std::span<const std::string> methods, const io::Notice& notice = {});

}  // namespace scree::app
