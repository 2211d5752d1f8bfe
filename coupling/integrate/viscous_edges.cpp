#include "coupling/integrate/viscous_edges.h"

#include <cmath>

namespace scree::coupling {

std::vector<Dashpot> dashpots(const Setup& setup, const State& state) {
  const Model& model = setup.model();
  std::vector<Dashpot> out;
  for (const ViscousEdge& edge : model.viscous_edges) {
    const Elasticity law = model.elasticity_of(edge.span.block);
    const double density = model.material_of(edge.span.block).density;
    for (const EdgeStretch& s : edge_stretches(setup, state, edge.span))
      out.push_back({s, 0.5 * s.length * std::sqrt(density * law.p_modulus()),
                     0.5 * s.length * std::sqrt(density * law.mu), edge.motion, edge.upgoing});
  }
  return out;
}

namespace {

/// Unit vector along the segment of a dashpot.
Vec2 tangent(const Dashpot& d, std::span<const double> q) {
  return (position(d.stretch.b, q) - position(d.stretch.a, q)).normalized();
}

/// Coefficients of a dashpot times a velocity.
Vec2 resistance(const Dashpot& d, const Vec2& t, const Vec2& v) {
  const Vec2 along = t.dot(v) * t;
  return d.shear * along + d.normal * (v - along);
}

/// Force of the incoming wave at one end.
Vec2 wave_force(const Setup& setup, const Dashpot& d, const Vec2& t, double time) {
  if (!d.motion.valid()) return {0.0, 0.0};
  return resistance(d, t, 2.0 * d.upgoing * setup.ground_velocity(d.motion, time));
}

}  // namespace

void add_incoming_waves(const Setup& setup, std::span<const Dashpot> dashpots, double time, std::span<const double> q,
                        std::span<double> f) {
  for (const Dashpot& d : dashpots) {
    if (!d.motion.valid()) continue;
    const Vec2 force = wave_force(setup, d, tangent(d, q), time);
    for (const double s : {d.stretch.from, d.stretch.to}) d.stretch.push(s, force, f);
  }
}

void ViscousEdges::add(const Instant& at, std::span<double> f) {
  force_.resize(dashpots_.size());
  wave_.resize(dashpots_.size());
  for (std::size_t i = 0; i < dashpots_.size(); ++i) {
    const Dashpot& d = dashpots_[i];
    const Vec2 t = tangent(d, at.q), wave = wave_force(*setup_, d, t, at.t);
    for (std::size_t end = 0; end < 2; ++end) {
      const double s = end == 0 ? d.stretch.from : d.stretch.to;
      force_[i][end] = -resistance(d, t, d.stretch.at(s, at.v));
      wave_[i][end] = wave;
      d.stretch.push(s, force_[i][end] + wave, f);
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
