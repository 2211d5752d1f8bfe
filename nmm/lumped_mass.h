// The lumped masses of all blocks of a pool, affine-exact or plain.
#pragma once

#include <span>
#include <vector>

#include "model/formulation.h"
#include "nmm/affine_basis.h"
#include "nmm/cover_chart.h"

namespace scree::nmm {

/// Row sums of the mass of a mesh's elements on its covers; those of tied covers are added to their roots [kg].
[[nodiscard]] std::vector<double> row_sums(const CoverMesh& mesh, double density);

/// Row sums on the free covers. `lumped` uses these alone ([Qu2013] 4.3.1). `affine_exact` corrects each connected
/// part so that its mass, momentum and rotational inertia are exact:
///   M~^-1 = M_L^-1 + P (M_a^-1 - S^^-1) P^T,  P = [1, X - c],  M_a = diag(m, S),  S^ = P^T M_L P.
/// Still explicit: a correction of rank 3 per part; on a onefold cover it is the consistent mass. Ties are folded in:
/// forces on a tied cover are added to its roots, its motion follows them.
/// @source docs/theory/kinematics-and-nmm.md, "Masses"
class LumpedMass {
 public:
  /// Appends the parts of a block.   @param first  its first cover in the pool
  /// Parts without elements in the mesh have no mass, and solve() and damp() do not change their covers.
  /// @return false if a row sum is not positive: the mesh cannot carry a lumped mass
  [[nodiscard]] bool add(const CoverMesh& mesh, std::int32_t first, const ReferenceShape& shape, MassKind kind);

  /// Called once after the last block.   @param chart  the same in every solve()
  void finish(const CoverChart& chart);

  /// a = M^-1 f on the free covers, followed by the ties.
  void solve(const CoverChart& chart, std::span<const double> f, std::span<double> a) const;
  /// p = M v on the free covers of one block, zero on its tied ones [kg m/s].
  void apply(std::int32_t begin, std::int32_t end, std::span<const double> v, std::span<double> p) const;
  /// 1/2 v^T M v over the covers of one block [J]
  [[nodiscard]] double kinetic_energy(std::int32_t begin, std::int32_t end, std::span<const double> v) const;
  /// w *= factor, f = -rate M w, a -= rate w; w = v - P S^^-1 P^T M_L v, M-orthogonal to affine fields of each part.
  double damp(double factor, double rate, std::span<const double> along, std::span<double> v, std::span<double> f,
              std::span<double> a) const;
  /// f += M 1 g on the covers of one block
  void add_weight(std::int32_t begin, std::int32_t end, const Vec2& g, std::span<double> f) const;

  /// Row sums per cover; 0 for tied covers and for covers of parts without elements [kg].
  [[nodiscard]] std::span<const double> lumped() const { return lumped_; }
  /// Inverses of the row sums, 0 for tied covers [1/kg].
  [[nodiscard]] std::span<const double> inverse() const { return inverse_; }
  /// theta, the largest eigenvalue of M_a^-1 S^ over the parts of the block with these covers; 1 for `lumped`.
  [[nodiscard]] double theta(std::int32_t begin, std::int32_t end) const;

 private:
  struct Part {                                                    // a connected part of a block
    std::int32_t begin = 0, end = 0;                               // its chunks
    Eigen::Matrix3d inverse_correction = Eigen::Matrix3d::Zero();  // M_a^-1 - S^^-1
    Eigen::Matrix3d correction = Eigen::Matrix3d::Zero();          // S^^-1 (S^ - M_a) S^^-1
    Eigen::Matrix3d hat_inverse = Eigen::Matrix3d::Zero();         // S^^-1
    double theta = 1.0;
  };
  struct Chunk {
    std::int32_t begin = 0, end = 0, part = 0;  // covers
    bool mixed = false;                         // its range has covers of other parts too, which are skipped
    std::size_t first_root = 0, last_root = 0;  // its covers that others follow, in the chart's order
    std::size_t first_tie = 0, last_tie = 0;    // its tied covers
  };
  /// Calls see(k) for the covers of a chunk that belong to its part; iterations must not share anything they write.
  template <class See>
  void each_of(const Chunk& chunk, See&& see) const;
  /// Sum of of(k) over the same covers.
  template <class Of>
  [[nodiscard]] double sum_of(const Chunk& chunk, Of&& of) const;
  /// P^T v, or P^T M_L v, of every part in [first, last).
  void project(std::size_t first, std::size_t last, std::span<const double> v, bool weighted) const;
  [[nodiscard]] std::pair<std::size_t, std::size_t> parts_of(std::int32_t begin, std::int32_t end) const;

  std::vector<Part> parts_;
  std::vector<Chunk> chunks_;                            // by part, each of at most kChunk covers
  std::vector<std::int32_t> part_of_;                    // per cover
  std::vector<double> lumped_, inverse_, unit_;          // M_L, 1/M_L (0 for tied covers), M 1
  std::vector<Vec2> X_;                                  // reference position less the part's centre of mass [m]
  mutable std::vector<AffineMoments> partial_, moment_;  // per chunk, per part
  mutable std::vector<double> power_;                    // per chunk: work of damping
};

}  // namespace scree::nmm
