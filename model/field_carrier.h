// Interface of a method, beside Pool, if the deformation of its bodies can be transferred to another mesh.
#pragma once

#include "model/pool.h"

namespace scree {

/// Bodies whose fields are more than affine. Found by dynamic_cast from a Pool; methods without fields have none.
class FieldCarrier {
 public:
  FieldCarrier() = default;
  FieldCarrier(const FieldCarrier&) = delete;
  FieldCarrier& operator=(const FieldCarrier&) = delete;
  virtual ~FieldCarrier() = default;

  /// True for a body with non-affine deformation.
  [[nodiscard]] virtual bool has_fields(int body) const = 0;
  /// Sets the nodes of a body to the motion of another one of the same method, made from the same reference shape with
  /// another mesh: displacements with the least elastic energy in the difference, velocities with the least kinetic
  /// energy in it. Rigid and affine motion is taken over exactly; momenta up to the difference of the two masses.
  /// @param from, other     the previous body
  /// @param q_from, v_from  nodes of its pool
  /// @param q, v            nodes of this pool
  virtual void project(int body, const FieldCarrier& from, int other, std::span<const double> q_from,
                       std::span<const double> v_from, std::span<double> q, std::span<double> v) const = 0;
};

}  // namespace scree
