// The linear system of an open-close pass where every free body is affine: blocks of 6 x 6.
#pragma once

#include <span>
#include <vector>

#include "coupling/linear/block_ilu.h"
#include "coupling/linear/block_matrix.h"
#include "coupling/linear/dof_rows.h"
#include "coupling/unknowns/implicit_system.h"
#include "model/parallel.h"

namespace scree::coupling {

/// What a contact point adds to the system: its forces along gap g and stretch s change by
///   df_n = -(nn dg + nt ds),   df_t = -(tn dg + tt ds).
struct PointTangent {
  double nn = 0.0, nt = 0.0, tn = 0.0, tt = 0.0;  // [N/m]
  [[nodiscard]] bool operator==(const PointTangent&) const = default;
  [[nodiscard]] bool zero() const { return nn == 0.0 && nt == 0.0 && tn == 0.0 && tt == 0.0; }
};

/// Forces of a point in its state: f_n = normal - nn dg - nt ds, f_t = tangential - tn dg - tt ds.
struct LinearContactForce {
  PointTangent k;
  double normal = 0.0, tangential = 0.0;  // [N]
};

/// Below this number of points a loop that takes some nanoseconds per point runs on one thread.
inline constexpr std::int64_t kFewPoints = 8000;

/// Assembles (A + springs + contact points, with friction and dilation) as a matrix of blocks, row of bodies by row of
/// bodies: only rows whose points have changed are summed again. The matrix is for corrections; residuals are
/// summed from the rows of the points themselves, whose elongations lose no digits when bodies move together.
/// @source docs/theory/linear-solvers.md, "Block matrix"
class BlockSystem {
 public:
  /// @param system  must outlive it
  explicit BlockSystem(const ImplicitSystem& system) : system_(&system) {}

  /// Begins a step. `rows` has the rows of its springs, then gap and stretch of its points; it must outlive the step.
  /// @pre system.affine()   @return false: a row couples more than two bodies, so blocks of pairs are not enough
  [[nodiscard]] bool begin(const DofRows& rows, std::size_t springs);
  /// Sums the matrix.
  /// @param A       on the pattern of the system   @param fresh  A has changed since the last call
  /// @param k       of the springs, constant during a step [N/m]   @param at  their elongations at its start [m]
  /// @param points  number of them   @param force  force(i): of point i in its state, called on threads
  template <class Force>
  void assemble(std::span<const double> A, bool fresh, std::span<const double> k, std::span<const double> at,
                std::size_t points, Force&& force) {
    const bool all = begin_assembly(A, fresh, k, at, points);
    parallel_for(
        static_cast<std::int64_t>(points), [&](std::int64_t i) { take(static_cast<std::size_t>(i), force(i), all); },
        kFewPoints);
    end_assembly();
  }
  /// Changes one point; its bodies' rows are summed again by the next assemble() or refresh().
  void set(std::size_t point, const PointTangent& tangent);
  /// Sums the row of a body if a point of it has changed.
  void refresh(std::int32_t body);
  [[nodiscard]] const BlockMatrix& matrix() const { return matrix_; }
  /// y = (A + springs + points) x from the rows themselves, with the values last assembled: elongations first, then
  /// the forces of every body in the order of its rows.
  void multiply(std::span<const double> x, std::span<double> y);
  /// The same less the forces of springs and points at no displacement: y = A x - (their forces on the bodies at x).
  void balance(std::span<const double> x, std::span<double> y);
  /// The largest force of a row in the last balance() [N].
  [[nodiscard]] double largest_force() const;

  /// The two bodies of a point; -1: held, or driven.
  [[nodiscard]] const BlockMatrix::Pair& bodies_of(std::size_t point) const { return bodies_[springs_ + point]; }
  /// A spring or a point at one of its bodies.
  struct Incidence {
    std::int32_t unit = 0;   // index of a spring, or after all springs of a point
    std::int32_t own = 0;    // 0 or 6: offset of the body's coefficients in the row
    std::int32_t other = 0;  // offset of the other body's coefficients; -1: no other body
    std::int32_t place = 0;  // index of the block that couples both
  };
  /// All incidences of a body, in the order of the rows.
  [[nodiscard]] std::span<const Incidence> incidences(std::int32_t body) const {
    const auto b = static_cast<std::size_t>(body), first = static_cast<std::size_t>(first_[b]);
    return std::span(incidence_).subspan(first, static_cast<std::size_t>(first_[b + 1]) - first);
  }
  /// sum += -A x, forces of the body's own block of A.   @param x  of all bodies   @param sum  6 numbers
  void subtract_own(std::int32_t body, std::span<const double> x, double* sum) const;
  /// Adds a force along a row to one of its bodies.   @param own  Incidence::own
  void add_force(std::size_t row, std::int32_t own, double force, double* sum) const {
    DoubleColumn all(sum);
    all.add(force, coefficients(row, own));
    all.store(sum);
  }

 private:
  void find_incidences();
  /// @return true: every row is to be summed
  [[nodiscard]] bool begin_assembly(std::span<const double> A, bool fresh, std::span<const double> k,
                                    std::span<const double> at, std::size_t points);
  /// Takes the forces of a point; marks the rows of its bodies if they change and not all are summed anyway.
  void take(std::size_t point, const LinearContactForce& force, bool all);
  void end_assembly();
  /// force_ of a spring or a point at x, with or without what it is at no displacement.
  template <bool Constant>
  void find_force(std::size_t unit, std::span<const double> x);
  template <bool Constant>
  void multiply_rows(std::span<const double> x, std::span<double> y);
  /// sum += the forces of all rows on a body.
  void add_forces(std::int32_t body, DoubleColumn& sum) const;
  void sum_row(std::int32_t body);
  /// Coefficients of one of the bodies of a row.   @param own  Incidence::own
  [[nodiscard]] DoubleColumn coefficients(std::size_t row, std::int32_t own) const {
    return DoubleColumn(&rows_->h()[static_cast<std::size_t>(rows_->start()[row]) + static_cast<std::size_t>(own)]);
  }
  /// h.x of a row.
  [[nodiscard]] double elongation(std::size_t row, std::size_t unit, std::span<const double> x) const;
  void add_point(const Incidence& at, std::int32_t body);

  const ImplicitSystem* system_;
  const DofRows* rows_ = nullptr;
  std::size_t springs_ = 0;
  BlockMatrix matrix_;
  std::vector<BlockMatrix::Pair> bodies_, found_;  // of every unit; -1: none
  std::vector<BlockMatrix::Pair> pairs_, places_;  // of the units that couple two bodies; where their blocks are
  std::vector<std::int32_t> first_;                // per body: its incidences
  std::vector<Incidence> incidence_;
  std::span<const double> A_;
  std::vector<double> k_;              // stiffnesses in the present matrix
  std::vector<PointTangent> tangent_;  // tangents in the present matrix
  std::vector<double> constant_;       // of every row: its force at no displacement [N]
  std::vector<double> force_;          // of every row in multiply() or balance(), against the elongation
  std::vector<char> changed_;          // per body
};

}  // namespace scree::coupling
