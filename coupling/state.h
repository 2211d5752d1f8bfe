// Everything that influences the future of a run, as one value. A copy of it is a checkpoint.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "coupling/ledger/ledger.h"
#include "coupling/visit.h"
#include "model/pool.h"

namespace scree::coupling {

enum class ContactStatus : std::int32_t { open, slip, stick };

/// A vertex of one block against an outline edge of another: the identity of a contact, whatever the methods.
struct ContactKey {
  std::int32_t block_p = -1, ring_p = 0, vertex = 0, part = 0;  // the corner; part > 0: a mesh node along edge `vertex`
  std::int32_t block_e = -1, ring_e = 0, edge = 0;              // the edge
  auto operator<=>(const ContactKey&) const = default;
  /// As State::visit().
  template <class Visitor>
  void visit(Visitor&& see) const;
};

/// What the check of friction remembers of a contact point that slides; all but `worst` are zero while it does not.
/// 72 bytes: memories are copied at every step. Windows are sums of many steps, in double; what is kept of them is not.
/// @see contact/friction_check.h
struct SlideMemory {
  /// A window, or some: net slip in elastic stretches; impulse of the tangential force and of Coulomb's limit [N s].
  struct Sum {
    float slip = 0.0F, drag = 0.0F, limit = 0.0F;
  };
  double slip = 0.0, drag = 0.0, limit = 0.0;            // of the present window: [m], [N s], [N s]
  double time = 0.0;                                     // of it that has passed [s]
  float length = 0.0F;                                   // of it, when it is complete [s]; 0: the point does not slide
  Sum last{};                                            // the window before; the first of a stretch has no impulses
  Sum total{};                                           // of the windows below
  std::int32_t losing = 0, keeping = 0;                  // windows in succession, by their friction
  float worst = std::numeric_limits<float>::infinity();  // smallest ratio of the impulses in a long stretch

  /// The stretch is over.
  void end() {
    const float kept = worst;
    *this = SlideMemory{};
    worst = kept;
  }
};

/// What a contact point remembers between steps.
struct ContactMemory {
  ContactKey key;
  ContactStatus status = ContactStatus::open;
  std::int32_t failed = 0;     // 1 once cohesion is lost
  std::int32_t bonded = 0;     // 1: closed since t = 0 with a tensile strength, which it still has
  std::int32_t joint = -1;     // law, chosen when the pair was first seen
  std::int32_t segment = -1;   // segment of the edge that the anchor below refers to, counted within the edge
  double gap0 = 0.0;           // gap that counts as closed without stress (closed at t = 0, changed share) [m]
  double gap = 0.0;            // gap at the present time, less gap0 [m]
  double stretch = 0.0;        // elongation of the tangential spring [m]
  double anchor = 0.0;         // its anchor: fraction of the segment
  double fn = 0.0, ft = 0.0;   // forces on the corner, along the outward normal and the direction of the edge [N]
  double fd = 0.0, fdt = 0.0;  // parts of fn and ft that are damping [N]
  double water = 0.0;          // force of the water in the joint on the corner, along the outward normal [N]
  double slip = 0.0;           // accumulated |slip| [m]
  std::int32_t facing = 0;     // 1: part of an edge-edge contact; 0: a corner against an edge
  double share = 0.0;          // length of joint that the point stands for [m]
  double kn = 0.0, kt = 0.0;   // stiffness of its springs [N/m]
  double impact = 0.0;         // time for which it still keeps the springs it closed with [s] (explicit steps)
  SlideMemory slide{};
};

/// Energy that a block could not take along into its present method (coupling.md 1), and what brings it back: the body
/// that it was, and its fields as Release has them. They are empty where the block has been something else since.
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
  Tick looked = -1, next_look = 0;            // for blocks that may change method
  std::vector<Tick> calm_since;               // a block; -1: it is not
  std::vector<char> other_method;             // a block: 1 where a rule has taken it from the stage's method
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
  double relaxing = 0.0;           // kinetic energy a step ago, in stages that run to rest [J]
  std::vector<BodyRecord> bodies;  // in the order of their blocks
  // A body: 1 where it takes explicit steps, kDivided where one half of it does; partitioned stages, else empty.
  std::vector<char> explicit_side;
  std::vector<double> q, v;      // x, y a node; pool after pool, body after body (Setup has the offsets)
  std::vector<double> a;         // acceleration at `time`, same layout (explicit stages; else empty)
  std::vector<double> v_before;  // velocity of the half step before, where damping lags on it (else empty)
  std::vector<double> damping;   // forces of mass-proportional damping that spares affine motion (else empty) [N]
  std::vector<double> sliding;   // forces that damp the deformation of sliding blocks (none slides: empty) [N]
  std::vector<ContactMemory> contacts;  // sorted by key
  KeptFactor factored;                  // of implicit steps
  std::vector<Remainder> rest;
  std::vector<double> anchors;  // x, y a point support: how far hand-overs have shifted its anchor; empty: none yet [m]
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

static_assert(sizeof(SlideMemory) == 72);

template <class Visitor>
void ContactKey::visit(Visitor&& see) const {
  see("contact.block_p", block_p);
  see("contact.ring_p", ring_p);
  see("contact.vertex", vertex);
  see("contact.part", part);
  see("contact.block_e", block_e);
  see("contact.ring_e", ring_e);
  see("contact.edge", edge);
}

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
  see("rules.looked", looked);
  see("rules.next_look", next_look);
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
  see.size("contacts", contacts);
  for (const ContactMemory& c : contacts) {
    c.key.visit(see);
    see("contact.status", c.status);
    see("contact.failed", c.failed);
    see("contact.bonded", c.bonded);
    see("contact.joint", c.joint);
    see("contact.segment", c.segment);
    see("contact.gap0", c.gap0);
    see("contact.gap", c.gap);
    see("contact.stretch", c.stretch);
    see("contact.anchor", c.anchor);
    see("contact.fn", c.fn);
    see("contact.ft", c.ft);
    see("contact.fd", c.fd);
    see("contact.fdt", c.fdt);
    see("contact.water", c.water);
    see("contact.slip", c.slip);
    see("contact.facing", c.facing);
    see("contact.share", c.share);
    see("contact.kn", c.kn);
    see("contact.kt", c.kt);
    see("contact.impact", c.impact);
    see("contact.slide_length", c.slide.length);
    see("contact.slide_time", c.slide.time);
    see("contact.slide_slip", c.slide.slip);
    see("contact.slide_drag", c.slide.drag);
    see("contact.slide_limit", c.slide.limit);
    for (const SlideMemory::Sum* sum : {&c.slide.last, &c.slide.total}) {
      see("contact.slide_sum_slip", sum->slip);
      see("contact.slide_sum_drag", sum->drag);
      see("contact.slide_sum_limit", sum->limit);
    }
    see("contact.slide_losing", c.slide.losing);
    see("contact.slide_keeping", c.slide.keeping);
    see("contact.slide_worst", c.slide.worst);
  }
  see("factored.wait", factored.patience.wait);
  see("factored.next_wait", factored.patience.next_wait);
  see("factored.least", factored.patience.least);
  see("factored.excess", factored.patience.excess);
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
  rules.visit(see);
  ledger.visit(see);
}

}  // namespace scree::coupling
