#include "coupling/integrate/awake_side.h"

#include <algorithm>
#include <iterator>

#include "coupling/bolts/bolt_rows.h"
#include "coupling/contact/contact_energy.h"
#include "coupling/integrate/point_springs.h"

namespace scree::coupling {
namespace {

std::vector<char> flags(const State& state) {
  std::vector<char> out;
  for (std::size_t i = 0; i < state.bodies.size(); ++i) out.push_back(state.sleep.asleep(i) ? 1 : 0);
  return out;
}

Ghosts resting(std::vector<char> asleep) {
  Ghosts out;
  out.asleep = std::move(asleep);
  return out;
}

double support_energy(const Setup& setup, const State& state) {
  double sum = 0.0;
  for (const PointSpring& s : point_springs(setup, state)) sum += spring_energy(s, state.q);
  return sum;
}

}  // namespace

AwakeSide::AwakeSide(const Setup& whole, const Methods& methods, const State& state, const StrengthPlan& strength,
                     double factor, const Make& make)
    : whole_(&whole),
      asleep_(flags(state)),
      setup_(whole.model(), methods, state.bodies, resting(asleep_), whole.clocks()) {
  if (strength.used()) setup_.divide_strength(strength, factor);
  side_.bodies = state.bodies;
  side_.anchors = state.anchors;
  side_.support = state.support;
  integrator_ = make(setup_);
  find_runs();
}

void AwakeSide::find_runs() {
  const auto add = [](std::vector<Run>& runs, const Run& r) {
    if (!runs.empty() && runs.back().whole + runs.back().count == r.whole &&
        runs.back().side + runs.back().count == r.side)
      runs.back().count += r.count;
    else
      runs.push_back(r);
  };
  for (std::size_t b = 0; b < whole_->bodies().size(); ++b) {
    const Body &w = whole_->bodies()[b], &s = setup_.bodies()[b];
    const Run run{2 * static_cast<std::size_t>(w.first_node), 2 * static_cast<std::size_t>(s.first_node),
                  2 * static_cast<std::size_t>(w.nodes)};
    add(all_, run);
    if (!s.resting) add(moving_, run);
  }
}

bool AwakeSide::is_awake(const ContactMemory& m) const {
  return asleep_[static_cast<std::size_t>(m.key.block_p)] == 0 && asleep_[static_cast<std::size_t>(m.key.block_e)] == 0;
}

void AwakeSide::split(const State& state) {
  side_.time = state.time;
  side_.step = state.step;
  side_.stage = state.stage;
  side_.last_step = state.last_step;
  side_.bolts = state.bolts;
  for (auto numbers : {&State::q, &State::v, &State::a, &State::v_before, &State::damping, &State::sliding}) {
    const std::vector<double>& from = state.*numbers;
    std::vector<double>& to = side_.*numbers;
    to.assign(from.size(), 0.0);
    if (from.empty()) continue;
    for (const Run& r : numbers == &State::q ? all_ : moving_)
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(r.whole), r.count,
                  to.begin() + static_cast<std::ptrdiff_t>(r.side));
  }
  parked_.clear();
  side_.contacts.clear();
  for (const ContactMemory& m : state.contacts) (is_awake(m) ? side_.contacts.memory : parked_).push_back(m);
  place_.clear();
  bolts_.clear();
  held_ = {};
  for (std::size_t i = 0; i < asleep_.size(); ++i) {
    if (asleep_[i] == 0) continue;
    const Body& b = whole_->bodies()[i];
    const auto p = static_cast<std::size_t>(b.pool);
    held(Column::elastic) += whole_->pool_of(b)
                                 .totals(b.index, whole_->part(std::span<const double>(state.q), p),
                                         whole_->part(std::span<const double>(state.v), p))
                                 .elastic;
  }
  for (const ContactMemory& m : parked_) held(Column::contact_springs) += closed_energy(m);
  held(Column::support_springs) = support_energy(*whole_, state) - support_energy(setup_, side_);
  for (const BoltMemory& m : state.bolts) held(Column::bolts) += m.energy;
  for (const BoltRows& rows : acting_bolts(setup_, side_)) {
    bolts_.push_back(static_cast<std::size_t>(rows.bolt));
    held(Column::bolts) -= state.bolts[bolts_.back()].energy;
  }
  opened_ = false;
}

void AwakeSide::open(const State& state) {
  if (!opened_) side_.ledger = state.ledger.with_resting(held_, -1.0);
}

double AwakeSide::enter(State& state) {
  split(state);
  return integrator_->enter(side_) + held(Column::contact_springs);
}

void AwakeSide::resume(State& state, const IntegratorMemory& memory) {
  split(state);
  side_.contacts.points = memory.sides[0].points;
  std::swap(side_.factored, state.factored);
  integrator_->resume(side_, memory.sides[0]);
  std::swap(side_.factored, state.factored);
  opened_ = !memory.ledgers.empty();
  if (opened_) side_.ledger = memory.ledgers[0];
}

IntegratorMemory AwakeSide::lend() {
  IntegratorMemory out;
  out.sides.push_back(integrator_->lend());
  out.sides[0].points.swap(side_.contacts.points);
  if (opened_) out.ledgers = {side_.ledger};
  return out;
}

void AwakeSide::take_back(IntegratorMemory& memory) {
  integrator_->take_back(memory.sides[0]);
  memory.sides[0].points.swap(side_.contacts.points);
}

void AwakeSide::join_contacts(ContactList& contacts) {
  const std::vector<ContactMemory>& mine = side_.contacts.memory;
  bool same = place_.size() == mine.size() && contacts.size() == mine.size() + parked_.size();
  for (std::size_t i = 0; same && i < mine.size(); ++i) same = contacts[place_[i]].key == mine[i].key;
  if (same) {  // as after most steps
    for (std::size_t i = 0; i < mine.size(); ++i) contacts[place_[i]] = mine[i];
    return;
  }
  contacts.clear();
  std::merge(mine.begin(), mine.end(), parked_.begin(), parked_.end(), std::back_inserter(contacts.memory),
             [](const ContactMemory& a, const ContactMemory& b) { return a.key < b.key; });
  place_.clear();
  for (std::size_t i = 0; i < contacts.size(); ++i)
    if (is_awake(contacts[i])) place_.push_back(i);
}

void AwakeSide::join_ledger(State& state) {
  side_.ledger.pass(state.ledger);
  state.ledger = side_.ledger.with_resting(held_, 1.0);
}

void AwakeSide::join(State& state) {
  for (auto numbers : {&State::q, &State::v, &State::a, &State::v_before, &State::damping, &State::sliding}) {
    const std::vector<double>& from = side_.*numbers;
    std::vector<double>& to = state.*numbers;
    if (to.size() != from.size()) to.assign(from.size(), 0.0);
    if (from.empty()) continue;
    for (const Run& r : moving_)
      std::copy_n(from.begin() + static_cast<std::ptrdiff_t>(r.side), r.count,
                  to.begin() + static_cast<std::ptrdiff_t>(r.whole));
  }
  state.time = side_.time;
  state.step = side_.step;
  state.last_step = side_.last_step;
  join_contacts(state.contacts);
  for (const std::size_t b : bolts_) state.bolts[b] = side_.bolts[b];
  join_ledger(state);
}

StepReport AwakeSide::step(State& state, Tick ticks_of_step) {
  open(state);
  opened_ = true;
  if (audit_ != nullptr) integrator_->watch(audit_);
  std::swap(side_.factored, state.factored);
  StepReport report = integrator_->step(side_, ticks_of_step);
  std::swap(side_.factored, state.factored);
  if (report.status == StepReport::Status::ok) join(state);
  return report;
}

void AwakeSide::update_ledger(State& state) {
  open(state);
  integrator_->update_ledger(side_);
  join_ledger(state);
}

void AwakeSide::leave(State& state) {
  open(state);
  opened_ = true;
  integrator_->leave(side_);
  join(state);
  state.factored = {};
}

void AwakeSide::contact_forces(const State&, std::span<double> f) const {
  std::vector<double> own(side_.q.size(), 0.0);
  integrator_->contact_forces(side_, own);
  for (const Run& r : all_)
    for (std::size_t k = 0; k < r.count; ++k) f[r.whole + k] += own[r.side + k];
}

}  // namespace scree::coupling
