// Runs the stages of a plan: the only place that knows the whole order of things.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

#include "coupling/integrate/time_integrator.h"
#include "coupling/sink.h"
#include "coupling/stages/bolt_watch.h"
#include "coupling/stages/checkpoint.h"
#include "coupling/stages/end_rules.h"
#include "coupling/stages/force_balance.h"
#include "coupling/stages/method_rules.h"
#include "coupling/stages/observer.h"
#include "coupling/stages/rest_watch.h"
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
  void set_keeper(Keeper& keeper) { keeper_ = &keeper; }
  /// run() goes on from here, to the same end as if it had never stopped. Sinks see begin() and the mesh again, then
  /// what comes after the checkpoint.   @pre it is of the same model, plan and methods
  void continue_from(Checkpoint checkpoint) { from_ = std::move(checkpoint); }
  /// Keeps a checkpoint now.   @pre called by the control while it is asked: between two steps
  void keep_checkpoint();

  /// Begins the first stage and finds its step, which is not taken: whether the plan can begin.
  /// @param sink  sees what is said of the step   @throws PlanError as run() does before its first step
  void begin_only(Sink& sink);
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
  /// What was warned of so far.
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  void start();
  void change_stage(std::size_t index);
  void assign_sides(const Stage& stage);
  /// Bodies as the stage, and the sides of a partitioned one, want them.
  /// @param why  blocks that change by a rule
  void change_bodies(const Stage& stage, std::span<const MethodChange> why = {});
  /// Tells of blocks that left and came.   @param energy  of those that left [J]
  void tell_construction(const Stage& stage, const TransferReport& handed, double energy);
  /// An integrator for them, and who looks on.
  void begin_moving(const Stage& stage, bool new_mesh);
  /// What looks at the rules of a stage, for the present bodies.
  void watch_rules(const Stage& stage);
  /// Blocks that have become fast or slow change sides.
  void change_partition(const Stage& stage);
  /// Blocks that have become calm, or are struck, change method.
  void change_methods(const Stage& stage);
  [[nodiscard]] bool takes_explicit_steps(const Stage& stage, const Body& b) const;
  /// The setup, integrator and observer of a checkpoint's stage, as they were.
  void go_on();
  [[nodiscard]] std::unique_ptr<TimeIntegrator> make_integrator(const Stage& stage);
  void observe();
  /// Shows sinks the present mesh, once.
  void show_mesh();
  [[nodiscard]] Checkpoint checkpoint_of_driver() const;
  /// Keeps a checkpoint, if it is due or in any case.
  void keep(bool in_any_case);
  /// @throws PlanError where linear kinematics would take a block's rotation for strain
  void refuse_turned_blocks(const Stage& stage) const;
  /// @throws PlanError where blocks cannot change method during the stage
  void refuse_switching(const Stage& stage) const;
  /// At the end of a stage to rest without a criterion: a block that nothing supports; invalid: none, or only told.
  [[nodiscard]] BlockId unsupported_at_rest(const Stage& stage);
  /// At the same place: warns of forces that nothing balances.
  void tell_unbalanced(const Stage& stage);
  /// What is remembered of the way to rest.   @param ratio  unbalanced force, of the largest force
  void follow_rest(const Stage& stage, std::optional<double> ratio);
  void begin_stage(const Stage& stage);
  /// A stage begins at the present time.
  void enter_time(const Stage& stage);
  [[nodiscard]] Clocks clocks() const;
  /// @throws PlanError for a motion or function that no stage can meet any more; warns of those that outlast the run
  void refuse_missed_times();
  /// @param stop  it stops at the first step at or after this, if the stage is not over before
  RunEnd run_stage(const Stage& stage, Tick stop);
  /// A stage that is to come to rest by a measure: done, not yet, or not in the steps or time it has.
  [[nodiscard]] RunEnd check_rest(const Stage& stage);
  /// Ends the stage where a rule of its own has come true, and moves the end of the run with it.
  void check_end(const Stage& stage);
  /// The latest end of the run, from the present stage on.
  [[nodiscard]] Tick latest_end() const;
  /// Ends a run with a number that is not finite in its state or its books, whatever brought it there.
  [[nodiscard]] RunEnd check_finite(const Stage& stage);
  /// Warns of friction that contacts have lost and of spins that the steps damp; `complete`, the ledger is up to date:
  /// and of large columns of the scheme.
  void warn_of_losses(const Stage& stage, bool complete);
  /// Ends a run that holds more energy than it was given (run_watch.h).   @param complete  the ledger is up to date
  [[nodiscard]] RunEnd check_gain(const Stage& stage, bool complete);
  /// Ends a partitioned stage that does not get on (pace.h).   @param cause  why its last step failed; empty: it did
  /// not
  [[nodiscard]] RunEnd check_pace(const Stage& stage, const std::string& cause);
  /// Ends a run whose ledger is open by more than the plan allows.
  [[nodiscard]] RunEnd check_closure(const Stage& stage);
  /// The longest step in which no point moves too far at its present velocity: an implicit step that is found too long
  /// afterwards has cost all its passes.
  [[nodiscard]] Tick step_of_fastest() const;
  /// @throws PlanError where dt is too long for internal forces that are met once in it
  void check_slow_step(const Stage& stage, bool first);
  /// Ends the run where the last step was wrong (Plan::audit).
  [[nodiscard]] RunEnd check_audit(const Stage& stage);
  void drop_velocities();
  [[nodiscard]] static double wall();  // time of a steady clock [s]
  enum class Phase { set_up, explicit_steps, implicit_steps, output };
  /// What the processor does from now on is charged to this phase; asked for where phases change, not at every step,
  /// as the clock of a process takes a call of the system.   @return the phase so far
  Phase enter(Phase next);
  /// One step, by as many attempts as it takes; and what is looked at after it.
  /// Finds anew how long steps may be, where that is due or a step has made it doubtful.
  void bound_step(const Stage& stage, bool due);
  /// Joints have the strengths that the stage gives them at a time.
  void set_strength(const Stage& stage, Tick time);
  /// One attempt of the integrator.   @param cap  of its length   @param h  its length
  [[nodiscard]] StepReport attempt(const Stage& stage, Tick cap, Tick& h);
  /// A sentence on an attempt that was refused.
  [[nodiscard]] std::string told_refusal(const StepReport& report, Tick h) const;
  [[nodiscard]] RunEnd advance_step(const Stage& stage);
  void count(const StepReport& report);
  [[nodiscard]] RunEnd after_step(const Stage& stage);
  [[nodiscard]] std::int64_t steps_of_stage() const { return state_.step - first_step_; }
  /// @param first  of the stage: what binds the step is told
  [[nodiscard]] Tick largest_step(const Stage& stage, bool first = false);
  /// Counts changes that rules of the present stage made.
  void count_rule(int kind, std::int64_t changes);
  /// Tells of rules of stages that have ended which changed nothing.
  void tell_idle_rules();
  void event(EventKind kind, std::string text, const TransferRow* row = nullptr, const StageTravel* travel = nullptr);
  [[nodiscard]] std::vector<Vec2> centres() const;
  [[nodiscard]] StageTravel travel_since(const std::vector<Vec2>& begin) const;
  /// Brings the ledger up to date, for whoever looks at its closure.
  void complete_ledger();
  void sample(bool frame);
  /// Hands the last state to the sinks.
  void finish(const RunEnd& result);

  static constexpr std::size_t kRuleKinds = 2;  // of Checkpoint::rule_changes, a stage

  const Model* model_;
  const Plan* plan_;
  const Methods* methods_;
  std::vector<Sink*> sinks_;
  Control* control_ = nullptr;
  Keeper* keeper_ = nullptr;
  std::optional<Checkpoint> from_;
  State state_;
  std::unique_ptr<Setup> setup_;
  std::unique_ptr<Observer> observer_;
  std::unique_ptr<TimeIntegrator> integrator_;
  StepControl step_control_;
  double detection_ = 0.0;
  std::unique_ptr<ForceBalance> balance_;      // of stages with rest_force
  std::unique_ptr<EndWatch> end_watch_;        // of stages with rules for their end
  std::unique_ptr<MethodRules> method_rules_;  // of stages with rules for methods
  BoltWatch bolt_watch_;
  bool ended_ = false;                       // the stage is over before its duration: at rest, or by a rule
  std::int64_t first_step_ = 0;              // of the stage
  std::vector<char> settled_;                // sides of blocks that stay on them in the stage; empty: to be found
  std::vector<Vec2> stage_begin_;            // centres of mass then
  RestTrace rest_trace_;                     // of stages that run to rest
  double fast_elements_ = 0.0;               // whose internal force is met at every substep
  std::uint32_t mesh_ = 0, mesh_shown_ = 0;  // ids of the present mesh and of that which sinks have
  Tick largest_ = 0;                         // step that is allowed; 0: to be found
  Tick end_ = 0, stage_end_ = 0;
  RunStats stats_, committed_;  // with and without the attempts at the present step
  Phase phase_ = Phase::set_up;
  double phase_begin_ = 0.0;  // by the clock of the process [s]
  Audit audit_;
  std::vector<TransferRow> transfers_;
  std::vector<StageTravel> travels_;
  std::vector<Warning> warnings_;
  std::vector<std::int64_t> rule_changes_;  // per stage: of methods, and of sides
  Told told_;
  double round_off_ = 0.0;  // energy_of_round_off() of the model [J]
};

/// What is said of a block that should come to rest.
inline constexpr const char* kUnsupported =
    "has no path of closed contacts to a support, so that nothing balances its weight and loads; likely causes: a gap "
    "under it, a support that is missing, or a stage that should not come to rest";

/// Contact detection distance that a plan leaves open: a twentieth of the smallest block's root area [m].
[[nodiscard]] double auto_detection(const Model& model);

}  // namespace scree::coupling
