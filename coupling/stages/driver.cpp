#include "coupling/stages/driver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <limits>
#include <utility>

#include "coupling/bodies/partition.h"
#include "coupling/bolts/bolt_rows.h"
#include "coupling/integrate/awake_side.h"
#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/newmark.h"
#include "coupling/integrate/partitioned.h"
#include "coupling/integrate/subcycled.h"
#include "coupling/stages/energy_watch.h"
#include "coupling/stages/implicit_damping.h"
#include "coupling/stages/plan_warnings.h"
#include "coupling/stages/round_off.h"
#include "coupling/stages/scheme_refusals.h"
#include "coupling/transfer/construction.h"
#include "model/mesh_error.h"

namespace scree::coupling {
namespace {

// Of Checkpoint::rule_changes.
constexpr int kMethodRule = 0, kSideRule = 1;

/// True if a multiple of `every` lies after `before`, and not after `now`.
bool passes_multiple(Tick before, Tick now, Tick every) { return every > 0 && now / every > before / every; }

ExplicitDamping explicit_damping(const Stage& stage) {
  return {stage.damping, stage.damp_rigid_motion, stage.stiffness_damping, stage.local_damping, stage.sliding_damping};
}

ImplicitOptions implicit_options(const Stage& stage) {
  return {stage.newmark,           stage.rest ? 0.0 : stage.dynamics, stage.damping,
          stage.damp_rigid_motion, stage.stiffness_damping,           stage.sliding_damping};
}

/// Time scheme as shown in results: blocks are distinguished only where some of them are implicit.
Integrator shown_integrator(const Stage& stage) { return stage.subcycled() ? Integrator::explicit_ : stage.integrator; }

double smallest_width(const Model& model) {
  double least = std::numeric_limits<double>::infinity();
  for (const Block& b : model.blocks) {
    const Moments m = moments(b.polygon);
    least = std::min(least, std::sqrt(m.area));
  }
  return least;
}

}  // namespace

double auto_detection(const Model& model) { return 0.05 * smallest_width(model); }

Driver::Driver(const Model& model, const Plan& plan, const Methods& methods)
    : model_(&model), plan_(&plan), methods_(&methods) {
  detection_ = plan.detection > 0.0 ? plan.detection : auto_detection(model);
  for (const Stage& s : plan.stages) end_ += s.duration;
  round_off_ = energy_of_round_off(model);
}

double Driver::wall() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

Driver::Phase Driver::enter(Phase next) {
  timespec now{};
  (void)::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);  // fails for a wrong argument only
  const double time = static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
  const double used = time - phase_begin_;
  phase_begin_ = time;
  for (RunStats* stats : {&stats_, &committed_}) {
    if (phase_ == Phase::explicit_steps) stats->cpu_explicit += used;
    if (phase_ == Phase::implicit_steps) stats->cpu_implicit += used;
    if (phase_ == Phase::output) stats->cpu_output += used;
  }
  return std::exchange(phase_, next);
}

void Driver::event(EventKind kind, std::string text, const TransferRow* row, const StageTravel* travel) {
  const Event e{kind, seconds(state_.time), std::move(text), row, travel};
  if (kind == EventKind::warning) warnings_.push_back({e.time, e.text});
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

void Driver::complete_ledger() {
  integrator_->update_ledger(state_);
  state_.ledger.set_last_places(stats_.left_work + energy_of_last_places(*model_, state_));
}

void Driver::sample(bool frame) {
  const double begin = wall();
  const Phase before = enter(Phase::output);
  complete_ledger();
  stats_.contacts = std::count_if(state_.contacts.begin(), state_.contacts.end(),
                                  [](const ContactMemory& m) { return m.status != ContactStatus::open; });
  const HistoryView history = observer_->history(state_, stats_);
  for (Sink* s : sinks_) s->history(history);
  if (frame && !sinks_.empty()) {
    show_mesh();
    FrameView view = observer_->frame(state_, stats_);
    const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
    view.stage_name = stage.name;
    view.integrator = shown_integrator(stage);
    view.end_time = seconds(end_);
    for (Sink* s : sinks_) s->frame(view);
  }
  enter(before);
  stats_.wall_output += wall() - begin;
}

namespace {

/// Result of `make`; a block that cannot be created as the stage requires is a fault of the plan.
template <class Make>
auto in_plan(const Stage& stage, double time, const Make& make) {
  try {
    return make();
  } catch (const MeshError& e) {
    throw PlanError(fmt::format("t = {:.6g} s, stage '{}': {}", time, stage.name, e.what()));
  }
}

}  // namespace

void Driver::start() {
  state_ = State{};
  mesh_ = mesh_shown_ = 0;
  enter_time(plan_->stages.front());
  assign_sides(plan_->stages.front());
  state_.bodies = initial_records(*model_, body_requests(*model_, plan_->stages.front(), state_.explicit_side));
  setup_ = in_plan(plan_->stages.front(), 0.0, [&] {
    return std::make_unique<Setup>(*model_, *methods_, state_.bodies,
                                   slow_bodies(*model_, plan_->stages.front(), state_.explicit_side), clocks());
  });
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
  reported_ = ReportedWarnings{};
  travels_.clear();
  warnings_.clear();
  rule_changes_.assign(kRuleKinds * plan_->stages.size(), 0);
  stats_.blocks = static_cast<std::int64_t>(model_->blocks.size());
}

void Driver::enter_time(const Stage& stage) {
  state_.stage_begin.push_back(state_.time);
  state_.step_limit = {};
  stage_end_ = state_.time + stage.duration;  // at the latest
}

Clocks Driver::clocks() const { return clocks_of(*model_, state_.stage_begin, stage_end_); }

void Driver::assign_sides(const Stage& stage) {
  settled_.clear();
  state_.explicit_side.clear();
  if (stage.integrator == Integrator::partitioned)
    state_.explicit_side = first_sides(*model_, stage.partition, stage.construction);
}

void Driver::change_stage(std::size_t index) {
  const Stage& stage = plan_->stages[index];
  stats_.effort_before = stats_.effort;
  if (index > 0) {
    integrator_->leave(state_);
    integrator_.reset();
    assign_sides(stage);
    enter_time(stage);
    state_.rules = {};
    state_.sleep = {};
    stats_.asleep = 0;
    sleep_audit_.reset();
    change_bodies(stage);
    state_.stage = static_cast<std::int32_t>(index);
    begin_release(stage.construction, state_);
  }
  refuse_turned_blocks(stage);
  refuse_switching(stage);
  begin_moving(stage, true);
  show_mesh();
}

void Driver::change_bodies(const Stage& stage, std::span<const MethodChange> why) {
  const double excavated = state_.ledger[Column::excavated];
  TransferReport handed = in_plan(stage, seconds(state_.time), [&] {
    return transfer_bodies(*model_, *methods_, *setup_, stage, state_, clocks());
  });
  report_construction(stage, handed, state_.ledger[Column::excavated] - excavated);
  observer_.reset();
  setup_ = std::move(handed.setup);
  for (TransferRow& row : handed.rows) {
    const auto rule = std::find_if(why.begin(), why.end(), [&](const MethodChange& c) { return c.block == row.block; });
    if (rule != why.end()) {
      row.by_rule = true;
      row.measures = rule->measures;
    }
    transfers_.push_back(row);
    event(EventKind::transfer,
          fmt::format(
              "block '{}': {} -> {}, {:.4g} J kinetic and {:.3g} J elastic to the reservoir, {}energy error {:.1e}{}",
              model_->blocks[row.block.index()].name, row.from, row.to, row.reservoir_kinetic, row.reservoir_elastic,
              row.from == row.to ? fmt::format("{:.4g} J of {:.4g} J not represented by the new mesh and booked, ",
                                               row.booked, row.before.kinetic + row.before.elastic)
                                 : std::string(),
              row.energy_error, row.by_rule ? "; by rule: " + text(row.measures) : std::string()),
          &row);
  }
}

void Driver::report_construction(const Stage& stage, const TransferReport& handed, double energy) {
  if (!handed.left.empty()) {
    const Construction& c = stage.construction;
    const std::string release =
        c.release_time == 0 ? std::string("at once") : fmt::format("over {:.6g} s", seconds(c.release_time));
    event(EventKind::excavated,
          fmt::format("stage '{}': {} excavated with {:.4g} J; {:.3g} of the forces that it carried is released {}",
                      stage.name, named_blocks(*model_, handed.left), energy, c.release.value_or(0.0), release));
  }
  if (!handed.came.empty())
    event(EventKind::filled, fmt::format("stage '{}': {} filled, at rest and free of stress", stage.name,
                                         named_blocks(*model_, handed.came)));
}

void Driver::begin_moving(const Stage& stage, bool new_mesh) {
  settle_broken_bolts(*setup_, state_);
  install_bolts(*setup_, state_);
  bolt_watch_ = BoltWatch(state_);
  if (stage.strength.used()) set_strength(stage, state_.time);
  integrator_ = make_integrator(stage);
  const double springs = state_.ledger[Column::contact_springs];
  // Contacts are measured on the new outlines; their energy may differ where a bent edge became a straight one.
  const double now = integrator_->enter(state_);
  state_.ledger.set(Column::contact_springs, now);
  state_.ledger.book(Column::contact_edges, now - springs);
  if (new_mesh) ++mesh_;
  observe();
  watch_rules(stage);
}

void Driver::watch_rules(const Stage& stage) {
  end_watch_ = stage.end.used() ? std::make_unique<EndWatch>(stage.end, *setup_, state_) : nullptr;
  sleep_rules_ = stage.sleep > 0.0 ? std::make_unique<SleepRules>(stage, *setup_, state_, detection_) : nullptr;
  method_rules_ = stage.change.used ? std::make_unique<MethodRules>(stage, *methods_, *setup_, state_) : nullptr;
}

void Driver::change_methods(const Stage& stage) {
  const std::vector<MethodChange> changes = method_rules_->evaluate(state_, *integrator_);
  if (changes.empty()) return;
  count_rule(kMethodRule, static_cast<std::int64_t>(changes.size()));
  integrator_->leave(state_);
  integrator_.reset();
  state_.rules.other_method.resize(model_->blocks.size(), 0);
  for (const MethodChange& c : changes) state_.rules.other_method[c.block.index()] ^= 1;
  change_bodies(stage, changes);
  begin_moving(stage, true);
  largest_ = 0;
}

void Driver::change_partition(const Stage& stage) {
  if (!stage.partition.changes()) return;
  if (settled_.empty()) settled_ = settled_sides(*model_, stage.partition, stage.construction);
  std::vector<char> sides = state_.explicit_side;
  if (!change_sides(*setup_, state_, stage.partition, settled_, sides)) return;
  std::string names;
  int changed = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == state_.explicit_side[i]) continue;
    if (++changed <= 5)
      names += fmt::format(
          "{}'{}' {}", names.empty() ? "" : ", ", model_->blocks[i].name,
          stage.subcycled() ? (sides[i] != 0 ? "fast" : "slow") : (sides[i] != 0 ? "explicit" : "implicit"));
  }
  count_rule(kSideRule, changed);
  integrator_->leave(state_);
  integrator_.reset();
  state_.explicit_side = std::move(sides);
  change_bodies(stage);
  begin_moving(stage, stage.subcycled());  // in the order of pools
  largest_ = 0;
  event(EventKind::partition, fmt::format("stage '{}': {}{}", stage.name, names,
                                          changed > 5 ? fmt::format(" and {} more", changed - 5) : std::string()));
}

std::unique_ptr<TimeIntegrator> Driver::make_plain(const Stage& stage, const Setup& setup) const {
  if (stage.integrator == Integrator::implicit)
    return std::make_unique<Newmark>(setup, step_control_, detection_, implicit_options(stage));
  return std::make_unique<CentralDifference>(setup, step_control_, detection_, explicit_damping(stage), stage.rest);
}

std::unique_ptr<TimeIntegrator> Driver::make_integrator(const Stage& stage) {
  step_control_ = stage.control;
  if (!(step_control_.max_displacement > 0.0)) step_control_.max_displacement = 0.01 * smallest_width(*model_);
  // A point must not pass through the detection distance in one step.
  step_control_.max_displacement = std::min(step_control_.max_displacement, 0.5 * detection_);
  std::unique_ptr<TimeIntegrator> integrator;
  if (stage.integrator != Integrator::partitioned) {
    if (stage.integrator == Integrator::implicit) check_implicit(stage, *setup_, {});
    if (stats_.asleep == 0)
      integrator = make_plain(stage, *setup_);
    else
      integrator = std::make_unique<AwakeSide>(*setup_, *methods_, state_, stage.strength, stage.strength.from,
                                               [&](const Setup& setup) { return make_plain(stage, setup); });
  } else if (stage.subcycled()) {
    check_subcycled(stage, *setup_, state_.explicit_side);
    integrator =
        std::make_unique<Subcycled>(*setup_, step_control_, detection_,
                                    Subcycled::Choice{explicit_damping(stage), stage.safety, stage.partition.substeps});
  } else {
    check_implicit(stage, *setup_, state_.explicit_side);
    integrator = std::make_unique<Partitioned>(
        *setup_, *methods_, state_, step_control_, detection_,
        Partitioned::Choice{explicit_damping(stage), implicit_options(stage), stage.safety, stage.partition.substeps,
                            stage.partition.shared_contacts});
  }
  if (plan_->audit) integrator->watch(&audit_);
  integrator->set_control(control_);
  return integrator;
}

void Driver::observe() {
  const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
  const auto contacts = plan_->output.contacts ? Observer::Contacts::all
                        : plan_->live.enabled  ? Observer::Contacts::now_and_then
                                               : Observer::Contacts::none;
  observer_ = std::make_unique<Observer>(*setup_, state_, mesh_, contacts);
  stats_.elements = static_cast<std::int64_t>(observer_->mesh().cell_block.size());
  fast_elements_ = 0.0;
  if (stage.subcycled() || stage.integrator == Integrator::partitioned)
    for (const std::int32_t b : observer_->mesh().cell_block)
      fast_elements_ += state_.explicit_side[static_cast<std::size_t>(b)] != 0 ? 1.0 : 0.0;
  count_awake_elements();
  stats_.unknowns = 0;
  for (const Body& b : setup_->bodies())
    if (!b.driven) stats_.unknowns += takes_explicit_steps(stage, b) ? 2 * b.nodes : setup_->pool_of(b).dofs(b.index);
}

void Driver::show_mesh() {
  if (mesh_shown_ == mesh_) return;
  mesh_shown_ = mesh_;
  for (Sink* s : sinks_) s->topology(observer_->mesh());
}

bool Driver::takes_explicit_steps(const Stage& stage, const Body& b) const {
  if (!stage.has_implicit_steps()) return true;
  return stage.integrator == Integrator::partitioned && state_.explicit_side[b.block.index()] != 0;
}

BlockId Driver::unsupported_at_rest(const Stage& stage) {
  const BlockId loose = unsupported_block(*setup_, state_);
  // Contacts of explicit steps open for an instant while blocks still vibrate: without rest_force only a warning.
  if (loose.valid() && stage.integrator == Integrator::explicit_ && stage.rest_force == 0.0) {
    event(EventKind::warning,
          fmt::format(
              "t = {:.6g} s, stage '{}': block '{}' has no chain of contacts to a support at the end of the stage",
              seconds(state_.time), stage.name, model_->blocks[loose.index()].name));
    return {};
  }
  return loose;
}

void Driver::begin_stage(const Stage& stage) {
  refuse_missed_times();
  ended_ = false;
  first_step_ = state_.step;
  largest_ = 0;
  stage_begin_ = centres();
  rest_trace_ = {};
  if (stage.rest) rest_trace_.begin_part(stage_begin_);
  begin_rules(stage.end, state_);
  if (stage.subcycled()) {
    complete_ledger();
    begin_energy_watch(state_);
  }
  event(EventKind::stage_start, fmt::format("stage '{}': {}, {}, {:.6g} s", stage.name, stage.method,
                                            name(stage.integrator), seconds(stage.duration)));
  const std::vector<char> acts =
      acts_in(*model_, *plan_, static_cast<std::size_t>(state_.stage), state_.stage_begin, stage_end_);
  if (const auto damping = stage_damping(*model_, stage, acts))
    event(damps_much(*damping) ? EventKind::warning : EventKind::stage_step, text(*damping));
  sample(true);
  keep(state_.step == 0);
}

Tick Driver::latest_end() const {
  Tick end = ended_ ? state_.time : stage_end_;
  for (std::size_t i = static_cast<std::size_t>(state_.stage) + 1; i < plan_->stages.size(); ++i)
    end += plan_->stages[i].duration;
  return end;
}

RunEnd Driver::run_stage(const Stage& stage, Tick stop) {
  const bool to_balance = stage.rest && stage.rest_force > 0.0;
  balance_ = to_balance ? std::make_unique<ForceBalance>(*setup_, state_) : nullptr;
  // Output is taken at the first step at or after its time: steps are set by the stage alone.
  while (state_.time < std::min(stop, stage_end_) && !ended_) {
    const Tick before = state_.time;
    RunEnd result = advance_step(stage);
    if (result.status != RunEnd::Status::done) return result;
    const bool over = ended_ || state_.time >= stage_end_, stopped = !over && state_.time >= stop;
    const bool frame = over || passes_multiple(before, state_.time, plan_->output.every);
    const bool sampled = frame || passes_multiple(before, state_.time, plan_->output.history_every);
    if (sampled) {
      sample(frame);
      warn_of_losses(stage, true);
      RunEnd found = check_finite(stage);
      if (found.status == RunEnd::Status::done) found = check_gain(stage, true);
      if (found.status != RunEnd::Status::done) return found;
    }
    keep(over || stopped);
    if (stopped && !sampled) sample(false);  // a run that continues from the checkpoint omits this sample
  }
  const bool rested = stage.rest && !to_balance && state_.time >= stage_end_;
  if (const BlockId loose = rested ? unsupported_at_rest(stage) : BlockId{}; loose.valid()) {
    const std::string reason = fmt::format("t = {:.6g} s, stage '{}', block '{}' {}", seconds(state_.time), stage.name,
                                           model_->blocks[loose.index()].name, kUnsupported);
    event(EventKind::not_converged, reason);
    return {RunEnd::Status::not_converged, reason};
  }
  if (rested) warn_unbalanced(stage);
  travels_.push_back(travel_since(stage_begin_));
  const StageTravel& travel = travels_.back();
  event(EventKind::stage_end,
        travel.block.valid() ? fmt::format("stage '{}' done: block '{}' moved farthest, {:.3g} m", stage.name,
                                           model_->blocks[travel.block.index()].name, travel.farthest)
                             : fmt::format("stage '{}' done", stage.name),
        nullptr, &travel);
  return {};
}

void Driver::begin_only(Sink& sink) {
  start();
  change_stage(0);
  begin_stage(plan_->stages.front());
  sinks_.push_back(&sink);
  (void)largest_step(plan_->stages.front(), true);
}

RunEnd Driver::run(std::optional<double> until) {
  const Tick stop = until ? ticks(*until) : std::numeric_limits<Tick>::max();
  enter(Phase::set_up);
  for (Sink* s : sinks_) s->begin(*model_, *plan_);
  const bool goes_on = from_.has_value();
  if (goes_on)
    go_on();
  else
    start();
  if (!goes_on)
    for (std::string& text : plan_warnings(*model_, *plan_)) event(EventKind::warning, std::move(text));
  const auto first = static_cast<std::size_t>(state_.stage);
  RunEnd result;
  for (std::size_t i = first; i < plan_->stages.size() && result.status == RunEnd::Status::done; ++i) {
    const Stage& stage = plan_->stages[i];
    const bool within = goes_on && i == first;
    if (!within && i > 0 && state_.time >= stop) break;
    if (!within) change_stage(i);
    try {
      if (!within) begin_stage(stage);
      enter(stage.has_implicit_steps() ? Phase::implicit_steps : Phase::explicit_steps);
      result = run_stage(stage, stop);
      enter(Phase::set_up);
    } catch (const PlanError& e) {  // a step may turn out to be above the bound only when contacts close
      event(EventKind::not_converged, e.what());
      finish({RunEnd::Status::not_converged, e.what()});
      throw;
    }
  }
  if (result.status == RunEnd::Status::interrupted) keep(true);
  if (result.status == RunEnd::Status::done) warn_idle_rules();
  finish(result);
  return result;
}

void Driver::count_rule(int kind, std::int64_t changes) {
  rule_changes_[kRuleKinds * static_cast<std::size_t>(state_.stage) + static_cast<std::size_t>(kind)] += changes;
}

void Driver::warn_idle_rules() {
  const bool over = ended_ || state_.time >= stage_end_;  // otherwise the run ends before the stage
  for (std::size_t i = 0; i < static_cast<std::size_t>(state_.stage) + (over ? 1 : 0); ++i) {
    const Stage& stage = plan_->stages[i];
    if (stage.change.used && rule_changes_[kRuleKinds * i + kMethodRule] == 0)
      event(EventKind::warning,
            fmt::format(
                "stage '{}': its rules for methods (switch) never fired: no block changed method; `scree check` and "
                "docs/theory/transfer.md, \"Switching rules\", explain what they measure",
                stage.name));
    if (stage.integrator == Integrator::partitioned && stage.partition.changes() &&
        rule_changes_[kRuleKinds * i + kSideRule] == 0)
      event(
          EventKind::warning,
          fmt::format("stage '{}': its rules of motion (explicit_speed, explicit_strain_rate) never fired: every block "
                      "took steps of one kind throughout",
                      stage.name));
  }
}

void Driver::finish(const RunEnd& result) {
  enter(Phase::output);
  complete_ledger();
  show_mesh();
  FrameView last = observer_->frame(state_, stats_, true);
  const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
  last.stage_name = stage.name;
  last.integrator = shown_integrator(stage);
  last.end_time = seconds(end_);
  enter(Phase::output);  // the time of the last view counts in the summary
  integrator_.reset();   // its memory is freed before the sinks need memory to close
  for (Sink* s : sinks_) s->end(result, last);
  enter(Phase::set_up);
}

}  // namespace scree::coupling
