// Averages of point values over the cells.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace scree::io {

/// Mean over the area of each cell of a vector given at its points, linear within the cell:
///   m = sum_i a_i (u_0 + u_i + u_i+1)/3 / sum_i a_i,   a_i the signed area of the triangle (0, i, i + 1)
/// Exact for fields that are affine in the cell, for any shape of the cell: those of a manifold element and of a DDA
/// block. For a cell without area: mean over its points.
/// @param place  x, y per point [m]    @param value  two per point    @param offsets, connectivity  as in MeshView
/// @return two per cell, in the unit of the value
[[nodiscard]] std::vector<double> cell_mean(std::span<const double> place, std::span<const double> value,
                                            std::span<const std::int32_t> offsets,
                                            std::span<const std::int32_t> connectivity);

}  // namespace scree::io
