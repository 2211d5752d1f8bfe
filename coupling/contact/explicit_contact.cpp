#include "coupling/contact/explicit_contact.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "coupling/contact/law/explicit_law.h"
#include "coupling/contact/law/joint_strength.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

constexpr std::int64_t kFewPoints = 1024;  // fewer are not worth waking threads

/// Input of the law for a point; at rest until a step sets its motion.
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
      checks_friction_(check_friction),
      node_forces_(setup, 2 * setup.outlines().vertices.size()) {
  const std::size_t expected = 2 * setup.outlines().vertices.size();  // so that steps need not allocate
  for (ContactList* list : {&before_, &ahead_, &left_list_}) {
    list->points.reserve(expected);
    list->memory.reserve(expected);
    list->briefs.reserve(expected);
  }
  left_.reserve(expected);
  weakened_.reserve(expected);
  left_first_.reserve(expected);
  kept_.reserve(expected);
  trial_.reserve(expected);
  anchor_.reserve(expected);
  kinds_.reserve(expected);
  slides_.reserve(expected);
  energy_.reserve(expected);
  for (const BodyIndex body : setup.outlines().node_body)
    ghost_.push_back(setup.body(body).ghost || setup.body(body).divided ? 1 : 0);
  chunks_.resize((expected + kContactChunk - 1) / kContactChunk);
  for (Chunk& chunk : chunks_) {
    chunk.slides.reserve(static_cast<std::size_t>(kContactChunk));
    chunk.kinds.reserve(static_cast<std::size_t>(kContactChunk));
  }
  opened_.reserve(expected);
}

void ExplicitContact::enter(State& state, bool at_start, bool goes_on) {
  list_ = &state.contacts;
  forces_taken_ = false;
  list_->reserve(2 * setup_->outlines().vertices.size());  // so that steps need not allocate
  finder_.restore(list_->memory, before_);
  if (!goes_on) {
    for (ContactMemory& m : before_.memory) m.impact = 0.0;
    if (friction_evolution_.used()) FrictionEvolution::skip(before_.memory);
  }
  finder_.find(state.q, before_, at_start, *list_);
  (void)finder_.adopt_kinds(*list_);  // its change is in the energy that enter() of the integrator returns
  // Forces of the present springs: a mesh, a share or a scheme may have changed since they were last computed.
  for (std::size_t i = 0; i < list_->points.size() && !goes_on; ++i) {
    ContactMemory& m = list_->memory[i];
    const auto joint = static_cast<std::size_t>(m.joint);
    explicit_law(setup_->laws()[joint], setup_->laws().tan_friction(joint), motion_of(list_->points[i]), m);
  }
  if (!checks_friction_) FrictionCheck::forget(*list_);
  indexed_ = false;
  // Remembered points that were not found are in before_: the next step removes them.
  clear_ = list_->points.empty() && before_.points.empty() ? finder_.clearance() : 0.0;
}

void ExplicitContact::check(std::span<const double> q, Audit& audit) const {
  double farthest = 0.0;
  for (const double x : q) farthest = std::max(farthest, std::abs(x));
  const double last_places = 8.0 * std::numeric_limits<double>::epsilon() * farthest;
  for (std::size_t i = 0; i < list_->points.size(); ++i) {
    const ContactPoint& p = list_->points[i];
    const ContactMemory& m = list_->memory[i];
    const double allowed = 1e-9 * (std::abs(m.fn) + std::abs(m.ft)) + (m.kn + m.kt) * last_places;
    if (m.status != ContactStatus::open) {
      // The step took the point's friction from the slip at its start.
      ContactMemory then = m;
      if (p.from >= 0) {
        const Weakened& was = weakened_[static_cast<std::size_t>(p.from)];
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
  audit_geometry(*setup_, *list_, q, finder_.detection(), audit);
}

void ExplicitContact::undo() {
  if (can_undo_)
    *list_ = left_list_;
  else if (!in_place_)
    std::swap(*list_, before_);
  clear_ = 0.0;
  indexed_ = can_undo_ = forces_taken_ = false;
}

void ExplicitContact::add(std::span<double> f) const {
  if (!std::exchange(forces_taken_, true)) node_forces_.take_all(*list_);
  node_forces_.add(f);
}

void ExplicitContact::add_ahead(std::span<double> f) {
  forces_taken_ = false;
  node_forces_.take_all(ahead_);
  node_forces_.add(f);
}

template <class OfRange>
void ExplicitContact::for_points(Ledger& ledger, OfRange&& of_range) {
  const std::int64_t size = std::ssize(list_->points);
  const auto count = static_cast<std::size_t>((size + kContactChunk - 1) / kContactChunk);
  if (chunks_.size() < count) chunks_.resize(count);
  const auto of_chunk = [&](std::int64_t begin, std::int64_t end) {
    Chunk& chunk = chunks_[static_cast<std::size_t>(begin / kContactChunk)];
    chunk.ledger = {};
    chunk.slides.clear();
    chunk.kinds.clear();
    of_range(static_cast<std::size_t>(begin), static_cast<std::size_t>(end), chunk);
  };
  parallel_for_chunks(size, of_chunk, kFewPoints, kContactChunk);
  slides_.clear();
  kinds_.clear();
  for (const Chunk& chunk : std::span(chunks_).first(count)) {
    ledger.add(chunk.ledger);
    slides_.insert(slides_.end(), chunk.slides.begin(), chunk.slides.end());
    kinds_.insert(kinds_.end(), chunk.kinds.begin(), chunk.kinds.end());
  }
}

void ExplicitContact::foresee(double h, std::span<const double> q, std::span<const double> v, std::span<double> f) {
  if (!std::exchange(indexed_, true)) finder_.index(*list_);
  finder_.find_of_ghosts(q, ahead_);
  ahead_found_ = ahead_.memory;
  set_velocities(v, v_);
  respond(h, ahead_);
  (void)finder_.adopt_kinds(ahead_);
  add_ahead(f);
}

void ExplicitContact::foresee_again(double h, std::span<const double> q, std::span<const double> v,
                                    std::span<double> f) {
  ahead_.memory = ahead_found_;
  finder_.follow(q, ahead_);
  ahead_found_ = ahead_.memory;
  set_velocities(v, v_);
  respond(h, ahead_);
  (void)finder_.adopt_kinds(ahead_);
  add_ahead(f);
}

void ExplicitContact::set_velocities(std::span<const double> v, IndexedVector<OutlineNode, Vec2>& out) const {
  const Outlines& o = setup_->outlines();
  if (out.size() != o.nodes.size()) out.assign(o.nodes.size(), Vec2::Zero());  // bodies that rest have none
  for (const IndexRange<OutlineNode> r : o.moving_nodes)
    parallel_for(r, [&](OutlineNode n) { out[n] = position(o.nodes[n], v); });
}

ExplicitContact::Half ExplicitContact::half_work(double h, const ContactPoint& p, const ContactMemory& m,
                                                 OutlineVelocities v, const Rates& rates) const {
  Half half;
  if (m.fn != 0.0 || m.fd != 0.0 || m.water != 0.0) {
    const double way = 0.5 * h * (rates.known ? rates.gap : row_rate(p, gap_row(p.at), v));
    half.normal = (m.fn - m.fd) * way;
    half.damping = m.fd * way;
    half.water = m.water * way;
  }
  if (m.ft != 0.0 || m.fdt != 0.0) {
    const bool known = rates.known && rates.anchor == m.anchor;
    const double way = 0.5 * h * (known ? rates.stretch : row_rate(p, stretch_row(p.at, m.anchor), v));
    half.tangential = (m.ft - m.fdt) * way;
    half.damping += m.fdt * way;
  }
  return half;
}

void ExplicitContact::leave(std::span<const double> v) {
  if (!list_->points.empty()) set_velocities(v, v_left_);
}

ExplicitContact::Rates ExplicitContact::rates_of(const ContactPoint& p, double anchor, OutlineVelocities v) {
  return {row_rate(p, gap_row(p.at), v), row_rate(p, stretch_row(p.at, anchor), v), anchor, true};
}

ExplicitContact::Left ExplicitContact::left_by(double h, const ContactPoint& p, const ContactMemory& m) const {
  const bool open = m.status == ContactStatus::open;
  // An open point has no force but that of water.
  const Half work =
      open && m.water == 0.0 ? Half{} : half_work(h, p, m, v_left_, open ? Rates{} : rates_of(p, m.anchor, v_left_));
  return {work, m.gap, m.stretch, m.fn,      m.fd, m.ft,          m.fdt,
          m.kn, m.kt,  p.at.xi,   p.segment, open, m.bonded != 0, !p.suppressed && !p.beyond};
}

void ExplicitContact::book_pair(const Left& a, std::size_t after, const Half& arriving, Ledger& ledger) const {
  const ContactMemory& b = list_->memory[after];
  const bool opened = b.status == ContactStatus::open, bond_broke = a.bonded && opened && b.gap >= 0.0;
  Ledger::Booking booking(ledger);
  const double lifted = 0.5 * opened_[after];
  booking.book(Column::contact_damping, -a.work.damping - arriving.damping + lifted * (a.fd + b.fd));
  if (lifted != 0.0) booking.book(Column::dilation, -lifted * (a.fn + b.fn));
  if (a.work.water != 0.0 || arriving.water != 0.0) booking.book(Column::water, a.work.water + arriving.water);
  const double fa = a.fn - a.fd, fb = b.fn - b.fd;  // of the springs alone
  if (fa != 0.0 || fb != 0.0) {
    const double dg = b.gap - a.gap, trapezoid = 0.5 * (fa + fb) * dg;
    // Dilation moves gap0: the bodies moved by more than the spring did.
    booking.book(Column::contact_geometry,
                 a.work.normal + arriving.normal - (trapezoid + 0.5 * (fa + fb) * opened_[after]));
    // Closed at both ends: trapezoid and energy cancel except for the change of the share. Closing: -k d g_n/2,
    // opening: +k d g_{n+1}/2.
    if (bond_broke) {
      booking.book(Column::contact_transition, trapezoid);
      booking.book(Column::bonds_broken, a.normal_energy());
    } else if (fa == 0.0 || fb == 0.0)
      booking.book(Column::contact_transition, trapezoid + normal_energy(list_->points[after], b) - a.normal_energy());
    else
      booking.book(Column::contact_tributary, 0.5 * a.gap * b.gap * (b.kn - a.kn));
  }
  if (a.open) return;  // a spring that begins here has done no work
  const double de = trial_[after] - a.stretch, ta = a.ft - a.fdt, tb = b.ft - b.fdt;
  if (opened) {
    booking.book(Column::contact_geometry, a.work.tangential - 0.5 * ta * de);
    booking.book(Column::contact_transition, 0.5 * ta * de);
    booking.book(bond_broke ? Column::bonds_broken : Column::springs_dropped, a.tangential_energy());
    return;
  }
  booking.book(Column::contact_geometry, a.work.tangential + arriving.tangential - 0.5 * (ta + tb) * de);
  booking.book(Column::contact_tributary, 0.5 * a.stretch * b.stretch * (b.kt - a.kt));
  if (b.status == ContactStatus::slip) booking.book(Column::friction, -0.5 * (ta + tb) * (trial_[after] - b.stretch));
}

void ExplicitContact::book_new(std::size_t i, const Half& arriving, Ledger& ledger) const {
  const ContactMemory& m = list_->memory[i];
  ledger.book(Column::water, arriving.water);
  if (m.gap >= 0.0 && m.bonded == 0) return;
  ledger.book(Column::contact_damping, -arriving.damping);
  ledger.book(Column::contact_edges,
              arriving.normal + arriving.tangential + normal_energy(list_->points[i], m) + tangential_energy(m));
}

void ExplicitContact::book_ended(std::size_t before, Ledger& ledger) const {
  const Left& a = left_[before];  // the pair ended: its springs are gone
  ledger.book(Column::contact_damping, -a.work.damping);
  ledger.book(Column::water, a.work.water);
  ledger.book(Column::contact_edges, a.work.normal + a.work.tangential);
  ledger.book(Column::springs_dropped, a.normal_energy() + a.tangential_energy());
}

bool ExplicitContact::on_ghost(const ContactPoint& p) const { return (ghost_[p.node[0]] | ghost_[p.node[1]]) != 0; }

void ExplicitContact::respond(double h, ContactList& list) {
  trial_.resize(list.points.size());
  opened_.resize(list.points.size());
  for (std::size_t i = 0; i < list.points.size(); ++i) (void)respond(h, i, list);
}

ExplicitContact::Rates ExplicitContact::respond(double h, std::size_t i, ContactList& list) {
  const ContactPoint& p = list.points[i];
  ContactMemory& m = list.memory[i];
  // The stretch that a spring would have here, also for one that opens now.
  trial_[i] = (p.at.xi - m.anchor) * p.at.length;
  const JointLaw& law = setup_->laws()[static_cast<std::size_t>(m.joint)];
  PointMotion motion = motion_of(p);
  Rates rates;
  motion.per_time = 1.0 / h;
  // A dashpot that begins to push where the contact closes could hold it open: then no position of the ghost body is
  // consistent with the dashpot's force. It acts from the next step on.
  if (m.status != ContactStatus::open || !on_ghost(p)) {
    motion.cn = p.cn;
    motion.ct = p.ct;
  }
  if ((m.gap < 0.0 || m.bonded != 0 || law.dilation > 0.0) && p.cn > 0.0 && !motion.held_elsewhere) {
    rates = rates_of(p, m.anchor, v_);
    motion.rate = rates.gap;
    motion.shear = rates.stretch;
  }
  const double gap0 = m.gap0;
  // Stages to rest have no physical velocities.
  if (m.status == ContactStatus::open && m.gap < 0.0 && !p.suppressed && !p.beyond && checks_friction_)
    finder_.begin_impact(p, -row_rate(p, gap_row(p.at), v_), m);
  explicit_law(law, setup_->laws().tan_friction(static_cast<std::size_t>(m.joint)), motion, m);
  opened_[i] = m.gap0 - gap0;
  if (m.status == ContactStatus::open)
    m.impact = 0.0;
  else
    m.impact = std::max(0.0, m.impact - h);
  return rates;
}

void ExplicitContact::leave_point(double h, std::size_t i) {
  left_[i] = left_by(h, list_->points[i], list_->memory[i]);
  weakened_[i] = {list_->memory[i].slip, list_->memory[i].friction_change};
}

void ExplicitContact::transfer_impact_energy(double h, const ContactPoint& p, const Left& was, ContactMemory& m) const {
  if (m.impact == 0.0 || !finder_.passed(p)) return;
  const double left = was.normal_energy() - was.work.normal;
  if (left <= 0.0) return;
  const double half_way = 0.5 * h * row_rate(p, gap_row(p.at), v_);
  const double gap = half_way - std::sqrt(half_way * half_way + 2.0 * left / m.kn);
  m.gap0 += m.gap - gap;
  m.gap = gap;
}

double ExplicitContact::slip_in_step(std::size_t i, const Left& was) const {
  const ContactMemory& m = list_->memory[i];
  if (m.status == ContactStatus::slip) return trial_[i] - m.stretch;
  const ContactPoint& p = list_->points[i];
  const bool hops = m.status == ContactStatus::open && m.slide.length > 0.0F && p.from >= 0;
  return hops && was.segment == p.segment ? (p.at.xi - was.foot) * p.at.length : 0.0;
}

void ExplicitContact::follow_slides(double h, double time) {
  friction_check_.begin(*list_, time);
  const Left none;
  for (std::size_t i = 0; i < list_->points.size(); ++i) {
    const std::int32_t from = list_->points[i].from;
    friction_check_.see(h, list_->points[i], slip_in_step(i, from < 0 ? none : left_[static_cast<std::size_t>(from)]),
                        list_->memory[i]);
  }
}

void ExplicitContact::adopt_kinds(double h, std::span<const std::int32_t> points, Ledger& ledger) {
  // A new kind moves the anchor, the point of the edge where the friction force acts in the other half of the kick.
  anchor_.clear();
  double change = 0.0;
  for (const std::int32_t i : points) {
    const auto at = static_cast<std::size_t>(i);
    anchor_.push_back({i, list_->memory[at].anchor});
    finder_.adopt_kind(list_->points[at], list_->memory[at], change);
  }
  ledger.book(Column::contact_tributary, change);
  for (const Anchor& a : anchor_) {
    const ContactPoint& p = list_->points[static_cast<std::size_t>(a.point)];
    const ContactMemory& m = list_->memory[static_cast<std::size_t>(a.point)];
    if (m.anchor == a.before || m.ft == 0.0) continue;
    const double way =
        0.5 * h * (row_rate(p, stretch_row(p.at, m.anchor), v_) - row_rate(p, stretch_row(p.at, a.before), v_));
    ledger.book(Column::contact_geometry, (m.ft - m.fdt) * way);
    ledger.book(Column::contact_damping, -m.fdt * way);
  }
}

void ExplicitContact::arrive(double h, double farthest, std::span<const double> q, std::span<const double> v,
                             State& state) {
  if (list_ != &state.contacts) {
    list_ = &state.contacts;
    indexed_ = false;
  }
  clear_ -= farthest;
  if (clear_ > 0.0) return;  // there are no points and there will be none
  forces_taken_ = false;
  set_velocities(v, v_);
  if (!indexed_) finder_.index(*list_);
  indexed_ = in_place_ = finder_.keeps(q, *list_) && !list_->points.empty() && !always_anew_;
  steps_in_place_ += in_place_ ? 1 : 0;
  left_.resize(list_->points.size());
  weakened_.resize(list_->points.size());
  if (in_place_)
    arrive_in_place(h, state);
  else
    arrive_anew(h, state);
  clear_ = list_->points.empty() && before_.points.empty() ? finder_.clearance() : 0.0;
}

void ExplicitContact::arrive_anew(double h, State& state) {
  Ledger& ledger = state.ledger;
  for (std::size_t i = 0; i < list_->points.size(); ++i) leave_point(h, i);
  std::swap(*list_, before_);
  finder_.find_again(before_, *list_);
  for (std::size_t i = 0; i < list_->points.size(); ++i)
    if (const std::int32_t from = list_->points[i].from; from >= 0)
      transfer_impact_energy(h, list_->points[i], left_[static_cast<std::size_t>(from)], list_->memory[i]);
  respond(h, *list_);
  if (checks_friction_) {  // velocities are physical
    follow_slides(h, seconds(state.time));
    friction_evolution_.advance(h, list_->memory);
  }
  for_points(ledger, [&](std::size_t begin, std::size_t end, Chunk& chunk) {
    for (std::size_t b = begin; b < end; ++b) {
      const ContactPoint& p = list_->points[b];
      const Half arriving = half_work(h, p, list_->memory[b], v_, {});
      if (ContactFinder::may_adopt(p, list_->memory[b])) chunk.kinds.push_back(static_cast<std::int32_t>(b));
      if (p.from >= 0)
        book_pair(left_[static_cast<std::size_t>(p.from)], b, arriving, chunk.ledger);
      else
        book_new(b, arriving, chunk.ledger);
    }
  });
  kept_.assign(before_.points.size(), 0);
  for (const ContactPoint& p : list_->points)
    if (p.from >= 0) kept_[static_cast<std::size_t>(p.from)] = 1;
  for (std::size_t i = 0; i < before_.points.size(); ++i)
    if (kept_[i] == 0) book_ended(i, ledger);
  // Energy of springs that closed points have taken over: subtracted where it was booked as dropped, and where the
  // points that took it changed.
  ledger.book(Column::springs_dropped, -finder_.merged());
  ledger.book(Column::contact_geometry, -finder_.merged());
  adopt_kinds(h, kinds_, ledger);
  ledger.set(Column::contact_springs, contact_energy(*list_));
}

void ExplicitContact::make_way(double h) {
  for (const Changed& c : finder_.changed())
    for (std::int32_t k = c.begin; k < c.end; ++k) leave_point(h, static_cast<std::size_t>(k));
  if (!finder_.changed().empty()) finder_.splice(*list_);
  finder_.find_first();
  left_first_.clear();
  for (const std::int32_t k : finder_.moves_first()) {
    const auto i = static_cast<std::size_t>(k);
    const ContactPoint& p = list_->points[i];
    if (finder_.made(i)) {
      left_first_.push_back(p.from < 0 ? Left{} : left_[static_cast<std::size_t>(p.from)]);
      continue;
    }
    left_first_.push_back(left_by(h, p, list_->memory[i]));
    finder_.move(i, *list_);
  }
  finder_.settle(*list_);
}

bool ExplicitContact::stays_open(const Left& was, std::size_t i) const {
  const ContactPoint& p = list_->points[i];
  const ContactMemory& m = list_->memory[i];
  return was.open && m.bonded == 0 && m.slide.length == 0.0F && m.water == 0.0 && was.work.water == 0.0 &&
         (p.suppressed || p.beyond || m.gap >= 0.0);
}

void ExplicitContact::arrive_point(double h, std::size_t i, Chunk& chunk) {
  const ContactPoint& p = list_->points[i];
  ContactMemory& m = list_->memory[i];
  const Left left = left_by(h, p, m);
  finder_.move(i, *list_);
  weakened_[static_cast<std::size_t>(p.from)] = {m.slip, m.friction_change};
  if (stays_open(left, i)) {
    m.impact = 0.0;
    energy_[i] = 0.0;
    node_forces_.take(i, p, m);
    finder_.note(i, m);
    return;
  }
  complete_point(h, i, left, chunk);
}

void ExplicitContact::arrive_first(double h, std::size_t i, const Left& left, Chunk& chunk) {
  const ContactPoint& p = list_->points[i];
  ContactMemory& m = list_->memory[i];
  if (finder_.made(i))
    transfer_impact_energy(h, p, left, m);
  else
    weakened_[static_cast<std::size_t>(p.from)] = {m.slip, m.friction_change};
  complete_point(h, i, left, chunk);
}

void ExplicitContact::complete_point(double h, std::size_t i, const Left& left, Chunk& chunk) {
  const ContactPoint& p = list_->points[i];
  ContactMemory& m = list_->memory[i];
  const Rates rates = respond(h, i, *list_);
  if (checks_friction_) {  // velocities are physical
    const double slip = slip_in_step(i, left);
    if (!friction_check_.goes_on(h, slip, m)) chunk.slides.push_back({static_cast<std::int32_t>(i), slip});
  }
  const Half arriving = half_work(h, p, m, v_, rates);
  if (p.from >= 0)
    book_pair(left, i, arriving, chunk.ledger);
  else
    book_new(i, arriving, chunk.ledger);
  if (ContactFinder::may_adopt(p, m)) chunk.kinds.push_back(static_cast<std::int32_t>(i));
  energy_[i] = normal_energy(p, m) + tangential_energy(m);
  node_forces_.take(i, p, m);
  finder_.note(i, m);
}

void ExplicitContact::arrive_in_place(double h, State& state) {
  make_way(h);
  Ledger& ledger = state.ledger;
  const std::size_t size = list_->points.size();
  for (auto* of_point : {&trial_, &opened_, &energy_}) of_point->resize(size);
  node_forces_.begin(size);
  const std::span<const std::int32_t> first = finder_.moves_first();
  // All else is done point by point, while the point is in the cache: the whole list does not fit.
  for_points(ledger, [&](std::size_t begin, std::size_t end, Chunk& chunk) {
    node_forces_.begin_chunk(begin);
    auto waiting = std::lower_bound(first.begin(), first.end(), static_cast<std::int32_t>(begin));
    for (std::size_t i = begin; i < end; ++i) {
      if (waiting != first.end() && static_cast<std::size_t>(*waiting) == i)
        arrive_first(h, i, left_first_[static_cast<std::size_t>(waiting++ - first.begin())], chunk);
      else
        arrive_point(h, i, chunk);
    }
  });
  for (const Changed& c : finder_.changed())
    for (std::int32_t k = c.begin; k < c.end; ++k)
      if (finder_.gone(static_cast<std::size_t>(k))) book_ended(static_cast<std::size_t>(k), ledger);
  if (checks_friction_) follow_some(h, state);
  adopt_kinds(h, kinds_, ledger);
  for (const std::int32_t k : kinds_) {
    const auto i = static_cast<std::size_t>(k);
    energy_[i] = normal_energy(list_->points[i], list_->memory[i]) + tangential_energy(list_->memory[i]);
    node_forces_.take(i, list_->points[i], list_->memory[i]);
    finder_.note(i, list_->memory[i]);
  }
  forces_taken_ = true;
  finder_.take_noted(*list_);
  double energy = 0.0;
  for (const double e : energy_) energy += e;
  ledger.set(Column::contact_springs, energy);
}

void ExplicitContact::follow_some(double h, State& state) {
  friction_check_.begin(*list_, seconds(state.time));
  for (const Slide& s : slides_) {
    const auto i = static_cast<std::size_t>(s.point);
    friction_check_.see(h, list_->points[i], s.way, list_->memory[i]);
  }
  if (friction_evolution_.used()) friction_evolution_.advance(h, list_->memory);
}

}  // namespace scree::coupling
