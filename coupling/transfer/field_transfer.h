// Transfer of the fields of a body to another mesh of the same method.
#pragma once

#include "coupling/state.h"
#include "model/pool.h"

namespace scree::coupling {

/// True for a method whose meshes can take over each other's fields.
[[nodiscard]] bool carries_fields(const Pool& pool);

/// True for a body with non-affine deformation, of such a method.
[[nodiscard]] bool has_fields(const Pool& pool, int body);

/// Adds a rigid motion to the velocities, so that momentum and angular momentum become those of `was`.
/// @param q, v  nodes of the body's pool
void keep_momenta(const Pool& pool, int body, const BodyTotals& was, std::span<const double> q, std::span<double> v);

/// Projects the motion of one body onto the nodes of another, created from the same shape with another mesh. The affine
/// part of the velocities, by the masses that each body uses, and so centre of mass and momenta, are kept exactly.
/// If the new mass gives more kinetic energy for the same motion, as the row sums of coarse covers do for a short wave,
/// the non-affine velocities are reduced, so that a mesh adds no energy.
/// @param from, other           the body before; its method carries fields
/// @param q_from, v_from, q, v  nodes of the two pools
/// @param was                   totals to preserve: of the body before, or of the affine body that it was in between
void project_fields(const Pool& from, int other, std::span<const double> q_from, std::span<const double> v_from,
                    const Pool& pool, int body, const BodyTotals& was, std::span<double> q, std::span<double> v);

}  // namespace scree::coupling
