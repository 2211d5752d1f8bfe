// A model that lies far from (0, 0), as in survey coordinates, counts its positions from a point nearby.
#pragma once

#include <string>

#include "model/model.h"

namespace scree {

/// A model farther from (0, 0) than this multiple of its extent gets a local origin.
///   Positions are rounded to the last place of their distance d from (0, 0), eps d. A joint of stiffness k [Pa/m]
///   turns that into forces: of the weight of a block of size L, k L eps d/(rho g L^2), which for k = 1e11 Pa/m, L = 1
///   m and rho g = 26 kN/m3 is 9e-8 at d = 100 L, and stays near 1e-6 with the errors of hundreds of steps added up. A
///   model nearer to (0, 0) is not changed by a single bit.
inline constexpr double kFarExtents = 100.0;

/// Moves all positions of a model, in x and in y where the box of its blocks lies farther from zero than kFarExtents
/// times its extent, so that it lies about zero, and adds the move to Model::origin. Else nothing changes, so that a
/// second call does nothing.
///   The origin is the multiple nearest to the middle of the box of a power of two not below the extent. It lies within
///   a factor of two of every coordinate of the box, so that the differences are exact.
/// @pre check_geometry finds nothing     @source [Sterbenz1974] theorem 4.3.1
void move_to_local_origin(Model& model);

/// A position for a message, in the coordinates of the user: "(0.5, 2)"; with more digits where the origin is not zero.
/// @param x  [m], counted from the origin
[[nodiscard]] std::string place_text(const Vec2& x, const Vec2& origin);

}  // namespace scree
