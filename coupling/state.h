// Everything that influences the future of a run, as one value. A copy of it is a checkpoint.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "coupling/bolt_memory.h"
#include "coupling/contact_list.h"
#include "coupling/ledger/ledger.h"
#include "coupling/step_limit.h"
#include "coupling/support_force.h"
#include "coupling/visit.h"
#include "model/pool.h"

namespace scree::coupling {

/// Energy that a block could not take along into its present method (docs/theory/transfer.md), and what brings it back:
/// the body that it was, and its fields as Release has them. They are empty where the block has been something else
/// since.
struct Remainder {
  BlockId block;
  double kinetic = 0.0, elastic = 0.0;  // [J]
  BodyRecord record;
  std::vector<double> position, velocity;
};

/// What the next implicit step begins to solve with.
struct KeptFactor {
  /// Steps make a factor of their own while `wait` is above 0, and wait the longer the less a kept one was worth.
  struct Patience {
    std::int32_t wait = 0, next_wait = 0;
    std::int32_t least = -1;  // corrections of a step with this factor; -1: of none yet
    std::int32_t excess = 0;  // of its steps so far, above that and one more
  };
  Patience patience;
  /// Which solver the next step of affine bodies begins with (docs/theory/linear-solvers.md).
  struct Choice {
    std::int32_t direct = 0;                // 1: a complete factor, 0: an incomplete one of blocks
    std::int32_t hold = 0, next_hold = 0;   // steps that it stays so after the incomplete one failed; the next time
    std::int32_t returns = 0;               // how often the complete one has been tried in vain
    double block_work = 0.0, excess = 0.0;  // of the last step by blocks; by which the other would have been less
  };
  Choice choice;
  std::vector<std::int32_t> column_start, row;  // the matrix it is of: lower triangle; empty: there is none
  std::vector<double> value;
};

inline constexpr char kDivided = 2;  // in State::explicit_side

/// What the rules of a stage remember of it (plan.h: EndRules, SwitchRules).
struct RuleMemory {
  struct Slip {
    std::int32_t a = -1, b = -1;  // blocks, a <= b
    double slip = 0.0;            // the largest of a point between them as the stage began [m]
    [[nodiscard]] bool same_pair(const Slip& other) const { return a == other.a && b == other.b; }
  };
  double peak = 0.0;                          // kinetic energy, the largest so far [J]
  Tick slow_since = -1, balanced_since = -1;  // -1: it is not
  std::vector<Slip> slips;                    // sorted by blocks
  Tick evaluated = -1, next_evaluation = 0;   // for blocks that may change method
  std::vector<Tick> calm_since;               // per block; -1: it is not
  std::vector<char> other_method;             // per block: 1 where a rule has taken it from the stage's method
  struct Energy {                             // where a subcycled stage began (energy_watch.h) [J]
    double held = 0.0, work = 0.0, made = 0.0;
    std::int32_t told = 0;  // 1: a warning has been given
  };
  Energy energy;
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

struct State {
  Tick time = 0;
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::vector<Tick> stage_begin;   // of each stage so far: what may be counted from them begins there
  Tick last_step = 0;              // length of the step before, for the shadow term
  StepLimit step_limit;            // of partitioned stages
  double relaxing = 0.0;           // kinetic energy a step ago, in stages that run to rest [J]
  std::vector<BodyRecord> bodies;  // in the order of their blocks
  // Per body: 1 where it takes explicit steps, kDivided where one half of it does; partitioned stages, else empty.
  std::vector<char> explicit_side;
  std::vector<double> q, v;      // x, y per node; pool after pool, body after body (Setup has the offsets)
  std::vector<double> a;         // acceleration at `time`, same layout (explicit stages; else empty)
  std::vector<double> v_before;  // velocity of the half step before, where damping lags on it (else empty)
  std::vector<double> damping;   // forces of mass-proportional damping that spares affine motion (else empty) [N]
  std::vector<double> sliding;   // forces that damp the deformation of sliding blocks (none slides: empty) [N]
  ContactList contacts;          // sorted by key; between stages, and where each half of a step has its own, memories alone
  KeptFactor factored;           // of implicit steps
  std::vector<Remainder> rest;
  std::vector<double>
      anchors;  // x, y per point support: how far hand-overs have shifted its anchor; empty: none yet [m]
  std::vector<BoltMemory> bolts;  // of the model; empty: it has none
  SupportForces support;          // of what has left the model
  RuleMemory rules;
  Ledger ledger;

  /// Shows every field, in a fixed order, to see(name, value); visit_to_write() so that they may change.
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// 64-bit hash of every bit of the state. Equal states have equal hashes; it is promised for one binary on one
/// type of processor.
[[nodiscard]] std::uint64_t state_hash(const State& state);

// ---------------------------------------------------------------------------------------------------------------

/// A body as State::visit() shows it.
template <class Visitor>
void visit_body(Visitor&& see, const BodyRecord& b) {
  see("body.block", b.block.value);
  see("body.method", b.method);
  see("body.outline", b.shape.outline);
  see("body.origin", b.shape.origin);
  see("body.mass", b.shape.mass);
  see("body.area", b.shape.area);
  see("body.second", b.shape.second);
  see("body.kinematics", b.form.kinematics);
  see("body.mass_kind", b.form.mass);
  see("body.cover_size", b.form.cover_size);
  see("body.offset_x", b.form.offset_x);
  see("body.offset_y", b.form.offset_y);
  see("body.onefold", b.form.onefold);
  see("body.model_triangle", b.form.model_triangle);
  see("body.rotation", b.form.rotation);
  see("body.cracks", b.form.cracks);
  see("body.edge_shift", b.edge_shift);
  see("body.absent", b.absent);
  see("body.placed", b.placed);
  see.size("body.explicit_region", b.form.division.region);
  for (const Vec2& x : b.form.division.region) {
    see("body.explicit_region", x.x());
    see("body.explicit_region", x.y());
  }
}

template <class Visitor>
void RuleMemory::visit(Visitor&& see) const {
  see("rules.peak", peak);
  see("rules.slow_since", slow_since);
  see("rules.balanced_since", balanced_since);
  see.size("rules.slips", slips);
  for (const Slip& s : slips) {
    see("rules.slip_a", s.a);
    see("rules.slip_b", s.b);
    see("rules.slip", s.slip);
  }
  see("rules.evaluated", evaluated);
  see("rules.next_evaluation", next_evaluation);
  see("rules.calm_since", calm_since);
  see("rules.other_method", other_method);
  see("rules.energy_held", energy.held);
  see("rules.energy_work", energy.work);
  see("rules.energy_made", energy.made);
  see("rules.energy_told", energy.told);
}

template <class Visitor>
void State::visit(Visitor&& see) const {
  see("time", time);
  see("step", step);
  see("stage", stage);
  see("stage_begin", stage_begin);
  see("last_step", last_step);
  see("step_limit.length", step_limit.length);
  see("step_limit.hold", step_limit.hold);
  see("step_limit.next_hold", step_limit.next_hold);
  see("relaxing", relaxing);
  see.size("bodies", bodies);
  for (const BodyRecord& b : bodies) visit_body(see, b);
  see("explicit_side", explicit_side);
  see("q", q);
  see("v", v);
  see("a", a);
  see("v_before", v_before);
  see("damping", damping);
  see("sliding", sliding);
  see.size("contacts", contacts.memory);
  for (const ContactMemory& c : contacts.memory) c.visit(see);
  see.size("points", contacts.points);
  for (const ContactPoint& p : contacts.points) p.visit(see);
  see("factored.wait", factored.patience.wait);
  see("factored.next_wait", factored.patience.next_wait);
  see("factored.least", factored.patience.least);
  see("factored.excess", factored.patience.excess);
  see("factored.direct", factored.choice.direct);
  see("factored.hold", factored.choice.hold);
  see("factored.next_hold", factored.choice.next_hold);
  see("factored.returns", factored.choice.returns);
  see("factored.block_work", factored.choice.block_work);
  see("factored.excess_work", factored.choice.excess);
  see("factored.column_start", factored.column_start);
  see("factored.row", factored.row);
  see("factored.value", factored.value);
  see.size("rest", rest);
  for (const Remainder& r : rest) {
    see("rest.block", r.block.value);
    see("rest.kinetic", r.kinetic);
    see("rest.elastic", r.elastic);
    visit_body(see, r.record);
    see("rest.position", r.position);
    see("rest.velocity", r.velocity);
  }
  see("anchors", anchors);
  see.size("bolts", bolts);
  for (const BoltMemory& b : bolts) b.visit(see);
  support.visit(see);
  rules.visit(see);
  ledger.visit(see);
}

}  // namespace scree::coupling
