// Blocks that fall asleep and wake within a stage.
#include <fmt/format.h>

#include "coupling/stages/driver.h"
#include "coupling/stages/plan_warnings.h"

namespace scree::coupling {

void Driver::change_sleep(const Stage& stage) {
  const auto change = sleep_rules_->evaluate(state_, *integrator_, state_.time + largest_);
  if (!change) return;
  complete_ledger();
  // The new integrator goes on from velocities and accelerations as they are, but those that fall asleep stop.
  double kinetic = 0.0, momentum = 0.0;
  for (const std::size_t i : change->fell) {
    const Body& b = setup_->bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool);
    const BodyTotals totals = setup_->pool_of(b).totals(b.index, setup_->part(std::span<const double>(state_.q), p),
                                                        setup_->part(std::span<const double>(state_.v), p));
    kinetic += totals.kinetic;
    momentum += totals.momentum.norm();
    std::fill_n(state_.v.begin() + 2 * static_cast<std::ptrdiff_t>(b.first_node), 2 * b.nodes, 0.0);
  }
  stats_.asleep += static_cast<std::int64_t>(change->fell.size()) - static_cast<std::int64_t>(change->woke.size());
  stats_.sleep_momentum += momentum;
  committed_.asleep = stats_.asleep;
  committed_.sleep_momentum = stats_.sleep_momentum;
  state_.ledger.book(Column::falling_asleep, kinetic);
  state_.ledger.set(Column::kinetic, state_.ledger[Column::kinetic] - kinetic);
  const double springs = state_.ledger[Column::contact_springs], shadow = state_.ledger[Column::shadow];
  state_.contacts.forget_points();
  state_.factored = {};
  integrator_.reset();
  integrator_ = make_integrator(stage);
  const double now = integrator_->enter(state_);
  state_.ledger.set(Column::contact_springs, now);
  state_.ledger.book(Column::contact_edges, now - springs);
  complete_ledger();
  state_.ledger.book(Column::step_change, state_.ledger[Column::shadow] - shadow);
  count_awake_elements();
  audit_sleep(stage);
  const auto names = [&](const std::vector<std::size_t>& bodies) {
    std::vector<BlockId> blocks;
    blocks.reserve(bodies.size());
    for (const std::size_t b : bodies) blocks.push_back(setup_->bodies()[b].block);
    return named_blocks(*model_, blocks);
  };
  std::string text;
  if (!change->fell.empty())
    text = fmt::format("asleep: {} ({:.3g} J and {:.3g} N s are removed); ", names(change->fell), kinetic, momentum);
  if (!change->woke.empty()) text += fmt::format("awake: {} ({}); ", names(change->woke), change->cause);
  event(EventKind::sleep,
        fmt::format("stage '{}': {}{} of {} blocks are asleep", stage.name, text, stats_.asleep, stats_.blocks));
}

void Driver::count_awake_elements() {
  awake_elements_ = 0.0;
  for (const std::int32_t b : observer_->mesh().cell_block)
    awake_elements_ += state_.sleep.asleep(static_cast<std::size_t>(b)) ? 0.0 : 1.0;
}

void Driver::audit_sleep(const Stage& stage) {
  sleep_audit_ = plan_->audit && stats_.asleep > 0
                     ? std::make_unique<SleepAudit>(*setup_, *methods_, state_,
                                                    [&](const Setup& setup) { return make_plain(stage, setup); })
                     : nullptr;
}

}  // namespace scree::coupling
