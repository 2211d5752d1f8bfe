// The affine fields of a block, which every mass represents exactly.
#pragma once

#include "model/geometry.h"

namespace scree::nmm {

/// P^T of a cover: the field [1, X, Y] at its reference position [1, m, m].
[[nodiscard]] inline Eigen::Vector3d affine_basis(const Vec2& X) { return {1.0, X.x(), X.y()}; }

/// P^T v: one row per field of the basis, one column per direction.
using AffineMoments = Eigen::Matrix<double, 3, 2>;

}  // namespace scree::nmm
