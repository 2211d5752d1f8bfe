#include "coupling/stages/force_balance.h"

#include <algorithm>
#include <cmath>

#include "coupling/bolts/bolt_rows.h"

namespace scree::coupling {

constexpr double kNoStrain = 1e-9;  // stresses of a smaller strain count as none

ForceBalance::ForceBalance(const Setup& setup, const State& state)
    : setup_(&setup),
      loads_(load_vectors(setup, state)),
      release_(setup, state),
      supports_(point_springs(setup, state)) {
  lever_.assign(static_cast<std::size_t>(setup.nodes()), 0.0);
  for (auto* v : {&largest_of_, &least_of_, &ratio_}) v->assign(setup.bodies().size(), 0.0);
  for (std::size_t i = 0; i < setup.bodies().size(); ++i) {
    const Body& b = setup.bodies()[i];
    if (b.driven) continue;
    const double size = std::sqrt(state.bodies[i].shape.area);
    least_of_[i] = kNoStrain * setup.model().elasticity_of(b.block).p_modulus() * size;
    least_ = std::max(least_, least_of_[i]);
    const auto moves = setup.pool_of(b).translation(b.index);
    const auto first = static_cast<std::size_t>(b.first_node);
    for (std::size_t k = 0; k < static_cast<std::size_t>(b.nodes); ++k)
      lever_[first + k] = moves[k] != 0.0 ? 1.0 : size;
  }
}

void ForceBalance::take(std::vector<double>& term) {
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    setup_->pool(p).fold_forces(setup_->part(std::span<double>(term), p));
  for (std::size_t b = 0; b < setup_->bodies().size(); ++b) {
    const Body& body = setup_->bodies()[b];
    const auto first = 2 * static_cast<std::size_t>(body.first_node),
               end = first + 2 * static_cast<std::size_t>(body.nodes);
    double& largest = largest_of_[b];
    for (std::size_t i = first; i < end; ++i) {
      if (lever_[i / 2] == 0.0) continue;
      largest = std::max(largest, std::abs(term[i]) / lever_[i / 2]);
      total_[i] += term[i];
    }
    largest_ = std::max(largest_, largest);
  }
}

ForceBalance::Result ForceBalance::measure(const State& state, const TimeIntegrator& integrator) {
  const std::size_t n = state.q.size();
  total_.assign(n, 0.0);
  largest_ = 0.0;
  std::fill(largest_of_.begin(), largest_of_.end(), 0.0);
  const auto term = [&](auto&& fill) {
    term_.assign(n, 0.0);
    fill(term_);
    take(term_);
  };
  term([&](std::vector<double>& f) {
    for (std::size_t p = 0; p < setup_->pools(); ++p)
      setup_->pool(p).body_force(setup_->model().gravity, setup_->part(std::span<double>(f), p));
  });
  term([&](std::vector<double>& f) { add_loads(*setup_, loads_, seconds(state.time), f); });
  term([&](std::vector<double>& f) {
    for (std::size_t p = 0; p < setup_->pools(); ++p)
      (void)setup_->pool(p).internal_force(setup_->part(std::span<const double>(state.q), p),
                                           setup_->part(std::span<double>(f), p));
  });
  term([&](std::vector<double>& f) {
    for (const PointSpring& s : supports_) add_force(s.row, spring_force(s, state.q), f);
  });
  if (release_.acts()) term([&](std::vector<double>& f) { release_.add(seconds(state.time), f); });
  term([&](std::vector<double>& f) { integrator.contact_forces(state, f); });
  term([&](std::vector<double>& f) { add_bolt_forces(*setup_, state, f); });

  Result out;
  for (std::size_t i = 0; i < setup_->bodies().size(); ++i) {
    const Body& b = setup_->bodies()[i];
    const auto first = static_cast<std::size_t>(b.first_node), end = first + static_cast<std::size_t>(b.nodes);
    double force = 0.0;
    for (std::size_t k = first; k < end; ++k)
      if (lever_[k] != 0.0)
        force = std::max({force, std::abs(total_[2 * k]) / lever_[k], std::abs(total_[2 * k + 1]) / lever_[k]});
    ratio_[i] = 0.0;
    if (b.driven || state.sleep.asleep(i)) continue;
    ratio_[i] = force / std::max(largest_of_[i], least_of_[i]);
    if (force <= out.force) continue;
    out.force = force;
    out.body = BodyIndex::of(i);
  }
  out.ratio = out.force / std::max(largest_, least_);
  return out;
}

BlockId unsupported_block(const Setup& setup, const State& state) {
  std::vector<char> held(setup.bodies().size(), 0);
  for (std::size_t i = 0; i < held.size(); ++i) held[i] = setup.bodies()[i].driven ? 1 : 0;
  for (const PointSupport& s : setup.model().point_supports) held[s.block.index()] = 1;
  for (const EdgeSupport& s : setup.model().edge_supports) held[s.span.block.index()] = 1;
  std::vector<BoltRows> bolts = acting_bolts(setup, state);
  for (bool grew = true; grew;) {  // one pass per layer of blocks
    grew = false;
    for (const BoltRows& rows : bolts)
      for (std::size_t s = 0; s < rows.segments; ++s) {
        char &a = held[rows.body[s].index()], &b = held[rows.body[s + 1].index()];
        const BoltMemory& m = state.bolts[static_cast<std::size_t>(rows.bolt)];
        if (a == b || !(rows.liner ? m.broken[s] == 0 : m.force[s] > 0.0)) continue;
        a = b = 1;
        grew = true;
      }
    for (const ContactMemory& m : state.contacts) {
      if (m.status == ContactStatus::open) continue;
      char &a = held[static_cast<std::size_t>(m.key.block_p)], &b = held[static_cast<std::size_t>(m.key.block_e)];
      if (a == b) continue;
      a = b = 1;
      grew = true;
    }
  }
  for (std::size_t i = 0; i < held.size(); ++i)
    if (held[i] == 0) return setup.bodies()[i].block;
  return {};
}

}  // namespace scree::coupling
