// A continuous stress for pictures, from one that is constant in each element.
#pragma once

#include <vector>

#include "io/results/run_reader.h"

namespace scree::io {

/// Stress at the corners of cells: xx, yy, xy for each entry of frame.connectivity. At a point of a block the stresses
/// of the cells around it, weighted by their areas, are fitted by a plane over x and y, which is evaluated at the point
/// and limited to the least and the largest of these stresses; with too few cells for a plane, cells of the next ring
/// are added. Points of two blocks, and of the two faces of an open crack, have separate stresses.
/// @source [Zienkiewicz1992] (superconvergent patch recovery); deviation: area weights, bounds, no higher order
[[nodiscard]] std::vector<double> recovered_stress(const StoredFrame& frame);

}  // namespace scree::io
