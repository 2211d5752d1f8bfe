// The six unknowns of a body that is affine as a whole, in centroidal form: the unknowns of implicit steps.
#pragma once

#include "model/pool.h"

namespace scree {

/// Unknowns of an implicit step of a body x = c + F X:
///   d = (dc, r dF e1, r dF e2) [m],   r = (tr S/m)^1/2, the radius of gyration,
/// S = int rho X X^T about the centre of mass. The mass is diag(m, m) and S/r^2 on x and y: translation and gradient
/// are not coupled, and the condition number depends on the block's shape alone, not on its position or its nodes.
/// @source docs/theory/kinematics-and-nmm.md, "Onefold covers"; docs/theory/dda.md, "Affine form"
class AffineForm {
 public:
  static constexpr int kUnknowns = 6;
  AffineForm() = default;
  /// @param initial  in-situ stress in the co-rotated frame [Pa]
  AffineForm(const ReferenceShape& shape, const Elasticity& law, Kinematics kinematics, const Mat2& initial);

  /// Chart row of the point  x = weight c + F X.
  [[nodiscard]] ChartRow chart_row(double weight, const Vec2& X) const;
  /// One element that holds all unknowns.
  [[nodiscard]] static ElementDofs element_dofs() { return {{0, kUnknowns}, {0, 1, 2, 3, 4, 5}}; }
  /// Mass, lower triangle [kg].
  void mass(std::span<double> lower) const;
  /// Tangent stiffness, lower triangle (empty: not computed), and the force -dU/dd.   @return elastic energy [J]
  double linearise(const Mat2& F, Stiffness kind, std::span<double> lower, std::span<double> force) const;
  /// Unknowns d of a change of c and F.
  void unknowns(const Vec2& dc, const Mat2& dF, std::span<double> d) const;
  [[nodiscard]] static Vec2 translation(std::span<const double> d) { return {d[0], d[1]}; }
  [[nodiscard]] Mat2 gradient(std::span<const double> d) const;
  /// r [m]
  [[nodiscard]] double length() const { return length_; }

 private:
  double mass_ = 0.0, area_ = 0.0, length_ = 1.0;
  Mat2 second_ = Mat2::Identity(), initial_ = Mat2::Zero();
  Elasticity law_;
  Kinematics kinematics_ = Kinematics::corotational;
};

/// Largest squared frequency of a free affine body, A0 C^1/2 (B D^-1 B^T) C^1/2 with D = diag(m, S) [1/s2].
[[nodiscard]] double affine_frequency(const ReferenceShape& shape, const Elasticity& law);

}  // namespace scree
