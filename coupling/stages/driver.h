// Runs the stages of a plan. The complete order of operations is defined here only.
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
#include "coupling/stages/sleep_audit.h"
#include "coupling/stages/sleep_rules.h"
#include "coupling/transfer/transfer.h"

namespace scree::coupling {

/// A plan that cannot be carried out as given: an explicit step above the stable one, a method without implicit form.
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
  /// run() continues from this checkpoint, to the same end as if it had not stopped. Sinks receive begin() and the mesh
  /// again, then everything after the checkpoint.   @pre it is of the same model, plan and methods
  void continue_from(Checkpoint checkpoint) { from_ = std::move(checkpoint); }
  /// Keeps a checkpoint now.   @pre called by the control while it is polled between two steps
  void keep_checkpoint();

  /// Checks that the plan can begin: begins the first stage and determines its step length, without a step.
  /// @param sink  receives the events about the step   @throws PlanError as run() does before its first step
  void begin_only(Sink& sink);
  /// Runs to the end of the plan, or to `until` [s]. Not converging is an outcome; only a PlanError is thrown.
  RunEnd run(std::optional<double> until = std::nullopt);

  [[nodiscard]] const State& state() const { return state_; }
  [[nodiscard]] const Setup& setup() const { return *setup_; }
  [[nodiscard]] const RunStats& stats() const { return stats_; }
  /// Results of the audit so far.
  [[nodiscard]] const Audit& audit() const { return audit_; }
  [[nodiscard]] const std::vector<TransferRow>& transfers() const { return transfers_; }
  /// Largest travel of a block, per stage that has ended.
  [[nodiscard]] const std::vector<StageTravel>& travels() const { return travels_; }
  /// Warnings so far.
  [[nodiscard]] const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  void start();
  void change_stage(std::size_t index);
  void assign_sides(const Stage& stage);
  /// Creates the bodies that the stage, and the sides of a partitioned one, require.
  /// @param why  blocks that change by a rule
  void change_bodies(const Stage& stage, std::span<const MethodChange> why = {});
  /// Reports blocks that were removed and added.   @param energy  of the removed ones [J]
  void report_construction(const Stage& stage, const TransferReport& handed, double energy);
  /// Creates the integrator of the present bodies, the observer and the watches.
  void begin_moving(const Stage& stage, bool new_mesh);
  /// Creates the evaluators of the rules of a stage, for the present bodies.
  void watch_rules(const Stage& stage);
  /// Changes the sides of blocks that have become fast or slow.
  void change_partition(const Stage& stage);
  /// Changes the method of blocks that have become calm, or are hit.
  void change_methods(const Stage& stage);
  /// Changes sides, sleep and methods of blocks by the rules of the stage, before a step.
  void change_by_rules(const Stage& stage);
  /// Changes which blocks are asleep.
  void change_sleep(const Stage& stage);
  /// Prepares the audit of the blocks that are asleep.
  void audit_sleep(const Stage& stage);
  [[nodiscard]] bool takes_explicit_steps(const Stage& stage, const Body& b) const;
  /// Restores the setup, integrator and observer of a checkpoint's stage.
  void go_on();
  void count_awake_elements();
  [[nodiscard]] std::unique_ptr<TimeIntegrator> make_integrator(const Stage& stage);
  /// The same for one with steps of one kind and the bodies of a setup.
  [[nodiscard]] std::unique_ptr<TimeIntegrator> make_plain(const Stage& stage, const Setup& setup) const;
  void observe();
  /// Passes the present mesh to the sinks, once.
  void show_mesh();
  [[nodiscard]] Checkpoint checkpoint_of_driver() const;
  /// Keeps a checkpoint, if one is due or `in_any_case`.
  void keep(bool in_any_case);
  /// @throws PlanError where linear kinematics would treat a block's rotation as strain
  void refuse_turned_blocks(const Stage& stage) const;
  /// @throws PlanError where blocks cannot change method during the stage
  void refuse_switching(const Stage& stage) const;
  /// At the end of a stage to rest without a criterion: a block that nothing supports; invalid: none, or it was only
  /// warned about.
  [[nodiscard]] BlockId unsupported_at_rest(const Stage& stage);
  /// At the end of such a stage: warns about unbalanced forces.
  void warn_unbalanced(const Stage& stage);
  /// Updates the trace to rest.   @param ratio  unbalanced force over the largest force
  void follow_rest(const Stage& stage, std::optional<double> ratio);
  void begin_stage(const Stage& stage);
  /// Sets the times of a stage that begins now.
  void enter_time(const Stage& stage);
  [[nodiscard]] Clocks clocks() const;
  /// @throws PlanError for a motion or function that no stage can cover any more; warns of those that outlast the run
  void refuse_missed_times();
  /// @param stop  the run stops after the first step that ends at or after this time, if the stage is not over before
  RunEnd run_stage(const Stage& stage, Tick stop);
  /// Checks a stage with rest_force: at rest, not yet, or not within its steps or its duration.
  [[nodiscard]] RunEnd check_rest(const Stage& stage);
  /// Ends the stage where one of its rules is met, and updates the end of the run.
  void check_end(const Stage& stage);
  /// The latest end of the run, from the present stage on.
  [[nodiscard]] Tick latest_end() const;
  /// Ends a run with a number that is not finite in its state or its ledger, whatever the cause.
  [[nodiscard]] RunEnd check_finite(const Stage& stage);
  /// Warns about friction that contacts have lost and about spins that the steps damp; if the ledger is up to date
  /// (`complete`), also about large columns of the scheme.
  void warn_of_losses(const Stage& stage, bool complete);
  /// Ends a run that holds more energy than was supplied (run_watch.h).   @param complete  the ledger is up to date
  [[nodiscard]] RunEnd check_gain(const Stage& stage, bool complete);
  /// Ends a partitioned stage that is too slow (pace.h).   @param cause  of the failure of its last step; empty: none
  [[nodiscard]] RunEnd check_pace(const Stage& stage, const std::string& cause);
  /// Ends a run whose ledger is open by more than the plan allows.
  [[nodiscard]] RunEnd check_closure(const Stage& stage);
  /// The longest step in which no point moves too far at its present velocity. An implicit step that proves too long
  /// only afterwards has cost all its passes.
  [[nodiscard]] Tick step_of_fastest() const;
  /// @throws PlanError where dt is too long for internal forces that are evaluated once per dt
  void check_slow_step(const Stage& stage, bool first);
  /// Ends the run where the last step was wrong (Plan::audit).
  [[nodiscard]] RunEnd check_audit(const Stage& stage);
  void drop_velocities();
  [[nodiscard]] static double wall();  // time of a steady clock [s]
  enum class Phase { set_up, explicit_steps, implicit_steps, output };
  /// Charges processor time from now on to a phase. Called where phases change, not at every step, because reading the
  /// clock of the process is a system call.   @return the phase so far
  Phase enter(Phase next);
  /// Determines the largest step anew, if this is due or the last step has put it in doubt.
  void bound_step(const Stage& stage, bool due);
  /// Sets the strengths of the joints to those of the stage at a time.
  void set_strength(const Stage& stage, Tick time);
  /// One attempt of the integrator.   @param cap  of its length   @param h  its length
  [[nodiscard]] StepReport attempt(const Stage& stage, Tick cap, Tick& h);
  /// A sentence about an attempt that failed.
  [[nodiscard]] std::string refusal_text(const StepReport& report, Tick h) const;
  /// Takes one step, in as many attempts as it needs, and evaluates rules, checks and output after it.
  [[nodiscard]] RunEnd advance_step(const Stage& stage);
  void count(const StepReport& report);
  [[nodiscard]] RunEnd after_step(const Stage& stage);
  [[nodiscard]] std::int64_t steps_of_stage() const { return state_.step - first_step_; }
  /// @param first  first step of the stage: reports what binds the step
  [[nodiscard]] Tick largest_step(const Stage& stage, bool first = false);
  /// Counts changes that rules of the present stage made.
  void count_rule(int kind, std::int64_t changes);
  /// Reports rules that changed nothing, of stages that have ended.
  void warn_idle_rules();
  void event(EventKind kind, std::string text, const TransferRow* row = nullptr, const StageTravel* travel = nullptr);
  [[nodiscard]] std::vector<Vec2> centres() const;
  [[nodiscard]] StageTravel travel_since(const std::vector<Vec2>& begin) const;
  /// Brings the ledger up to date, for a check of its closure or for output.
  void complete_ledger();
  void sample(bool frame);
  /// Passes the last state to the sinks.
  void finish(const RunEnd& result);

  static constexpr std::size_t kRuleKinds = 2;  // entries of Checkpoint::rule_changes per stage

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
  std::unique_ptr<SleepRules> sleep_rules_;    // of stages with sleep
  std::unique_ptr<SleepAudit> sleep_audit_;    // while blocks are asleep, in an audited run
  BoltWatch bolt_watch_;
  bool ended_ = false;                       // the stage ended before its duration was over: at rest, or by a rule
  std::int64_t first_step_ = 0;              // of the stage
  std::vector<char> settled_;                // blocks that stay on their side in the stage; empty: not determined yet
  std::vector<Vec2> stage_begin_;            // centres of mass at the beginning of the stage
  RestTrace rest_trace_;                     // of stages that run to rest
  double fast_elements_ = 0.0;               // number of elements whose internal force is evaluated at every substep
  double awake_elements_ = 0.0;              // number of elements of blocks that take steps
  std::uint32_t mesh_ = 0, mesh_shown_ = 0;  // ids of the present mesh and of the one passed to the sinks
  Tick largest_ = 0;                         // largest allowed step; 0: not determined yet
  Tick end_ = 0, stage_end_ = 0;
  RunStats stats_, committed_;  // with and without the attempts at the present step
  Phase phase_ = Phase::set_up;
  double phase_begin_ = 0.0;  // by the clock of the process [s]
  Audit audit_;
  std::vector<TransferRow> transfers_;
  std::vector<StageTravel> travels_;
  std::vector<Warning> warnings_;
  std::vector<std::int64_t> rule_changes_;  // per stage: of methods, and of sides
  ReportedWarnings reported_;
  double round_off_ = 0.0;  // energy_of_round_off() of the model [J]
};

/// Message about a block that should come to rest.
inline constexpr const char* kUnsupported =
    "has no path of closed contacts to a support, so that nothing balances its weight and loads; likely causes: a gap "
    "under it, a support that is missing, or a stage that should not come to rest";

/// Contact detection distance if the plan gives none: a twentieth of the smallest block's root area [m].
[[nodiscard]] double auto_detection(const Model& model);

}  // namespace scree::coupling
