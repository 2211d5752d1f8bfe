// DXF drawings, R12 to 2018, read by dxflib.
#pragma once

#include <optional>
#include <string_view>

#include "io/drawing/drawing.h"

namespace scree::io {

struct DrawingOptions {
  std::optional<double> unit;       // length of a unit [m]; empty: from the header
  std::optional<double> tolerance;  // of the flattening of curves [m]; empty: 1e-4 of the extent of the drawing
};

/// Lines and points of the model space: LINE, LWPOLYLINE and POLYLINE with bulges, ARC, CIRCLE, ELLIPSE, SPLINE, POINT,
/// and the blocks placed by INSERT, nested and in rows and columns. Layers that are off or frozen are read like any
/// other; entities on layer 0 of a block are placed on the layer of its INSERT. Other entities are counted as left out.
/// @throws DrawingError: groups, counts, sections or entities that are damaged, no unit, too much of anything
[[nodiscard]] Drawing read_dxf(std::string_view text, const DrawingOptions& options);

}  // namespace scree::io
