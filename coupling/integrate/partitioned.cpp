#include "coupling/integrate/partitioned.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace scree::coupling {
namespace {

void copy_numbers(const Body& from, std::span<const double> all, const Body& to, std::span<double> out) {
  const auto a = 2 * static_cast<std::ptrdiff_t>(from.first_node), b = 2 * static_cast<std::ptrdiff_t>(to.first_node);
  std::copy_n(all.begin() + a, 2 * from.nodes, out.begin() + b);
}

}  // namespace

Guests Partitioned::guests(const Setup& whole, const State& state, bool is_explicit) {
  Guests out;
  out.touch = is_explicit;
  for (std::size_t i = 0; i < whole.bodies().size(); ++i)
    out.guest.push_back((state.explicit_side[i] != 0) == is_explicit ? 0 : 1);
  return out;
}

Partitioned::Side::Side(const Setup& whole, const Methods& methods, const State& state_of_all, bool is_explicit)
    : setup(whole.model(), methods, state_of_all.bodies, guests(whole, state_of_all, is_explicit)) {
  state.bodies = state_of_all.bodies;
  state.anchors = state_of_all.anchors;
  for (const Body& b : setup.bodies()) own.push_back(b.driven ? 0 : 1);
}

Partitioned::Partitioned(const Setup& whole, const Methods& methods, const State& state, const StepControl& control,
                         double detection, const Choice& choice)
    : whole_(&whole),
      choice_(choice),
      explicit_side_(whole, methods, state, true),
      implicit_side_(whole, methods, state, false),
      explicit_(std::make_unique<CentralDifference>(explicit_side_.setup, control, detection, choice.explicit_damping)),
      implicit_(std::make_unique<Newmark>(implicit_side_.setup, control, detection, choice.implicit)) {
  implicit_->pull(this);
}

void Partitioned::take(const Setup& from, std::span<const double> all, const Setup& to,
                       std::vector<double>& out) const {
  out.assign(all.empty() ? 0 : 2 * static_cast<std::size_t>(to.nodes()), 0.0);
  for (std::size_t i = 0; i < from.bodies().size() && !all.empty(); ++i)
    copy_numbers(from.bodies()[i], all, to.bodies()[i], out);
}

void Partitioned::take_bodies(const Side& from, std::span<const double> all, const Setup& to,
                              std::span<double> out) const {
  for (std::size_t i = 0; i < from.own.size(); ++i)
    if (from.own[i] != 0) copy_numbers(from.setup.bodies()[i], all, to.bodies()[i], out);
}

void Partitioned::split(const State& state) {
  for (Side* side : {&explicit_side_, &implicit_side_}) {
    State& s = side->state;
    s.time = state.time;
    s.step = state.step;
    s.stage = state.stage;
    s.last_step = state.last_step;
    s.contacts = state.contacts;
    take(*whole_, state.q, side->setup, s.q);
    take(*whole_, state.v, side->setup, s.v);
  }
  take(*whole_, state.a, explicit_side_.setup, explicit_side_.state.a);
  take(*whole_, state.v_before, explicit_side_.setup, explicit_side_.state.v_before);
  take(*whole_, state.damping, explicit_side_.setup, explicit_side_.state.damping);
  implicit_side_.state.factored = state.factored;
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
    s.ledger.open(std::array{kinetic, elastic, contact_energy(list), supports});
  }
}

double Partitioned::enter(State& state) {
  split(state);
  const double energy = explicit_->enter(explicit_side_.state) + implicit_->enter(implicit_side_.state);
  open_ledgers();
  has_base_ = false;
  bound_ = 0.0;
  const Ledger before = state.ledger;
  join(state);
  state.ledger = before;  // the caller books what has changed
  return energy;
}

void Partitioned::resume(const State& state, const MoverMemory& memory) {
  split(state);
  explicit_side_.state.contacts.clear();
  implicit_side_.state.contacts.clear();
  for (const ContactMemory& m : state.contacts) {
    const auto is_explicit = [&](std::int32_t block) {
      return explicit_side_.own[static_cast<std::size_t>(block)] != 0;
    };
    (is_explicit(m.key.block_p) || is_explicit(m.key.block_e) ? explicit_side_ : implicit_side_)
        .state.contacts.push_back(m);
  }
  explicit_->resume(explicit_side_.state, memory.sides[0]);
  implicit_->resume(implicit_side_.state, memory.sides[1]);
  explicit_side_.state.ledger = memory.ledgers[0];
  implicit_side_.state.ledger = memory.ledgers[1];
  base_ = memory.ledgers[2];
  has_base_ = true;
  bound_ = memory.step_bound;
}

MoverMemory Partitioned::memory() const {
  MoverMemory out;
  out.sides = {explicit_->memory(), implicit_->memory()};
  out.ledgers = {explicit_side_.state.ledger, implicit_side_.state.ledger, base_};
  out.step_bound = bound_;
  return out;
}

void Partitioned::join(State& state) {
  const State &e = explicit_side_.state, &i = implicit_side_.state;
  take_bodies(explicit_side_, e.q, *whole_, state.q);
  take_bodies(explicit_side_, e.v, *whole_, state.v);
  take_bodies(implicit_side_, i.q, *whole_, state.q);
  take_bodies(implicit_side_, i.v, *whole_, state.v);
  const auto of_explicit = [&](const std::vector<double>& numbers, std::vector<double>& out) {
    out.assign(numbers.empty() ? 0 : state.q.size(), 0.0);
    if (!numbers.empty()) take_bodies(explicit_side_, numbers, *whole_, out);
  };
  of_explicit(e.a, state.a);
  of_explicit(e.v_before, state.v_before);
  of_explicit(e.damping, state.damping);
  state.time = e.time;
  state.last_step = e.last_step;
  state.contacts.clear();
  std::merge(e.contacts.begin(), e.contacts.end(), i.contacts.begin(), i.contacts.end(),
             std::back_inserter(state.contacts),
             [](const ContactMemory& a, const ContactMemory& b) { return a.key < b.key; });
  whole_->prescribe(seconds(state.time), state.q, state.v);
  state.ledger = Ledger::joined(base_, e.ledger, i.ledger);
}

void Partitioned::find_springs() {
  // Springs of closed contacts with an implicit body. They stretch with the way, so that their mean sees half of it.
  springs_.clear();
  const Setup& setup = explicit_side_.setup;
  const Outlines& o = setup.outlines();
  const ContactList& list = explicit_->contacts();
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    if (m.status == ContactStatus::open) continue;
    const auto is_guest = [&](std::int32_t node) {
      return setup.bodies()[static_cast<std::size_t>(o.node_body[static_cast<std::size_t>(node)])].guest;
    };
    const auto add = [&](const ContactRow& row, double k) {
      Spring s;
      s.k = 0.5 * k;
      for (std::size_t n = 0; n < 3; ++n) {
        if (!is_guest(p.node[n])) continue;
        s.node[s.count] = p.node[n];
        s.direction[s.count++] = row[n];
      }
      if (s.count > 0) springs_.push_back(s);
    };
    add(gap_row(p.at), m.kn);
    if (m.status == ContactStatus::stick) add(stretch_row(p.at, m.anchor), m.kt);
  }
}

void Partitioned::rewind() {
  State& s = explicit_side_.state;
  s.time = saved_.time;
  s.last_step = saved_.last_step;
  s.step = saved_.step;
  s.q = saved_.q;
  s.v = saved_.v;
  s.a = saved_.a;
  s.v_before = saved_.v_before;
  s.damping = saved_.damping;
  s.contacts = saved_.contacts;
  s.ledger = saved_.ledger;
  explicit_->go_back(s, mark_);
}

StepReport Partitioned::mean(std::span<const double> end, std::span<double> force) {
  State& s = explicit_side_.state;
  if (repeats_++ > 0) rewind();
  take_bodies(implicit_side_, end, explicit_side_.setup, end_);
  explicit_->lead_guests(s, end_, s.time + step_);
  std::fill(sum_.begin(), sum_.end(), 0.0);
  const double H = seconds(step_);
  const auto add = [&](double weight) {
    const std::span<const double> f = explicit_->forces();
    for (std::size_t i = 0; i < explicit_side_.own.size(); ++i) {
      const Body& b = explicit_side_.setup.bodies()[i];
      if (!b.guest) continue;
      const auto first = 2 * static_cast<std::size_t>(b.first_node), n = 2 * static_cast<std::size_t>(b.nodes);
      for (std::size_t k = first; k < first + n; ++k) sum_[k] += weight * f[k];
    }
  };
  Tick left = step_;
  for (std::int32_t j = 0; j < substeps_; ++j) {
    const Tick ticks = left / (substeps_ - j);
    const double weight = 0.5 * seconds(ticks) / H;
    add(weight);
    StepReport report = explicit_->step(s, ticks);
    if (report.status != StepReport::Status::ok) return report;
    add(weight);
    left -= ticks;
  }
  for (std::size_t i = 0; i < implicit_side_.own.size(); ++i)
    if (implicit_side_.own[i] != 0)
      copy_numbers(explicit_side_.setup.bodies()[i], sum_, implicit_side_.setup.bodies()[i], force);
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
  explicit_->mark(mark_);
  saved_.time = e.time;
  saved_.last_step = e.last_step;
  saved_.step = e.step;
  saved_.q = e.q;
  saved_.v = e.v;
  saved_.a = e.a;
  saved_.v_before = e.v_before;
  saved_.damping = e.damping;
  saved_.contacts = e.contacts;
  saved_.ledger = e.ledger;
  end_ = e.q;
  sum_.assign(e.q.size(), 0.0);
  take_bodies(explicit_side_, e.q, implicit_side_.setup, i.q);
  present_.assign(i.q.size(), 0.0);
  for (std::size_t b = 0; b < implicit_side_.own.size(); ++b)
    if (implicit_side_.own[b] != 0)
      copy_numbers(explicit_side_.setup.bodies()[b], explicit_->forces(), implicit_side_.setup.bodies()[b], present_);
  find_springs();
  if (audit_ != nullptr) implicit_->watch(audit_);
  StepReport report = implicit_->step(i, ticks_of_step);
  if (report.status != StepReport::Status::ok) {
    if (repeats_ > 0) rewind();
    return report;
  }
  if (audit_ != nullptr) explicit_->check(e, *audit_);
  // Guests stand where their own side has them, with its velocity.
  take_bodies(implicit_side_, i.q, explicit_side_.setup, e.q);
  take_bodies(implicit_side_, i.v, explicit_side_.setup, e.v);
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
    for (std::size_t i = 0; i < side->own.size(); ++i) {
      const Body &a = side->setup.bodies()[i], &b = whole_->bodies()[i];
      const auto from = 2 * static_cast<std::size_t>(a.first_node), to = 2 * static_cast<std::size_t>(b.first_node),
                 count = 2 * static_cast<std::size_t>(a.nodes);
      for (std::size_t k = 0; k < count; ++k) f[to + k] += own[from + k];
    }
  }
}

}  // namespace scree::coupling
