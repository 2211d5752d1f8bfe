#include "coupling/integrate/partitioned.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "model/dense_algebra.h"

namespace scree::coupling {
Ghosts Partitioned::ghosts(const Setup& whole, const State& state, bool is_explicit, bool shared) {
  Ghosts out;
  out.touch = is_explicit;
  out.shared = shared;
  for (std::size_t i = 0; i < whole.bodies().size(); ++i)
    out.ghost.push_back(state.explicit_side[i] == kDivided || (state.explicit_side[i] != 0) == is_explicit ? 0 : 1);
  return out;
}

std::vector<BodyRecord> Partitioned::records(const State& state, bool is_explicit) {
  std::vector<BodyRecord> out = state.bodies;
  for (BodyRecord& r : out)
    if (r.form.division.divides())
      r.form.division.acts = is_explicit ? Division::Acts::explicit_half : Division::Acts::implicit_half;
  return out;
}

Partitioned::Side::Side(const Setup& whole, const Methods& methods, const State& state_of_all, bool is_explicit,
                        bool shared)
    : setup(whole.model(), methods, records(state_of_all, is_explicit),
            ghosts(whole, state_of_all, is_explicit, shared), whole.clocks(), &whole) {
  state.bodies = state_of_all.bodies;
  state.anchors = state_of_all.anchors;
  state.support = state_of_all.support;
}

Partitioned::Partitioned(const Setup& whole, const Methods& methods, const State& state, const StepControl& control,
                         double detection, const Choice& choice)
    : whole_(&whole),
      choice_(choice),
      explicit_side_(whole, methods, state, true, choice.shared_contacts),
      implicit_side_(whole, methods, state, false, choice.shared_contacts),
      explicit_(std::make_unique<CentralDifference>(explicit_side_.setup, control, detection, choice.explicit_damping)),
      implicit_(std::make_unique<Newmark>(implicit_side_.setup, control, detection, choice.implicit)) {
  find_runs();
  implicit_->set_interface(this);
  implicit_->also_touch(&explicit_side_.setup.outlines(), &explicit_side_.state.contacts);
  const Setup& setup = explicit_side_.setup;
  for (const OutlineNode i : setup.outlines().nodes.indices()) {
    const Row& row = setup.outlines().nodes[i];
    const Body& b = setup.body(setup.outlines().node_body[i]);
    is_ghost_.push_back(setup.on_ghost(row) ? 1 : 0);
    compliance_.push_back(is_ghost_[i] != 0 ? setup.pool_of(b).compliance(b.index, setup.local(b, row)) : 0.0);
  }
}

void Partitioned::find_runs() {
  const auto add = [](std::vector<Run>& runs, const Run& r) {
    if (!runs.empty() && runs.back().whole + runs.back().count == r.whole &&
        runs.back().of_explicit + runs.back().count == r.of_explicit &&
        runs.back().of_implicit + runs.back().count == r.of_implicit)
      runs.back().count += r.count;
    else
      runs.push_back(r);
  };
  for (std::size_t b = 0; b < whole_->bodies().size(); ++b) {
    const Body &w = whole_->bodies()[b], &e = explicit_side_.setup.bodies()[b], &i = implicit_side_.setup.bodies()[b];
    for (std::int32_t k = 0; k < w.nodes; ++k) {
      const Run run{2 * static_cast<std::size_t>(w.first_node + k), 2 * static_cast<std::size_t>(e.first_node + k),
                    2 * static_cast<std::size_t>(i.first_node + k), 2};
      add(all_, run);
      if (explicit_side_.setup.kind(e.first_node + k) == Setup::NodeKind::free) add(explicit_runs_, run);
      if (implicit_side_.setup.kind(i.first_node + k) == Setup::NodeKind::free) add(implicit_runs_, run);
    }
  }
}

void Partitioned::find_interface_constraints(const IntegratorMemory* memory) {
  interface_constraints_.clear();
  explicit_at_.clear();
  implicit_at_.clear();
  std::vector<std::int32_t> nodes;
  for (std::size_t b = 0; b < whole_->bodies().size(); ++b) {
    const Body &w = whole_->bodies()[b], &e = explicit_side_.setup.bodies()[b], &i = implicit_side_.setup.bodies()[b];
    const std::int32_t first = whole_->pool_of(w).first_node(w.index);
    for (const Pool::InterfaceConstraint& s : whole_->pool_of(w).interface_constraints(w.index)) {
      const std::int32_t of_explicit = e.first_node + s.explicit_node - first,
                         of_implicit = i.first_node + s.implicit_node - first;
      const auto row = [](std::int32_t node) { return Row{{node, node, node}, {1.0, 0.0, 0.0}}; };
      interface_constraints_.push_back({BodyIndex::of(b), row(of_implicit)});
      nodes.push_back(of_explicit);
      explicit_at_.push_back(2 * static_cast<std::size_t>(of_explicit));
      implicit_at_.push_back(2 * static_cast<std::size_t>(of_implicit));
    }
  }
  held_.assign(2 * interface_constraints_.size(), 0.0);
  held_back_ = held_;
  if (!nodes.empty()) explicit_->hold_nodes(std::move(nodes));
  find_constraint_mass();
  if (memory != nullptr) {
    apart_ = memory->apart;
    for (std::size_t k = 0; k < held_.size(); ++k) held_[k] = -memory->sides[0].held[k];
    return;
  }
  apart_.clear();
  for (std::size_t k = 0; k < 2 * interface_constraints_.size(); ++k)
    apart_.push_back(implicit_side_.state.q[implicit_at_[k / 2] + k % 2] -
                     explicit_side_.state.q[explicit_at_[k / 2] + k % 2]);
}

void Partitioned::find_constraint_mass() {
  // Inverse of the matrix of accelerations of each node by a unit force on each.
  const auto n = static_cast<Eigen::Index>(interface_constraints_.size());
  const Setup& setup = explicit_side_.setup;
  Eigen::MatrixXd compliance(n, n);
  std::vector<double> force(explicit_side_.state.q.size(), 0.0), a = force;
  for (Eigen::Index j = 0; j < n; ++j) {
    const std::size_t at = explicit_at_[static_cast<std::size_t>(j)];
    force[at] = 1.0;
    for (const std::size_t p : setup.own_pools())
      setup.pool(p).mass_solve(setup.part(std::span<const double>(explicit_side_.state.q), p),
                               setup.part(std::span<const double>(force), p), setup.part(std::span<double>(a), p));
    force[at] = 0.0;
    for (Eigen::Index i = 0; i < n; ++i) compliance(i, j) = a[explicit_at_[static_cast<std::size_t>(i)]];
  }
  // Covers that follow the same others have no relative mass of their own: a larger diagonal keeps it definite.
  compliance = 0.5 * (compliance + compliance.transpose()).eval();
  compliance.diagonal() *= 1.0 + 1e-6;
  const Eigen::MatrixXd mass = solve_positive(compliance, Eigen::MatrixXd::Identity(n, n)),
                        factor = cholesky_factor(mass);
  constraint_mass_.assign(factor.data(), factor.data() + factor.size());
  constraint_factor_ = constraint_mass_;
}

void Partitioned::copy(std::span<const Run> runs, std::size_t Run::*from, std::span<const double> all,
                       std::size_t Run::*to, std::span<double> out) {
  for (const Run& r : runs)
    std::copy_n(all.begin() + static_cast<std::ptrdiff_t>(r.*from), r.count,
                out.begin() + static_cast<std::ptrdiff_t>(r.*to));
}

void Partitioned::take(std::span<const double> all, std::size_t Run::*to, std::vector<double>& out) const {
  out.assign(all.size(), 0.0);
  if (!all.empty()) copy(all_, &Run::whole, all, to, out);
}

void Partitioned::split(const State& state) {
  for (Side* side : {&explicit_side_, &implicit_side_}) {
    State& s = side->state;
    s.time = state.time;
    s.step = state.step;
    s.stage = state.stage;
    s.last_step = state.last_step;
    s.contacts.memory = state.contacts.memory;
    s.bolts = state.bolts;
    const auto to = side == &explicit_side_ ? &Run::of_explicit : &Run::of_implicit;
    take(state.q, to, s.q);
    take(state.v, to, s.v);
  }
  take(state.a, &Run::of_explicit, explicit_side_.state.a);
  take(state.a, &Run::of_implicit, implicit_side_.state.a);
  take(state.v_before, &Run::of_explicit, explicit_side_.state.v_before);
  take(state.damping, &Run::of_explicit, explicit_side_.state.damping);
  take(state.sliding, &Run::of_explicit, explicit_side_.state.sliding);
  implicit_side_.state.factored = state.factored;
  for (auto [side, bolts] :
       {std::pair(&explicit_side_, &explicit_bolts_), std::pair(&implicit_side_, &implicit_bolts_)}) {
    bolts->clear();
    for (const BoltRows& rows : acting_bolts(side->setup, side->state))
      bolts->push_back(static_cast<std::size_t>(rows.bolt));
  }
}

void Partitioned::open_ledgers() {
  for (Side* side : {&explicit_side_, &implicit_side_}) {
    const Setup& setup = side->setup;
    State& s = side->state;
    double kinetic = 0.0, elastic = 0.0, supports = 0.0;
    std::vector<double> force(s.q.size(), 0.0);
    for (const std::size_t p : setup.own_pools()) {
      kinetic += setup.pool(p).kinetic_energy(setup.part(std::span<const double>(s.q), p),
                                              setup.part(std::span<const double>(s.v), p), setup.counted(p));
      elastic += setup.pool(p).internal_force(setup.part(std::span<const double>(s.q), p),
                                              setup.part(std::span<double>(force), p));
    }
    for (const PointSpring& spring : point_springs(setup, s)) supports += spring_energy(spring, s.q);
    const ContactList& list = side == &explicit_side_ ? explicit_->contacts() : implicit_->list();
    double bolts = 0.0;
    for (const BoltRows& rows : acting_bolts(setup, s)) bolts += s.bolts[static_cast<std::size_t>(rows.bolt)].energy;
    s.ledger.open(std::array{kinetic, elastic, contact_energy(list), supports, bolts});
  }
}

double Partitioned::enter(State& state) {
  split(state);
  find_interface_constraints(nullptr);
  const double energy = explicit_->enter(explicit_side_.state) + implicit_->enter(implicit_side_.state);
  open_ledgers();
  has_base_ = false;
  bound_ = 0.0;
  const Ledger before = state.ledger;
  join(state);
  state.ledger = before;  // the caller books what has changed
  return energy;
}

void Partitioned::resume(State& state, const IntegratorMemory& memory) {
  split(state);
  find_interface_constraints(&memory);
  explicit_side_.state.contacts.clear();
  implicit_side_.state.contacts.clear();
  for (const ContactMemory& m : state.contacts) {
    const auto is_explicit = [&](std::int32_t block) {
      return state.explicit_side[static_cast<std::size_t>(block)] != 0;
    };
    (choice_.shared_contacts || is_explicit(m.key.block_p) || is_explicit(m.key.block_e) ? explicit_side_
                                                                                         : implicit_side_)
        .state.contacts.memory.push_back(m);
  }
  explicit_side_.state.contacts.points = memory.sides[0].points;
  implicit_side_.state.contacts.points = memory.sides[1].points;
  explicit_->resume(explicit_side_.state, memory.sides[0]);
  implicit_->resume(implicit_side_.state, memory.sides[1]);
  explicit_side_.state.ledger = memory.ledgers[0];
  implicit_side_.state.ledger = memory.ledgers[1];
  base_ = memory.ledgers[2];
  has_base_ = true;
  bound_ = memory.step_bound;
  springs_ = memory.springs;
}

IntegratorMemory Partitioned::lend() {
  IntegratorMemory out;
  out.sides.resize(2);
  out.ledgers = {explicit_side_.state.ledger, implicit_side_.state.ledger, base_};
  out.step_bound = bound_;
  out.apart = apart_;
  out.springs = springs_;
  out.sides[0] = explicit_->lend();
  out.sides[1] = implicit_->lend();
  out.sides[0].points.swap(explicit_side_.state.contacts.points);
  out.sides[1].points.swap(implicit_side_.state.contacts.points);
  return out;
}

void Partitioned::take_back(IntegratorMemory& memory) {
  explicit_->take_back(memory.sides[0]);
  implicit_->take_back(memory.sides[1]);
  memory.sides[0].points.swap(explicit_side_.state.contacts.points);
  memory.sides[1].points.swap(implicit_side_.state.contacts.points);
}

void Partitioned::join(State& state) {
  const State &e = explicit_side_.state, &i = implicit_side_.state;
  copy(explicit_runs_, &Run::of_explicit, e.q, &Run::whole, state.q);
  copy(explicit_runs_, &Run::of_explicit, e.v, &Run::whole, state.v);
  copy(implicit_runs_, &Run::of_implicit, i.q, &Run::whole, state.q);
  copy(implicit_runs_, &Run::of_implicit, i.v, &Run::whole, state.v);
  const auto of_explicit = [&](const std::vector<double>& numbers, std::vector<double>& out) {
    out.assign(numbers.empty() ? 0 : state.q.size(), 0.0);
    if (!numbers.empty()) copy(explicit_runs_, &Run::of_explicit, numbers, &Run::whole, out);
  };
  of_explicit(e.a, state.a);
  if (!i.a.empty()) copy(implicit_runs_, &Run::of_implicit, i.a, &Run::whole, state.a);
  of_explicit(e.v_before, state.v_before);
  of_explicit(e.damping, state.damping);
  of_explicit(e.sliding, state.sliding);
  state.time = e.time;
  state.last_step = e.last_step;
  state.contacts.clear();
  std::merge(e.contacts.begin(), e.contacts.end(), i.contacts.begin(), i.contacts.end(),
             std::back_inserter(state.contacts.memory),
             [](const ContactMemory& a, const ContactMemory& b) { return a.key < b.key; });
  for (const std::size_t b : explicit_bolts_) state.bolts[b] = e.bolts[b];
  for (const std::size_t b : implicit_bolts_) state.bolts[b] = i.bolts[b];
  whole_->prescribe(seconds(state.time), state.q, state.v);
  base_.pass(state.ledger);
  state.ledger = Ledger::joined(base_, e.ledger, i.ledger);
}

void Partitioned::find_springs(bool keep) {
  // Springs of closed contacts with an implicit body. They stretch linearly to the displacement u, so that the
  // mean over the step has half of it; their dashpots have the constant rate u/H.
  if (!keep) springs_.clear();
  stiffness_ = largest_stiffness_ = 0.0;
  const double H = seconds(step_);
  double turns_back = 0.0;  // times H^2/2 it bounds the ratio of successive changes of u in the iteration
  const ContactList& list = explicit_->contacts();
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    if (m.status == ContactStatus::open) continue;
    if ((is_ghost_[p.node[0]] | is_ghost_[p.node[1]] | is_ghost_[p.node[2]]) == 0) continue;
    const auto add = [&](const ContactRow& row, double k, double c) {
      Spring s;
      s.k = 0.5 * k + c / H;
      stiffness_ += s.k;
      largest_stiffness_ = std::max(largest_stiffness_, s.k);
      if (keep) return;
      for (std::size_t n = 0; n < 3; ++n) {
        if (is_ghost_[p.node[n]] == 0) continue;
        s.node[s.count] = p.node[n];
        s.direction[s.count++] = row[n];
        turns_back += s.k * compliance_[p.node[n]];
      }
      springs_.push_back(s);
    };
    add(gap_row(p.at), m.kn, p.cn);
    if (m.status == ContactStatus::stick) add(stretch_row(p.at, m.anchor), m.kt, p.ct);
  }
  // Short steps: bodies hardly respond, and iterations without the springs converge as fast.
  constexpr double kHardly = 1e-3;
  if (!keep && interface_constraints_.empty() && 0.5 * H * H * turns_back < kHardly) springs_.clear();
}

void Partitioned::rewind() {
  rollback_.go(*explicit_, explicit_side_.state);
  gone_ = false;
}

void Partitioned::add_to_ghosts(double weight, std::span<const double> f) {
  for (const Run& r : implicit_runs_)
    for (std::size_t k = r.of_explicit; k < r.of_explicit + r.count; ++k) sum_[k] += weight * f[k];
}

bool Partitioned::foresee(std::span<const double> end, std::span<double> force) {
  // In a single substep the positions of explicit bodies do not depend on the ghosts; with several substeps they do.
  if (substeps_ > 1 || !interface_constraints_.empty()) return false;
  if (gone_) rewind();
  copy(implicit_runs_, &Run::of_implicit, end, &Run::of_explicit, end_);
  ahead_.assign(end_.size(), 0.0);
  explicit_->foresee(explicit_side_.state, end_, step_, std::exchange(foreseen_, true), ahead_);
  std::fill(sum_.begin(), sum_.end(), 0.0);
  add_to_ghosts(0.5, explicit_->forces());
  add_to_ghosts(0.5, ahead_);
  copy(implicit_runs_, &Run::of_explicit, sum_, &Run::of_implicit, force);
  return true;
}

StepReport Partitioned::mean(std::span<const double> end, std::span<const double> held, std::span<double> force,
                             std::span<double> apart) {
  State& s = explicit_side_.state;
  if (gone_) rewind();
  gone_ = true;
  ++repeats_;
  copy(implicit_runs_, &Run::of_implicit, end, &Run::of_explicit, end_);
  explicit_->lead_ghosts(s, end_, s.time + step_);
  if (!interface_constraints_.empty()) {
    for (std::size_t k = 0; k < held.size(); ++k) {
      held_[k] = held[k];
      held_back_[k] = -held[k];
    }
    explicit_->hold(s, held_back_);
  }
  std::fill(sum_.begin(), sum_.end(), 0.0);
  const double H = seconds(step_);
  Tick left = step_;
  for (std::int32_t j = 0; j < substeps_; ++j) {
    const Tick ticks = left / (substeps_ - j);
    const double weight = 0.5 * seconds(ticks) / H;
    add_to_ghosts(weight, explicit_->forces());
    StepReport report = explicit_->step(s, ticks);
    if (report.status != StepReport::Status::ok) {
      gone_ = substeps_ > 1 || !interface_constraints_.empty();  // a failed step leaves its state unchanged
      return report;
    }
    add_to_ghosts(weight, explicit_->forces());
    left -= ticks;
  }
  copy(implicit_runs_, &Run::of_explicit, sum_, &Run::of_implicit, force);
  for (std::size_t k = 0; k < apart.size(); ++k)
    apart[k] = end[implicit_at_[k / 2] + k % 2] - s.q[explicit_at_[k / 2] + k % 2] - apart_[k];
  return {};
}

StepReport Partitioned::step(State& state, Tick ticks_of_step) {
  if (!has_base_) {
    base_ = state.ledger;
    has_base_ = true;
  }
  State &e = explicit_side_.state, &i = implicit_side_.state;
  if (bound_ == 0.0 || !explicit_->step_still_stable()) bound_ = explicit_->stable_step(e, nullptr);
  const double H = seconds(ticks_of_step);
  substeps_ = choice_.substeps > 0 ? choice_.substeps
                                   : static_cast<std::int32_t>(std::max(1.0, std::ceil(H / (choice_.safety * bound_))));
  substeps_ = static_cast<std::int32_t>(std::min<Tick>(substeps_, ticks_of_step));
  step_ = ticks_of_step;
  repeats_ = 0;
  gone_ = foreseen_ = false;
  rollback_.keep(*explicit_, e);
  end_ = e.q;
  sum_.assign(e.q.size(), 0.0);
  copy(explicit_runs_, &Run::of_explicit, e.q, &Run::of_implicit, i.q);
  present_.assign(i.q.size(), 0.0);
  copy(implicit_runs_, &Run::of_explicit, explicit_->forces(), &Run::of_implicit, present_);
  const bool keeps = implicit_->keeps_tangent(ticks_of_step);
  find_springs(keeps);
  // By their own mass nodes move by H^2/2 per unit of acceleration; the part that waves have reached by then is slower.
  const double scale = std::sqrt(2.0 * substeps_) / H;
  for (std::size_t k = 0; k < constraint_mass_.size(); ++k) constraint_factor_[k] = scale * constraint_mass_[k];
  if (audit_ != nullptr) implicit_->watch(audit_);
  StepReport report = implicit_->step(i, ticks_of_step);
  if (keeps && report.status != StepReport::Status::ok && report.status != StepReport::Status::given_up) {
    // The tangent of an earlier step may be too far from this one's.
    if (gone_) rewind();
    const std::vector<Spring> of_tangent = springs_;
    find_springs(false);
    implicit_->renew();
    const StepReport first = report;
    report = implicit_->step(i, ticks_of_step);
    report.add_work(first);
    if (report.status != StepReport::Status::ok) springs_ = of_tangent;
  }
  report.explicit_steps = static_cast<std::int64_t>(repeats_) * substeps_;
  if (report.status != StepReport::Status::ok) {
    if (gone_) rewind();
    return report;
  }
  if (audit_ != nullptr) explicit_->check(e, *audit_);
  // Ghosts take position and velocity from their own side.
  copy(implicit_runs_, &Run::of_implicit, i.q, &Run::of_explicit, e.q);
  copy(implicit_runs_, &Run::of_implicit, i.v, &Run::of_explicit, e.v);
  join(state);
  state.factored = i.factored;
  ++state.step;
  return report;
}

void Partitioned::update_ledger(State& state) {
  if (!has_base_) {
    base_ = state.ledger;
    has_base_ = true;
  }
  explicit_->update_ledger(explicit_side_.state);
  implicit_->update_ledger(implicit_side_.state);
  base_.pass(state.ledger);
  state.ledger = Ledger::joined(base_, explicit_side_.state.ledger, implicit_side_.state.ledger);
}

void Partitioned::leave(State& state) {
  update_ledger(state);
  explicit_->leave(explicit_side_.state);
  implicit_->leave(implicit_side_.state);
  join(state);
  state.last_step = 0;
  state.factored = {};
}

double Partitioned::stable_step(const State&, std::string* binding) {
  bound_ = explicit_->stable_step(explicit_side_.state, binding);
  return bound_;
}

void Partitioned::contact_forces(const State&, std::span<double> f) const {
  for (const Side* side : {&explicit_side_, &implicit_side_}) {
    std::vector<double> own(side->state.q.size(), 0.0);
    if (side == &explicit_side_)
      explicit_->contact_forces(side->state, own);
    else
      implicit_->contact_forces(side->state, own);
    const auto from = side == &explicit_side_ ? &Run::of_explicit : &Run::of_implicit;
    for (const Run& r : all_)
      for (std::size_t k = 0; k < r.count; ++k) f[r.whole + k] += own[r.*from + k];
  }
}

}  // namespace scree::coupling
