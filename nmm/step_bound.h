// Certified bound of the highest frequency of one block's own stiffness.
#pragma once

#include "model/elasticity.h"
#include "nmm/affine_mass.h"
#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// Largest over the elements of the eigenvalue of (K_e, D_e), where K_e is the element's stiffness on free covers (ties
/// folded in) and the D_e share out the lumped mass: x^T K x = sum x^T K_e x <= max lambda_e sum x^T D_e x.
/// Each cover's mass is shared in proportion to the elements' diagonal stiffness, which is tight on the regular mesh
/// (dt = 2/sqrt(lambda) = 0.866 h/c_p).
/// @return lambda [1/s2]; stable explicit steps obey dt <= 2/sqrt(theta lambda) without contacts
[[nodiscard]] double frequency_bound_of(const CoverMesh& mesh, const AffineMass& mass, const Elasticity& law);

}  // namespace scree::nmm
