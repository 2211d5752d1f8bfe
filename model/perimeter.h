// Length of all outlines of a polygon.
#pragma once

#include "model/geometry.h"

namespace scree {

/// Total length of the outer ring and the holes [m].
[[nodiscard]] double perimeter(const Polygon& p);

}  // namespace scree
