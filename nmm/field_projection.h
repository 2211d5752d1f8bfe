// Displacements and velocities of one mesh of a shape, as another mesh of it can have them.
#pragma once

#include "model/elasticity.h"
#include "model/formulation.h"
#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// A mesh with its motion: x, y a cover, counted from the mesh's first.
struct MovingMesh {
  const CoverMesh* mesh = nullptr;
  std::span<const double> q, v;
};

/// The motion x'(X), v'(X) on the covers of `to` nearest to that of `from`, both affine beside what is projected:
///   velocity      min int rho |v' - v|^2                                        (M' v' = int rho w' v)
///   displacement  min int d:C:d + kappa |x' - x|^2,  d = sym(R^T (F' - F)),  R the rotation of the affine part.
/// The second makes the force of the old stresses on every cover of the new mesh, int P grad w', that of the new ones
/// as well, so that what was in balance with loads and contacts stays so, and the elastic energy falls by that of the
/// difference alone; both but for the square of the rotations within the block. Displacements nearest in the mass would
/// not: they overshoot at the kinks of the old mesh, and an element's stress with them. kappa is small and settles the
/// rigid motion, which has no strain. (With R = polar(F) of each old element in place of the one rotation, turning the
/// whole is no longer free, and its small stiffness turns what the mesh cannot follow into a rotation.)
/// Integrals are exact, over the material that two elements have in common. Ties are folded in; covers that a division
/// has twice move together.
/// @param q, v  of the covers of `to`, counted from its first; written
void project_motion(const MovingMesh& from, const CoverMesh& to, const Elasticity& law, Kinematics kinematics,
                    std::span<double> q, std::span<double> v);

}  // namespace scree::nmm
