// Certified bound of the highest frequency of one block's own stiffness.
#pragma once

#include "model/elasticity.h"
#include "nmm/cover_chart.h"

namespace scree::nmm {

struct FrequencyBound {
  double lambda = 0.0;       // [1/s2]
  std::int32_t element = 0;  // that determines it, counted from the mesh's first
};

/// Largest over the elements of the eigenvalue of (K_e, D_e), where K_e is the element's stiffness on free covers (ties
/// folded in) and the D_e add up to the lumped mass: x^T K x = sum x^T K_e x <= max lambda_e sum x^T D_e x.
/// Each cover's mass is shared in proportion to the elements' diagonal stiffness, which is tight on the regular mesh
/// (dt = 2/sqrt(lambda) = 0.866 h/c_p). Stable explicit steps obey dt <= 2/sqrt(theta lambda) without contacts.
/// @param first   first cover of the mesh in the pool   @param lumped  row sums, per cover of the pool [kg]
/// @param scale   of the elements' areas
[[nodiscard]] FrequencyBound frequency_bound_of(const CoverMesh& mesh, const CoverChart& chart, std::int32_t first,
                                                std::span<const double> lumped, double scale, const Elasticity& law);

}  // namespace scree::nmm
