// Reports of verified cases as JSON: for other programs, and from one process of this program to another.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/verify/evaluate.h"

namespace scree::app {

/// A list of objects, one per case, with the fields of CaseReport by their names; numbers to the last bit, those that
/// are not finite as null.
[[nodiscard]] std::string json_report(const std::vector<CaseReport>& reports);

/// Reads the output of json_report(); null is not a number.   @throws io::FileError where it is something else
[[nodiscard]] std::vector<CaseReport> read_json_report(const std::filesystem::path& file);

}  // namespace scree::app
