// The steps of a stage: their largest length, treatment of a failed step, checks after each step.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/integrate/lost_state.h"
#include "coupling/integrate/step_bound.h"
#include "coupling/stages/driver.h"
#include "coupling/stages/energy_watch.h"
#include "coupling/stages/implicit_damping.h"
#include "coupling/stages/pace.h"
#include "coupling/stages/spin_watch.h"
#include "coupling/stages/step_grid.h"

namespace scree::coupling {
namespace {

constexpr double kOfAllowed = 0.95;          // target: fraction of the displacement allowed per step
constexpr std::int64_t kFrictionEvery = 64;  // steps between checks of friction lost by contacts

constexpr double kRested = 0.01;  // unbalanced over largest force: threshold of the warning at the end of rest stages

// Steps of a stage between two evaluations of the bound of explicit steps, which may grow, for example because contacts
// have ended; the same for steps with substeps; and between two checks of the closure of the ledger. Counted in steps,
// and so independent of output.
constexpr std::int64_t kBoundSteps = 500, kBoundLongSteps = 20, kClosureSteps = 100;
// Every change of an explicit step changes the energy of vibration of undamped blocks, up or down (by (h w)^2/4 of it:
// the column step_change), and with many changes this energy grows without bound: 100 blocks that collided for 10 s at
// a safety of 0.8 had 14 to 22 times their energy. So the step does not follow every contact that opens: it grows by
// more than this factor or not at all.
constexpr double kGrowsBy = 1.5;

/// ", about 2e+09 of them" where the number explains a long run time.
std::string count_text(double steps) { return steps < 1e6 ? "" : fmt::format(", about {:.2g} of them", steps); }

/// Largest length of the first attempt of a step.
Tick first_cap(const Stage& stage, const StepLimit& limit) {
  return stage.integrator == Integrator::partitioned && limit.length > 0 ? limit.length
                                                                         : std::numeric_limits<Tick>::max();
}

/// @param elements   of the explicit side
/// @param converged  in all attempts of the step
StepLimit::Iteration iteration_of(const StepReport& report, const RunStats& stats, double elements, bool converged) {
  if (!converged) return StepLimit::Iteration::failed;
  return shorter_is_cheaper(report, stats, elements) ? StepLimit::Iteration::long_ : StepLimit::Iteration::short_;
}

/// True where a shorter step fails too.
bool is_hopeless(const StepReport& report) {
  return report.status == StepReport::Status::non_finite || report.status == StepReport::Status::refused;
}

/// Length of the attempt after one that failed.
Tick shorter(const StepReport& report, const StepControl& control, Tick h) {
  const double factor = report.suggested > 0.0 ? std::clamp(report.suggested, 0.1, 0.9) : control.cut_factor;
  return std::max<Tick>(1, static_cast<Tick>(static_cast<double>(h) * factor));
}

}  // namespace

Tick Driver::largest_step(const Stage& stage, bool first) {
  if (stage.integrator == Integrator::implicit) return ticks(*stage.dt);
  std::string binding;
  // The block that binds the step is named when a stage begins and when a step is refused.
  const double bound = integrator_->stable_step(state_, first ? &binding : nullptr);
  const auto refused = [&] {
    (void)integrator_->stable_step(state_, &binding);
    return std::string_view(binding);
  };
  if (stage.subcycled()) check_slow_step(stage, first);
  if (stage.integrator == Integrator::partitioned) {
    const std::int32_t m = stage.partition.substeps;
    if (m > 0 && *stage.dt > m * bound && !stage.force_dt)
      throw PlanError(fmt::format(
          "t = {:.6g} s, stage '{}': explicit steps of {:.4g} s, {} in an implicit one, are above the certified stable "
          "one, {:.4g} s, bound by {}; leave substeps out, give {} or more, or force_dt = true to take them anyway",
          seconds(state_.time), stage.name, *stage.dt / m, m, bound, refused(), std::ceil(*stage.dt / bound)));
    if (m > 0 && *stage.dt > m * bound && first)
      event(EventKind::warning,
            fmt::format("stage '{}': explicit steps of {:.4g} s, {} in an implicit one, are forced above the certified "
                        "stable one, {:.4g} s, bound by {}",
                        stage.name, *stage.dt / m, m, bound, binding));
    else if (first) {
      const double fine = m > 0 ? *stage.dt / m : std::min(*stage.dt, stage.safety * bound);
      event(
          EventKind::stage_step,
          std::isfinite(bound)
              ? fmt::format("stage '{}': steps of {:.4g} s, explicit ones of at most {:.4g} s{}; certified are {:.4g} "
                            "s, bound by {}",
                            stage.name, *stage.dt, fine, count_text(seconds(stage.duration) / fine), bound, binding)
              : fmt::format("stage '{}': steps of {:.4g} s; no block is explicit yet", stage.name, *stage.dt));
    }
    return ticks(*stage.dt);
  }
  if (stage.dt) {
    if (*stage.dt > bound && !stage.force_dt)
      throw PlanError(fmt::format(
          "t = {:.6g} s, stage '{}': the explicit step {:.4g} s is above the certified stable one, {:.4g} s, bound by "
          "{}; use dt = \"auto\" or a smaller step, or force_dt = true to take it anyway",
          seconds(state_.time), stage.name, *stage.dt, bound, refused()));
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

void Driver::check_slow_step(const Stage& stage, bool first) {
  std::string binding;
  const double most = slow_step(*setup_, &binding);
  if (*stage.dt <= most) return;
  if (!stage.force_dt)
    throw PlanError(fmt::format(
        "t = {:.6g} s, stage '{}': internal forces of blocks that are not in explicit_blocks are evaluated every "
        "{:.4g} s, and {:.4g} s is allowed by {} (dt w <= 0.5); use a smaller dt, name the block there, or force_dt "
        "= true to take it anyway",
        seconds(state_.time), stage.name, *stage.dt, most, binding));
  if (first)
    event(EventKind::warning,
          fmt::format("stage '{}': dt {:.4g} s is forced above what slow internal forces allow, {:.4g} s by {}",
                      stage.name, *stage.dt, most, binding));
}

Tick Driver::step_of_fastest() const {
  double fastest = 0.0;
  const Outlines& o = setup_->outlines();
  for (const OutlineNode k : o.nodes.indices()) {
    if (!state_.explicit_side.empty() && state_.explicit_side[o.node_body[k].index()] != 0) continue;
    fastest = std::max(fastest, position(o.nodes[k], state_.v).squaredNorm());
  }
  const double step = kOfAllowed * step_control_.max_displacement / std::sqrt(fastest);
  return step < 1.0 ? std::max<Tick>(1, ticks(step)) : std::numeric_limits<Tick>::max();
}

void Driver::change_by_rules(const Stage& stage) {
  if (stage.integrator == Integrator::partitioned) change_partition(stage);
  if (sleep_rules_) change_sleep(stage);
  if (method_rules_) change_methods(stage);
}

void Driver::bound_step(const Stage& stage, bool due) {
  if (!due && largest_ != 0 && integrator_->step_still_stable()) return;
  // Events about the first step are sent once, although a stop may undo the step itself.
  const Tick found = largest_step(stage, steps_of_stage() == 0 && largest_ == 0);
  // Blocks that are asleep bind no step, but loads that wake them are seen at the ends of steps only.
  const bool grows = stats_.asleep == 0 && seconds(found) > kGrowsBy * seconds(largest_);
  if (largest_ == 0 || found < largest_ || grows) largest_ = found;
}

void Driver::set_strength(const Stage& stage, Tick time) {
  const double part =
      static_cast<double>(time - state_.stage_begin.back()) / static_cast<double>(std::max<Tick>(stage.duration, 1));
  setup_->divide_strength(stage.strength, strength_factor(stage.strength, part));
}

StepReport Driver::attempt(const Stage& stage, Tick cap, Tick& h) {
  const bool implicit = stage.has_implicit_steps();
  if (implicit) cap = std::min(cap, step_of_fastest());
  h = next_step(state_.stage_begin.back(), stage_end_, state_.time, stage.dt ? ticks(*stage.dt) : 0, cap);
  if (stage.strength.used()) set_strength(stage, state_.time + h);
  const double begin = wall();
  StepReport report = integrator_->step(state_, h);
  (implicit ? stats_.wall_implicit : stats_.wall_explicit) += wall() - begin;
  count(report);
  return report;
}

std::string Driver::refusal_text(const StepReport& report, Tick h) const {
  const std::string where =
      report.body.valid() ? fmt::format("block '{}', ", model_->blocks[setup_->body(report.body).block.index()].name)
                          : std::string();
  return fmt::format("{}step {:.4g} s: {}", where, seconds(h), report.cause);
}

RunEnd Driver::advance_step(const Stage& stage) {
  int cuts = 0;
  bool converged = true;  // in all attempts
  Tick attempt_cap = first_cap(stage, state_.step_limit);
  // A step that is given up leaves no trace: a run that continues from here repeats all its attempts.
  committed_ = stats_;
  std::optional<Event> cut;  // reported with the step that follows from it
  const auto stopped = [&] {
    stats_ = committed_;
    return RunEnd{RunEnd::Status::interrupted, "stopped on request"};
  };
  const auto report_cut = [&] {
    if (cut)
      for (Sink* s : sinks_) s->event(*cut);
    cut.reset();
  };
  bool due = steps_of_stage() % (stage.integrator == Integrator::partitioned ? kBoundLongSteps : kBoundSteps) == 0;
  for (;;) {
    if (control_ != nullptr && control_->stop_requested()) return stopped();
    if (steps_of_stage() > 0 && cuts == 0) change_by_rules(stage);
    bound_step(stage, due);
    due = false;
    Tick h = 0;
    const StepReport report = attempt(stage, std::min(largest_, attempt_cap), h);
    if (report.status == StepReport::Status::given_up) return stopped();
    if (stage.integrator == Integrator::partitioned) stats_.effort += effort(report, stats_, fast_elements_);
    if (report.status == StepReport::Status::ok) {
      report_cut();
      ++stats_.steps;
      if (stage.integrator == Integrator::partitioned)
        state_.step_limit.taken(h, iteration_of(report, stats_, fast_elements_, converged), largest_);
      stats_.left_work += report.left_work;
      if (!stage.has_implicit_steps())
        stats_.element_steps += awake_elements_ + static_cast<double>(report.substeps - 1) * fast_elements_;
      return after_step(stage);
    }
    ++stats_.cuts;
    const std::string text = refusal_text(report, h);
    if (is_hopeless(report) || ++cuts > step_control_.max_cuts || h <= 3) {
      const auto status =
          report.status == StepReport::Status::non_finite ? RunEnd::Status::non_finite : RunEnd::Status::not_converged;
      const std::string reason =
          fmt::format("t = {:.6g} s, stage '{}', {} (after {} cuts)", seconds(state_.time), stage.name, text, cuts);
      report_cut();
      event(EventKind::not_converged, reason);
      return {status, reason};
    }
    if (RunEnd slow = check_pace(stage, text); slow.status != RunEnd::Status::done) {
      report_cut();
      return slow;
    }
    converged = converged && report.suggested > 0.0;  // > 0: only its displacement was too large
    if (cuts == 1) cut = Event{EventKind::step_cut, seconds(state_.time), text, nullptr, nullptr};
    attempt_cap = shorter(report, step_control_, h);
  }
}

void Driver::count(const StepReport& report) {
  stats_.iterations += report.iterations;
  stats_.passes += report.passes;
  stats_.switches += report.switches;
  stats_.factorisations += report.factorisations;
  stats_.updates += report.updates;
  stats_.corrections += report.corrections;
  stats_.block_iterations += report.block_iterations;
  stats_.incomplete_factors += report.incomplete_factors;
  stats_.local_passes += report.local_passes;
  stats_.fallbacks += report.fallbacks;
}

RunEnd Driver::after_step(const Stage& stage) {
  state_.ledger.pass();
  for (std::string& text : bolt_watch_.new_breaks(*model_, state_))
    event(EventKind::bolt_broken, fmt::format("t = {:.6g} s, {}", seconds(state_.time), text));
  RunEnd found = check_audit(stage);
  if (found.status == RunEnd::Status::done) found = check_gain(stage, false);
  if (found.status == RunEnd::Status::done) found = check_pace(stage, {});
  if (state_.step % kFrictionEvery == 0) warn_of_losses(stage, false);
  committed_ = stats_;
  for (Sink* s : sinks_) s->step(seconds(state_.time), stats_, state_.ledger);
  if (found.status != RunEnd::Status::done) return found;
  if (stage.rest && !balance_) follow_rest(stage, {});
  if (balance_) {
    RunEnd rest = check_rest(stage);
    if (ended_) end_ = latest_end();
    if (rest.status != RunEnd::Status::done || ended_) return rest;
  }
  if (stage.subcycled())
    if (const auto text = watch_energy(state_))
      event(EventKind::warning, fmt::format("t = {:.6g} s, stage '{}': {}", seconds(state_.time), stage.name, *text));
  check_end(stage);
  const bool over = ended_ || state_.time >= stage_end_;
  return over || steps_of_stage() % kClosureSteps == 0 ? check_closure(stage) : RunEnd();
}

RunEnd Driver::check_finite(const Stage& stage) {
  std::string what;
  LostPlace place = not_finite_at(*setup_, state_.q, "the position", state_.q);
  if (!place.body.valid()) place = not_finite_at(*setup_, state_.v, "the velocity", state_.q);
  if (place.body.valid())
    what = fmt::format("block '{}', {}", model_->blocks[setup_->body(place.body).block.index()].name, place.what);
  else if (const std::string_view wrong = state_.ledger.not_finite(); !wrong.empty())
    what = fmt::format("'{}' of the energy ledger is not finite", wrong);
  if (what.empty()) return {};
  const std::string reason =
      fmt::format("t = {:.6g} s, stage '{}': {}; results after the last frame before this time are meaningless",
                  seconds(state_.time), stage.name, what);
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::non_finite, reason};
}

void Driver::warn_of_losses(const Stage& stage, bool complete) {
  std::vector<std::string> lines = lost_friction(*model_, state_, stats_, reported_);
  if (complete && state_.ledger.passed_given() > round_off_) {
    const std::vector<std::string> columns = large_scheme_columns(state_.ledger, reported_);
    lines.insert(lines.end(), columns.begin(), columns.end());
  }
  if (damps_motion(stage)) {
    const std::vector<std::string> spins = damped_spins(*model_, *setup_, state_, reported_);
    lines.insert(lines.end(), spins.begin(), spins.end());
  }
  for (const std::string& line : lines)
    event(EventKind::warning, fmt::format("t = {:.6g} s, stage '{}': {}", seconds(state_.time), stage.name, line));
}

RunEnd Driver::check_gain(const Stage& stage, bool complete) {
  const auto gone = energy_from_nowhere(state_.ledger, plan_->max_gain, round_off_, complete);
  if (!gone) return {};
  const std::string reason = fmt::format("t = {:.6g} s, stage '{}': {}", seconds(state_.time), stage.name, *gone);
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::not_converged, reason};
}

RunEnd Driver::check_pace(const Stage& stage, const std::string& cause) {
  if (stage.integrator != Integrator::partitioned) return {};
  const double steps = seconds(state_.time - state_.stage_begin.back()) / *stage.dt;
  const auto slow = too_slow(stats_, steps, plan_->max_slowdown);
  if (!slow) return {};
  const std::string reason = fmt::format("t = {:.6g} s, stage '{}': {}{}{}", seconds(state_.time), stage.name, *slow,
                                         cause.empty() ? "" : "; the last step failed: ", cause);
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::not_converged, reason};
}

RunEnd Driver::check_closure(const Stage& stage) {
  if (!(plan_->max_closure > 0.0) && !(plan_->max_passed_closure > 0.0)) return {};
  complete_ledger();
  const Ledger& ledger = state_.ledger;
  const double open = std::abs(ledger.closure());
  const auto closes = [&](double part, double energy) {
    return !(part > 0.0) || open <= part * energy + ledger.last_places();
  };
  const auto end = [&](double share, double energy, const char* kind, double allowed, const char* key) -> RunEnd {
    const std::string reason = fmt::format(
        "t = {:.6g} s, stage '{}': the energy ledger is open by {:.3g} J, {:.2g} of the {:.3g} J that {}; {:.2g} is "
        "allowed ({})",
        seconds(state_.time), stage.name, ledger.closure(), share, energy, kind, allowed, key);
    event(EventKind::not_converged, reason);
    return {RunEnd::Status::not_converged, reason};
  };
  if (!closes(plan_->max_closure, ledger.moved()))
    return end(ledger.relative_closure(), ledger.moved(), "moved", plan_->max_closure, "run.max_closure");
  if (!closes(plan_->max_passed_closure, ledger.passed()))
    return end(ledger.passed_closure(), ledger.passed(), "passed", plan_->max_passed_closure, "run.max_passed_closure");
  return {};
}

RunEnd Driver::check_audit(const Stage& stage) {
  if (!plan_->audit) return {};
  complete_ledger();
  if (sleep_audit_) sleep_audit_->check(state_.time, stage.sleep, audit_);
  const Ledger& ledger = state_.ledger;
  audit_.check(std::abs(ledger.closure()), kCloses * ledger.moved() + ledger.last_places(), [&] {
    return fmt::format("the energy ledger is open by {:.2g} J of the {:.2g} J moved", ledger.closure(), ledger.moved());
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
  complete_ledger();
  const double kinetic = state_.ledger[Column::kinetic];
  state_.ledger.book(Column::rest_damping, kinetic);
  state_.ledger.set(Column::kinetic, 0.0);
  std::fill(state_.v.begin(), state_.v.end(), 0.0);
  setup_->prescribe(seconds(state_.time), state_.q, state_.v);
}

void Driver::check_end(const Stage& stage) {
  if (!end_watch_ || state_.support.releasing(state_.time)) return;
  const std::optional<std::string> why = end_watch_->evaluate(state_, *integrator_, stage_begin_);
  if (!why || state_.time >= stage_end_) return;
  ended_ = true;
  end_ = latest_end();
  event(EventKind::stage_rule, fmt::format("stage '{}' ends by a rule: {}", stage.name, *why));
}

void Driver::follow_rest(const Stage& stage, std::optional<double> ratio) {
  double progress = static_cast<double>(state_.time - state_.stage_begin.back()) / static_cast<double>(stage.duration);
  if (stage.rest_steps > 0)
    progress = std::max(progress, static_cast<double>(steps_of_stage()) / static_cast<double>(stage.rest_steps));
  if (ratio) rest_trace_.follow(*ratio);
  if (progress < 1.0 && rest_trace_.begins_part(progress)) rest_trace_.begin_part(centres());
}

void Driver::warn_unbalanced(const Stage& stage) {
  const ForceBalance::Result found = ForceBalance(*setup_, state_).measure(state_, *integrator_);
  if (!found.body.valid() || found.ratio <= kRested) return;
  event(
      EventKind::warning,
      fmt::format(
          "t = {:.6g} s, stage '{}' ends before it is at rest: block '{}' has an unbalanced force of {:.3g} N, {:.2g} "
          "of the largest force{}; make the stage longer, or give rest_force",
          seconds(state_.time), stage.name, model_->blocks[setup_->body(found.body).block.index()].name, found.force,
          found.ratio, rest_text(rest_trace_, *setup_, centres(), seconds(state_.time - state_.stage_begin.back()))));
}

RunEnd Driver::check_rest(const Stage& stage) {
  const ForceBalance::Result found = balance_->measure(state_, *integrator_);
  follow_rest(stage, found.ratio);
  const auto block_name = [&](BlockId b) { return model_->blocks[b.index()].name; };
  ended_ = found.ratio <= stage.rest_force && !state_.support.releasing(state_.time);
  const bool over = state_.time >= stage_end_ || (stage.rest_steps > 0 && steps_of_stage() >= stage.rest_steps);
  if (!ended_ && !over) return {};
  std::string reason;
  if (const BlockId loose = unsupported_block(*setup_, state_); loose.valid())
    reason = fmt::format("block '{}' {}", block_name(loose), kUnsupported);
  else if (!ended_)
    reason = fmt::format(
        "not at rest after {} steps: block '{}' has an unbalanced force of {:.3g} N, {:.2g} of the largest force "
        "({:.2g} allowed){}",
        steps_of_stage(), found.body.valid() ? block_name(setup_->body(found.body).block) : std::string(), found.force,
        found.ratio, stage.rest_force,
        rest_text(rest_trace_, *setup_, centres(), seconds(state_.time - state_.stage_begin.back())));
  if (reason.empty()) {
    drop_velocities();  // an oscillation may be passing through equilibrium
    return {};
  }
  reason = fmt::format("t = {:.6g} s, stage '{}', {}", seconds(state_.time), stage.name, reason);
  event(EventKind::not_converged, reason);
  return {RunEnd::Status::not_converged, reason};
}

}  // namespace scree::coupling
