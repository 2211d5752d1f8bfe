// Bolts in implicit steps.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "coupling/bolts/bolt_response.h"
#include "coupling/bolts/bolt_rows.h"
#include "coupling/integrate/open_close.h"

namespace scree::coupling {

/// Lengths of segments and shears of crossings are linear in the unknowns of a step, about its start; forces follow
/// from them by the bolt's law at the end of the step, and Newton's method uses the tangent of that law. A segment's
/// tension N also resists motion across it, as a spring N/l. Tangents enter the step as springs; add() subtracts the
/// forces of these springs and adds the true ones.
/// @source docs/theory/bolts.md, "Implicit steps"
class ImplicitBolts {
 public:
  ImplicitBolts(const Setup& setup, const ImplicitSystem& system) : setup_(&setup), system_(&system) {}

  void enter(const State& state);
  [[nodiscard]] bool any() const { return !bolts_.empty(); }
  /// Finds the rows at the start of a step, and appends their springs to `springs`.
  void begin(const State& state, std::span<const Vec2> driven_move, StepSprings& springs);
  /// Finds the forces at the unknowns d.   @return false: they are not finite
  bool evaluate(std::span<const double> d);
  /// Writes the tangents at these unknowns into the springs.   @return true if they have changed
  bool linearise(StepSprings& springs);
  /// out += forces of the bolts where they were evaluated last, less those of their springs in `springs` at d.
  /// @return the largest force on an unknown [N]
  double add(std::span<const double> d, const StepSprings& springs, std::span<double> out) const;

  /// Books an accepted step by the linear lengths that the equations use.
  /// @return elastic energy of all bolts, and dissipation in the step, by linear lengths [J]
  double book(std::span<const double> d, const StepSprings& springs, Ledger& ledger);
  /// Measures the bolts at the new positions, applies rupture, writes them into the state and books.
  /// @param linear  what book() returned
  void accept(State& state, double linear);

 private:
  struct One {
    One(BoltRows of, BoltResponse law) : rows(std::move(of)), response(std::move(law)) {}
    BoltRows rows;
    BoltShape shape;  // at the start of the step
    BoltResponse response;
    BoltMemory before, after;
    std::vector<double> lengths, shears;  // at the unknowns
    std::vector<double> slopes;           // that the tangent below belongs to
    Eigen::VectorXd values;               // of the tangent: eigenvalues [N/m], and eigenvectors
    Eigen::MatrixXd vectors;
    std::size_t first_row = 0;     // into rows_: segments, then crossings
    std::size_t first_spring = 0;  // of the step: combinations of segments, crossings, then across each segment
  };
  void add_point(const One& one, std::size_t row, const Vec2& c, std::span<const Vec2> driven_move, DofRows& out) const;
  /// The last row += eigenvector m of the segments.
  void combine(const One& one, std::size_t m, DofRows& out) const;

  const Setup* setup_;
  const ImplicitSystem* system_;
  std::vector<One> bolts_;
  std::vector<ChartRow> charts_;  // of the rows of the present bolt
  DofRows rows_, scratch_;
};

}  // namespace scree::coupling
