// The consistent mass of one block, int rho w_i w_j over its material, ties folded in.
#pragma once

#include <Eigen/SparseCore>
#include <memory>
#include <span>
#include <vector>

#include "nmm/affine_basis.h"
#include "nmm/folded_elements.h"

namespace scree::nmm {

/// Data of an element for a mass: the moments of its material and the weights there.
struct MassElement {
  std::array<std::int32_t, 3> cover{};   // counted from the block's first
  std::array<double, 3> weight{};        // of the three covers at the centroid of the material
  Eigen::Matrix<double, 2, 3> gradient;  // of the weights [1/m]
  Moments material;                      // area, centroid, second moment about it (reference shape)
};

/// M = C^T M_covers C with the exact scalar mass of each piece of material,
///   int rho w_i w_j = m_e w_i(c_e) w_j(c_e) + (grad w_i)^T S_e grad w_j,
/// the same for x and y. Its affine part is the block's: mass, momenta and rotational inertia are exact. If the outline
/// was fitted to a deformed body, its moments differ slightly from those stored with the body; then the material points
/// at which the weights are evaluated are moved by the affine map that restores the stored moments.
/// @source docs/theory/kinematics-and-nmm.md, "Masses"; [Qu2013] 3.3.1
class ConsistentMass {
 public:
  ConsistentMass();
  ConsistentMass(ConsistentMass&&) noexcept;
  ConsistentMass& operator=(ConsistentMass&&) noexcept;
  ~ConsistentMass();

  /// @param folded  the block's elements, in the order of `elements`
  /// @param star    reference position of every cover of the block [m]
  /// @param density  of the material as it is drawn [kg/m2]
  /// @param second   moment about the origin to reproduce [kg m2]; null: that of the elements as they are drawn
  /// @param first   first cover of the block in the pool's arrays; the spans below hold the whole pool
  void make(const FoldedElements& folded, std::span<const MassElement> elements, std::span<const Vec2> star,
            double density, const Mat2* second, std::int32_t first);

  /// a = M^-1 f on the free covers (forces on tied ones are added to their roots), followed by the ties. The first call
  /// factorises. f and a may be the same.
  void solve(std::span<const double> f, std::span<double> a) const;
  /// p = M v on the free covers, zero on tied ones.
  void apply(std::span<const double> v, std::span<double> p) const;
  /// 1/2 v^T M v [J]
  [[nodiscard]] double kinetic_energy(std::span<const double> v) const;
  /// w *= factor, f = -rate M w, a -= rate w; w = v minus its affine part, to which it is M-orthogonal.
  double damp(double factor, double rate, std::span<const double> along, std::span<double> v, std::span<double> f,
              std::span<double> a) const;
  /// f += M 1 g
  void add_weight(const Vec2& g, std::span<double> f) const;
  /// Exact scalar mass of an element over its three covers, before ties [kg].
  [[nodiscard]] const Mat3& element(std::size_t e) const { return element_[e]; }
  /// Row sums per cover; 0 for tied ones [kg].
  [[nodiscard]] std::span<const double> row_sums() const { return row_sum_; }

 private:
  struct Factor;
  [[nodiscard]] AffineMoments affine_part(std::span<const double> v) const;

  std::int32_t first_ = 0;
  std::vector<Mat3> element_;
  CoverChart chart_;
  std::vector<std::int32_t> cover_of_;                            // per free cover
  Eigen::SparseMatrix<double, Eigen::RowMajor, std::int32_t> M_;  // over free covers, both triangles
  std::vector<double> row_sum_;                                   // per cover
  std::vector<Eigen::Vector3d> basis_;                            // M [1, X] per free cover
  std::vector<Vec2> star_;                                        // reference position per cover [m]
  Mat3 inverse_ = Mat3::Zero();                                   // (P^T M P)^-1, P = [1, X]
  mutable std::unique_ptr<Factor> factor_;
};

}  // namespace scree::nmm
