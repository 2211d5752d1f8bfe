// Completion of the command line in the shells that people use.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace scree::app {

/// Words that options and arguments take, by their place: "scree snapshot --field", "scree cases verify".
using Choices = std::map<std::string, std::vector<std::string>>;

/// A script that completes commands, options, the words that they take, and file names.   @param shell  bash, zsh or
/// fish
[[nodiscard]] std::string completion(const CLI::App& app, const std::string& shell, const Choices& choices);

}  // namespace scree::app
