// Fields of a body that go on with another mesh of the same method.
#pragma once

#include "coupling/state.h"
#include "model/pool.h"

namespace scree::coupling {

/// True for a method whose meshes can take over each other's fields.
[[nodiscard]] bool carries_fields(const Pool& pool);

/// True for a body with deformation beside the affine one, of such a method.
[[nodiscard]] bool has_fields(const Pool& pool, int body);

/// Adds a rigid motion to velocities, so that momentum and angular momentum become those of `was`.
/// @param q, v  nodes of the body's pool
void keep_momenta(const Pool& pool, int body, const BodyTotals& was, std::span<const double> q, std::span<double> v);

/// Puts the motion of one body on the nodes of another, made from the same shape with another mesh. What is affine in
/// the velocities, in the masses that both really use, and so centre of mass and momenta, is exactly what it was. Where
/// the new mass sees more kinetic energy in the same motion than there was, as the row sums of coarse covers do in a
/// short wave, the velocities beside the affine ones are made smaller, so that a mesh gives nothing away.
/// @param from, other           the body before; its method carries fields
/// @param q_from, v_from, q, v  nodes of the two pools
/// @param was                   totals to keep: of the body before, or of the affine one that it has been since
void project_fields(const Pool& from, int other, std::span<const double> q_from, std::span<const double> v_from,
                    const Pool& pool, int body, const BodyTotals& was, std::span<double> q, std::span<double> v);

}  // namespace scree::coupling
