// Bolts in explicit steps.
#pragma once

#include <vector>

#include "coupling/bolts/bolt_response.h"
#include "coupling/bolts/bolt_rows.h"
#include "coupling/integrate/force_term.h"

namespace scree::coupling {

/// The forces at an instant follow from the positions there and from the memory of the bolts at the instant before.
/// What breaks at an instant bears no force from the next on. Forces on driven bodies are added too.
class BoltForces final : public ForceTerm {
 public:
  BoltForces(const Setup& setup, std::vector<BoltRows> rows);

  /// Takes over the memory of the bolts in a state, at its time.
  void take(const State& state);
  /// Writes the memory back into the state after a step.
  void keep(State& state) const;

  void add(const Instant& at, std::span<double> f) override;
  void leave(double h, std::span<const double> v) override { work_ = half_work(h, v); }
  void arrive(double h, std::span<const double> v, Ledger& ledger) override;

 private:
  struct One {
    BoltRows rows;
    BoltShape shape;
    BoltResponse response;
    BoltMemory now, trial;    // at time_; at the instant that add() was last called for
    std::vector<Vec2> force;  // on the rows
  };
  [[nodiscard]] double half_work(double h, std::span<const double> v) const;
  /// If something breaks, finds the energy that is lost with it at the present lengths.
  static void find_broken(One& one);

  std::vector<One> bolts_;
  double time_ = -1.0;     // of `now` [s]
  bool on_trial_ = false;  // forces are those of `trial`
  double trial_time_ = -1.0;
  double work_ = 0.0;
};

/// Stiffness of a bolt in the step bound: a spring between rows, or between one row and a fixed point.
struct BoltSpring {
  std::vector<Row> rows;
  std::vector<BodyIndex> body;
  double k = 0.0;  // [N/m]
};
/// For every bolt that this setup applies, the less stiff of two bounds of its elastic stiffness: the bond's springs
/// with the bar at rest, or the bar's segments without slip. Then its shear springs, and, with the bond's springs, its
/// tension across the segments.
[[nodiscard]] std::vector<BoltSpring> bolt_springs(const Setup& setup, const State& state);

}  // namespace scree::coupling
