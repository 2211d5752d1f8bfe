#include "coupling/integrate/newmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <utility>

#include "model/parallel.h"

namespace scree::coupling {
Newmark::Newmark(const Setup& setup, const StepControl& control, double detection, const ImplicitOptions& options)
    : setup_(&setup),
      control_(control),
      options_(options),
      finder_(setup, detection),
      friction_check_(setup),
      friction_evolution_(setup.laws().all()),
      system_(setup),
      contacts_(setup, control, system_, options.scheme == NewmarkScheme::damped, options.factor),
      sliding_(setup, velocity_is_physical() ? options.sliding_damping : 0.0),
      stacks_(setup, sliding_),
      damper_(setup, system_),
      interface_(setup, system_),
      bolts_(setup, system_) {
  driven_move_.resize(setup.bodies().size());
  weight_.assign(2 * static_cast<std::size_t>(setup.nodes()), 0.0);
  for (std::size_t p = 0; p < setup.pools(); ++p)
    setup.pool(p).body_force(setup.model().gravity, setup.part(std::span<double>(weight_), p));
  const auto make = [&](std::initializer_list<std::vector<double>*> vectors) {
    for (auto* v : vectors) v->assign(static_cast<std::size_t>(system_.dofs()), 0.0);
  };
  make({&gravity_, &load_, &release_load_, &inertia_, &force_before_, &force_, &force_after_, &d_, &rate_, &rhs_,
        &out_});
  if (trapezoidal()) make({&load_before_, &acceleration_});
  if (options.damping > 0.0) make({&damped_before_.mass, &damped_after_.mass});
  if (options.stiffness_damping > 0.0) make({&damped_before_.stiffness, &damped_after_.stiffness});
  K_.assign(system_.pattern().size(), 0.0);
  A_ = K_;
  const auto nonlinear = system_.nonlinear_dofs();
  tangent_may_stay_ = system_.constant_charts() &&
                      std::all_of(nonlinear.begin(), nonlinear.end(), [](double is) { return is != 0.0; }) &&
                      options.stiffness_damping == 0.0 &&
                      (options.factor == OpenClose::Factor::kept || options.factor == OpenClose::Factor::chosen);
}

void Newmark::enter_stage(const State& state) {
  supports_ = point_springs(*setup_, state);
  dashpots_ = dashpots(*setup_, state);
  bolts_.enter(state);
  loads_ = load_vectors(*setup_, state);
  release_ = SupportRelease(*setup_, state);
  contacts_.enter(state.factored);
  tangent_ = {};
  start_ = {};
  interface_.kept() = {};
  has_end_ = has_tangent_ = renew_ = false;
  clear_ = 0.0;
  reference_.assign(state.q.size(), 0.0);
  node_scratch_.assign(state.q.size(), 0.0);
  for (const Body& b : setup_->bodies()) {
    AffineMotion still;
    still.c = b.centre;
    const auto p = static_cast<std::size_t>(b.pool);
    setup_->pool_of(b).place(b.index, still, setup_->part(std::span<double>(reference_), p),
                             setup_->part(std::span<double>(node_scratch_), p));
  }
  system_.find_units(reference_);
}

void Newmark::resume(State& state, const IntegratorMemory& memory) {
  enter_stage(state);
  list_ = &state.contacts;
  list_->find_briefs();
  tangent_ = memory.tangent;
  start_ = memory.start;
  interface_.kept() = memory.iterates;
}

double Newmark::enter(State& state) {
  enter_stage(state);
  list_ = &state.contacts;
  finder_.restore(list_->memory, before_);
  for (ContactMemory& m : before_.memory) m.impact = 0.0;  // springs follow the joint from step to step
  if (friction_evolution_.used()) FrictionEvolution::skip(before_.memory);
  finder_.find(state.q, before_, state.step == 0, *list_);
  list_->shrink_to_fit();
  before_ = {};                       // rarely needed in steps, and large
  (void)finder_.adopt_kinds(*list_);  // the energy returned below includes its change
  if (!checks_friction()) FrictionCheck::forget(*list_);
  state.last_step = 0;
  if (trapezoidal()) {
    if (state.a.empty()) {
      // M a = f - C v at the start: the residual of a step at zero displacement.
      state.a.assign(state.q.size(), 0.0);
      prepare(state, 1.0);
      find_step_springs(state, 1.0);
      contacts_.begin(*list_, state.q, driven_move_, springs_);
      std::fill(d_.begin(), d_.end(), 0.0);
      for (std::size_t i = 0; i < rhs_.size(); ++i)
        rhs_[i] = damped_before_.added_to(gravity_[i] + load_before_[i] + force_before_[i], i);
      // For a dashpot k at = -c v, see StepSprings.
      for (std::size_t k = 0; k < springs_.size(); ++k)
        springs_.rows[k].add_force((k < 2 * supports_.size() ? -1.0 : 1.0) * springs_.k[k] * springs_.at[k], rhs_);
      Cholesky mass;
      mass.set_pattern(system_.pattern());
      if (mass.factorise(system_.mass(), DofRows(), {})) mass.solve(rhs_, acceleration_);
      system_.node_accelerations(acceleration_, state.a);
    }
  } else {
    state.a.assign(interface_.acts() ? state.q.size() : 0, 0.0);
  }
  return contact_energy(*list_);
}

void Newmark::leave(State& state) {
  update_ledger(state);
  state.last_step = 0;  // this scheme has no shadow energy
  state.factored = {};
  state.a.clear();
  state.contacts.forget_points();
}

double Newmark::stable_step(const State&, std::string*) { return std::numeric_limits<double>::infinity(); }

double Newmark::kinetic_energy(const State& state) const {
  double kinetic = 0.0;
  for (const std::size_t p : setup_->own_pools())
    kinetic += setup_->pool(p).kinetic_energy(setup_->part(std::span<const double>(state.q), p),
                                              setup_->part(std::span<const double>(state.v), p), setup_->counted(p));
  return kinetic;
}

void Newmark::update_ledger(State& state) { state.ledger.set(Column::kinetic, kinetic_energy(state)); }

void Newmark::contact_forces(const State&, std::span<double> f) const {
  for (std::size_t i = 0; i < list_->points.size(); ++i) {
    const ContactPoint& p = list_->points[i];
    const ContactMemory& m = list_->memory[i];
    if (m.status == ContactStatus::open && m.water == 0.0) continue;
    add_row_force(setup_->outlines(), p, gap_row(p.at), m.fn + m.water, f);
    add_row_force(setup_->outlines(), p, stretch_row(p.at, m.anchor), m.ft, f);
  }
}

void Newmark::prepare(const State& state, double h) {
  const std::span<const double> q(state.q);
  const double t0 = seconds(state.time);
  for (std::size_t i = 0; i < driven_move_.size(); ++i) {
    const Body& b = setup_->bodies()[i];
    driven_move_[i] =
        b.driven ? Vec2(setup_->driven_displacement(b, t0 + h) - setup_->driven_displacement(b, t0)) : Vec2(0.0, 0.0);
  }
  system_.compute_masses(q, state.v);
  find_sliding(state, h);
  const auto to_dofs = [&](std::span<const double> nodes, std::vector<double>& out) {
    std::fill(out.begin(), out.end(), 0.0);
    system_.add_forces(nodes, q, out);
  };
  to_dofs(weight_, gravity_);
  const auto loads_at = [&](double t, std::vector<double>& out) {
    node_scratch_.assign(q.size(), 0.0);
    add_loads(*setup_, loads_, t, node_scratch_);
    add_incoming_waves(*setup_, dashpots_, t, trapezoidal() ? std::span<const double>(reference_) : q, node_scratch_);
    to_dofs(node_scratch_, out);
  };
  if (!loads_.empty() || !dashpots_.empty()) {
    loads_at(t0 + h, load_);
    if (trapezoidal()) loads_at(t0, load_before_);
  }
  if (release_.acts()) {
    if (loads_.empty() && dashpots_.empty()) std::fill(load_.begin(), load_.end(), 0.0);
    node_scratch_.assign(q.size(), 0.0);
    release_.add(t0 + h, node_scratch_);
    to_dofs(node_scratch_, release_load_);
    for (std::size_t i = 0; i < load_.size(); ++i) load_[i] += release_load_[i];
  }
  keep_ = keep_ && !damper_.acts();
  made_ = !keep_;
  if (keep_ && !has_tangent_) take_tangent(state, h);
  if (keep_ && has_end_) {  // the last step ended with them
    force_before_ = force_after_;
    energy_before_ = energy_after_;
  } else {
    energy_before_ = system_.linearise(q, Stiffness::exact, true, keep_ ? std::span<double>{} : K_, force_before_);
  }
  // Inertia of the known terms: M (2 v/h), or M (4 v/h + a).
  if (trapezoidal()) system_.accelerations(q, state.a, acceleration_);
  for (std::size_t i = 0; i < rhs_.size(); ++i)
    rhs_[i] = trapezoidal() ? 4.0 / h * system_.rate()[i] + acceleration_[i] : 2.0 / h * system_.rate()[i];
  system_.pattern().multiply(system_.mass(), rhs_, inertia_);
  prepare_damping(state);
}

void Newmark::find_sliding(const State& state, double h) {
  damper_.clear();
  if (!sliding_.used()) return;
  sliding_.begin();
  sliding_.count(setup_->outlines(), *list_);
  if (list_elsewhere_ != nullptr) sliding_.count(*outlines_elsewhere_, *list_elsewhere_);
  if (sliding_.find()) damper_.find(state.q, sliding_.rates(), 2.0 / h);
}

void Newmark::prepare_damping(const State& state) {
  C_.clear();
  if (options_.stiffness_damping > 0.0) {
    C_.assign(K_.size(), 0.0);
    (void)system_.linearise(state.q, Stiffness::material, true, C_, out_);
    for (double& c : C_) c *= options_.stiffness_damping;
  }
  damping_forces(state, system_.rate(), damped_before_);
}

void Newmark::damping_forces(const State& state, std::span<const double> rate, Damping& out) {
  std::fill(out.mass.begin(), out.mass.end(), 0.0);
  std::fill(out.stiffness.begin(), out.stiffness.end(), 0.0);
  if (damper_.acts()) {
    out.sliding.assign(rate.size(), 0.0);
    damper_.add_force(-1.0, rate, out.sliding);
  }
  if (!C_.empty()) system_.pattern().multiply_add(-1.0, C_, rate, out.stiffness);
  if (options_.damping > 0.0) {
    system_.pattern().multiply_add(-options_.damping, system_.mass(), rate, out.mass);
    add_affine_damping(state, rate, out.mass);
  }
}

void Newmark::add_affine_damping(const State& state, std::span<const double> rate, std::span<double> out) {
  // Mass damping that excludes affine motion: C includes a M v, and this adds a M v_affine = a M v - a M w.
  if (options_.damping == 0.0 || options_.damp_rigid_motion) return;
  system_.pattern().multiply_add(options_.damping, system_.mass(), rate, out);
  const std::vector<double> still(rate.size(), 0.0);
  node_scratch_ = state.q;
  node_scratch2_.assign(state.q.size(), 0.0);
  system_.retract(still, rate, true, node_scratch_, node_scratch2_);
  node_scratch_.assign(state.q.size(), 0.0);
  node_scratch3_.assign(state.q.size(), 0.0);
  for (const std::size_t p : setup_->own_pools())
    setup_->pool(p).damp(1.0, options_.damping, setup_->part(std::span<const double>(state.v), p),
                         setup_->part(std::span<double>(node_scratch2_), p),
                         setup_->part(std::span<double>(node_scratch_), p),
                         setup_->part(std::span<double>(node_scratch3_), p));
  system_.add_forces(node_scratch_, state.q, out);
}

void Newmark::find_step_springs(const State& state, double h) {
  const bool was_still = std::exchange(
      still_, std::all_of(driven_move_.begin(), driven_move_.end(), [](const Vec2& move) { return move.isZero(0.0); }));
  if (keep_ && has_end_ && was_still && still_) {  // as in the last step, but for the elongation of supports
    std::size_t k = 0;
    for (const PointSpring& s : supports_)
      for (int d = 0; d < 2; ++d) springs_.at[k++] = s.axes.col(d).dot(position(s.row, state.q) - s.anchor);
    return;
  }
  springs_.clear();
  const auto begin = [&](double k, double at) {
    springs_.rows.begin_row();
    springs_.k.push_back(k);
    springs_.at.push_back(at);
  };
  const auto add = [&](BodyIndex body, const Row& row, const Vec2& direction) {
    if (setup_->body(body).driven)
      springs_.rows.add_known(direction.dot(driven_move_[body.index()]));
    else
      ImplicitSystem::add_point(system_.chart(body, row, state.q), direction, springs_.rows);
  };
  for (const PointSpring& s : supports_) {
    const Vec2 u = position(s.row, state.q) - s.anchor;
    for (int d = 0; d < 2; ++d) {
      const Vec2 axis = s.axes.col(d);
      begin(s.k[d], axis.dot(u));
      add(s.body, s.row, axis);
    }
  }
  // A dashpot's force -c v', v' = 2 u/h - v.
  for (const Dashpot& p : dashpots_) {
    // The trapezoidal rule uses a force twice, at the end of one step and the start of the next: its axes are fixed.
    const std::span<const double> at = trapezoidal() ? std::span<const double>(reference_) : state.q;
    const Vec2 t = (position(p.stretch.b, at) - position(p.stretch.a, at)).normalized(), n(t.y(), -t.x());
    for (const double s : {p.stretch.from, p.stretch.to}) {
      const Vec2 v = p.stretch.at(s, state.v);
      for (const auto& [direction, c] : {std::pair(n, p.normal), std::pair(t, p.shear)}) {
        begin(2.0 * c / h, -0.5 * h * direction.dot(v));
        add(p.stretch.body, p.stretch.a, (1.0 - s) * direction);
        add(p.stretch.body, p.stretch.b, s * direction);
      }
    }
  }
  interface_springs_ = springs_.size();
  if (interface_.acts()) interface_.add_springs(state.q, driven_move_, springs_);
}

void Newmark::linear_system(double h) {
  constexpr std::int64_t kFewNumbers = 32768;
  parallel_for(
      std::ssize(A_),
      [&](std::int64_t at) {
        const auto k = static_cast<std::size_t>(at);
        A_[k] = mass_factor(h) * system_.mass()[k] + K_[k];
        if (!C_.empty()) A_[k] += 2.0 / h * C_[k];
        if (options_.damping > 0.0) A_[k] += 2.0 / h * options_.damping * system_.mass()[k];
      },
      kFewNumbers);
  damper_.add_matrix(A_);
  largest_ = {};
  for (const std::int32_t diagonal : std::span(system_.pattern().column_start).first(d_.size())) {
    largest_.system = std::max(largest_.system, A_[static_cast<std::size_t>(diagonal)]);
    largest_.bodies = std::max(largest_.bodies, K_[static_cast<std::size_t>(diagonal)]);
  }
}

StepReport Newmark::lost(const StepReport& report, const LostPlace& place, const State& state, double h) {
  StepReport out = report;
  const StepReport found = lost_state(place, seconds(state.time) + h);
  out.status = found.status;
  out.body = found.body;
  out.cause = found.cause;
  return out;
}

bool Newmark::reach(const State& state, Tick ticks_of_step, StepReport& report) {
  // Every body is retracted, then the displacement of its outline is found.
  const double h = seconds(ticks_of_step);
  q_new_ = state.q;
  v_new_ = state.v;
  for (std::size_t i = 0; i < d_.size(); ++i) rate_[i] = 2.0 / h * d_[i] - system_.rate()[i];
  if (interface_.acts()) interface_.kick(h, rate_);
  system_.retract(d_, rate_, true, q_new_, v_new_);
  setup_->prescribe(seconds(state.time + ticks_of_step), q_new_, v_new_);
  double& farthest = farthest_;
  farthest = 0.0;
  const Outlines& o = setup_->outlines();
  for (const OutlineNode k : o.nodes.indices()) {
    const double u = (position(o.nodes[k], q_new_) - position(o.nodes[k], state.q)).norm();
    if (!(u <= farthest)) {
      farthest = u;
      report.body = o.node_body[k];
    }
  }
  if (farthest <= control_.max_displacement) {
    report.body = {};
    // Newton's method may balance an element that is turned inside out as well.
    const LostPlace place = lost_place(*setup_, q_new_);
    if (!place.body.valid()) return true;
    report = lost(report, place, state, h);
    report.status = StepReport::Status::no_balance;  // a shorter step may converge to the other balance
    return false;
  }
  report.status = std::isfinite(farthest) ? StepReport::Status::too_far : StepReport::Status::non_finite;
  report.suggested = std::isfinite(farthest) ? 0.9 * control_.max_displacement / farthest : 0.0;
  report.cause = std::isfinite(farthest) ? fmt::format("a point would move {:.3g} m in one step, {:.3g} m is allowed",
                                                       farthest, control_.max_displacement)
                                         : "a displacement is not finite";
  return false;
}

StepReport Newmark::step(State& state, Tick ticks_of_step) {
  StepReport report;
  const double h = seconds(ticks_of_step);
  renewed_ = std::exchange(renew_, false);
  keep_ = keeps_tangent(ticks_of_step) && !renewed_;
  prepare(state, h);
  const bool balanced = balance(state, h, report);
  if (made_) has_tangent_ = false;
  has_end_ = false;
  if (!balanced) return report;
  const LeftOver left = left_over(state);
  report.left_work = left.work;
  if (!reach(state, ticks_of_step, report)) return report;
  if (audit_ != nullptr) contacts_.check(d_, left.force, *audit_);
  if (interface_.acts()) keep_for_next_step(ticks_of_step, report.iterations);
  accept(state, ticks_of_step);
  if (audit_ != nullptr) audit_geometry(*setup_, *list_, state.q, finder_.detection(), *audit_);
  return report;
}

}  // namespace scree::coupling
