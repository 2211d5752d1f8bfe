// The driver's checkpoint: taken, and restored to continue a run.
#include <utility>

#include "coupling/bodies/partition.h"
#include "coupling/stages/driver.h"

namespace scree::coupling {

void Driver::go_on() {
  Checkpoint& c = *from_;
  state_ = std::move(c.state);
  stage_end_ = c.stage_end;
  first_step_ = c.first_step;
  stage_begin_.clear();
  for (std::size_t i = 0; i + 1 < c.stage_begin.size(); i += 2)
    stage_begin_.emplace_back(c.stage_begin[i], c.stage_begin[i + 1]);
  rest_trace_ = std::move(c.rest);
  ended_ = c.ended;
  largest_ = c.largest_step;
  mesh_ = c.mesh;
  audit_ = std::move(c.audit);
  transfers_ = std::move(c.transfers);
  reported_ = std::move(c.reported);
  travels_ = std::move(c.travels);
  warnings_ = std::move(c.warnings);
  rule_changes_ = std::move(c.rule_changes);
  stats_ = c.stats;
  rule_changes_.resize(kRuleKinds * plan_->stages.size(), 0);  // the checkpoint may be of a run with fewer stages
  const Stage& stage = plan_->stages[static_cast<std::size_t>(state_.stage)];
  setup_ = std::make_unique<Setup>(*model_, *methods_, state_.bodies, slow_bodies(*model_, stage, state_.explicit_side),
                                   clocks());
  integrator_ = make_integrator(stage);
  integrator_->resume(state_, c.integrator);
  bolt_watch_ = BoltWatch(state_);
  if (stage.strength.used()) set_strength(stage, state_.time);
  end_ = latest_end();
  observe();
  watch_rules(stage);
  audit_sleep(stage);
  from_.reset();
}

Checkpoint Driver::checkpoint_of_driver() const {
  Checkpoint c;
  c.stage_end = stage_end_;
  c.first_step = first_step_;
  for (const Vec2& x : stage_begin_) c.stage_begin.insert(c.stage_begin.end(), {x.x(), x.y()});
  c.rest = rest_trace_;
  c.ended = ended_;
  c.mesh = mesh_;
  c.largest_step = largest_;
  c.stats = stats_;
  c.audit = audit_;
  c.transfers = transfers_;
  c.travels = travels_;
  c.warnings = warnings_;
  c.rule_changes = rule_changes_;
  c.reported = reported_;
  return c;
}

void Driver::keep(bool in_any_case) {
  if (keeper_ == nullptr || !(in_any_case || keeper_->due(state_.step))) return;
  const double begin = wall();
  const Phase before = enter(Phase::output);
  Checkpoint c = checkpoint_of_driver();
  // Lent, and taken back in any case, because a copy would be as large as the model.
  c.integrator = integrator_->lend();
  std::swap(c.state, state_);
  const auto take_back = [&] {
    std::swap(c.state, state_);
    integrator_->take_back(c.integrator);
  };
  try {
    keeper_->keep(c);
  } catch (...) {
    take_back();
    throw;
  }
  take_back();
  enter(before);
  stats_.wall_output += wall() - begin;
}

void Driver::keep_checkpoint() {
  // A run that continues from here repeats all attempts at the present step.
  RunStats attempts = std::exchange(stats_, committed_);
  keep(true);
  attempts.wall_output = committed_.wall_output = stats_.wall_output;
  attempts.cpu_explicit = stats_.cpu_explicit;
  attempts.cpu_implicit = stats_.cpu_implicit;
  attempts.cpu_output = stats_.cpu_output;
  stats_ = attempts;
}

}  // namespace scree::coupling
