// Lines that meet end to end, as rings and polylines.
#pragma once

#include <vector>

#include "io/drawing/drawing.h"

namespace scree::io {

/// A ring or polyline, and the row of the first line in it.
struct Chain {
  std::vector<Vec2> points;
  bool closed = false;  // if true, the first point is not repeated
  int row = 0;
};

/// Joins lines whose ends are within the distance of each other.
/// @param lines  usable lines only
/// @throws DrawingError where three or more ends meet: the continuation is ambiguous
[[nodiscard]] std::vector<Chain> chained(const std::vector<const DrawnLine*>& lines, double distance);

}  // namespace scree::io
