// Writes all data of a case as text, for comparisons of whole cases.
#include <fmt/format.h>

#include "coupling/sink.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test {
namespace {

class Dump {
 public:
  template <class... T>
  void line(fmt::format_string<T...> form, T&&... values) {
    out += fmt::format(form, std::forward<T>(values)...) + "\n";
  }
  static std::string of(const Vec2& p) { return fmt::format("({}, {})", p.x(), p.y()); }
  static std::string of(const std::optional<double>& v) { return v ? fmt::format("{}", *v) : "auto"; }
  std::string out;
};

void dump_model(Dump& d, const Model& m) {
  d.line("title {}", m.title);
  d.line("origin {}", Dump::of(m.origin));
  d.line("plane {} gravity {} default joint {}", m.plane == Plane::strain ? "strain" : "stress", Dump::of(m.gravity),
         m.default_joint.value);
  for (const Material& x : m.materials) {
    d.line("material {} {} {} {}", x.name, x.density, x.young, x.poisson);
    if (x.rock_strength) {
      const auto* c = std::get_if<MohrCoulombStrength>(&*x.rock_strength);
      const auto* h = std::get_if<HoekBrownStrength>(&*x.rock_strength);
      if (c) d.line("  rock strength {} {} {}", c->cohesion, c->friction, c->tension);
      if (h) d.line("  rock strength {} {} {} {}", h->ucs, h->mb, h->s, h->a);
    }
    if (!x.initial_stress) continue;
    for (const Mat2& s : {x.initial_stress->stress, x.initial_stress->gradient})
      d.line("  {} {} {} {} from {}", s(0, 0), s(0, 1), s(1, 0), s(1, 1), x.initial_stress->level);
  }
  for (const JointLaw& x : m.joints) {
    d.line("joint {} {} {} {} {} {} {} {} {} tension {} residual {} {} over {} dilation {} {}", x.name, x.friction,
           x.cohesion, x.contact_length, Dump::of(x.normal_stiffness), Dump::of(x.shear_stiffness), Dump::of(x.penalty),
           Dump::of(x.shear_penalty), x.damping, x.tensile_strength, Dump::of(x.residual_friction), x.residual_cohesion,
           x.weakening_slip, x.dilation, Dump::of(x.dilation_slip));
    if (x.friction_law != nullptr)
      d.line("  friction by {} {}", x.friction_law->name, fmt::join(x.friction_constants, " "));
  }
  for (const Block& b : m.blocks) {
    d.line("block {} material {} joint {} covers {}", b.name, b.material.value, b.joint.value, b.cover_size);
    for (std::size_t k = 0; k < b.polygon.rings(); ++k)
      for (std::size_t i = 0; i < b.polygon.ring(k).size(); ++i)
        d.line("  {} {} {}", k, Dump::of(b.polygon.ring(k)[i]), b.edges[k][i].value);
  }
  for (const JointLine& l : m.joint_lines)
    d.line("line {} {} joint {} kind {} {}", Dump::of(l.from), Dump::of(l.to), l.joint.value, static_cast<int>(l.kind),
           l.source);
  for (const Crack& c : m.cracks)
    d.line("crack {} {} joint {} block {}", Dump::of(c.from), Dump::of(c.to), c.joint.value, c.block.value);
  if (m.cutting) d.line("snap {} least width {}", m.cutting->snap, m.cutting->least_width);
  for (const BlockSupport& s : m.block_supports) d.line("hold {} motion {}", s.block.value, s.motion.value);
  for (const PointSupport& s : m.point_supports)
    d.line("tie {} {} {} {} {}", s.block.value, Dump::of(s.point), s.fix_x, s.fix_y, Dump::of(s.stiffness));
  for (const Monitor& x : m.monitors) d.line("monitor {} {} {}", x.name, x.block.value, Dump::of(x.point));
  for (const InitialVelocity& x : m.initial_velocities)
    d.line("start {} {} {}", x.block.value, Dump::of(x.velocity), x.spin);
  for (const GroundMotion& g : m.motions) {
    d.line("motion {} {} start {} {}", g.setting().name, Dump::of(g.direction()), g.setting().start,
           g.setting().between == Between::linear ? "linear" : "constant");
    for (std::size_t i = 0; i < g.times().size(); ++i) d.line("  {} {}", g.times()[i], g.accelerations()[i]);
  }
}

void dump_span(Dump& d, const EdgeSpan& s) {
  d.line("  block {} edge {} {} from {} to {}", s.block.value, s.edge.ring, s.edge.edge, s.s0, s.s1);
}

void dump_loads(Dump& d, const Model& m) {
  for (const TimeFunction& f : m.functions) {
    d.line("function {} {} {} {} {} {}", f.name, static_cast<int>(f.shape), f.amplitude, f.start, f.duration,
           f.frequency);
    for (std::size_t i = 0; i < f.time.size(); ++i) d.line("  {} {}", f.time[i], f.table[i]);
  }
  for (const PointLoad& x : m.point_loads)
    d.line("load {} {} {} {}", x.block.value, Dump::of(x.point), Dump::of(x.force), x.function.value);
  for (const EdgeTraction& x : m.tractions) {
    d.line("traction {} {}", Dump::of(x.traction), x.function.value);
    dump_span(d, x.span);
  }
  for (const BodyAcceleration& x : m.body_accelerations) {
    d.line("acceleration {} {}", Dump::of(x.acceleration), x.function.value);
    for (const BlockId b : x.blocks) d.line("  of {}", b.value);
  }
  for (const ViscousEdge& x : m.viscous_edges) {
    d.line("viscous {} {}", x.motion.value, x.upgoing);
    dump_span(d, x.span);
  }
  for (const Bolt& x : m.bolts) {
    d.line("bolt {} {} {} stage {} plate {}", x.name, Dump::of(x.head), Dump::of(x.toe), x.stage.value, x.plate);
    d.line("  bar {} {} {} {}", x.stiffness, x.yield, x.rupture_strain, x.pretension);
    d.line("  bond {} {} {} {}", x.bond_length, x.bond_stiffness, x.bond_strength, x.segment);
    d.line("  shear {} {} {}", x.shear_stiffness, x.shear_strength, x.rupture_shear);
    d.line("  {} nodes, {} crossings", x.nodes.size(), x.crossings.size());
    for (const Vec2& p : x.along) d.line("  along {}", Dump::of(p));
    if (x.liner()) d.line("  liner {} {} {}", x.tolerance, x.bending, x.crushing);
  }
  for (const EdgeSupport& x : m.edge_supports) {
    d.line("held {} {} {} bedding {}", x.held(0, 0), x.held(0, 1), x.held(1, 1), Dump::of(x.bedding));
    dump_span(d, x.span);
  }
}

void dump_water(Dump& d, const Model& m) {
  for (const JointWater& w : m.waters) {
    d.line("water {}", w.unit_weight);
    for (const Vec2& p : w.line) d.line("  {}", Dump::of(p));
    for (const JointId j : w.joints) d.line("  in {}", j.value);
    for (const EdgeSpan& e : w.faces) dump_span(d, e);
    for (const JointWater::Level& l : w.levels) {
      d.line("  from stage {}", l.stage.value);
      for (const Vec2& p : l.line) d.line("    {}", Dump::of(p));
    }
  }
}

void dump_plan(Dump& d, const coupling::Plan& p) {
  d.line("detection {} threads {} closure {} passed {} gain {} slowdown {}", p.detection, p.threads, p.max_closure,
         p.max_passed_closure, p.max_gain, p.max_slowdown);
  for (const coupling::Stage& s : p.stages) {
    d.line("stage {} {} {} dt {} safety {} duration {} cover {} passes {} displacement {} damping {} rest {}", s.name,
           s.method, coupling::name(s.integrator), Dump::of(s.dt), s.safety, s.duration, s.cover_size,
           s.control.max_passes, s.control.max_displacement, s.damping, s.rest);
    if (s.force_dt) d.line("  forced");
    d.line("  rotation {}", static_cast<int>(s.rotation));
    d.line("  transfer {} {}", static_cast<int>(s.transfer), s.transfer_cap);
    d.line("  kinematics {} mass {} cracks {} rigid {} stiffness {} local {} newmark {} dynamics {} rest {} {}",
           static_cast<int>(s.kinematics), s.mass ? static_cast<int>(*s.mass) : -1, s.cracks, s.damp_rigid_motion,
           s.stiffness_damping, s.local_damping, static_cast<int>(s.newmark), s.dynamics, s.rest_force, s.rest_steps);
    d.line("  sliding {} sleep {}", s.sliding_damping, s.sleep);
    const coupling::Partition& sides = s.partition;
    d.line("  area {} speed {} {} strain rate {} {} substeps {}", sides.explicit_area, sides.speed.up, sides.speed.down,
           sides.strain_rate.up, sides.strain_rate.down, sides.substeps);
    d.line("  shared contacts {} others explicit {}", sides.shared_contacts, sides.slow_explicit);
    for (const Vec2& x : sides.explicit_region) d.line("  region {} {}", x.x(), x.y());
    d.line("  end {} {} {} {} {}", s.end.kinetic_below, s.end.force_below, s.end.hold, s.end.slip, s.end.displacement);
    d.line("  strength {} {} {}", static_cast<int>(s.strength.part), s.strength.from, s.strength.to);
    for (const JointId j : s.strength.joints) d.line("  of {}", j.value);
    d.line("  release {} in {}", Dump::of(s.construction.release), s.construction.release_time);
    for (const BlockId b : s.construction.absent) d.line("  without {}", b.value);
    const coupling::SwitchRules& change = s.change;
    d.line("  switch {} {} {} {} {} back {} {} {}", change.used, change.kinetic, change.elastic, change.inhomogeneity,
           change.hold, change.back.strain_rate, change.back.stress, change.back.acceleration);
    for (const BlockId b : change.blocks) d.line("  {} may change", b.value);
    for (const BlockId b : sides.explicit_blocks) d.line("  {} explicit", b.value);
    for (const BlockId b : sides.implicit_blocks) d.line("  {} implicit", b.value);
    for (const coupling::MethodRule& r : s.rules)
      for (const BlockId b : r.blocks)
        d.line("  {} by {} covers {} onefold {} model {}", b.value, r.method, r.cover_size, r.onefold,
               r.model_triangle);
  }
  d.line("output {} {} {} {} {}", p.output.every, p.output.history_every, p.output.contacts, p.output.checkpoint_every,
         p.output.checkpoint_steps);
  d.line("live {} {} {}", p.live.enabled, p.live.url, p.live.rate);
}

}  // namespace

std::string dump(const Case& c) {
  Dump d;
  dump_model(d, c.model);
  dump_loads(d, c.model);
  dump_water(d, c.model);
  if (c.drawing) d.line("drawing {} {} {}", c.drawing->unit, c.drawing->tolerance, c.drawing->join);
  dump_plan(d, c.plan);
  d.line("live field {}", c.live_field);
  return d.out;
}

}  // namespace scree::io::test
