// The affine-exact lumped mass of one block.
#pragma once

#include <span>
#include <vector>

#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// Row sums on the free covers, corrected so that mass, momentum and rotational inertia are those of the block:
///   M~^-1 = M_L^-1 + P (M_a^-1 - S^^-1) P^T,  P = [1, X],  M_a = diag(m, S),  S^ = P^T M_L P.
/// Still explicit: a correction of rank 3 a block. Ties are folded in: forces on a tied cover go to its roots, its
/// motion follows them.
/// @source nmm.md "Mass"; row sums: thesis 4.3.1
class AffineMass {
 public:
  /// @param first  first cover of the block in the pool's arrays; the spans below hold the whole pool
  /// @return false where a row sum is not positive (the mesh cannot carry a lumped mass)
  [[nodiscard]] bool make(const CoverMesh& mesh, const ReferenceShape& shape, std::int32_t first);

  /// a = M~^-1 f on the free covers, followed by the ties.
  void solve(std::span<const double> f, std::span<double> a) const;
  /// p = M~ v on the free covers, zero on tied ones.
  void apply(std::span<const double> v, std::span<double> p) const;
  /// 1/2 v^T M~ v [J]
  [[nodiscard]] double kinetic_energy(std::span<const double> v) const;
  /// w *= factor, f = -rate M~ w, a -= rate w; w = v - P S^^-1 P^T M_L v, the part M~-orthogonal to affine fields.
  void damp(double factor, double rate, std::span<double> v, std::span<double> f, std::span<double> a) const;
  /// f += M~ 1 g
  void add_weight(const Vec2& g, std::span<double> f) const;

  [[nodiscard]] std::int32_t first() const { return first_; }  // first cover in the pool
  /// theta, the largest eigenvalue of M_a^-1 S^.
  [[nodiscard]] double theta() const { return theta_; }
  /// Row sums, a cover; 0 for tied ones [kg].
  [[nodiscard]] std::span<const double> lumped() const { return lumped_; }
  /// Weights on free covers (counted from the block's first) that a row stands for.
  void fold(const Row& row, std::vector<std::pair<std::int32_t, double>>& folded) const;

 private:
  using Moments3 = Eigen::Matrix<double, 3, 2>;
  [[nodiscard]] Moments3 projection(std::span<const double> v, bool weighted) const;  // P^T (M_L) v

  mutable std::vector<Moments3> partial_;  // of projection(), chunk by chunk
  std::int32_t first_ = 0;
  std::vector<double> lumped_, unit_;  // M_L, M~ 1
  std::vector<Vec2> X_;
  std::vector<Tie> ties_;
  std::vector<std::int32_t> tie_of_;                              // a cover: its tie or -1
  Eigen::Matrix3d inverse_correction_ = Eigen::Matrix3d::Zero();  // M_a^-1 - S^^-1
  Eigen::Matrix3d correction_ = Eigen::Matrix3d::Zero();          // S^^-1 (S^ - M_a) S^^-1
  Eigen::Matrix3d hat_inverse_ = Eigen::Matrix3d::Zero();         // S^^-1
  double theta_ = 1.0;
};

}  // namespace scree::nmm
