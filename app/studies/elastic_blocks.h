// Elastic blocks that slide on a plane: an integration that shares nothing with Scree's methods.
#pragma once

#include <functional>
#include <vector>

#include "model/geometry.h"

namespace scree::app {

/// `row` x `stack` blocks of one convex shape, side by side and on each other, on the plane y = 0; downslope is -x.
/// Ritz's method: the displacements of a block are polynomials of `degree` about its centroid, integrated over the
/// polygon (degree 1 are the affine displacements of DDA), as modes of the free block; small displacements. Contacts
/// join points that faced each other at the start by springs of `stiffness`, dashpots and Coulomb's friction; the
/// deformation of a block is damped until a natural period after one of its contacts has slipped down the plane.
struct ElasticBlocks {
  Ring shape;  // its base lies on y = 0
  int row = 1, stack = 1;
  int degree = 1;  // 7 at most
  int points = 2;  // on a side, at equal distances, the first and the last on corners
  double density = 2600.0, young = 0.0, poisson = 0.2;
  double friction_plane = 0.0, friction_between = 0.0;  // coefficients
  // Contact stiffness per area, normal and tangential: with the plane, between stacked blocks, in a row [Pa/m].
  double stiffness_plane = 0.0, stiffness_stack = 0.0, stiffness_row = 0.0;
  double damping = 0.5;          // of contacts, as a fraction of critical for the point on its block
  double sliding_damping = 1.0;  // as a fraction of critical for the lowest frequency of deformation
};

/// @param acceleration  body acceleration at a time [m/s2]
/// @param fraction  of the stable step that is taken
/// @return per block, stack after stack: the displacement of its centroid down the plane between two times [m]
[[nodiscard]] std::vector<double> elastic_ways(const ElasticBlocks& e, const std::function<Vec2(double)>& acceleration,
                                               double from, double end, double fraction);

}  // namespace scree::app
