#include "coupling/stages/end_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace scree::coupling {
namespace {

/// True once a condition has held for long enough.   @param since  when it began to hold, -1: it does not
bool has_held(bool holds, Tick hold, Tick now, Tick& since) {
  if (!holds) {
    since = -1;
    return false;
  }
  if (since < 0) since = now;
  return now - since >= hold;
}

RuleMemory::Slip slip_of(const ContactMemory& m) {
  return {std::min(m.key.block_p, m.key.block_e), std::max(m.key.block_p, m.key.block_e), m.slip};
}

bool by_blocks(const RuleMemory::Slip& x, const RuleMemory::Slip& y) {
  return std::pair(x.a, x.b) < std::pair(y.a, y.b);
}

/// Slip between two blocks when the stage began. It is stored per pair of blocks, because points between them appear
/// and disappear, and new ones take over the slip of their neighbours.
double slip_before(const RuleMemory& memory, const ContactMemory& m) {
  const RuleMemory::Slip s = slip_of(m);
  const auto found = std::lower_bound(memory.slips.begin(), memory.slips.end(), s, by_blocks);
  return found != memory.slips.end() && found->same_pair(s) ? found->slip : 0.0;
}

}  // namespace

void begin_rules(const EndRules& rules, State& state) {
  if (!(rules.slip > 0.0)) return;
  std::vector<RuleMemory::Slip>& slips = state.rules.slips;
  for (const ContactMemory& m : state.contacts)
    if (m.slip > 0.0) slips.push_back(slip_of(m));
  std::sort(slips.begin(), slips.end(), [](const auto& x, const auto& y) {
    return by_blocks(x, y) || (x.same_pair(y) && x.slip > y.slip);  // the largest first
  });
  slips.erase(std::unique(slips.begin(), slips.end(), [](const auto& x, const auto& y) { return x.same_pair(y); }),
              slips.end());
}

EndWatch::EndWatch(const EndRules& rules, const Setup& setup, const State& state) : rules_(&rules), setup_(&setup) {
  if (rules.force_below > 0.0) balance_ = std::make_unique<ForceBalance>(setup, state);
  if (!(rules.displacement > 0.0)) return;
  mass_.assign(2 * static_cast<std::size_t>(setup.nodes()), 0.0);
  for (std::size_t p = 0; p < setup.pools(); ++p)
    setup.pool(p).body_force({1.0, 1.0}, setup.part(std::span<double>(mass_), p));
}

std::optional<std::string> EndWatch::slow(State& state) const {
  double kinetic = 0.0;
  for (const std::size_t p : setup_->own_pools())
    kinetic += setup_->pool(p).kinetic_energy(setup_->part(std::span<const double>(state.q), p),
                                              setup_->part(std::span<const double>(state.v), p), setup_->counted(p));
  double& peak = state.rules.peak;
  peak = std::max(peak, kinetic);
  const bool below = peak > 0.0 && kinetic <= rules_->kinetic_below * peak;
  if (!has_held(below, rules_->hold, state.time, state.rules.slow_since)) return {};
  return fmt::format("the kinetic energy, {:.4g} J, is {:.3g} of its peak (kinetic_below = {:g})", kinetic,
                     kinetic / peak, rules_->kinetic_below);
}

std::optional<std::string> EndWatch::balanced(State& state, const TimeIntegrator& integrator) {
  const ForceBalance::Result found = balance_->measure(state, integrator);
  if (!has_held(found.ratio <= rules_->force_below, rules_->hold, state.time, state.rules.balanced_since)) return {};
  return fmt::format("no unbalanced force is above {:.3g} of the largest force (force_below = {:g})", found.ratio,
                     rules_->force_below);
}

std::optional<std::string> EndWatch::slipped(const State& state) const {
  const ContactMemory* most = nullptr;
  double farthest = 0.0;
  for (const ContactMemory& m : state.contacts) {
    const double slip = m.slip - slip_before(state.rules, m);
    if (slip <= farthest) continue;
    farthest = slip;
    most = &m;
  }
  if (most == nullptr || farthest < rules_->slip) return {};
  const auto block = [&](std::int32_t b) { return setup_->model().blocks[static_cast<std::size_t>(b)].name; };
  return fmt::format("joint '{}' between '{}' and '{}' has slipped {:.4g} m (slip = {:g})",
                     setup_->model().joints[static_cast<std::size_t>(most->joint)].name, block(most->key.block_p),
                     block(most->key.block_e), farthest, rules_->slip);
}

Vec2 EndWatch::centre(const Body& b, std::span<const double> q) const {
  Vec2 sum = Vec2::Zero(), mass = Vec2::Zero();
  const auto first = 2 * static_cast<std::size_t>(b.first_node), end = first + 2 * static_cast<std::size_t>(b.nodes);
  for (std::size_t i = first; i < end; i += 2) {
    const Vec2 m(mass_[i], mass_[i + 1]);
    sum += m.cwiseProduct(Vec2(q[i], q[i + 1]));
    mass += m;
  }
  return sum.cwiseQuotient(mass);
}

std::optional<std::string> EndWatch::moved(const State& state, std::span<const Vec2> begin) const {
  BlockId most;
  double farthest = 0.0;
  for (const Body& b : setup_->bodies()) {
    if (b.driven) continue;
    const double way = (centre(b, state.q) - begin[b.block.index()]).norm();
    if (way <= farthest) continue;
    farthest = way;
    most = b.block;
  }
  if (farthest < rules_->displacement) return {};
  return fmt::format("block '{}' has moved {:.4g} m (displacement = {:g})", setup_->model().blocks[most.index()].name,
                     farthest, rules_->displacement);
}

std::optional<std::string> EndWatch::evaluate(State& state, const TimeIntegrator& integrator,
                                              std::span<const Vec2> begin) {
  std::optional<std::string> why;
  const auto add = [&](std::optional<std::string> one) {
    if (one) why = why ? *why + ", and " + *one : std::move(one);
  };
  // Each rule is evaluated in any case, because the rules store data in the state.
  if (rules_->kinetic_below > 0.0) add(slow(state));
  if (rules_->force_below > 0.0) add(balanced(state, integrator));
  if (rules_->slip > 0.0) add(slipped(state));
  if (rules_->displacement > 0.0) add(moved(state, begin));
  return why;
}

}  // namespace scree::coupling
