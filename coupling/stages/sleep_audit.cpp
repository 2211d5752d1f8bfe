#include "coupling/stages/sleep_audit.h"

#include <fmt/format.h>

#include <algorithm>

namespace scree::coupling {
namespace {

// Of the tolerance: without velocities the forces of dashpots are missing, which held as much.
constexpr double kWithoutDashpots = 4.0;

Ghosts awake(const State& state) {
  Ghosts out;
  for (std::size_t i = 0; i < state.bodies.size(); ++i) out.asleep.push_back(state.sleep.asleep(i) ? 0 : 1);
  return out;
}

}  // namespace

SleepAudit::SleepAudit(const Setup& whole, const Methods& methods, const State& state, const Make& make)
    : setup_(whole.model(), methods, state.bodies, awake(state), whole.clocks()) {
  state_.bodies = state.bodies;
  state_.anchors = state.anchors;
  state_.support = state.support;
  state_.time = state.time;
  state_.step = state.step;
  state_.stage = state.stage;
  state_.bolts = state.bolts;
  state_.q.resize(state.q.size());
  state_.v.assign(state.q.size(), 0.0);
  for (std::size_t i = 0; i < setup_.bodies().size(); ++i) {
    const Body &from = whole.bodies()[i], &to = setup_.bodies()[i];
    std::copy_n(state.q.begin() + 2 * static_cast<std::ptrdiff_t>(from.first_node), 2 * from.nodes,
                state_.q.begin() + 2 * static_cast<std::ptrdiff_t>(to.first_node));
  }
  for (const ContactMemory& m : state.contacts)
    if (setup_.can_touch(static_cast<std::size_t>(m.key.block_p), static_cast<std::size_t>(m.key.block_e)))
      state_.contacts.memory.push_back(m);
  integrator_ = make(setup_);
  (void)integrator_->enter(state_);
  balance_ = std::make_unique<ForceBalance>(setup_, state_);
}

void SleepAudit::check(Tick time, double tolerance, Audit& audit) {
  state_.time = time;
  (void)balance_->measure(state_, *integrator_);
  for (std::size_t i = 0; i < setup_.bodies().size(); ++i) {
    const Body& b = setup_.bodies()[i];
    if (b.driven) continue;
    const double ratio = balance_->ratio_of(BodyIndex::of(i));
    audit.check(ratio, kWithoutDashpots * tolerance, [&] {
      return fmt::format("block '{}', which is asleep, has an unbalanced force of {:.3g} of the largest force on it",
                         setup_.model().blocks[b.block.index()].name, ratio);
    });
  }
}

}  // namespace scree::coupling
