#include <fmt/format.h>

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
  d.line("plane {} gravity {} default joint {}", m.plane == Plane::strain ? "strain" : "stress", Dump::of(m.gravity),
         m.default_joint.value);
  for (const Material& x : m.materials) d.line("material {} {} {} {}", x.name, x.density, x.young, x.poisson);
  for (const JointLaw& x : m.joints)
    d.line("joint {} {} {} {} {} {} {} {} {}", x.name, x.friction, x.cohesion, x.contact_length,
           Dump::of(x.normal_stiffness), Dump::of(x.shear_stiffness), Dump::of(x.penalty), Dump::of(x.shear_penalty),
           x.damping);
  for (const Block& b : m.blocks) {
    d.line("block {} material {} joint {}", b.name, b.material.value, b.joint.value);
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

void dump_plan(Dump& d, const coupling::Plan& p) {
  d.line("detection {} threads {}", p.detection, p.threads);
  for (const coupling::Stage& s : p.stages) {
    d.line("stage {} {} {} dt {} safety {} duration {} cover {} passes {} displacement {} damping {} rest {}", s.name,
           s.method, s.integrator == coupling::Integrator::implicit ? "implicit" : "explicit", Dump::of(s.dt), s.safety,
           s.duration, s.cover_size, s.control.max_passes, s.control.max_displacement, s.damping, s.rest);
    for (const coupling::MethodRule& r : s.rules)
      for (const BlockId b : r.blocks) d.line("  {} by {}", b.value, r.method);
  }
  d.line("output {} {}", p.output.every, p.output.history_every);
  d.line("live {} {} {}", p.live.enabled, p.live.url, p.live.rate);
}

}  // namespace

std::string dump(const Case& c) {
  Dump d;
  dump_model(d, c.model);
  dump_plan(d, c.plan);
  return d.out;
}

}  // namespace scree::io::test
