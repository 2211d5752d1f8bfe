// The linear system of an open-close pass where every free body is affine: blocks of 6 x 6.
#pragma once

#include <span>
#include <vector>

#include "coupling/linear/block_ilu.h"
#include "coupling/linear/block_matrix.h"
#include "coupling/linear/dof_rows.h"
#include "coupling/unknowns/implicit_system.h"

namespace scree::coupling {

/// What a contact point adds to the system: its forces along gap g and stretch s change by
///   df_n = -(nn dg + nt ds),   df_t = -(tn dg + tt ds).
struct PointTangent {
  double nn = 0.0, nt = 0.0, tn = 0.0, tt = 0.0;  // [N/m]
  [[nodiscard]] bool operator==(const PointTangent&) const = default;
  [[nodiscard]] bool zero() const { return nn == 0.0 && nt == 0.0 && tn == 0.0 && tt == 0.0; }
};

/// Points that are not worth waking threads for, in loops that take some nanoseconds each.
inline constexpr std::int64_t kFewPoints = 30000;

/// Assembles (A + springs + contact points, with friction and dilation) as a matrix of blocks, row of bodies by row of
/// bodies: only those rows are summed again whose points have changed. The matrix is for corrections; residuals are
/// summed from the rows of the points themselves, whose elongations lose nothing when bodies move together.
/// @source docs/theory/linear-solvers.md, "Block matrix"
class BlockSystem {
 public:
  /// @param system  must outlive it
  explicit BlockSystem(const ImplicitSystem& system) : system_(&system) {}

  /// Begins a step with the rows of its springs and then of gap and stretch of its points, which must outlive the step.
  /// @pre system.affine()   @return false: a row couples more than two bodies, and the system is none of pairs
  [[nodiscard]] bool begin(const DofRows& rows, std::size_t springs);
  /// Sums the matrix.
  /// @param A       on the pattern of the system   @param fresh  it has changed since the last call
  /// @param k       of the springs, the same during a step [N/m]   @param points  of the points
  void assemble(std::span<const double> A, bool fresh, std::span<const double> k, std::span<const PointTangent> points);
  /// Changes one point; its bodies' rows are summed again by the next assemble() or refresh().
  void set(std::size_t point, const PointTangent& tangent);
  /// Sums the row of a body if a point of it has changed.
  void refresh(std::int32_t body);
  [[nodiscard]] const BlockMatrix& matrix() const { return matrix_; }
  /// y = (A + springs + points) x from the rows themselves, with the numbers last assembled: elongations first, then
  /// the forces of every body in the order of its rows.
  void multiply(std::span<const double> x, std::span<double> y);

  /// The two bodies of a point; -1: held, or driven.
  [[nodiscard]] const BlockMatrix::Pair& bodies_of(std::size_t point) const { return bodies_[springs_ + point]; }
  /// Where a row of the rows above acts on a body.
  struct Incidence {
    std::int32_t unit = 0;   // a spring, or after all of them a point
    std::int32_t own = 0;    // 0 or 6: where the numbers of the body begin in the row
    std::int32_t other = 0;  // where those of the other body do; -1: there is none
    std::int32_t place = 0;  // of the block that couples both
  };
  /// All of a body, in the order of the rows.
  [[nodiscard]] std::span<const Incidence> incidences(std::int32_t body) const {
    const auto b = static_cast<std::size_t>(body), first = static_cast<std::size_t>(first_[b]);
    return std::span(incidence_).subspan(first, static_cast<std::size_t>(first_[b + 1]) - first);
  }
  /// Adds -A x of a body's own forces.   @param x  of all bodies   @param sum  6 numbers
  void subtract_own(std::int32_t body, std::span<const double> x, double* sum) const;
  /// Adds a force along a row to one of its bodies.   @param own  Incidence::own
  void add_force(std::size_t row, std::int32_t own, double force, double* sum) const {
    const double* h = &rows_->h()[static_cast<std::size_t>(rows_->start()[row]) + static_cast<std::size_t>(own)];
    for (int k = 0; k < kBlockSide; ++k) sum[k] += force * h[k];
  }

 private:
  void find_incidences();
  void sum_row(std::int32_t body);
  /// h.x of a row.
  [[nodiscard]] double elongation(std::size_t row, std::size_t unit, std::span<const double> x) const;
  void add_point(const Incidence& at, std::int32_t body);

  const ImplicitSystem* system_;
  const DofRows* rows_ = nullptr;
  std::size_t springs_ = 0;
  BlockMatrix matrix_;
  std::vector<BlockMatrix::Pair> bodies_, found_;  // of every unit; -1: none
  std::vector<BlockMatrix::Pair> pairs_;           // scratch
  std::vector<std::int32_t> first_;                // per body: its incidences
  std::vector<Incidence> incidence_;
  std::span<const double> A_;
  std::vector<double> k_;              // that the matrix is the sum of
  std::vector<PointTangent> tangent_;  // likewise
  std::vector<double> force_;          // of every row in multiply()
  std::vector<char> changed_;          // per body
};

}  // namespace scree::coupling
