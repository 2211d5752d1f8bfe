// DXF drawings, R12 to 2018, read by dxflib.
#pragma once

#include <optional>
#include <string_view>

#include "io/drawing/drawing.h"

namespace scree::io {

struct DrawingOptions {
  std::optional<double> unit;       // [m] of a unit; empty: as the header says
  std::optional<double> tolerance;  // that curves are flattened to [m]; empty: 1e-4 of the extent of the drawing
};

/// Lines and points of the model space: LINE, LWPOLYLINE and POLYLINE with bulges, ARC, CIRCLE, ELLIPSE, SPLINE, POINT,
/// and what INSERT puts in, nested and in rows and columns. Layers that are off or frozen count like any other; what
/// lies on layer 0 of a block is on the layer of its INSERT. The rest is counted as left out.
/// @throws DrawingError: groups, counts, sections or entities that are damaged, no unit, too much of anything
[[nodiscard]] Drawing read_dxf(std::string_view text, const DrawingOptions& options);

}  // namespace scree::io
