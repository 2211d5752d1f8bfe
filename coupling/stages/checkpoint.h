// The complete data of a run at an instant, from which the driver continues as if the run had not stopped.
#pragma once

#include <vector>

#include "coupling/integrate/time_integrator.h"
#include "coupling/sink.h"
#include "coupling/stages/rest_watch.h"
#include "coupling/stages/run_watch.h"

namespace scree::coupling {

/// All data that the further run depends on, and all totals since the start. Taken within a stage, between two steps;
/// at the end of a stage before this end is reported.
struct Checkpoint {
  State state;
  IntegratorMemory integrator;
  // Progress of the stage.
  Tick stage_end = 0;
  std::int64_t first_step = 0;      // of the stage
  std::vector<double> stage_begin;  // x, y per body: centre of mass at the beginning of the stage [m]
  RestTrace rest;                   // history of a stage that runs to rest
  bool ended = false;               // ended before its duration was over: at rest, or by a rule
  std::uint32_t mesh = 0;           // id of the present mesh
  Tick largest_step = 0;            // largest allowed step; 0: not determined yet
  // Totals and records.
  RunStats stats;
  Audit audit;
  std::vector<TransferRow> transfers;
  std::vector<StageTravel> travels;
  std::vector<Warning> warnings;
  std::vector<std::int64_t> rule_changes;  // 2 per stage: changes by its rules of methods, and of sides
  ReportedWarnings reported;

  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// Stores checkpoints. Like a Sink it must not change the run, but a checkpoint that cannot be written ends the run.
class Keeper {
 public:
  Keeper() = default;
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;
  virtual ~Keeper() = default;
  /// Called after every step. A checkpoint is also kept, without this call, where the run begins, ends or stops, and
  /// where a stage ends.
  virtual bool due(std::int64_t step) = 0;
  /// @throws any exception of the keeper; it ends the run
  virtual void keep(const Checkpoint& checkpoint) = 0;
};

// ---------------------------------------------------------------------------------------------------------------

template <class Visitor>
void visit(const BodyTotals& t, Visitor&& see) {
  see("totals.mass", t.mass);
  see("totals.centre", t.centre);
  see("totals.momentum", t.momentum);
  see("totals.angular_momentum", t.angular_momentum);
  see("totals.kinetic", t.kinetic);
  see("totals.elastic", t.elastic);
}

template <class Visitor>
void visit(const TransferRow& row, Visitor&& see) {
  see("row.time", row.time);
  see("row.block", row.block.value);
  see("row.from", row.from);
  see("row.to", row.to);
  visit(row.before, see);
  visit(row.after, see);
  see("row.reservoir_kinetic", row.reservoir_kinetic);
  see("row.reservoir_elastic", row.reservoir_elastic);
  see("row.booked", row.booked);
  see("row.mass_error", row.mass_error);
  see("row.momentum_error", row.momentum_error);
  see("row.angular_error", row.angular_error);
  see("row.energy_error", row.energy_error);
  see("row.by_rule", row.by_rule);
  see("row.kinetic", row.measures.kinetic);
  see("row.elastic", row.measures.elastic);
  see("row.inhomogeneity", row.measures.inhomogeneity);
  see("row.strain_rate", row.measures.strain_rate);
  see("row.stress", row.measures.stress);
  see("row.acceleration", row.measures.acceleration);
  see("row.cost_before", row.measures.cost_before);
  see("row.cost_after", row.measures.cost_after);
}

template <class Visitor>
void visit(const RunStats& s, Visitor&& see) {
  static_assert(sizeof(RunStats) == 35 * 8, "a field that is new here belongs in the list below");
  see("stats.steps", s.steps);
  see("stats.cuts", s.cuts);
  see("stats.iterations", s.iterations);
  see("stats.passes", s.passes);
  see("stats.switches", s.switches);
  see("stats.factorisations", s.factorisations);
  see("stats.updates", s.updates);
  see("stats.corrections", s.corrections);
  see("stats.block_iterations", s.block_iterations);
  see("stats.incomplete_factors", s.incomplete_factors);
  see("stats.local_passes", s.local_passes);
  see("stats.fallbacks", s.fallbacks);
  see("stats.contacts", s.contacts);
  see("stats.elements", s.elements);
  see("stats.unknowns", s.unknowns);
  see("stats.blocks", s.blocks);
  see("stats.wall_explicit", s.wall_explicit);
  see("stats.wall_implicit", s.wall_implicit);
  see("stats.wall_output", s.wall_output);
  see("stats.cpu_explicit", s.cpu_explicit);
  see("stats.cpu_implicit", s.cpu_implicit);
  see("stats.cpu_output", s.cpu_output);
  see("stats.audit_checks", s.audit_checks);
  see("stats.audit_worst", s.audit_worst);
  see("stats.left_work", s.left_work);
  see("stats.element_steps", s.element_steps);
  see("stats.asleep", s.asleep);
  see("stats.sleep_momentum", s.sleep_momentum);
  see("stats.effort", s.effort);
  see("stats.effort_before", s.effort_before);
  see("stats.friction_ratio", s.friction_ratio);
  s.friction_key.visit(see);
}

template <class Visitor>
void Checkpoint::visit(Visitor&& see) const {
  state.visit(see);
  integrator.visit(see);
  see("stage_end", stage_end);
  see("first_step", first_step);
  see("stage_begin", stage_begin);
  rest.visit(see);
  see("ended", ended);
  see("mesh", mesh);
  see("largest_step", largest_step);
  coupling::visit(stats, see);
  audit.visit(see);
  see.size("transfers", transfers);
  for (const TransferRow& row : transfers) coupling::visit(row, see);
  see.size("travels", travels);
  for (const StageTravel& t : travels) {
    see("travel.stage", t.stage);
    see("travel.block", t.block.value);
    see("travel.farthest", t.farthest);
  }
  see.size("warnings", warnings);
  for (const Warning& w : warnings) {
    see("warning.time", w.time);
    see("warning.text", w.text);
  }
  see("rule_changes", rule_changes);
  reported.visit(see);
}

}  // namespace scree::coupling
