// State and ledger after an accepted implicit step.
#include <algorithm>
#include <cmath>

#include "coupling/contact/law/joint_strength.h"
#include "coupling/integrate/newmark.h"
#include "coupling/linear/vectors.h"
#include "model/parallel.h"

namespace scree::coupling {
namespace {

/// True if the normal spring of a point has a force at the end of the step: pressed, or pulled and still bonded.
bool loaded(const OpenClose::Trial& t, const ContactMemory& before) {
  return t.status != ContactStatus::open && (t.gap < 0.0 || (before.bonded != 0 && t.status == ContactStatus::stick));
}

/// Part of a point's normal force that is its spring's; the rest is the dashpot's [N].
double spring_force(const OpenClose::Trial& t, const ContactMemory& before) {
  return loaded(t, before) ? -before.kn * t.gap : 0.0;
}

}  // namespace

void Newmark::book_bodies(Ledger& ledger, Energies& after) {
  const auto mask = system_.nonlinear_dofs();
  ledger.book(Column::gravity, dot(gravity_, d_));
  if (!loads_.empty() || !dashpots_.empty())
    ledger.book(Column::loads, trapezoidal()     ? 0.5 * (dot(load_, d_) + dot(load_before_, d_))
                               : release_.acts() ? dot(load_, d_) - dot(release_load_, d_)
                                                 : dot(load_, d_));
  if (release_.acts()) ledger.book(Column::support_release, dot(release_load_, d_));
  // Bodies whose force is linear in the unknowns: U' - U = -f.d + 1/2 d.K.d.
  std::vector<double> linear(d_.size()), curved(d_.size());
  for (std::size_t i = 0; i < d_.size(); ++i) {
    linear[i] = mask[i] != 0.0 ? 0.0 : d_[i];
    curved[i] = mask[i] * d_[i];
  }
  system_.pattern().multiply(K_, linear, out_);
  const double damping = 0.5 * dot(linear, out_);
  if (!trapezoidal()) ledger.book(Column::newmark_damping, damping);
  after.elastic += -dot(force_before_, linear) + damping;
  if (system_.nonlinear()) {
    const double change = energy_after_ - energy_before_;
    after.elastic += change;
    if (trapezoidal())
      ledger.book(Column::elastic_trapezoid, change + 0.5 * (dot(force_before_, curved) + dot(force_after_, curved)));
    else
      ledger.book(Column::newmark_damping, -dot(force_after_, curved) - change);
  }
  system_.pattern().multiply(system_.mass(), rate_, out_);
  after.kinetic += 0.5 * dot(rate_, out_);
}

void Newmark::book_damping(Ledger& ledger) const {
  const auto work = [&](const std::vector<double>& before, const std::vector<double>& now) {
    return trapezoidal() ? 0.5 * (dot(before, d_) + dot(now, d_)) : dot(now, d_);
  };
  if (options_.damping > 0.0) ledger.book(Column::mass_damping, -work(damped_before_.mass, damped_after_.mass));
  if (!C_.empty()) ledger.book(Column::stiffness_damping, -work(damped_before_.stiffness, damped_after_.stiffness));
  if (damper_.acts()) ledger.book(Column::deformation_damping, -dot(damped_after_.sliding, d_));
}

void Newmark::book_springs(Ledger& ledger, Energies& after) const {
  for (std::size_t i = 0; i < interface_springs_; ++i) {
    const double u = springs_.rows[i].change(d_), k = springs_.k[i], at = springs_.at[i];
    if (i < 2 * supports_.size()) {
      if (!trapezoidal()) ledger.book(Column::newmark_damping, 0.5 * k * u * u);
      after.supports += 0.5 * k * (at + u) * (at + u);
    } else {  // a dashpot: its force at the start of the step was k at
      ledger.book(Column::viscous_edges, trapezoidal() ? 0.5 * k * u * u : -springs_.force(i, d_) * u);
    }
  }
}

void Newmark::book_contact(std::size_t i, Ledger::Booking& booking) const {
  const OpenClose::Trial& t = contacts_.trials()[i];
  const ContactMemory& m = list_->memory[i];
  const double known = (t.fn + m.water) * contacts_.normal(i).known + t.ft * contacts_.tangential(i).known;
  if (known != 0.0) booking.book(Column::prescribed_motion, -known);
  if (m.water != 0.0) booking.book(Column::water, m.water * contacts_.normal(i).change(d_));
  // Normal: -(f dg + dU), split by cause; dg is that of the spring, without the opening by dilation.
  if (t.opened != 0.0) booking.book(Column::dilation, -t.fn * t.opened);
  const double g0 = m.gap, g1 = t.gap, dg = g1 - g0;
  // True if its energy was counted at the start of the step.
  const bool counted = (g0 < 0.0 || m.bonded != 0) && !list_->points[i].suppressed && !list_->points[i].beyond;
  const bool bond_broke = m.bonded != 0 && t.status == ContactStatus::open;
  if (const double damping = t.fn - spring_force(t, m); damping != 0.0)
    booking.book(Column::contact_damping, -damping * dg);
  if (loaded(t, m)) {
    if (counted)
      booking.book(Column::newmark_damping, 0.5 * m.kn * dg * dg);
    else
      booking.book(Column::contact_closing, 0.5 * m.kn * g1 * g1 - m.kn * g1 * g0);
  } else if (counted) {
    booking.book(bond_broke ? Column::bonds_broken : Column::contact_closing, 0.5 * m.kn * g0 * g0);
  }
  // Tangential.
  const double e0 = m.status == ContactStatus::open ? 0.0 : m.stretch, e1 = t.stretch;
  if (t.status == ContactStatus::open) {
    if (e0 != 0.0) booking.book(bond_broke ? Column::bonds_broken : Column::springs_dropped, 0.5 * m.kt * e0 * e0);
    return;
  }
  booking.book(Column::newmark_damping, 0.5 * m.kt * (e1 - e0) * (e1 - e0));
  if (t.status == ContactStatus::slip) booking.book(Column::friction, -t.ft * (e0 + t.moved - e1));
}

void Newmark::remember_contact(std::size_t i, const State& state, PointBooks::Chunk& chunk) {
  // A sticking point keeps its anchor in the material; that of a slipping one has the stretch at the friction limit, on
  // the new geometry.
  const OpenClose::Trial& t = contacts_.trials()[i];
  ContactMemory& m = list_->memory[i];
  const ContactPoint& p = list_->points[i];
  m.fd = t.fn - spring_force(t, m);
  linear_[i] = {m.kn, m.kt,
                0.5 * m.kn * (loaded(t, m) ? t.gap * t.gap : 0.0) +
                    (t.status == ContactStatus::open ? 0.0 : 0.5 * m.kt * t.stretch * t.stretch)};
  const JointLaw& law = setup_->laws()[static_cast<std::size_t>(m.joint)];
  if (m.bonded != 0 && t.status == ContactStatus::open) mark_failed(law, m);
  double slip = 0.0;
  if (t.status == ContactStatus::slip) {
    const Outlines& o = setup_->outlines();
    const double before = m.status == ContactStatus::open ? 0.0 : m.stretch;
    slip = before + t.moved - t.stretch;
    m.slip += std::abs(slip);
    m.gap0 += t.opened;
    mark_failed(law, m);
    const ContactGeometry g =
        contact_geometry(position(o.nodes[p.node[0]], state.q), position(o.nodes[p.node[1]], state.q),
                         position(o.nodes[p.node[2]], state.q));
    m.anchor = g.xi - t.stretch / g.length;
  }
  if (t.status == ContactStatus::open && m.slide.length > 0.0F) slip = t.moved;  // the block hops while it slides
  m.status = t.status;
  m.fn = t.fn;
  m.fdt = 0.0;
  m.ft = t.ft;
  if (checks_friction() && !friction_check_.goes_on(seconds(state.last_step), slip, m))
    chunk.slides.emplace_back(i, slip);
}

void Newmark::leave_contacts(State& state) {
  linear_.resize(contacts_.trials().size());
  books_.book(linear_.size(), true, state.ledger,
              [&](std::size_t i, Ledger::Booking& booking, PointBooks::Chunk& chunk) {
                book_contact(i, booking);  // both at once, while the point is in the cache
                remember_contact(i, state, chunk);
              });
  if (!checks_friction()) return;
  friction_check_.begin(*list_, seconds(state.time));
  for (const PointBooks::Chunk& chunk : books_.chunks())
    for (const auto& [i, slip] : chunk.slides)
      friction_check_.see(seconds(state.last_step), list_->points[i], slip, list_->memory[i]);
  friction_evolution_.advance(seconds(state.last_step), list_->memory);
}

bool Newmark::move_points(std::span<const double> q) {
  const bool was_clear = clear_ > 0.0;
  clear_ -= farthest_;
  if (clear_ > 0.0 && !always_anew_) return true;  // there are no points and there will be none
  finder_.index(*list_, !always_anew_ && !was_clear);
  if (!finder_.keeps(q, *list_) || list_->points.empty() || always_anew_) {
    const bool none = list_->points.empty();
    std::swap(*list_, before_);
    finder_.find_again(before_, *list_);
    clear_ = none && list_->points.empty() ? finder_.clearance() : 0.0;
    return false;
  }
  ++steps_in_place_;
  if (!finder_.changed().empty()) finder_.splice(*list_);
  finder_.find_first();
  const std::span<const std::int32_t> first = finder_.moves_first();
  for (const std::int32_t i : first)
    if (!finder_.made(static_cast<std::size_t>(i))) finder_.move(static_cast<std::size_t>(i), *list_);
  finder_.settle(*list_);
  constexpr std::int64_t kFewMoved = 1024;  // fewer points are moved on one thread
  parallel_for_chunks(
      std::ssize(list_->points),
      [&](std::int64_t begin, std::int64_t end) {
        auto moved = std::lower_bound(first.begin(), first.end(), static_cast<std::int32_t>(begin));
        for (std::int64_t i = begin; i < end; ++i)
          if (moved != first.end() && *moved == i)
            ++moved;
          else
            finder_.move(static_cast<std::size_t>(i), *list_);
      },
      kFewMoved, kContactChunk);
  return true;
}

void Newmark::book_point_update(std::size_t i, Ledger::Booking& booking, PointBooks::Chunk& chunk) {
  const ContactPoint& p = list_->points[i];
  const ContactMemory& m = list_->memory[i];
  const double now = normal_energy(p, m) + tangential_energy(m);
  chunk.energy += now;
  chunk.adopts = chunk.adopts || ContactFinder::may_adopt(p, m);
  if (p.from < 0) {
    if (now != 0.0) booking.book(Column::contact_edges, now);
    return;
  }
  Linear& before = linear_[static_cast<std::size_t>(p.from)];
  double with_old_tributary = now;
  if (before.kn != m.kn || before.kt != m.kt) {
    with_old_tributary = normal_energy(p, m, before.kn) + tangential_energy(m, before.kt);
    booking.book(Column::contact_tributary, now - with_old_tributary);
  }
  booking.book(Column::update_contact, with_old_tributary - before.energy);
  before.energy = 0.0;
}

void Newmark::book_contact_update(State& state) {
  const bool in_place = move_points(state.q);  // then no two points come from the same one
  Ledger& ledger = state.ledger;
  books_.book(list_->points.size(), in_place, ledger,
              [this](std::size_t i, Ledger::Booking& booking, PointBooks::Chunk& chunk) {
                book_point_update(i, booking, chunk);
              });
  for (const Linear& left : linear_)  // of contacts that ended
    if (left.energy != 0.0) ledger.book(Column::springs_dropped, left.energy);
  double energy = 0.0;
  bool adopts = false;
  for (const PointBooks::Chunk& chunk : books_.chunks()) {
    energy += chunk.energy;
    adopts = adopts || chunk.adopts;
  }
  if (adopts) {
    ledger.book(Column::contact_tributary, finder_.adopt_kinds(*list_));
    energy = contact_energy(*list_);
  }
  ledger.set(Column::contact_springs, energy);
}

void Newmark::book_update(State& state, const Energies& after) {
  Ledger& ledger = state.ledger;
  double elastic = 0.0, kinetic = 0.0, supports = 0.0;
  q_new_.assign(state.q.size(), 0.0);  // scratch: of these forces only the energy is used
  for (const std::size_t p : setup_->own_pools())
    elastic += setup_->pool(p).internal_force(setup_->part(std::span<const double>(state.q), p),
                                              setup_->part(std::span<double>(q_new_), p));
  kinetic = kinetic_energy(state);
  for (const PointSpring& s : supports_) supports += spring_energy(s, state.q);
  ledger.set(Column::elastic, elastic);
  ledger.book(Column::update_elastic, elastic - after.elastic);
  ledger.set(Column::kinetic, kinetic);
  ledger.book(Column::update_kinetic, kinetic - after.kinetic);
  if (!supports_.empty()) {
    ledger.set(Column::support_springs, supports);
    ledger.book(Column::update_contact, supports - after.supports);
  }
  if (bolts_.any()) bolts_.accept(state, after.bolts);
  if (options_.dynamics == 1.0) return;
  const double kept = options_.dynamics * options_.dynamics;
  ledger.book(Column::rest_damping, (1.0 - kept) * kinetic);
  for (double& v : state.v) v *= options_.dynamics;
  setup_->prescribe(seconds(state.time), state.q, state.v);
  ledger.set(Column::kinetic, kept * kinetic);
}

void Newmark::accept(State& state, Tick ticks_of_step) {
  const double h = seconds(ticks_of_step);
  Energies after;
  after.elastic = state.ledger[Column::elastic];
  book_bodies(state.ledger, after);
  book_damping(state.ledger);
  book_springs(state.ledger, after);
  if (bolts_.any()) after.bolts = bolts_.book(d_, springs_, state.ledger);
  if (trapezoidal()) {
    for (std::size_t i = 0; i < d_.size(); ++i)
      acceleration_[i] = 4.0 / (h * h) * (d_[i] - h * system_.rate()[i]) - acceleration_[i];
    system_.node_accelerations(acceleration_, state.a);
  }

  if (interface_.acts()) interface_.book(iterate(state), h, rate_, state.ledger);
  if (interface_.acts() && !trapezoidal())  // start value of the next step
    for (std::size_t i = 0; i < state.a.size(); ++i) state.a[i] = (v_new_[i] - state.v[i]) / h;

  state.q.swap(q_new_);
  state.v.swap(v_new_);
  state.time += ticks_of_step;
  ++state.step;
  state.last_step = ticks_of_step;
  leave_contacts(state);
  book_contact_update(state);
  contacts_.accept(state.factored);
  book_update(state, after);
  if (damper_.acts() && stacks_.find(sliding_, setup_->outlines(), *list_)) damp_stacks(state, h);
}

void Newmark::damp_stacks(State& state, double h) {
  stacks_.act(setup_->outlines(), *list_, state.q, state.v, h);
  stacks_.add_acceleration(h, state.v);
  const double work = h * stacks_.power(), friction = h * stacks_.friction();
  state.ledger.book(Column::friction, -friction);
  state.ledger.book(Column::deformation_damping, friction - work);
  state.ledger.set(Column::kinetic, state.ledger[Column::kinetic] + work);
}

}  // namespace scree::coupling
