// Which blocks may touch: pairs whose boxes overlap, found by a tree.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "model/model.h"

namespace scree {

/// Pairs i < j, ascending, of blocks whose boxes overlap when each is grown by its margin, both in the axes of the
/// model and in axes along the direction in which most of the outlines runs: in the model's axes, boxes of long strips
/// between parallel joints overlap those of all others. A tree (GEOS STRtree) stores the boxes in the turned axes.
/// @param margin  per block [m]
[[nodiscard]] std::vector<std::pair<std::int32_t, std::int32_t>> near_pairs(std::span<const Block> blocks,
                                                                            std::span<const double> margin);

}  // namespace scree
