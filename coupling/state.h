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

/// Energy of a block that its present method cannot represent (docs/theory/transfer.md), and the data to restore it:
/// the former body, and its fields as in Release. These are empty if the block has had yet another method or mesh
/// since.
struct Remainder {
  BlockId block;
  double kinetic = 0.0, elastic = 0.0;  // [J]
  BodyRecord record;
  std::vector<double> position, velocity;
};

/// Factor and solver settings with which the next implicit step begins.
struct KeptFactor {
  /// Steps compute their own factor while `wait` is above 0; the wait grows with each successive failure of a kept one.
  struct Patience {
    std::int32_t wait = 0, next_wait = 0;
    std::int32_t least = -1;  // smallest number of corrections of a step with this factor; -1: no step yet
    std::int32_t excess = 0;  // sum over its steps of the corrections beyond `least` + 1
  };
  Patience patience;
  /// Which solver the next step of affine bodies begins with (docs/theory/linear-solvers.md).
  struct Choice {
    std::int32_t direct = 0;                // 1: a complete factor, 0: an incomplete one of blocks
    std::int32_t hold = 0, next_hold = 0;   // steps with `direct` after the incomplete one failed; next time
    std::int32_t returns = 0;               // number of trials of the complete one without a gain
    double block_work = 0.0, excess = 0.0;  // of the last step by blocks; excess over the other solver
  };
  Choice choice;
  std::vector<std::int32_t> column_start, row;  // factored matrix: lower triangle; empty: none
  std::vector<double> value;
};

inline constexpr char kDivided = 2;  // value in State::explicit_side

/// Data of the rules of the present stage (plan.h: EndRules, SwitchRules).
struct RuleMemory {
  struct Slip {
    std::int32_t a = -1, b = -1;  // blocks, a <= b
    double slip = 0.0;            // largest of their contact points as the stage began [m]
    [[nodiscard]] bool same_pair(const Slip& other) const { return a == other.a && b == other.b; }
  };
  double peak = 0.0;                          // largest kinetic energy so far [J]
  Tick slow_since = -1, balanced_since = -1;  // -1: the condition does not hold
  std::vector<Slip> slips;                    // sorted by blocks
  Tick evaluated = -1, next_evaluation = 0;   // of blocks that may change method
  std::vector<Tick> calm_since;               // per block; -1: not calm
  std::vector<char> other_method;             // per block: 1 where a rule has changed it from the stage's method
  struct Energy {                             // at the beginning of a subcycled stage (energy_watch.h) [J]
    double held = 0.0, work = 0.0, made = 0.0;
    std::int32_t warned = 0;  // 1: a warning has been given
  };
  Energy energy;
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// Blocks at rest that take no steps (Stage::sleep).
struct SleepMemory {
  // Per body: the lowest body of its island if it is asleep, -1 if it is awake; empty: all are awake.
  std::vector<std::int32_t> island;
  std::vector<std::int32_t> calm;  // per body: successive checks at rest; empty: there has been no check
  Tick seen = 0;                   // loads and motions are known to be constant for sleeping blocks up to this time
  std::int64_t evaluated = -1;     // step at which the rules were evaluated last
  std::int64_t fell = 0;           // step at which blocks fell asleep last
  [[nodiscard]] bool asleep(std::size_t body) const { return !island.empty() && island[body] >= 0; }
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const {
    see("sleep.island", island);
    see("sleep.calm", calm);
    see("sleep.seen", seen);
    see("sleep.evaluated", evaluated);
    see("sleep.fell", fell);
  }
};

struct State {
  Tick time = 0;
  std::int64_t step = 0;
  std::int32_t stage = 0;
  std::vector<Tick> stage_begin;   // of each stage so far: origin of times counted from a stage
  Tick last_step = 0;              // length of the step before, for the shadow term
  StepLimit step_limit;            // of partitioned stages
  double relaxing = 0.0;           // kinetic energy one step before, in stages that run to rest [J]
  std::vector<BodyRecord> bodies;  // in the order of their blocks
  // Per body: 1 where it takes explicit steps, kDivided where one part of it does; partitioned stages, else empty.
  std::vector<char> explicit_side;
  std::vector<double> q, v;      // x, y per node; pool after pool, body after body (Setup has the offsets)
  std::vector<double> a;         // acceleration at `time`, same layout (explicit stages; else empty)
  std::vector<double> v_before;  // velocity of the previous half step, where damping uses it (else empty)
  std::vector<double> damping;   // forces of mass-proportional damping of non-affine motion (else empty) [N]
  std::vector<double> sliding;   // forces that damp the deformation of sliding blocks (empty: none slides) [N]
  ContactList contacts;          // sorted by key; memories alone between stages, or where each side of a step has one
  KeptFactor factored;           // of implicit steps
  std::vector<Remainder> rest;
  std::vector<double>
      anchors;  // x, y per point support: total shift of its anchor by hand-overs so far; empty: no shift yet [m]
  std::vector<BoltMemory> bolts;  // of the model; empty: the model has none
  SupportForces support;          // of blocks and supports that have been removed
  RuleMemory rules;
  SleepMemory sleep;
  Ledger ledger;

  /// Calls see(name, value) for every field, in a fixed order; visit_to_write() lets the visitor change them.
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// 64-bit hash of every bit of the state. Equal states have equal hashes; this is guaranteed only for the same binary
/// on the same type of processor.
[[nodiscard]] std::uint64_t state_hash(const State& state);

// ---------------------------------------------------------------------------------------------------------------

/// The fields of a body, as part of State::visit().
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
  see("rules.energy_warned", energy.warned);
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
  sleep.visit(see);
  ledger.visit(see);
}

}  // namespace scree::coupling
