// A stored run as one page of HTML that needs no network and no other file: what `scree report` writes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

#include "io/results/file_error.h"

namespace scree::io {

struct ReportOptions {
  double megabytes = 5.0;  // of the file; frames are left out until they fit in, 0: all are kept
  std::string version;     // of the program that writes
};

struct ReportNote {
  std::size_t stored = 0, shown = 0;  // frames
  std::uintmax_t bytes = 0;           // of the file
};

/// Writes the page in one piece: an earlier file stays if writing fails.
/// @throws FileError where the run cannot be read, has no frame, or the file cannot be written
ReportNote write_report(const std::filesystem::path& run_folder, const ReportOptions& options,
                        const std::filesystem::path& file);

}  // namespace scree::io
