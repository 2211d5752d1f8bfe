#include "coupling/contact/explicit_contact.h"

#include <algorithm>
#include <cmath>

#include "coupling/contact/joint_strength.h"

namespace scree::coupling {
namespace {

void let_go(ContactMemory& m) {
  m.status = ContactStatus::open;
  m.fn = m.fd = m.ft = m.fdt = m.stretch = 0.0;
}

/// Normal penalty, which pulls as far as a bond bears, tangential spring with Coulomb's cap (return mapping). Moves the
/// anchor when it slips.
/// @param rate,shear  rates of gap and stretch [m/s]
void apply_law(const JointLaw& law, const ContactPoint& p, double rate, double shear, ContactMemory& m) {
  const double spring = -m.kn * m.gap;
  if (m.bonded != 0 && -spring > tension_limit(law, m)) mark_failed(law, m);
  if (p.suppressed || p.beyond || (m.gap >= 0.0 && m.bonded == 0)) return let_go(m);
  const auto press = [&] {  // damping never pulls more than a bond bears
    m.fn = std::max(0.0 - tension_limit(law, m), spring - p.cn * rate);
    m.fd = m.fn - spring;
  };
  press();
  if (m.status == ContactStatus::open) {  // closes here: the spring begins at the foot
    m.anchor = p.at.xi;
    m.stretch = 0.0;
    m.status = ContactStatus::stick;
  }
  const double limit = friction_limit(law, m, m.fn);
  if (m.kt * std::abs(m.stretch) > limit) {
    mark_failed(law, m);
    if (m.gap >= 0.0) return let_go(m);  // sheared through while it was pulled
    press();
    const double kept = std::copysign(friction_limit(law, m, m.fn) / m.kt, m.stretch);
    m.slip += std::abs(m.stretch - kept);
    m.anchor = p.at.xi - kept / p.at.length;
    m.stretch = (p.at.xi - m.anchor) * p.at.length;
    m.status = ContactStatus::slip;
  } else {
    m.status = ContactStatus::stick;
  }
  // Damping only where the contact sticks, and never beyond Coulomb's limit.
  const double spring_t = -m.kt * m.stretch, cap = friction_limit(law, m, m.fn);
  m.ft = m.status == ContactStatus::stick ? std::clamp(spring_t - p.ct * shear, -cap, cap) : spring_t;
  m.fdt = m.ft - spring_t;
}

}  // namespace

ExplicitContact::ExplicitContact(const Setup& setup, double detection) : setup_(&setup), finder_(setup, detection) {
  const std::size_t expected = 2 * setup.outlines().vertices.size();  // so that steps need not allocate
  for (ContactList* list : {&now_, &before_}) {
    list->points.reserve(expected);
    list->memory.reserve(expected);
  }
  left_.reserve(expected);
  kept_.reserve(expected);
  trial_.reserve(expected);
}

void ExplicitContact::enter(State& state, bool at_start, bool goes_on) {
  finder_.restore(state.contacts, before_);
  finder_.find(state.q, before_, at_start, now_);
  (void)finder_.adopt_kinds(now_);  // the energy returned below has it
  // Forces of the springs as they are now: a mesh, a share or a scheme may have changed since they were last known.
  for (std::size_t i = 0; i < now_.points.size() && !goes_on; ++i) {
    ContactMemory& m = now_.memory[i];
    apply_law(setup_->model().joints[static_cast<std::size_t>(m.joint)], now_.points[i], 0.0, 0.0, m);
  }
  state.contacts = now_.memory;
  clear_ = now_.points.empty() ? finder_.clearance() : 0.0;
}

void ExplicitContact::undo(State& state) {
  std::swap(now_, before_);
  state.contacts = now_.memory;
  clear_ = 0.0;
}

void ExplicitContact::add(std::span<double> f) const {
  const Outlines& o = setup_->outlines();
  for (std::size_t i = 0; i < now_.points.size(); ++i) {
    const ContactMemory& m = now_.memory[i];
    if (m.fn != 0.0) add_row_force(o, now_.points[i], gap_row(now_.points[i].at), m.fn, f);
    if (m.ft != 0.0) add_row_force(o, now_.points[i], stretch_row(now_.points[i].at, m.anchor), m.ft, f);
  }
}

ExplicitContact::Half ExplicitContact::half_work(double h, const ContactPoint& p, const ContactMemory& m,
                                                 std::span<const double> v) const {
  const Outlines& o = setup_->outlines();
  Half half;
  if (m.fn != 0.0 || m.fd != 0.0) {
    const double way = 0.5 * h * row_rate(o, p, gap_row(p.at), v);
    half.normal = (m.fn - m.fd) * way;
    half.damping = m.fd * way;
  }
  if (m.ft != 0.0 || m.fdt != 0.0) {
    const double way = 0.5 * h * row_rate(o, p, stretch_row(p.at, m.anchor), v);
    half.tangential = (m.ft - m.fdt) * way;
    half.damping += m.fdt * way;
  }
  return half;
}

void ExplicitContact::leave(double h, std::span<const double> v) {
  left_.resize(now_.points.size());
  for (std::size_t i = 0; i < now_.points.size(); ++i) left_[i] = half_work(h, now_.points[i], now_.memory[i], v);
}

void ExplicitContact::book_pair(std::size_t before, std::size_t after, const Half& arriving, Ledger& ledger) const {
  const ContactMemory &a = before_.memory[before], &b = now_.memory[after];
  const double energy_a = normal_energy(before_.points[before], a), energy_b = normal_energy(now_.points[after], b);
  const bool bond_broke = a.bonded != 0 && b.status == ContactStatus::open && b.gap >= 0.0;
  ledger.book(Column::contact_damping, -left_[before].damping - arriving.damping);
  const double fa = a.fn - a.fd, fb = b.fn - b.fd;  // of the springs alone
  if (fa != 0.0 || fb != 0.0) {
    const double dg = b.gap - a.gap, trapezoid = 0.5 * (fa + fb) * dg;
    ledger.book(Column::contact_geometry, left_[before].normal + arriving.normal - trapezoid);
    // Closed at both ends: trapezoid and energy cancel but for the change of the share. Closing: -k d g_n/2, opening:
    // +k d g_{n+1}/2.
    if (bond_broke) {
      ledger.book(Column::contact_transition, trapezoid);
      ledger.book(Column::bonds_broken, energy_a);
    } else if (fa == 0.0 || fb == 0.0)
      ledger.book(Column::contact_transition, trapezoid + energy_b - energy_a);
    else
      ledger.book(Column::contact_share, 0.5 * a.gap * b.gap * (b.kn - a.kn));
  }
  if (a.status == ContactStatus::open) return;  // a spring that begins here has done no work
  const double de = trial_[after] - a.stretch, ta = a.ft - a.fdt, tb = b.ft - b.fdt;
  if (b.status == ContactStatus::open) {
    ledger.book(Column::contact_geometry, left_[before].tangential - 0.5 * ta * de);
    ledger.book(Column::contact_transition, 0.5 * ta * de);
    ledger.book(bond_broke ? Column::bonds_broken : Column::springs_dropped, tangential_energy(a));
    return;
  }
  ledger.book(Column::contact_geometry, left_[before].tangential + arriving.tangential - 0.5 * (ta + tb) * de);
  ledger.book(Column::contact_share, 0.5 * a.stretch * b.stretch * (b.kt - a.kt));
  if (b.status == ContactStatus::slip) ledger.book(Column::friction, -0.5 * (ta + tb) * (trial_[after] - b.stretch));
}

void ExplicitContact::arrive(double h, double farthest, std::span<const double> q, std::span<const double> v,
                             State& state) {
  clear_ -= farthest;
  std::swap(now_, before_);
  if (clear_ > 0.0) return;  // both lists are empty and stay so
  finder_.find(q, before_, false, now_);
  trial_.resize(now_.points.size());
  for (std::size_t i = 0; i < now_.points.size(); ++i) {
    ContactMemory& m = now_.memory[i];
    // The stretch that a spring would have here, also for one that opens now.
    trial_[i] = (now_.points[i].at.xi - m.anchor) * now_.points[i].at.length;
    const ContactPoint& p = now_.points[i];
    double rate = 0.0, shear = 0.0;
    if ((m.gap < 0.0 || m.bonded != 0) && p.cn > 0.0) {
      rate = row_rate(setup_->outlines(), p, gap_row(p.at), v);
      shear = row_rate(setup_->outlines(), p, stretch_row(p.at, m.anchor), v);
    }
    apply_law(setup_->model().joints[static_cast<std::size_t>(m.joint)], p, rate, shear, m);
  }
  Ledger& ledger = state.ledger;
  kept_.assign(before_.points.size(), 0);
  for (std::size_t b = 0; b < now_.points.size(); ++b) {
    const Half arriving = half_work(h, now_.points[b], now_.memory[b], v);
    if (now_.points[b].from >= 0) {
      const auto a = static_cast<std::size_t>(now_.points[b].from);
      kept_[a] = 1;
      book_pair(a, b, arriving, ledger);
    } else if (now_.memory[b].gap < 0.0 || now_.memory[b].bonded != 0) {
      ledger.book(Column::contact_damping, -arriving.damping);
      ledger.book(Column::contact_edges, arriving.normal + arriving.tangential +
                                             normal_energy(now_.points[b], now_.memory[b]) +
                                             tangential_energy(now_.memory[b]));
    }
  }
  for (std::size_t i = 0; i < before_.points.size(); ++i) {
    if (kept_[i] != 0) continue;  // else the pair ended: its springs are gone
    ledger.book(Column::contact_damping, -left_[i].damping);
    ledger.book(Column::contact_edges, left_[i].normal + left_[i].tangential);
    ledger.book(Column::springs_dropped,
                normal_energy(before_.points[i], before_.memory[i]) + tangential_energy(before_.memory[i]));
  }
  ledger.book(Column::contact_share, finder_.adopt_kinds(now_));
  state.contacts = now_.memory;
  ledger.set(Column::contact_springs, contact_energy(now_));
  clear_ = now_.points.empty() && before_.points.empty() ? finder_.clearance() : 0.0;
}

}  // namespace scree::coupling
