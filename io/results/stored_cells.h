// Cells of a stored frame at their current positions.
#pragma once

#include "io/results/run_reader.h"

namespace scree::io {

/// Mean of the current points of a cell [m].
[[nodiscard]] Vec2 cell_middle(const StoredFrame& frame, std::size_t cell);

/// Current signed area of a cell [m2].
[[nodiscard]] double cell_area(const StoredFrame& frame, std::size_t cell);

}  // namespace scree::io
