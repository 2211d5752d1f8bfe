// The error of all file operations; the program ends with exit code 5.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

#include "io/text/printable.h"

namespace scree::io {

/// A file or folder could not be made, written or read. what() is "path: reason", the path on one line.
struct FileError : std::runtime_error {
  static constexpr int kExitCode = 5;

  FileError(std::filesystem::path where, const std::string& why)
      : std::runtime_error(printable_line(where.string()) + ": " + why), path(std::move(where)), reason(why) {}

  std::filesystem::path path;
  std::string reason;  // the operation that failed and the message of the system
};

/// A file that was once complete cannot be read any more.
struct DamagedFile : FileError {
  using FileError::FileError;
  explicit DamagedFile(const FileError& e) : FileError(e.path, e.reason) {}
};

}  // namespace scree::io
