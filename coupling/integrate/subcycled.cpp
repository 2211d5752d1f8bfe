#include "coupling/integrate/subcycled.h"

#include <algorithm>
#include <cmath>

namespace scree::coupling {

Subcycled::Subcycled(const Setup& setup, const StepControl& control, double detection, const Choice& choice)
    : choice_(choice), fine_(setup, control, detection, choice.damping) {}

double Subcycled::enter(State& state) {
  bound_ = 0.0;
  return fine_.enter(state);
}

void Subcycled::resume(State& state, const IntegratorMemory& memory) {
  fine_.resume(state, memory);
  bound_ = memory.step_bound;
}

IntegratorMemory Subcycled::lend() {
  IntegratorMemory out = fine_.lend();
  out.step_bound = bound_;
  return out;
}

void Subcycled::take_back(IntegratorMemory& memory) { fine_.take_back(memory); }

double Subcycled::stable_step(const State& state, std::string* binding) {
  bound_ = fine_.stable_step(state, binding);
  return bound_;
}

std::int64_t Subcycled::parts(Tick left) const {
  const std::int64_t wanted =
      choice_.substeps > 0
          ? std::max(1, choice_.substeps - substeps_)
          : static_cast<std::int64_t>(std::max(1.0, std::ceil(seconds(left) / (choice_.safety * bound_))));
  return std::min<std::int64_t>(wanted, left);
}

StepReport Subcycled::step(State& state, Tick ticks_of_step) {
  const double H = seconds(ticks_of_step);
  const std::int64_t first = state.step;
  rollback_.keep(fine_, state);
  fine_.watch(audit_);
  substeps_ = 0;
  std::int64_t parts_left = 0;
  for (Tick left = ticks_of_step; left > 0;) {
    // Contacts that close within H may require shorter substeps from then on.
    if (bound_ == 0.0 || !fine_.step_still_stable()) {
      (void)stable_step(state, nullptr);
      parts_left = 0;
    }
    if (parts_left == 0) parts_left = parts(left);
    const Tick ticks = left / parts_left;
    const double kick = H / seconds(ticks);
    if (left == ticks_of_step) fine_.weigh(state, kick);
    fine_.weigh_next(ticks == left ? kick : 0.0);
    StepReport report = fine_.step(state, ticks);
    if (report.status != StepReport::Status::ok) {
      rollback_.go(fine_, state);
      return report;
    }
    left -= ticks;
    --parts_left;
    ++substeps_;
  }
  state.step = first + 1;
  StepReport report;
  report.substeps = substeps_;
  return report;
}

}  // namespace scree::coupling
