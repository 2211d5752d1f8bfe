// Return to the start of a step that consists of several explicit ones.
#pragma once

#include <vector>

#include "coupling/integrate/central_difference.h"

namespace scree::coupling {

/// What explicit steps change in a state and its integrator, stored at the start of the first.
class StepRollback {
 public:
  void keep(const CentralDifference& integrator, const State& state) {
    integrator.mark(mark_);
    time_ = state.time;
    last_step_ = state.last_step;
    step_ = state.step;
    q_ = state.q;
    v_ = state.v;
    a_ = state.a;
    v_before_ = state.v_before;
    damping_ = state.damping;
    sliding_ = state.sliding;
    bolts_ = state.bolts;
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
    state.bolts = bolts_;
    state.ledger = ledger_;
    integrator.go_back(state, mark_);
  }

 private:
  CentralDifference::Mark mark_;
  Tick time_ = 0, last_step_ = 0;
  std::int64_t step_ = 0;
  std::vector<double> q_, v_, a_, v_before_, damping_, sliding_;
  std::vector<BoltMemory> bolts_;
  Ledger ledger_;
};

}  // namespace scree::coupling
