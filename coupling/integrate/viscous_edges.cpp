#include "coupling/integrate/viscous_edges.h"

#include <algorithm>
#include <cmath>

#include "model/edge_selection.h"

namespace scree::coupling {
namespace {

/// The ground beside a stretch of a free-field edge.
FreeFieldSide side_of(const Model& model, const ViscousEdge& edge, const EdgeStretch& s, const Elasticity& law,
                      double density) {
  const Polygon& polygon = model.blocks[edge.span.block.index()].polygon;
  const auto [from, to] = ends_of(polygon, edge.span.edge);
  const auto height = [&, a = from.y(), b = to.y()](double at) {
    return std::clamp((1.0 - at) * a + at * b, edge.free_field->bottom, edge.free_field->top);
  };
  return {*edge.free_field,
          law,
          density,
          {height(s.begin), height(s.end)},
          0.5 * s.length * outward_normal(polygon, edge.span.edge)};
}

}  // namespace

std::vector<Dashpot> dashpots(const Setup& setup, const State& state) {
  const Model& model = setup.model();
  std::vector<Dashpot> out;
  for (const ViscousEdge& edge : model.viscous_edges) {
    const Elasticity law = model.elasticity_of(edge.span.block);
    const double density = model.material_of(edge.span.block).density;
    for (const EdgeStretch& s : edge_stretches(setup, state, edge.span)) {
      out.push_back({s, 0.5 * s.length * std::sqrt(density * law.p_modulus()),
                     0.5 * s.length * std::sqrt(density * law.mu), edge.motion, edge.upgoing});
      if (edge.free_field) out.back().side = side_of(model, edge, s, law, density);
    }
  }
  return out;
}

namespace {

/// Along the segment of a dashpot.
Vec2 tangent(const Dashpot& d, std::span<const double> q) {
  return (position(d.stretch.b, q) - position(d.stretch.a, q)).normalized();
}

/// What a dashpot makes of a velocity.
Vec2 resistance(const Dashpot& d, const Vec2& t, const Vec2& v) {
  const Vec2 along = t.dot(v) * t;
  return d.shear * along + d.normal * (v - along);
}

/// Force of the incoming wave, or of the free field, at one end: 0 or 1.
Vec2 wave_force(const Setup& setup, const Dashpot& d, const Vec2& t, std::size_t end, double time) {
  if (!d.motion.valid()) return {0.0, 0.0};
  const auto wave = [&](double delay) { return Vec2(d.upgoing * setup.ground_velocity(d.motion, time - delay)); };
  if (!d.side) return resistance(d, t, 2.0 * wave(0.0));
  const FreeFieldSide& side = *d.side;
  const GroundWave w =
      ground_wave(side.ground, side.law, side.density, side.height[end], time - setup.motion_begin(d.motion), wave);
  return resistance(d, t, w.velocity) + w.stress * side.area;
}

}  // namespace

void add_incoming_waves(const Setup& setup, std::span<const Dashpot> dashpots, double time, std::span<const double> q,
                        std::span<double> f) {
  for (const Dashpot& d : dashpots) {
    if (!d.motion.valid()) continue;
    const Vec2 t = tangent(d, q);
    d.stretch.push(d.stretch.from, wave_force(setup, d, t, 0, time), f);
    d.stretch.push(d.stretch.to, wave_force(setup, d, t, 1, time), f);
  }
}

void ViscousEdges::add(const Instant& at, std::span<double> f) {
  force_.resize(dashpots_.size());
  wave_.resize(dashpots_.size());
  for (std::size_t i = 0; i < dashpots_.size(); ++i) {
    const Dashpot& d = dashpots_[i];
    const Vec2 t = tangent(d, at.q);
    for (std::size_t end = 0; end < 2; ++end) {
      const double s = end == 0 ? d.stretch.from : d.stretch.to;
      force_[i][end] = -resistance(d, t, d.stretch.at(s, at.v));
      wave_[i][end] = wave_force(*setup_, d, t, end, at.t);
      d.stretch.push(s, force_[i][end] + wave_[i][end], f);
    }
  }
}

double ViscousEdges::half_work(double h, std::span<const double> v, const EndForces& force) const {
  double power = 0.0;
  for (std::size_t i = 0; i < dashpots_.size(); ++i) {
    const EdgeStretch& s = dashpots_[i].stretch;
    power += force[i][0].dot(s.at(s.from, v)) + force[i][1].dot(s.at(s.to, v));
  }
  return 0.5 * h * power;
}

}  // namespace scree::coupling
