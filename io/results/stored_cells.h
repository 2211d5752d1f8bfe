// Cells of a stored frame as they lie now.
#pragma once

#include "io/results/run_reader.h"

namespace scree::io {

/// Mean of a cell's points now [m].
[[nodiscard]] Vec2 cell_middle(const StoredFrame& frame, std::size_t cell);

/// Signed area of a cell now [m2].
[[nodiscard]] double cell_area(const StoredFrame& frame, std::size_t cell);

}  // namespace scree::io
