// Cases verified in processes of their own, several at a time.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/commands.h"
#include "app/verify/evaluate.h"

namespace scree::app {

/// Evaluates cases, `command.jobs` of them at a time, each in a process of its own with its part of the threads: those
/// that take longest first. Cases whose timings need several cores to themselves come last, one by one with all
/// threads.
/// @param library  folder of the cases
/// @param see      called with each report when it is available
/// @return reports in the order of the names; none: a signal requested the end
/// @throws io::CaseError for what is wrong in an expected.toml, io::FileError for temporary files
[[nodiscard]] std::optional<std::vector<CaseReport>> evaluate_in_processes(
    const VerifyCommand& command, const std::vector<std::string>& names, const std::filesystem::path& library,
    const std::function<void(const CaseReport&)>& see);

}  // namespace scree::app
