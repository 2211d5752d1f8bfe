#include "coupling/stages/driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "coupling/integrate/partitioned.h"
#include "coupling/stages/partition.h"

namespace scree::coupling {
namespace {

double wall() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }

constexpr double kLastPlaces = 1e-13;
constexpr double kOfAllowed = 0.95;  // of the displacement allowed a step: what is planned for
constexpr double kClosure = 1e-9;    // of the energy moved: what an audit lets the ledger be open by

constexpr const char* kUnsupported =
    "has no path of closed contacts to a support, so that nothing balances its weight and loads; likely causes: a gap "
    "under it, a support that is missing, or a stage that should not come to rest";

/// First multiple of `every` after `now`.
Tick next_multiple(Tick now, Tick every) {
  return every > 0 ? (now / every + 1) * every : std::numeric_limits<Tick>::max();
}

ExplicitDamping explicit_damping(const Stage& stage) {
  return {stage.damping, stage.damp_rigid_motion, stage.stiffness_damping, stage.local_damping};
}

double smallest_width(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (const Block& b : model.blocks) {
    const Moments m = moments(b.polygon);
    least = std::min(least, std::sqrt(m.area));
  }
  return least;
}

/// Throws where a body, or the scheme, cannot take the stage's implicit steps.
void check_implicit(const Stage& stage, const Setup& setup, std::span<const char> explicit_side) {
  const bool partitioned = stage.integrator == Integrator::partitioned;
  const auto refuse = [&](const std::string& why) {
    throw PlanError(fmt::format("stage '{}' is {}: {}", stage.name, partitioned ? "partitioned" : "implicit", why));
  };
  const bool trapezoidal = stage.newmark == NewmarkScheme::trapezoidal;
  if (partitioned && (trapezoidal || stage.rest))
    refuse("its implicit blocks take newmark = \"damped\", and it cannot run to rest");
  if (trapezoidal && (stage.rest || stage.dynamics != 1.0))
    refuse("the trapezoidal scheme carries accelerations along and cannot drop velocities; use newmark = \"damped\"");
  if (trapezoidal && stage.kinematics == Kinematics::corotational &&
      (stage.stiffness_damping > 0.0 || !setup.model().viscous_edges.empty()))
    refuse("the trapezoidal scheme takes stiffness damping and viscous edges with kinematics = \"linear\" only");
  if (trapezoidal && !setup.model().waters.empty())
    refuse("the trapezoidal scheme has no contacts, and so no water in joints; use newmark = \"damped\"");
  for (const Body& b : setup.bodies()) {
    if (b.driven || (partitioned && explicit_side[b.block.index()] != 0)) continue;
    const Pool& pool = setup.pool_of(b);
    const std::string block = setup.model().blocks[b.block.index()].name;
    if (const std::string obstacle = pool.implicit_obstacle(b.index); !obstacle.empty())
      refuse(fmt::format("block '{}': {}", block, obstacle));
    if (pool.dofs(b.index) == 0)
      refuse(fmt::format("block '{}' uses the method {}, which is explicit only", block, pool.method()));
    if (trapezoidal && !pool.constant_chart(b.index))
      refuse(
          fmt::format("block '{}' uses the method {}, whose unknowns turn with the block from step to step; the "
                      "trapezoidal scheme needs rotation = \"affine\", or the NMM",
                      block, pool.method()));
  }
}

}  // namespace

std::string_view name(EventKind kind) {
  switch (kind) {
    case EventKind::stage_start:
      return "stage_start";
    case EventKind::stage_step:
      return "stage_step";
    case EventKind::stage_end:
      return "stage_end";
    case EventKind::transfer:
      return "transfer";
    case EventKind::step_cut:
      return "step_cut";
    case EventKind::partition:
      return "partition";
    case EventKind::not_converged:
      return "not_converged";
    case EventKind::warning:
      return "warning";
  }
  return "unknown";
}

bool comes_often(std::string_view kind) {
  return kind == name(EventKind::step_cut) || kind == name(EventKind::transfer) || kind == name(EventKind::partition);
}

std::string_view name(Integrator integrator) {
  switch (integrator) {
    case Integrator::explicit_:
      return "explicit";
    case Integrator::implicit:
      return "implicit";
    case Integrator::partitioned:
      return "partitioned";
  }
  return "unknown";
}

double auto_detection(const Model& model) { return 0.05 * smallest_width(model); }

Driver::Driver(const Model& model, const Plan& plan, const Methods& methods)
    : model_(&model), plan_(&plan), methods_(&methods) {
  detection_ = plan.detection > 0.0 ? plan.detection : auto_detection(model);
  for (const Stage& s : plan.stages) end_ += s.duration;
}

void Driver::event(EventKind kind, std::string text, const TransferRow* row, const StageTravel* travel) {
  const Event e{kind, seconds(state_.time), std::move(text), row, travel};
  for (Sink* s : sinks_) s->event(e);
}

std::vector<Vec2> Driver::centres() const {
  std::vector<Vec2> out;
  for (const Body& b : setup_->bodies()) {
    const auto p = static_cast<std::size_t>(b.pool);
    out.push_back(setup_->pool_of(b)
                      .totals(b.index, setup_->part(std::span<const double>(state_.q), p),
                              setup_->part(std::span<const double>(state_.v), p))
                      .centre);
  }
  return out;
}

StageTravel Driver::travel_since(const std::vector<Vec2>& begin) const {
  StageTravel travel{plan_->stages[static_cast<std::size_t>(state_.stage)].name, {}, 0.0};
  const std::vector<Vec2> now = centres();
  for (std::size_t i = 0; i < now.size(); ++i) {
    const double moved = (now[i] - begin[i]).norm();
    if (setup_->bodies()[i].driven || (travel.block.valid() && moved <= travel.farthest)) continue;
    travel.block = setup_->bodies()[i].block;
    travel.farthest = moved;
  }
  return travel;
}

void Driver::look(bool frame) {
  const double begin = wall();
  mover_->update_ledger(state_);
  stats_.contacts = std::count_if(state_.contacts.begin(), state_.contacts.end(),
                                  [](const ContactMemory& m) { return m.status != ContactStatus::open; });
  const HistoryView history = observer_->history(state_, stats_);
  for (Sink* s : sinks_) s->history(history);
  if (frame && !sinks_.empty()) {
    FrameView view = observer_->frame(state_, stats_);
    const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
    view.stage_name = stage.name;
    view.integrator = stage.integrator;
    view.end_time = seconds(end_);
    for (Sink* s : sinks_) s->frame(view);
  }
  stats_.wall_output += wall() - begin;
}

void Driver::start() {
  state_ = State{};
  take_sides(plan_->stages.front());
  state_.bodies = initial_records(*model_, wishes(*model_, plan_->stages.front(), state_.explicit_side));
  setup_ = std::make_unique<Setup>(*model_, *methods_, state_.bodies);
  state_.q.assign(2 * static_cast<std::size_t>(setup_->nodes()), 0.0);
  state_.v = state_.q;
  for (const Body& b : setup_->bodies()) {
    AffineMotion m;
    m.c = b.centre;
    for (const InitialVelocity& i : model_->initial_velocities)
      if (i.block == b.block) {
        m.vc = i.velocity;
        m.Fdot = i.spin * quarter_turn();
      }
    const auto p = static_cast<std::size_t>(b.pool);
    setup_->pool_of(b).place(b.index, m, setup_->part(std::span<double>(state_.q), p),
                             setup_->part(std::span<double>(state_.v), p));
  }
  setup_->prescribe(0.0, state_.q, state_.v);
  double kinetic = 0.0;
  for (std::size_t p = 0; p < setup_->pools(); ++p)
    kinetic += setup_->pool(p).kinetic_energy(setup_->part(std::span<const double>(state_.q), p),
                                              setup_->part(std::span<const double>(state_.v), p), setup_->counted(p));
  state_.ledger.open(std::array{kinetic});
  stats_ = RunStats{};
  audit_ = Audit{};
  travels_.clear();
  stats_.blocks = static_cast<std::int64_t>(model_->blocks.size());
}

void Driver::take_sides(const Stage& stage) {
  state_.explicit_side.clear();
  if (stage.integrator == Integrator::partitioned) state_.explicit_side = first_sides(*model_, stage.partition);
}

void Driver::change_stage(std::size_t index) {
  const Stage& stage = plan_->stages[index];
  if (index > 0) {
    mover_->leave(state_);
    mover_.reset();
    take_sides(stage);
    change_bodies(stage);
    state_.stage = static_cast<std::int32_t>(index);
  }
  refuse_turned_blocks(stage);
  begin_moving(stage, true);
}

void Driver::change_bodies(const Stage& stage) {
  HandOver handed = hand_over(*model_, *methods_, *setup_, stage, state_);
  observer_.reset();
  setup_ = std::move(handed.setup);
  for (const TransferRow& row : handed.rows) {
    transfers_.push_back(row);
    event(
        EventKind::transfer,
        fmt::format("block '{}': {} -> {}, {:.4g} J kinetic and {:.3g} J elastic to the reservoir, energy error {:.1e}",
                    model_->blocks[row.block.index()].name, row.from, row.to, row.reservoir_kinetic,
                    row.reservoir_elastic, row.energy_error),
        &row);
  }
}

void Driver::begin_moving(const Stage& stage, bool new_mesh) {
  mover_ = make_mover(stage);
  const double springs = state_.ledger[Column::contact_springs];
  // Contacts measured on the new outlines; their energy may differ where a bent edge became a straight one.
  const double now = mover_->enter(state_);
  state_.ledger.set(Column::contact_springs, now);
  state_.ledger.book(Column::contact_edges, now - springs);
  observe(new_mesh);
}

void Driver::change_partition(const Stage& stage) {
  std::vector<char> sides = state_.explicit_side;
  if (!change_sides(*setup_, state_, stage.partition, sides)) return;
  std::string names;
  int changed = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == state_.explicit_side[i]) continue;
    if (++changed <= 5)
      names += fmt::format("{}'{}' {}", names.empty() ? "" : ", ", model_->blocks[i].name,
                           sides[i] != 0 ? "explicit" : "implicit");
  }
  mover_->leave(state_);
  mover_.reset();
  state_.explicit_side = std::move(sides);
  change_bodies(stage);
  begin_moving(stage, false);
  largest_ = 0;
  event(EventKind::partition, fmt::format("stage '{}': {}{}", stage.name, names,
                                          changed > 5 ? fmt::format(" and {} more", changed - 5) : std::string()));
}

std::unique_ptr<Mover> Driver::make_mover(const Stage& stage) {
  step_control_ = stage.control;
  if (!(step_control_.max_displacement > 0.0)) step_control_.max_displacement = 0.01 * smallest_width(*model_);
  // A point may not pass through the detection distance in one step.
  step_control_.max_displacement = std::min(step_control_.max_displacement, 0.5 * detection_);
  std::unique_ptr<Mover> mover;
  if (stage.integrator == Integrator::explicit_) {
    mover =
        std::make_unique<CentralDifference>(*setup_, step_control_, detection_, explicit_damping(stage), stage.rest);
  } else {
    check_implicit(stage, *setup_, state_.explicit_side);
    const ImplicitOptions options{stage.newmark, stage.rest ? 0.0 : stage.dynamics, stage.damping,
                                  stage.damp_rigid_motion, stage.stiffness_damping};
    if (stage.integrator == Integrator::implicit)
      mover = std::make_unique<Newmark>(*setup_, step_control_, detection_, options);
    else
      mover = std::make_unique<Partitioned>(
          *setup_, *methods_, state_, step_control_, detection_,
          Partitioned::Choice{explicit_damping(stage), options, stage.safety, stage.partition.substeps});
  }
  if (plan_->audit) mover->watch(&audit_);
  mover->heed(control_);
  return mover;
}

void Driver::observe(bool new_mesh) {
  const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
  observer_ =
      std::make_unique<Observer>(*setup_, state_, static_cast<std::uint32_t>(state_.stage) + 1, plan_->output.contacts);
  stats_.elements = static_cast<std::int64_t>(observer_->mesh().cell_block.size());
  stats_.unknowns = 0;
  for (const Body& b : setup_->bodies())
    if (!b.driven) stats_.unknowns += takes_explicit_steps(stage, b) ? 2 * b.nodes : setup_->pool_of(b).dofs(b.index);
  if (!new_mesh) return;
  for (Sink* s : sinks_) s->topology(observer_->mesh());
}

bool Driver::takes_explicit_steps(const Stage& stage, const Body& b) const {
  if (stage.integrator == Integrator::partitioned) return state_.explicit_side[b.block.index()] != 0;
  return stage.integrator == Integrator::explicit_;
}

void Driver::go_on() {
  Checkpoint& c = *from_;
  state_ = std::move(c.state);
  stage_end_ = c.stage_end;
  first_step_ = c.first_step;
  stage_begin_.clear();
  for (std::size_t i = 0; i + 1 < c.stage_begin.size(); i += 2)
    stage_begin_.emplace_back(c.stage_begin[i], c.stage_begin[i + 1]);
  rested_ = c.rested;
  largest_ = c.largest_step;
  audit_ = std::move(c.audit);
  transfers_ = std::move(c.transfers);
  travels_ = std::move(c.travels);
  const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
  setup_ = std::make_unique<Setup>(*model_, *methods_, state_.bodies);
  mover_ = make_mover(stage);
  mover_->resume(state_, c.mover);
  stats_ = c.stats;
  observe(true);
  from_.reset();
}

Checkpoint Driver::checkpoint() const {
  Checkpoint c;
  c.state = state_;
  c.mover = mover_->memory();
  c.stage_end = stage_end_;
  c.first_step = first_step_;
  for (const Vec2& x : stage_begin_) c.stage_begin.insert(c.stage_begin.end(), {x.x(), x.y()});
  c.rested = rested_;
  c.largest_step = largest_;
  c.stats = stats_;
  c.audit = audit_;
  c.transfers = transfers_;
  c.travels = travels_;
  return c;
}

void Driver::keep(bool in_any_case) {
  if (keeper_ == nullptr || !(in_any_case || keeper_->due(state_.step))) return;
  const double begin = wall();
  keeper_->keep(checkpoint());
  stats_.wall_output += wall() - begin;
}

void Driver::keep_checkpoint() {
  // Whoever goes on from here makes all attempts at the present step again.
  RunStats attempts = std::exchange(stats_, committed_);
  keep(true);
  attempts.wall_output = committed_.wall_output = stats_.wall_output;
  stats_ = attempts;
}

void Driver::refuse_turned_blocks(const Stage& stage) const {
  if (stage.kinematics != Kinematics::linear) return;
  constexpr double kMost = 0.01;  // [rad]; a rotation r reads as a strain r^2/2
  for (const Body& b : setup_->bodies()) {
    if (b.driven || setup_->pool_of(b).method() != "nmm") continue;
    const auto p = static_cast<std::size_t>(b.pool);
    const Mat2 R = polar_rotation(setup_->pool_of(b)
                                      .release(b.index, setup_->part(std::span<const double>(state_.q), p),
                                               setup_->part(std::span<const double>(state_.v), p))
                                      .motion.F);
    const double turn = std::atan2(R(1, 0), R(0, 0));
    if (std::abs(turn) <= kMost) continue;
    throw PlanError(
        fmt::format("t = {:.6g} s, stage '{}': block '{}' is turned by {:.3g} rad, and linear kinematics, which takes "
                    "rotations for strains, bears {:g} rad; use kinematics = \"corotational\"",
                    seconds(state_.time), stage.name, model_->blocks[b.block.index()].name, turn, kMost));
  }
}

BlockId Driver::unsupported_at_rest(const Stage& stage) {
  const BlockId loose = unsupported_block(*setup_, state_);
  // Contacts of explicit steps open for an instant while blocks still swing: without a criterion of rest that is told.
  if (loose.valid() && stage.integrator == Integrator::explicit_ && stage.rest_force == 0.0) {
    event(EventKind::warning,
          fmt::format("t = {:.6g} s, stage '{}': block '{}' touches nothing that leads to a support at its end",
                      seconds(state_.time), stage.name, model_->blocks[loose.index()].name));
    return {};
  }
  return loose;
}

Tick Driver::largest_step(const Stage& stage, bool first) {
  if (stage.integrator == Integrator::implicit) return ticks(*stage.dt);
  std::string binding;
  const double bound = mover_->stable_step(state_, &binding);
  if (stage.integrator == Integrator::partitioned) {
    const std::int32_t m = stage.partition.substeps;
    if (m > 0 && *stage.dt > m * bound && !stage.force_dt)
      throw PlanError(fmt::format(
          "t = {:.6g} s, stage '{}': explicit steps of {:.4g} s, {} in an implicit one, are above the certified stable "
          "one, {:.4g} s, bound by {}; leave substeps out, give {} or more, or force_dt = true to take them all the "
          "same",
          seconds(state_.time), stage.name, *stage.dt / m, m, bound, binding, std::ceil(*stage.dt / bound)));
    if (m > 0 && *stage.dt > m * bound && first)
      event(EventKind::warning,
            fmt::format("stage '{}': explicit steps of {:.4g} s, {} in an implicit one, are forced above the certified "
                        "stable one, {:.4g} s, bound by {}",
                        stage.name, *stage.dt / m, m, bound, binding));
    else if (first)
      event(
          EventKind::stage_step,
          std::isfinite(bound)
              ? fmt::format("stage '{}': steps of {:.4g} s, explicit ones of at most {:.4g} s; certified are {:.4g} s, "
                            "bound by {}",
                            stage.name, *stage.dt, m > 0 ? *stage.dt / m : std::min(*stage.dt, stage.safety * bound),
                            bound, binding)
              : fmt::format("stage '{}': steps of {:.4g} s; no block is explicit yet", stage.name, *stage.dt));
    return ticks(*stage.dt);
  }
  if (stage.dt) {
    if (*stage.dt > bound && !stage.force_dt)
      throw PlanError(fmt::format(
          "t = {:.6g} s, stage '{}': the explicit step {:.4g} s is above the certified stable one, {:.4g} s, bound by "
          "{}; use dt = \"auto\" or a smaller step, or force_dt = true to take it all the same",
          seconds(state_.time), stage.name, *stage.dt, bound, binding));
    if (*stage.dt > bound && first)
      event(EventKind::warning,
            fmt::format("stage '{}': the explicit step {:.4g} s is forced above the certified stable one, {:.4g} s, "
                        "bound by {}",
                        stage.name, *stage.dt, bound, binding));
    return ticks(*stage.dt);
  }
  const double step = std::min(stage.safety * bound, 1.0);
  if (first)
    event(EventKind::stage_step, fmt::format("stage '{}': steps of {:.4g} s, {:g} of the certified bound, set by {}",
                                             stage.name, step, stage.safety, binding));
  return std::max<Tick>(1, ticks(step));
}

Tick Driver::step_of_fastest() const {
  double fastest = 0.0;
  const Outlines& o = setup_->outlines();
  for (std::size_t k = 0; k < o.nodes.size(); ++k) {
    if (!state_.explicit_side.empty() && state_.explicit_side[static_cast<std::size_t>(o.node_body[k])] != 0) continue;
    fastest = std::max(fastest, position(o.nodes[k], state_.v).squaredNorm());
  }
  const double step = kOfAllowed * step_control_.max_displacement / std::sqrt(fastest);
  return step < 1.0 ? std::max<Tick>(1, ticks(step)) : std::numeric_limits<Tick>::max();
}

RunEnd Driver::advance_to(const Stage& stage, Tick target) {
  const bool implicit = stage.integrator != Integrator::explicit_;
  if (largest_ == 0) largest_ = largest_step(stage, state_.step == first_step_);
  int cuts = 0;
  Tick attempt_cap = std::numeric_limits<Tick>::max();
  // A step that is given up leaves no trace: whoever goes on from here makes all its attempts again.
  committed_ = stats_;
  std::optional<Event> cut;  // told with the step that came of it
  const auto stopped = [&] {
    stats_ = committed_;
    return RunEnd{RunEnd::Status::interrupted, "stopped on request"};
  };
  const auto tell_cut = [&] {
    if (cut)
      for (Sink* s : sinks_) s->event(*cut);
    cut.reset();
  };
  while (state_.time < target) {
    if (control_ != nullptr && control_->stop_requested()) return stopped();
    if (stage.integrator == Integrator::partitioned && state_.step > first_step_ && cuts == 0) change_partition(stage);
    if (largest_ == 0 || !mover_->step_still_stable()) largest_ = largest_step(stage);
    Tick cap = std::min(largest_, attempt_cap);
    if (implicit) cap = std::min(cap, step_of_fastest());
    const Tick remaining = target - state_.time;
    const Tick h = remaining / ((remaining + cap - 1) / cap);  // equal parts of what remains
    const double begin = wall();
    const StepReport report = mover_->step(state_, h);
    (implicit ? stats_.wall_implicit : stats_.wall_explicit) += wall() - begin;
    stats_.iterations += report.iterations;
    stats_.passes += report.passes;
    stats_.switches += report.switches;
    stats_.factorisations += report.factorisations;
    stats_.updates += report.updates;
    stats_.corrections += report.corrections;
    if (report.status == StepReport::Status::given_up) return stopped();
    if (report.status == StepReport::Status::ok) {
      tell_cut();
      ++stats_.steps;
      if (!implicit) stats_.element_steps += static_cast<double>(stats_.elements);
      cuts = 0;
      attempt_cap = std::numeric_limits<Tick>::max();
      RunEnd found = check_audit(stage);
      committed_ = stats_;
      for (Sink* s : sinks_) s->step(seconds(state_.time), stats_, state_.ledger);
      if (found.status != RunEnd::Status::done) return found;
      if (balance_) {
        RunEnd rest = check_rest(stage, stage_end_);
        if (rest.status != RunEnd::Status::done || rested_) return rest;
      }
      if (state_.time < target) keep(false);  // at the target after what is looked at there
      continue;
    }
    ++stats_.cuts;
    const std::string where =
        report.body >= 0
            ? fmt::format("block '{}', ",
                          model_->blocks[setup_->bodies()[static_cast<std::size_t>(report.body)].block.index()].name)
            : std::string();
    const std::string text = fmt::format("{}step {:.4g} s: {}", where, seconds(h), report.cause);
    const bool hopeless =
        report.status == StepReport::Status::non_finite || report.status == StepReport::Status::refused;
    if (hopeless || ++cuts > step_control_.max_cuts || h <= 3) {
      const auto status =
          report.status == StepReport::Status::non_finite ? RunEnd::Status::non_finite : RunEnd::Status::not_converged;
      const std::string reason =
          fmt::format("t = {:.6g} s, stage '{}', {} (after {} cuts)", seconds(state_.time), stage.name, text, cuts);
      tell_cut();
      event(EventKind::not_converged, reason);
      return {status, reason};
    }
    if (cuts == 1) cut = Event{EventKind::step_cut, seconds(state_.time), text, nullptr, nullptr};
    const double factor = report.suggested > 0.0 ? std::clamp(report.suggested, 0.1, 0.9) : step_control_.cut_factor;
    attempt_cap = std::max<Tick>(1, static_cast<Tick>(static_cast<double>(h) * factor));
  }
  return {};
}

RunEnd Driver::check_closure(const Stage& stage) {
  if (!(plan_->max_closure > 0.0)) return {};
  const Ledger& ledger = state_.ledger;
  // Energies at rest may be large against what moves: their last places are no fault.
  if (std::abs(ledger.closure()) <= plan_->max_closure * ledger.moved() + kLastPlaces * ledger.largest()) return {};
  const std::string reason = fmt::format(
      "t = {:.6g} s, stage '{}': the energy ledger is open by {:.3g} J, {:.2g} of the {:.3g} J that moved; {:.2g} is "
      "allowed (run.max_closure)",
      seconds(state_.time), stage.name, ledger.closure(), ledger.relative_closure(), ledger.moved(),
      plan_->max_closure);
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::not_converged, reason};
}

RunEnd Driver::check_audit(const Stage& stage) {
  if (!plan_->audit) return {};
  mover_->update_ledger(state_);
  audit_.check(state_.ledger.relative_closure(), kClosure, [&] {
    return fmt::format("the energy ledger is open by {:.2g} of the energy moved", state_.ledger.relative_closure());
  });
  stats_.audit_checks = audit_.checks();
  stats_.audit_worst = audit_.worst();
  if (audit_.passed()) return {};
  const std::string reason = fmt::format("t = {:.6g} s, stage '{}', audit: {}, {:.3g} times what is allowed",
                                         seconds(state_.time), stage.name, audit_.text(), audit_.worst());
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::not_converged, reason};
}

void Driver::drop_velocities() {
  mover_->update_ledger(state_);
  const double kinetic = state_.ledger[Column::kinetic];
  state_.ledger.book(Column::rest_damping, kinetic);
  state_.ledger.set(Column::kinetic, 0.0);
  std::fill(state_.v.begin(), state_.v.end(), 0.0);
  setup_->prescribe(seconds(state_.time), state_.q, state_.v);
}

RunEnd Driver::check_rest(const Stage& stage, Tick end) {
  const ForceBalance::Result found = balance_->measure(state_, *mover_);
  const auto block_name = [&](BlockId b) { return model_->blocks[b.index()].name; };
  rested_ = found.ratio <= stage.rest_force;
  const bool over = state_.time >= end || (stage.rest_steps > 0 && state_.step - first_step_ >= stage.rest_steps);
  if (!rested_ && !over) return {};
  std::string reason;
  if (const BlockId loose = unsupported_block(*setup_, state_); loose.valid())
    reason = fmt::format("block '{}' {}", block_name(loose), kUnsupported);
  else if (!rested_)
    reason = fmt::format(
        "not at rest after {} steps: block '{}' has an unbalanced force of {:.3g} N, {:.2g} of the largest force "
        "({:.2g} allowed)",
        state_.step - first_step_,
        found.body >= 0 ? block_name(setup_->bodies()[static_cast<std::size_t>(found.body)].block) : std::string(),
        found.force, found.ratio, stage.rest_force);
  if (reason.empty()) {
    drop_velocities();  // an oscillation may be caught as it passes the balance
    return {};
  }
  reason = fmt::format("t = {:.6g} s, stage '{}', {}", seconds(state_.time), stage.name, reason);
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::not_converged, reason};
}

void Driver::begin_stage(const Stage& stage) {
  stage_end_ = state_.time + stage.duration;  // a stage that comes to rest ends before its time
  rested_ = false;
  first_step_ = state_.step;
  largest_ = 0;
  stage_begin_ = centres();
  event(EventKind::stage_start, fmt::format("stage '{}': {}, {}, {:.6g} s", stage.name, stage.method,
                                            name(stage.integrator), seconds(stage.duration)));
  look(true);
  keep(state_.step == 0);
}

RunEnd Driver::run_stage(const Stage& stage, Tick end) {
  const bool to_balance = stage.rest && stage.rest_force > 0.0;
  balance_ = to_balance ? std::make_unique<ForceBalance>(*setup_, state_) : nullptr;
  while (state_.time < end && !rested_) {
    const Tick frame = next_multiple(state_.time, plan_->output.every);
    const Tick history = next_multiple(state_.time, plan_->output.history_every);
    const Tick target = std::min({frame, history, end});
    RunEnd result = advance_to(stage, target);
    if (result.status != RunEnd::Status::done) return result;
    largest_ = 0;
    look(target == frame || target == end || rested_);
    result = check_closure(stage);
    if (result.status != RunEnd::Status::done) return result;
    keep(target == end || rested_);
  }
  if (const BlockId loose = stage.rest && !to_balance ? unsupported_at_rest(stage) : BlockId{}; loose.valid()) {
    const std::string reason = fmt::format("t = {:.6g} s, stage '{}', block '{}' {}", seconds(state_.time), stage.name,
                                           model_->blocks[loose.index()].name, kUnsupported);
    event(EventKind::not_converged, reason);
    return {RunEnd::Status::not_converged, reason};
  }
  travels_.push_back(travel_since(stage_begin_));
  const StageTravel& travel = travels_.back();
  event(EventKind::stage_end,
        travel.block.valid() ? fmt::format("stage '{}' done: block '{}' moved farthest, {:.3g} m", stage.name,
                                           model_->blocks[travel.block.index()].name, travel.farthest)
                             : fmt::format("stage '{}' done", stage.name),
        nullptr, &travel);
  return {};
}

RunEnd Driver::run(std::optional<double> until) {
  const Tick stop = until ? std::min(end_, ticks(*until)) : end_;
  for (Sink* s : sinks_) s->begin(*model_, *plan_);
  const bool goes_on = from_.has_value();
  if (goes_on)
    go_on();
  else
    start();
  const auto first = static_cast<std::size_t>(state_.stage);
  RunEnd result;
  for (std::size_t i = first; i < plan_->stages.size() && result.status == RunEnd::Status::done; ++i) {
    const Stage& stage = plan_->stages[i];
    const bool within = goes_on && i == first;
    if (!within && i > 0 && state_.time >= stop) break;
    if (!within) change_stage(i);
    try {
      if (!within) begin_stage(stage);
      result = run_stage(stage, std::min(stage_end_, stop));
    } catch (const PlanError& e) {  // a step above the bound may show only when contacts close
      event(EventKind::not_converged, e.what());
      finish({RunEnd::Status::not_converged, e.what()});
      throw;
    }
  }
  if (result.status == RunEnd::Status::interrupted) keep(true);
  finish(result);
  return result;
}

void Driver::finish(const RunEnd& result) {
  mover_->update_ledger(state_);
  FrameView last = observer_->frame(state_, stats_);
  const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
  last.stage_name = stage.name;
  last.integrator = stage.integrator;
  last.end_time = seconds(end_);
  for (Sink* s : sinks_) s->end(result, last);
}

}  // namespace scree::coupling
