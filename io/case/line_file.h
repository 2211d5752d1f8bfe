// Polylines in a text file: traces, outlines.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/geometry.h"

namespace scree::io {

struct FileLine {
  std::vector<Vec2> points;  // [m], at least two
  std::vector<int> rows;     // line of the file that contains each point, from 1
  std::string label{};       // text of the third column
};

/// Reads points x, y [m], separated by comma, semicolon or white space, and an optional third column. A blank line
/// begins another polyline, and so does a change of the third column. '#' begins a comment (a line with a comment only
/// is not blank); one line of headings may precede the numbers.
/// @throws CaseError with file, line and column: unreadable, no number, not finite, wrong number of columns, polylines
///         of one point, no polyline at all
[[nodiscard]] std::vector<FileLine> read_lines(const std::filesystem::path& file);

}  // namespace scree::io
