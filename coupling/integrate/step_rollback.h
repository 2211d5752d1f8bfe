// Back to the beginning of a step that is made of several explicit ones.
#pragma once

#include <vector>

#include "coupling/integrate/central_difference.h"

namespace scree::coupling {

/// What explicit steps change in a state and its integrator, kept where the first of them begins.
class StepRollback {
 public:
  /// @param far  more than one step may be taken before going back
  void keep(const CentralDifference& integrator, const State& state, bool far) {
    integrator.mark(mark_, far);
    time_ = state.time;
    last_step_ = state.last_step;
    step_ = state.step;
    q_ = state.q;
    v_ = state.v;
    a_ = state.a;
    v_before_ = state.v_before;
    damping_ = state.damping;
    sliding_ = state.sliding;
    ledger_ = state.ledger;
  }
  void go(CentralDifference& integrator, State& state) const {
    state.time = time_;
    state.last_step = last_step_;
    state.step = step_;
    state.q = q_;
    state.v = v_;
    state.a = a_;
    state.v_before = v_before_;
    state.damping = damping_;
    state.sliding = sliding_;
    state.ledger = ledger_;
    integrator.go_back(state, mark_);
  }

 private:
  CentralDifference::Mark mark_;
  Tick time_ = 0, last_step_ = 0;
  std::int64_t step_ = 0;
  std::vector<double> q_, v_, a_, v_before_, damping_, sliding_;
  Ledger ledger_;
};

}  // namespace scree::coupling
