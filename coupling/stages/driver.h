// Runs the stages of a plan: the only place that knows the whole order of things.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "coupling/integrate/mover.h"
#include "coupling/sink.h"
#include "coupling/stages/force_balance.h"
#include "coupling/stages/observer.h"
#include "coupling/transfer/transfer.h"

namespace scree::coupling {

/// A plan that cannot be carried out as it stands: an explicit step above the stable one, a method without implicit
/// form.
struct PlanError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Driver {
 public:
  /// @param model,plan,methods  must outlive the driver
  Driver(const Model& model, const Plan& plan, const Methods& methods);

  void add_sink(Sink& sink) { sinks_.push_back(&sink); }
  void set_control(Control& control) { control_ = &control; }

  /// Runs to the end of the plan, or to `until` [s]. Not converging is an outcome; only a PlanError is thrown.
  RunEnd run(std::optional<double> until = std::nullopt);

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Setup& setup() const { return *setup_; }
  [[nodiscard]] const RunStats& stats() const { return stats_; }
  /// What an audited run has found so far.
  [[nodiscard]] const Audit& audit() const { return audit_; }
  [[nodiscard]] const std::vector<TransferRow>& transfers() const { return transfers_; }
  /// A stage that has ended: how far its blocks went.
  [[nodiscard]] const std::vector<StageTravel>& travels() const { return travels_; }

 private:
  void start();
  void change_stage(std::size_t index);
  /// @throws PlanError where linear kinematics would take a block's rotation for strain
  void refuse_turned_blocks(const Stage& stage) const;
  /// At the end of a stage to rest without a criterion: a block that nothing supports; invalid: none, or only told.
  [[nodiscard]] BlockId unsupported_at_rest(const Stage& stage);
  RunEnd run_stage(std::size_t index, Tick end);
  /// A stage that is to come to rest by a measure: done, not yet, or not in the steps or time it has.
  [[nodiscard]] RunEnd check_rest(const Stage& stage, Tick end);
  /// Ends the run where the last step was wrong (Plan::audit).
  [[nodiscard]] RunEnd check_audit(const Stage& stage);
  void drop_velocities();
  RunEnd advance_to(const Stage& stage, Tick target);
  /// @param first  of the stage: what binds the step is told
  [[nodiscard]] Tick largest_step(const Stage& stage, bool first = false);
  void event(EventKind kind, std::string text, const TransferRow* row = nullptr, const StageTravel* travel = nullptr);
  [[nodiscard]] std::vector<Vec2> centres() const;
  [[nodiscard]] StageTravel travel_since(const std::vector<Vec2>& begin) const;
  void look(bool frame);
  /// Hands the last state to the sinks.
  void finish(const RunEnd& result);

  const Model* model_;
  const Plan* plan_;
  const Methods* methods_;
  std::vector<Sink*> sinks_;
  Control* control_ = nullptr;
  State state_;
  std::unique_ptr<Setup> setup_;
  std::unique_ptr<Observer> observer_;
  std::unique_ptr<Mover> mover_;
  StepControl step_control_;
  double detection_ = 0.0;
  std::unique_ptr<ForceBalance> balance_;  // of stages with rest_force
  bool rested_ = false;                    // the stage has found its balance
  std::int64_t first_step_ = 0;            // of the stage
  Tick end_ = 0, stage_end_ = 0;
  RunStats stats_;
  Audit audit_;
  std::vector<TransferRow> transfers_;
  std::vector<StageTravel> travels_;
};

/// Contact detection distance that a plan leaves open: a twentieth of the smallest block's root area [m].
[[nodiscard]] double auto_detection(const Model& model);

}  // namespace scree::coupling
