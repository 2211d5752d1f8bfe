// Role of a method: placing a body by a given motion, and releasing it to another method.
#pragma once

#include <span>
#include <vector>

#include "model/body.h"

namespace scree {

/// What a body passes on when it changes method: its affine part exactly, the rest as energy and fields.
/// @source docs/theory/transfer.md, "Reservoir"
struct Release {
  ReferenceShape shape;  // reference shape of the affine body that remains
  AffineMotion motion;
  Mat2 initial = Mat2::Zero();  // mean in-situ stress of the released body, co-rotated [Pa]
  double kinetic_rest = 0.0;    // 1/2 w^T M w, w = v - affine [J]
  double elastic_rest = 0.0;    // 1/2 sum A_e (s_e - s):D:(s_e - s) [J]
  double elastic_cross = 0.0;   // sum A_e s:(e_e - e): zero to first order, booked [J]
  double spin_squared = 0.0;    // sum J_e w_e^2 / sum J_e over its cells [1/s2]
  // Two numbers per node, empty if the motion is affine: F^-1 (x - c), which determines the non-affine deformation,
  // and w in the co-rotated frame.
  std::vector<double> position, velocity_rest;
};

/// Motion of a body in and out of its nodes. Spans q, v hold two numbers (x, y) per node of the pool.
class BodyTransfer {
 public:
  BodyTransfer() = default;
  BodyTransfer(const BodyTransfer&) = delete;
  BodyTransfer& operator=(const BodyTransfer&) = delete;
  virtual ~BodyTransfer() = default;

  /// True if place() takes any affine motion; false for a method whose bodies cannot strain.
  [[nodiscard]] virtual bool strains() const { return true; }
  /// Sets the body's nodes to an affine motion, or to the rigid one nearest to it.
  virtual void place(int body, const AffineMotion& motion, std::span<double> q, std::span<double> v) const = 0;
  /// Affine part of the motion, and the rest.
  [[nodiscard]] virtual Release release(int body, std::span<const double> q, std::span<const double> v) const = 0;
  [[nodiscard]] virtual BodyTotals totals(int body, std::span<const double> q, std::span<const double> v) const = 0;

  /// True if the body's own forces and elastic energy contain those of its edge supports; else springs represent these.
  [[nodiscard]] virtual bool holds_edges(int body) const;
  /// Traction of a support at a fraction of its span, for a body that holds its edges [Pa].
  /// @param support  counted among the edge supports of the block
  [[nodiscard]] virtual Vec2 edge_reaction(int body, std::size_t support, double s, std::span<const double> q) const;
  /// Part of the body's elastic energy that is stored in its edge supports [J].
  [[nodiscard]] virtual double edge_energy(int body, std::span<const double> q) const;
  /// Moves the anchors of the edge supports of a body that holds its edges.   @param shift  as BodyRecord::edge_shift
  virtual void shift_edges(int body, std::span<const double> shift);
};

}  // namespace scree
