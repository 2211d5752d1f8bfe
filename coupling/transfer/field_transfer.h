// Fields of a body that go on with another mesh of the same method.
#pragma once

#include "coupling/state.h"
#include "model/field_carrier.h"

namespace scree::coupling {

/// True for a method whose meshes can take over each other's fields.
[[nodiscard]] bool carries_fields(const Pool& pool);

/// What brings a method's fields to another of its meshes; null where the body has none to bring.
[[nodiscard]] const FieldCarrier* fields_of(const Pool& pool, int body);

/// Adds a rigid motion to velocities, so that momentum and angular momentum become those of `was`.
/// @param q, v  nodes of the body's pool
void keep_momenta(const Pool& pool, int body, const BodyTotals& was, std::span<const double> q, std::span<double> v);

/// Puts the motion of one body on the nodes of another, made from the same shape with another mesh. Centre of mass and
/// momenta are exactly those of `was`, in the masses that both really use. Where the new mass sees more kinetic energy
/// in the same motion than there was, as the row sums of coarse covers do in a short wave, the velocities beside the
/// affine ones are made smaller, so that a mesh gives nothing away.
/// @param was           the body before, with what its reservoir holds of it
/// @param q_from, v_from, q, v  nodes of the two pools
void take_fields(const FieldCarrier& from, int other, std::span<const double> q_from, std::span<const double> v_from,
                 const Pool& pool, int body, const BodyTotals& was, std::span<double> q, std::span<double> v);

}  // namespace scree::coupling
