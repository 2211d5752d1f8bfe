// The affine motion of a body, as six numbers.
#pragma once

#include <array>
#include <optional>
#include <span>

#include "io/live/live_data.h"

namespace scree::io {

/// x = start + u + (D - 1) (start - start of the body's first point); x, y of a point of the body.
struct AffineMap {
  float ux = 0.0F, uy = 0.0F;                        // displacement of the first point [m]
  float xx = 0.0F, xy = 0.0F, yx = 0.0F, yy = 0.0F;  // D - 1
  [[nodiscard]] std::array<double, 2> place(const LiveMesh& mesh, std::size_t first, std::size_t point) const;
};

/// The map of a body, if it has one: least squares over its points, accepted when it reproduces the position of each
/// point to within the rounding of float32 displacements. So this does not depend on the method of the body: DDA blocks
/// and driven blocks always have a map, an NMM block as long as its strain is uniform to that accuracy.
/// @param position  x, y per point of the mesh [m]
/// @return empty where no map fits, or a position is not finite
[[nodiscard]] std::optional<AffineMap> affine_map(const LiveMesh& mesh, std::size_t body,
                                                  std::span<const double> position);

}  // namespace scree::io
