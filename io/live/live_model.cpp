#include "io/live/live_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "io/live/wire.h"
#include "model/edge_selection.h"

namespace scree::io {
namespace {

std::int32_t count(const auto& list) { return static_cast<std::int32_t>(list.size()); }

void add_block(model_v1_t& out, const std::string& name, std::int32_t material, bool held) {
  out.block.push_back(wire_text(name));
  out.block_material.push_back(material);
  out.held.push_back(held ? 1 : 0);
}
void add_material(model_v1_t& out, const std::string& name, double density, double young, double poisson) {
  out.material.push_back(wire_text(name));
  out.density.push_back(density);
  out.young.push_back(young);
  out.poisson.push_back(poisson);
}
void add_law(model_v1_t& out, const std::string& name, double friction_deg, double cohesion, double tension) {
  out.law.push_back(wire_text(name));
  out.friction_deg.push_back(friction_deg);
  out.cohesion.push_back(cohesion);
  out.tensile_strength.push_back(tension);
}
void add_line(model_v1_t& out, const Vec2& from, const Vec2& to, std::int32_t law, bool crack) {
  out.line_x0.push_back(from.x()), out.line_y0.push_back(from.y());
  out.line_x1.push_back(to.x()), out.line_y1.push_back(to.y());
  out.line_law.push_back(law);
  out.crack.push_back(crack ? 1 : 0);
}
void add_support(model_v1_t& out, const Vec2& point, bool fix_x, bool fix_y) {
  out.support_x.push_back(point.x()), out.support_y.push_back(point.y());
  out.fix_x.push_back(fix_x ? 1 : 0), out.fix_y.push_back(fix_y ? 1 : 0);
}
void add_edge(model_v1_t& out, const Vec2& from, const Vec2& to, const Mat2& held) {
  out.edge_x0.push_back(from.x()), out.edge_y0.push_back(from.y());
  out.edge_x1.push_back(to.x()), out.edge_y1.push_back(to.y());
  out.edge_fixed.push_back(held.trace() > 1.5 ? 1 : 0);
}
void add_water(model_v1_t& out, const std::vector<Vec2>& line, std::int32_t number) {
  for (const Vec2& p : line) {
    out.water_x.push_back(p.x()), out.water_y.push_back(p.y());
    out.water_line.push_back(number);
  }
}

void set_counts(model_v1_t& out) {
  out.blocks = count(out.block);
  out.materials = count(out.material);
  out.laws = count(out.law);
  out.lines = count(out.line_law);
  out.supports = count(out.fix_x);
  out.edges = count(out.edge_fixed);
  out.water_points = count(out.water_line);
  out.water_joints = count(out.water_law);
}

}  // namespace

model_v1_t live_model(const Model& model) {
  model_v1_t out{};
  for (std::size_t b = 0; b < model.blocks.size(); ++b) {
    const BlockId id{static_cast<std::int32_t>(b)};
    add_block(out, model.blocks[b].name, model.blocks[b].material.value, model.support_of(id) != nullptr);
  }
  for (const Material& m : model.materials) add_material(out, m.name, m.density, m.young, m.poisson);
  for (const JointLaw& l : model.joints)
    add_law(out, l.name, l.friction * 180.0 / std::numbers::pi, l.cohesion, l.tensile_strength);
  for (const JointLine& l : model.joint_lines) add_line(out, l.from, l.to, l.joint.value, false);
  for (const Crack& c : model.cracks) add_line(out, c.from, c.to, c.joint.value, true);
  for (const PointSupport& s : model.point_supports) add_support(out, s.point, s.fix_x, s.fix_y);
  for (const EdgeSupport& s : model.edge_supports) {
    const auto [from, to] = ends_of(model.blocks[s.span.block.index()].polygon, s.span.edge);
    add_edge(out, from + s.span.s0 * (to - from), from + s.span.s1 * (to - from), s.held);
  }
  for (const JointWater& w : model.waters) {
    const std::int32_t number = static_cast<std::int32_t>(&w - model.waters.data());
    add_water(out, w.line, number);
    for (const JointId law : w.joints) out.water_law.push_back(law.value), out.law_line.push_back(number);
  }
  out.bolts = count(model.bolts);
  set_counts(out);
  return out;
}

model_v1_t live_model(const RunReader& run) {
  model_v1_t out{};
  for (const StoredBlock& b : run.blocks()) add_block(out, b.name, static_cast<std::int32_t>(b.material), b.held);
  for (const StoredMaterial& m : run.materials()) add_material(out, m.name, m.density, m.young, m.poisson);
  const StoredJoints joints = run.joints();
  for (const StoredJoints::Law& l : joints.laws) add_law(out, l.name, l.friction_deg, l.cohesion, l.tensile_strength);
  for (const StoredJointLine& l : joints.lines) add_line(out, l.from, l.to, l.law, false);
  for (const StoredJointLine& l : joints.cracks) add_line(out, l.from, l.to, l.law, true);
  for (const StoredSupport& s : run.supports()) add_support(out, s.point, s.fix_x, s.fix_y);
  for (const StoredEdgeSupport& s : run.edge_supports()) add_edge(out, s.from, s.to, s.held);
  std::int32_t number = 0;
  for (const StoredWater& w : run.waters()) {
    add_water(out, w.line, number);
    for (const std::int32_t law : w.joints) out.water_law.push_back(law), out.law_line.push_back(number);
    ++number;
  }
  // The last frame has the bolts installed so far; in a run that reached its end these are all bolts.
  if (run.has_bolts() && !run.times().empty())
    for (const std::int32_t bolt : run.bolts(run.times().size() - 1).bolt) out.bolts = std::max(out.bolts, bolt + 1);
  set_counts(out);
  return out;
}

bool holds_together(const model_v1_t& m) {
  const auto in = [](const std::vector<std::int32_t>& values, std::int32_t low, std::int32_t high) {
    return std::all_of(values.begin(), values.end(), [&](std::int32_t v) { return v >= low && v < high; });
  };
  const auto finite = [](const std::vector<double>& values) {
    return std::all_of(values.begin(), values.end(), [](double v) { return std::isfinite(v); });
  };
  for (const auto* list : {&m.line_x0, &m.line_y0, &m.line_x1, &m.line_y1, &m.support_x, &m.support_y, &m.edge_x0,
                           &m.edge_y0, &m.edge_x1, &m.edge_y1, &m.water_x, &m.water_y})
    if (!finite(*list)) return false;
  // A line of the drawing may have no law of its own; a piezometric line has points.
  return in(m.block_material, 0, m.materials) && in(m.line_law, -1, m.laws) && in(m.water_law, 0, m.laws) &&
         in(m.water_line, 0, m.water_points) && in(m.law_line, 0, std::max(m.water_points, 1)) &&
         std::is_sorted(m.water_line.begin(), m.water_line.end());
}

}  // namespace scree::io
