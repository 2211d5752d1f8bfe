// Completion of the command line in the shells that people use.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace scree::app {

/// A script that completes commands, options and file names.   @param shell  bash, zsh or fish
[[nodiscard]] std::string completion(const CLI::App& app, const std::string& shell);

}  // namespace scree::app
