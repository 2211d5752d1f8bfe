// A block on one triangle of covers: three stars, six unknowns, solved in centroidal form.
#pragma once

#include "model/affine_form.h"
#include "nmm/folded_elements.h"

namespace scree::nmm {

/// The stars q_k of a onefold cover and (c, F) of its block are the same six numbers,
///   q_k = c + F X_k,   c = sum_k w_k(0) q_k,   F = sum_k q_k (grad w_k)^T,
/// X_k the stars' reference positions about the centre of mass. On a triangle as wide as the model the weights vary
/// little over a block of width d, and the condition number of matrices in the stars grows as (model/d)^2. Therefore
/// accelerations and implicit steps are solved in centroidal form, which does not depend on the triangle. Nothing is
/// lost: the map is exact.
/// @source [Qu2013] 7.3.1, which solves in the stars; docs/theory/kinematics-and-nmm.md, "Onefold covers"
class OnefoldCover {
 public:
  /// @param first  first cover of the block in the pool's arrays; spans q, v, f, a hold the whole pool
  OnefoldCover(const std::array<Vec2, 3>& star, const ReferenceShape& shape, const Elasticity& law,
               Kinematics kinematics, const Mat2& initial, std::int32_t first);

  // --- the map ---
  [[nodiscard]] Vec2 centre(std::span<const double> q) const;
  [[nodiscard]] Mat2 gradient(std::span<const double> q) const;
  /// q of the stars at c + F X.
  void place(const Vec2& c, const Mat2& F, std::span<double> q) const;
  /// Reference position of a point from its weights, nodes counted in the pool.
  [[nodiscard]] Vec2 point(const Row& row) const;

  // --- explicit ---
  /// a = M^-1 f and p = M v, M the exact mass int rho w_i w_j.
  void mass_solve(std::span<const double> f, std::span<double> a) const;
  void mass_apply(std::span<const double> v, std::span<double> p) const;
  void add_weight(const Vec2& g, std::span<double> f) const;
  [[nodiscard]] double kinetic_energy(std::span<const double> v) const;
  /// J M^-1 J^T of a row [1/kg].
  [[nodiscard]] double compliance(const Row& row) const;

  // --- implicit ---
  [[nodiscard]] const AffineForm& form() const { return form_; }
  [[nodiscard]] ChartRow chart_row(const Row& row) const;
  void rates(std::span<const double> v, std::span<double> rate) const;
  void retract(std::span<const double> d, std::span<const double> rate, std::span<double> q, std::span<double> v) const;

  // --- matrices in the stars, for studies of the cost of that form: x, y of each star ---
  /// B of dq = B d.
  [[nodiscard]] Mat6 star_map() const;
  /// int rho w_i w_j on x and y [kg].
  [[nodiscard]] Mat6 star_mass() const;

 private:
  [[nodiscard]] std::size_t at(std::size_t k) const { return 2 * (static_cast<std::size_t>(first_) + k); }

  std::array<Vec2, 3> star_;
  std::array<double, 3> weight_{};  // of the stars at the centre of mass
  Gradients slope_;                 // grad w_k
  double mass_;
  Mat2 second_, second_inverse_;
  AffineForm form_;
  std::int32_t first_;
};

}  // namespace scree::nmm
