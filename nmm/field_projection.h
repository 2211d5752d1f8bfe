// Projects displacements and velocities of one mesh of a shape on another mesh of the same shape.
#pragma once

#include "model/elasticity.h"
#include "model/formulation.h"
#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// A mesh with its motion: x, y per cover, counted from the mesh's first.
struct MovingMesh {
  const CoverMesh* mesh = nullptr;
  std::span<const double> q, v;
};

/// The motion x'(X), v'(X) on the covers of `to` nearest to that of `from`. Affine parts are kept, the rest projected:
///   velocity      min int rho |v' - v|^2                                        (M' v' = int rho w' v)
///   displacement  min int d:C:d + kappa |x' - x|^2,  d = sym(R^T (F' - F)),  R the rotation of the affine part.
/// With the second, the new stresses exert the same force on every cover of the new mesh, int P grad w', as the old
/// ones, so that a body in equilibrium with loads and contacts stays so, and the elastic energy falls by that of the
/// difference alone; both hold up to the square of the rotations within the block. Displacements nearest in the mass
/// do not have this property: they overshoot at the kinks of the old mesh, and so do the stresses of the elements.
/// kappa is small and determines the rigid motion, which has no strain. (With R = polar(F) of each old element in place
/// of the one rotation, a rotation of the whole block has a small stiffness, which converts what the mesh cannot
/// represent into a rotation.)
/// Integrals are exact, over the material that two elements have in common. Ties are folded in; covers that a division
/// duplicates move together.
/// @param q, v  of the covers of `to`, counted from its first; written
void project_motion(const MovingMesh& from, const CoverMesh& to, const Elasticity& law, Kinematics kinematics,
                    std::span<double> q, std::span<double> v);

}  // namespace scree::nmm
