// Read-only views of a run for its consumers: results, live streaming, progress, tests.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "coupling/ledger/ledger.h"
#include "coupling/plan.h"
#include "coupling/state.h"

namespace scree::coupling {

/// The cells of all bodies; constant while `id` does not change (it changes when a stage creates new bodies).
struct MeshView {
  std::uint32_t id = 0;
  std::span<const std::int32_t> offsets, connectivity;                   // polygon cells of points (VTK polygons)
  std::span<const std::int32_t> cell_block, cell_material, cell_method;  // per cell
  std::span<const char> cell_explicit;  // per cell: 1 in the explicit half of a divided block
  std::span<const double> origin;       // x, y per point: initial position in the model [m]
  std::vector<std::string> methods;     // names; cell_method is an index into them
};

/// Statistics of the driver since the start.
struct RunStats {
  std::int64_t steps = 0, cuts = 0;
  // Of implicit steps: Newton iterations, open-close passes, switches of contact states in these passes,
  // factorisations, rank-1 updates of factors.
  std::int64_t iterations = 0, passes = 0, switches = 0, factorisations = 0, updates = 0;
  std::int64_t corrections = 0;  // solutions with the factor of another matrix
  // Corrections with an incomplete factor of blocks; number of such factors; passes of clusters of bodies; passes that
  // fell back from an incomplete factor to a complete one.
  std::int64_t block_iterations = 0, incomplete_factors = 0, local_passes = 0, fallbacks = 0;
  std::int64_t contacts = 0;  // closed points at present
  std::int64_t elements = 0, unknowns = 0, blocks = 0;
  double wall_explicit = 0.0, wall_implicit = 0.0, wall_output = 0.0;  // of all attempts at steps; of output [s]
  // Processor time of the process, all threads [s]: of stages with explicit steps only, of other stages (steps with the
  // work before and after them: bounds, rules, checks, ledger), and of output (frames, histories, checkpoints).
  double cpu_explicit = 0.0, cpu_implicit = 0.0, cpu_output = 0.0;
  std::int64_t audit_checks = 0;  // so far, in an audited run
  double audit_worst = 0.0;       // the largest ratio of a checked value to its limit
  // Effort of partitioned stages, including failed steps (pace.h): so far, and at the beginning of the present stage.
  double effort = 0.0, effort_before = 0.0;
  double left_work = 0.0;       // work of residual forces at round-off in implicit steps [J]
  double element_steps = 0.0;   // number of explicit element updates
  std::int64_t asleep = 0;      // blocks at present
  double sleep_momentum = 0.0;  // sum of |momentum| of blocks when they fell asleep [N s]
  // Of contacts that slid far: the smallest ratio of the impulse of friction to that of its limit, and the contact.
  double friction_ratio = std::numeric_limits<double>::infinity();
  ContactKey friction_key{};
};

/// The contact points in the list at an instant, open ones included, in the order of their keys.
struct ContactView {
  std::span<const double> position;       // x, y of the corner per point [m]
  std::span<const double> normal;         // x, y per point of the unit normal of the edge, outward of its block
  std::span<const ContactMemory> memory;  // per point: key, status, forces
};

/// The bolts and liners at an instant, in the order of Model::bolts, and the nodes of those that are installed. Of a
/// liner `force` is the axial force of largest size, and `shear` the largest bending moment [N m]; it has no slip.
struct BoltsView {
  std::span<const double> force, shear;  // per bolt: largest axial force, and shear force at a joint [N]
  std::span<const double> slip, strain;  // per bolt: largest slip of the bond [m], largest plastic strain
  std::span<const std::int32_t> broken;  // per bolt: number of broken segments
  std::span<const double> position;      // x, y per node [m]
  std::span<const double> node_force;    // per node: axial force in the segment to the next node [N]
  std::span<const std::int32_t> bolt;    // per node: index of its bolt
  std::span<const std::int32_t> liner;   // per bolt: 1 for a liner
};

/// State at one instant. Points are those of the mesh, in the same order.
struct FrameView {
  double time = 0.0;  // [s]
  Tick tick = 0;
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::string_view stage_name;
  Integrator integrator = Integrator::explicit_;
  double end_time = 0.0;                       // of the whole plan [s]
  std::span<const double> position, velocity;  // x, y per point [m], [m/s]
  std::span<const double> stress;              // xx, yy, xy per cell, Cauchy [Pa]
  const MeshView* mesh = nullptr;
  const State* state = nullptr;
  const RunStats* stats = nullptr;
  const ContactView* contacts = nullptr;  // nullptr: not requested (Plan::output.contacts)
  const BoltsView* bolts = nullptr;       // nullptr: the model has no bolts
};

/// Monitors and ledger, written more often than frames. Spans are in the order of Model::monitors.
struct HistoryView {
  double time = 0.0;
  Tick tick = 0;
  std::span<const double> position, displacement, velocity;  // x, y per monitor
  std::span<const double> stress;                            // xx, yy, xy per monitor, recovered Cauchy stress [Pa]
  const Ledger* ledger = nullptr;
  const RunStats* stats = nullptr;
  const BoltsView* bolts = nullptr;  // nullptr: the model has no bolts
};

/// Measures by which a rule changes the method of a block (plan.h: SwitchRules). T and U are its kinetic and elastic
/// energy, dT and dU their non-affine parts.
struct MethodMeasures {
  double kinetic = 0.0, elastic = 0.0;         // dT and dU over T + |U|
  double inhomogeneity = 0.0;                  // sqrt(dU/|U|)
  double strain_rate = 0.0;                    // largest principal one of the affine part [1/s]
  double stress = 0.0;                         // largest principal one of the affine part, absolute value [Pa]
  double acceleration = 0.0;                   // resultant of the contact forces over the mass [m/s2]
  double cost_before = 0.0, cost_after = 0.0;  // predicted: unknowns per step, explicit: per second; 0: none
};

/// Balance of one hand-over of one block (docs/theory/transfer.md).
struct TransferRow {
  double time = 0.0;
  BlockId block;
  std::string from, to;
  BodyTotals before, after;
  double reservoir_kinetic = 0.0, reservoir_elastic = 0.0, booked = 0.0;  // [J]
  /// Relative errors: mass, momentum, angular momentum about the block's centre, energy with `reservoir` and `booked`.
  double mass_error = 0.0, momentum_error = 0.0, angular_error = 0.0, energy_error = 0.0;
  bool by_rule = false;  // changed by a rule during a stage, because of `measures`
  MethodMeasures measures;
};

/// The free block whose centre of mass moved farthest in a stage.
struct StageTravel {
  std::string stage;
  BlockId block;          // invalid: no block is free
  double farthest = 0.0;  // [m]
};

/// A message to the user about a run that continues.
struct Warning {
  double time = 0.0;  // [s]
  std::string text;   // one line
};

enum class EventKind {
  stage_start,
  stage_step,
  stage_rule,
  stage_end,
  transfer,
  partition,
  sleep,
  bolt_broken,
  excavated,
  filled,
  step_cut,
  not_converged,
  warning
};
struct Event {
  EventKind kind = EventKind::warning;
  double time = 0.0;
  std::string text;  // one line
  const TransferRow* transfer = nullptr;
  const StageTravel* travel = nullptr;  // of stage_end
};
[[nodiscard]] std::string_view name(EventKind kind);
/// True for a kind that may occur hundreds of times: cuts, hand-overs of blocks, changes of a partition, sleep.
/// @param kind  its name
[[nodiscard]] bool comes_often(std::string_view kind);
[[nodiscard]] std::string_view name(Integrator integrator);

/// Result of a run.
struct RunEnd {
  enum class Status { done, interrupted, not_converged, non_finite } status = Status::done;
  std::string reason;  // for anything but done: time, block, contact, likely cause
};

/// A consumer. It must not change the run, and must not make the run wait or fail unless results would be lost.
class Sink {
 public:
  Sink() = default;
  Sink(const Sink&) = delete;
  Sink& operator=(const Sink&) = delete;
  virtual ~Sink() = default;
  virtual void begin(const Model& model, const Plan& plan) { (void)model, (void)plan; }
  virtual void topology(const MeshView& mesh) { (void)mesh; }
  virtual void frame(const FrameView& frame) { (void)frame; }
  virtual void history(const HistoryView& history) { (void)history; }
  virtual void event(const Event& event) { (void)event; }
  /// Called after every committed step: cheap, for progress and rates.
  virtual void step(double time, const RunStats& stats, const Ledger& ledger) { (void)time, (void)stats, (void)ledger; }
  virtual void end(const RunEnd& end, const FrameView& last) { (void)end, (void)last; }
};

/// Requests to a run from outside, polled between steps.
class Control {
 public:
  Control() = default;
  Control(const Control&) = delete;
  Control& operator=(const Control&) = delete;
  virtual ~Control() = default;
  /// True to stop after the present step.
  virtual bool stop_requested() { return false; }
  /// True to give up the present step too, if it takes long: the state stays the one before the step. Polled inside
  /// steps: it must be fast.
  virtual bool give_up_step() { return false; }
};

}  // namespace scree::coupling
