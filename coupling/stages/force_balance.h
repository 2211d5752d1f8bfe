// Whether the model is at rest: unbalanced forces, and the support of each block.
#pragma once

#include <vector>

#include "coupling/integrate/load_vectors.h"
#include "coupling/integrate/point_springs.h"
#include "coupling/integrate/support_release.h"
#include "coupling/integrate/time_integrator.h"

namespace scree::coupling {

/// The largest unbalanced force on an unknown of a free body, relative to the largest single force: weight, loads,
/// internal stress, supports, contacts; at least the force of a strain of 1e-9, so that a model which becomes free of
/// stress is at rest. Bodies that are asleep are balanced within their own tolerance, and left out. Moments are divided
/// by the root area of their block. Constant during a stage.
class ForceBalance {
 public:
  struct Result {
    double ratio = 0.0;  // unbalanced over the largest single force
    double force = 0.0;  // unbalanced [N]
    BodyIndex body;      // with the largest unbalanced force
  };
  ForceBalance(const Setup& setup, const State& state);
  [[nodiscard]] Result measure(const State& state, const TimeIntegrator& integrator);
  /// Of one body in the last measure(), 0 for a driven one: its unbalanced force over the largest single force on it.
  [[nodiscard]] double ratio_of(BodyIndex body) const { return ratio_[body.index()]; }

 private:
  void take(std::vector<double>& term);

  const Setup* setup_;
  std::vector<LoadVector> loads_;
  SupportRelease release_;
  std::vector<PointSpring> supports_;
  std::vector<double> lever_;  // per node: divisor of its force, 0 for driven bodies
  std::vector<double> term_, total_;
  std::vector<double> largest_of_, least_of_, ratio_;  // per body [N], [N], [-]
  double largest_ = 0.0, least_ = 0.0;                 // [N]
};

/// First block without a path of closed contacts to a held block, or to one with a point support; invalid: every block
/// has such a path.
[[nodiscard]] BlockId unsupported_block(const Setup& setup, const State& state);

}  // namespace scree::coupling
