#include "coupling/contact/explicit_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/contact/law/explicit_law.h"
#include "coupling/contact/law/joint_strength.h"

namespace scree::coupling {
namespace {

/// What the law has to know of a point; at rest until a step says how it moved.
PointMotion motion_of(const ContactPoint& p) {
  PointMotion motion;
  motion.foot = p.at.xi;
  motion.length = p.at.length;
  motion.held_elsewhere = p.suppressed || p.beyond;
  return motion;
}

}  // namespace

ExplicitContact::ExplicitContact(const Setup& setup, double detection, bool check_friction)
    : setup_(&setup),
      finder_(setup, detection),
      friction_check_(setup),
      friction_evolution_(setup.laws().all()),
      checks_friction_(check_friction) {
  const std::size_t expected = 2 * setup.outlines().vertices.size();  // so that steps need not allocate
  for (ContactList* list : {&now_, &before_, &ahead_}) {
    list->points.reserve(expected);
    list->memory.reserve(expected);
    list->briefs.reserve(expected);
  }
  left_.reserve(expected);
  kept_.reserve(expected);
  trial_.reserve(expected);
  anchor_.reserve(expected);
  opened_.reserve(expected);
}

void ExplicitContact::enter(State& state, bool at_start, bool goes_on) {
  finder_.restore(state.contacts, before_);
  for (std::size_t i = 0; i < before_.memory.size() && !goes_on; ++i) before_.memory[i].impact = 0.0;
  finder_.find(state.q, before_, at_start, now_);
  (void)finder_.adopt_kinds(now_);  // the energy returned below has it
  // Forces of the springs as they are now: a mesh, a share or a scheme may have changed since they were last known.
  for (std::size_t i = 0; i < now_.points.size() && !goes_on; ++i) {
    ContactMemory& m = now_.memory[i];
    const auto joint = static_cast<std::size_t>(m.joint);
    explicit_law(setup_->laws()[joint], setup_->laws().tan_friction(joint), motion_of(now_.points[i]), m);
  }
  if (!checks_friction_) FrictionCheck::forget(now_);
  state.contacts = now_.memory;
  // What was remembered and is not found is in the list before: the next step takes it out.
  clear_ = now_.points.empty() && before_.points.empty() ? finder_.clearance() : 0.0;
}

void ExplicitContact::check(std::span<const double> q, Audit& audit) const {
  double farthest = 0.0;
  for (const double x : q) farthest = std::max(farthest, std::abs(x));
  const double last_places = 8.0 * std::numeric_limits<double>::epsilon() * farthest;
  for (std::size_t i = 0; i < now_.points.size(); ++i) {
    const ContactPoint& p = now_.points[i];
    const ContactMemory& m = now_.memory[i];
    const double allowed = 1e-9 * (std::abs(m.fn) + std::abs(m.ft)) + (m.kn + m.kt) * last_places;
    if (m.status != ContactStatus::open) {
      // The step took its friction from the slip that there was.
      ContactMemory then = m;
      if (p.from >= 0) {
        const ContactMemory& was = before_.memory[static_cast<std::size_t>(p.from)];
        then.slip = was.slip;
        then.friction_change = was.friction_change;
      }
      const JointLaw& law = setup_->laws()[static_cast<std::size_t>(m.joint)];
      audit_law(*setup_, then, m.failed == 0 && can_fail(law) ? std::max(m.fn, m.fn - m.fd) : m.fn, m.ft, allowed,
                audit);
    } else if (!p.suppressed && !p.beyond) {
      audit.check(m.kn * std::max(0.0, -m.gap), allowed, [&] {
        return fmt::format("{}: open and {:.3g} m deep", contact_name(setup_->model(), m.key), -m.gap);
      });
    }
  }
  audit_geometry(*setup_, now_, q, finder_.detection(), audit);
}

void ExplicitContact::undo(State& state) {
  std::swap(now_, before_);
  state.contacts = now_.memory;
  clear_ = 0.0;
}

void ExplicitContact::add(std::span<double> f) const { add(now_, f); }

void ExplicitContact::add(const ContactList& list, std::span<double> f) const {
  const Outlines& o = setup_->outlines();
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    const ContactPoint& p = list.points[i];
    const ContactMemory& m = list.memory[i];
    if (m.fn != 0.0 || m.water != 0.0) add_row_force(o, p, gap_row(p.at), m.fn + m.water, f);
    if (m.ft != 0.0) add_row_force(o, p, stretch_row(p.at, m.anchor), m.ft, f);
  }
}

void ExplicitContact::foresee(double h, std::span<const double> q, std::span<const double> v, std::span<double> f) {
  finder_.find(q, now_, false, ahead_, ContactPairs::Of::ghosts);
  respond(h, v, ahead_);
  (void)finder_.adopt_kinds(ahead_);
  add(ahead_, f);
}

ExplicitContact::Half ExplicitContact::half_work(double h, const ContactPoint& p, const ContactMemory& m,
                                                 std::span<const double> v) const {
  const Outlines& o = setup_->outlines();
  Half half;
  if (m.fn != 0.0 || m.fd != 0.0 || m.water != 0.0) {
    const double way = 0.5 * h * row_rate(o, p, gap_row(p.at), v);
    half.normal = (m.fn - m.fd) * way;
    half.damping = m.fd * way;
    half.water = m.water * way;
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
  const double lifted = 0.5 * opened_[after];
  ledger.book(Column::contact_damping, -left_[before].damping - arriving.damping + lifted * (a.fd + b.fd));
  if (lifted != 0.0) ledger.book(Column::dilation, -lifted * (a.fn + b.fn));
  ledger.book(Column::water, left_[before].water + arriving.water);
  const double fa = a.fn - a.fd, fb = b.fn - b.fd;  // of the springs alone
  if (fa != 0.0 || fb != 0.0) {
    const double dg = b.gap - a.gap, trapezoid = 0.5 * (fa + fb) * dg;
    // Dilation takes the spring with it: the bodies moved by more than the spring did.
    ledger.book(Column::contact_geometry,
                left_[before].normal + arriving.normal - (trapezoid + 0.5 * (fa + fb) * opened_[after]));
    // Closed at both ends: trapezoid and energy cancel but for the change of the share. Closing: -k d g_n/2, opening:
    // +k d g_{n+1}/2.
    if (bond_broke) {
      ledger.book(Column::contact_transition, trapezoid);
      ledger.book(Column::bonds_broken, energy_a);
    } else if (fa == 0.0 || fb == 0.0)
      ledger.book(Column::contact_transition, trapezoid + energy_b - energy_a);
    else
      ledger.book(Column::contact_tributary, 0.5 * a.gap * b.gap * (b.kn - a.kn));
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
  ledger.book(Column::contact_tributary, 0.5 * a.stretch * b.stretch * (b.kt - a.kt));
  if (b.status == ContactStatus::slip) ledger.book(Column::friction, -0.5 * (ta + tb) * (trial_[after] - b.stretch));
}

bool ExplicitContact::on_ghost(const ContactPoint& p) const {
  const auto is_ghost = [&](std::int32_t node) {
    const auto b = static_cast<std::size_t>(setup_->outlines().node_body[static_cast<std::size_t>(node)]);
    return setup_->bodies()[b].ghost || setup_->bodies()[b].divided;
  };
  return is_ghost(p.node[0]) || is_ghost(p.node[1]);
}

void ExplicitContact::respond(double h, std::span<const double> v, ContactList& list) {
  trial_.resize(list.points.size());
  opened_.resize(list.points.size());
  for (std::size_t i = 0; i < list.points.size(); ++i) {
    const ContactPoint& p = list.points[i];
    ContactMemory& m = list.memory[i];
    // The stretch that a spring would have here, also for one that opens now.
    trial_[i] = (p.at.xi - m.anchor) * p.at.length;
    const JointLaw& law = setup_->laws()[static_cast<std::size_t>(m.joint)];
    PointMotion motion = motion_of(p);
    motion.per_time = 1.0 / h;
    // A dashpot that begins to push where the contact closes could hold it open: then there is no place of the ghost
    // that its own force leads to. It acts from the next step on.
    if (m.status != ContactStatus::open || !on_ghost(p)) {
      motion.cn = p.cn;
      motion.ct = p.ct;
    }
    if ((m.gap < 0.0 || m.bonded != 0 || law.dilation > 0.0) && p.cn > 0.0) {
      motion.rate = row_rate(setup_->outlines(), p, gap_row(p.at), v);
      motion.shear = row_rate(setup_->outlines(), p, stretch_row(p.at, m.anchor), v);
    }
    const double gap0 = m.gap0;
    // Stages to rest have no velocities of their own.
    if (m.status == ContactStatus::open && m.gap < 0.0 && !p.suppressed && !p.beyond && checks_friction_)
      finder_.begin_impact(p, -row_rate(setup_->outlines(), p, gap_row(p.at), v), m);
    explicit_law(law, setup_->laws().tan_friction(static_cast<std::size_t>(m.joint)), motion, m);
    opened_[i] = m.gap0 - gap0;
    if (m.status == ContactStatus::open)
      m.impact = 0.0;
    else
      m.impact = std::max(0.0, m.impact - h);
  }
}

void ExplicitContact::transfer_impact_energy(double h, std::span<const double> v) {
  for (std::size_t i = 0; i < now_.points.size(); ++i) {
    const ContactPoint& p = now_.points[i];
    ContactMemory& m = now_.memory[i];
    if (p.from < 0 || m.impact == 0.0) continue;
    const auto from = static_cast<std::size_t>(p.from);
    const ContactPoint& was = before_.points[from];
    if (was.vertex == p.vertex && was.edge == p.edge) continue;
    const double left = normal_energy(was, before_.memory[from]) - left_[from].normal;
    if (left <= 0.0) continue;
    const double half_way = 0.5 * h * row_rate(setup_->outlines(), p, gap_row(p.at), v);
    const double gap = half_way - std::sqrt(half_way * half_way + 2.0 * left / m.kn);
    m.gap0 += m.gap - gap;
    m.gap = gap;
  }
}

void ExplicitContact::follow_slides(double h) {
  friction_check_.begin(now_);
  for (std::size_t i = 0; i < now_.points.size(); ++i) {
    ContactMemory& m = now_.memory[i];
    const ContactPoint& p = now_.points[i];
    double way = m.status == ContactStatus::slip ? trial_[i] - m.stretch : 0.0;
    if (m.status == ContactStatus::open && m.slide.length > 0.0F && p.from >= 0) {  // it hops
      const ContactPoint& was = before_.points[static_cast<std::size_t>(p.from)];
      if (was.segment == p.segment) way = (p.at.xi - was.at.xi) * p.at.length;
    }
    friction_check_.see(h, p, way, m);
  }
}

void ExplicitContact::arrive(double h, double farthest, std::span<const double> q, std::span<const double> v,
                             State& state) {
  clear_ -= farthest;
  std::swap(now_, before_);
  if (clear_ > 0.0) return;  // both lists are empty and stay so
  finder_.find(q, before_, false, now_);
  transfer_impact_energy(h, v);
  respond(h, v, now_);
  if (checks_friction_) {  // velocities are physical
    follow_slides(h);
    friction_evolution_.advance(h, now_.memory);
  }
  Ledger& ledger = state.ledger;
  kept_.assign(before_.points.size(), 0);
  for (std::size_t b = 0; b < now_.points.size(); ++b) {
    const Half arriving = half_work(h, now_.points[b], now_.memory[b], v);
    if (now_.points[b].from >= 0) {
      const auto a = static_cast<std::size_t>(now_.points[b].from);
      kept_[a] = 1;
      book_pair(a, b, arriving, ledger);
      continue;
    }
    ledger.book(Column::water, arriving.water);
    if (now_.memory[b].gap < 0.0 || now_.memory[b].bonded != 0) {
      ledger.book(Column::contact_damping, -arriving.damping);
      ledger.book(Column::contact_edges, arriving.normal + arriving.tangential +
                                             normal_energy(now_.points[b], now_.memory[b]) +
                                             tangential_energy(now_.memory[b]));
    }
  }
  for (std::size_t i = 0; i < before_.points.size(); ++i) {
    if (kept_[i] != 0) continue;  // else the pair ended: its springs are gone
    ledger.book(Column::contact_damping, -left_[i].damping);
    ledger.book(Column::water, left_[i].water);
    ledger.book(Column::contact_edges, left_[i].normal + left_[i].tangential);
    ledger.book(Column::springs_dropped,
                normal_energy(before_.points[i], before_.memory[i]) + tangential_energy(before_.memory[i]));
  }
  // Those that closed points have taken over: booked as dropped, and where the others changed.
  ledger.book(Column::springs_dropped, -finder_.merged());
  ledger.book(Column::contact_geometry, -finder_.merged());
  // A new kind moves the anchor, at which the friction force takes hold of the edge while it kicks for the other half.
  anchor_.resize(now_.memory.size());
  for (std::size_t i = 0; i < anchor_.size(); ++i) anchor_[i] = now_.memory[i].anchor;
  ledger.book(Column::contact_tributary, finder_.adopt_kinds(now_));
  for (std::size_t i = 0; i < anchor_.size(); ++i) {
    const ContactPoint& p = now_.points[i];
    const ContactMemory& m = now_.memory[i];
    if (m.anchor == anchor_[i] || m.ft == 0.0) continue;
    const double way = 0.5 * h *
                       (row_rate(setup_->outlines(), p, stretch_row(p.at, m.anchor), v) -
                        row_rate(setup_->outlines(), p, stretch_row(p.at, anchor_[i]), v));
    ledger.book(Column::contact_geometry, (m.ft - m.fdt) * way);
    ledger.book(Column::contact_damping, -m.fdt * way);
  }
  state.contacts = now_.memory;
  ledger.set(Column::contact_springs, contact_energy(now_));
  clear_ = now_.points.empty() && before_.points.empty() ? finder_.clearance() : 0.0;
}

}  // namespace scree::coupling
