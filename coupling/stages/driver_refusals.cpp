// Checks before the first step of a stage: rules, rotated blocks and times that it cannot handle.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "coupling/stages/driver.h"

namespace scree::coupling {

void Driver::refuse_switching(const Stage& stage) const {
  if (!stage.change.used) return;
  const auto refuse = [&](const char* why) {
    throw PlanError(fmt::format("stage '{}': blocks cannot change method during it: {}", stage.name, why));
  };
  if (stage.rest) refuse("it runs to rest, which removes the motion that the rules measure");
  if (stage.kinematics == Kinematics::linear) refuse("linear kinematics cannot return a rotated block to the NMM");
  if (stage.newmark == NewmarkScheme::trapezoidal) refuse("the trapezoidal scheme does not support blocks of the DDA");
}

void Driver::refuse_turned_blocks(const Stage& stage) const {
  if (stage.kinematics != Kinematics::linear) return;
  constexpr double kMost = 0.01;  // [rad]; a rotation r is measured as a strain r^2/2
  for (const Body& b : setup_->bodies()) {
    if (b.driven || setup_->pool_of(b).method() != "nmm") continue;
    const auto p = static_cast<std::size_t>(b.pool);
    const Mat2 R = polar_rotation(setup_->pool_of(b)
                                      .release(b.index, setup_->part(std::span<const double>(state_.q), p),
                                               setup_->part(std::span<const double>(state_.v), p))
                                      .motion.F);
    const double turn = std::atan2(R(1, 0), R(0, 0));
    if (std::abs(turn) <= kMost) continue;
    throw PlanError(fmt::format(
        "t = {:.6g} s, stage '{}': block '{}' is turned by {:.3g} rad, and linear kinematics, in which rotations "
        "cause strains, allows {:g} rad; use kinematics = \"corotational\"",
        seconds(state_.time), stage.name, model_->blocks[b.block.index()].name, turn, kMost));
  }
}

void Driver::refuse_missed_times() {
  const std::span<const Tick> begins(state_.stage_begin);
  const auto now = static_cast<std::size_t>(state_.stage);
  const auto stage_name = [&](StageId s) { return plan_->stages[s.index()].name; };
  // Faults that existed before the stage that has just ended have been reported.
  std::vector<TimeFault> known;
  std::vector<StageId> met;
  if (now > 0) {
    const Tick planned = begins[now - 1] + plan_->stages[now - 1].duration;
    known = time_faults(*model_, *plan_, begins.first(now), planned);
    met = stages_met(*model_, *plan_, begins.first(now), planned);
  }
  for (const TimeFault& f : time_faults(*model_, *plan_, begins, stage_end_)) {
    if (std::any_of(known.begin(), known.end(), [&](const TimeFault& k) { return k.same(f); })) continue;
    if (f.kind == TimeFault::Kind::missed)
      throw PlanError(
          fmt::format("t = {:.6g} s, stage '{}': {}{}; it acts in no stage: let it begin with a stage (start = \"{}\")",
                      seconds(state_.time), stage_name(StageId{state_.stage}), text(f, *model_),
                      now > 0 ? " because an earlier stage has ended early" : "", stage_name(StageId{state_.stage})));
    event(EventKind::warning, text(f, *model_));
  }
  const std::vector<StageId> meets = stages_met(*model_, *plan_, begins, stage_end_);
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (met[i] == meets[i]) continue;
    const bool motion = i < model_->motions.size();
    event(EventKind::warning,
          fmt::format("stage '{}' has ended early: the {} '{}' begins in stage '{}', not in '{}' as planned; start = "
                      "\"{}\" would "
                      "make it begin with that stage",
                      plan_->stages[now - 1].name, motion ? "motion" : "function",
                      motion ? model_->motions[i].setting().name : model_->functions[i - model_->motions.size()].name,
                      stage_name(meets[i]), stage_name(met[i]), stage_name(met[i])));
  }
}

}  // namespace scree::coupling
