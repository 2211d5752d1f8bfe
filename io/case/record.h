// A recorded acceleration in two columns of a text file.
#pragma once

#include <filesystem>
#include <vector>

namespace scree::io {

struct Record {
  std::vector<double> time;          // [s], strictly increasing, at least two
  std::vector<double> acceleration;  // [m/s2], as many
};

/// Reads time [s] and acceleration, separated by comma, semicolon or white space. '#' begins a comment; one line of
/// headings may come before the numbers.
/// @param factor  from the numbers of the second column to m/s2 (unit and scale)
/// @throws CaseError with file, line and column: unreadable, no number, not finite, not two columns, time that does not
///         increase, fewer than two rows
[[nodiscard]] Record read_record(const std::filesystem::path& file, double factor);

}  // namespace scree::io
