// Bolts in explicit steps.
#pragma once

#include <vector>

#include "coupling/bolts/bolt_response.h"
#include "coupling/bolts/bolt_rows.h"
#include "coupling/integrate/force_term.h"

namespace scree::coupling {

/// The forces at an instant follow from the positions there and from what the bolts remember of the instant before.
/// What breaks at an instant lets go at the next. Forces on driven bodies are added too.
class BoltForces final : public ForceTerm {
 public:
  BoltForces(const Setup& setup, std::vector<BoltRows> rows);

  /// Takes over what the bolts of a state remember, at its time.
  void take(const State& state);
  /// Puts it back, once a step is done.
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
  /// Where something breaks: the energy that goes with it at the present lengths.
  static void find_broken(One& one);

  std::vector<One> bolts_;
  double time_ = -1.0;     // of `now` [s]
  bool on_trial_ = false;  // forces are those of `trial`
  double trial_time_ = -1.0;
  double work_ = 0.0;
};

/// Stiffness of a bolt as the step bound sees it: a spring between rows, or of one row to something that stays.
struct BoltSpring {
  std::vector<Row> rows;
  std::vector<BodyIndex> body;
  double k = 0.0;  // [N/m]
};
/// For every bolt that this setup applies, the less stiff of two bounds of its elastic stiffness: the bond's springs
/// with the bar at rest, or the bar's segments without slip; its shear springs, and its tension across the segments.
[[nodiscard]] std::vector<BoltSpring> bolt_springs(const Setup& setup, const State& state);

}  // namespace scree::coupling
