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
      out.push_back(
          {s, 0.5 * s.length * std::sqrt(density * law.p_modulus()), 0.5 * s.length * std::sqrt(density * law.mu)});
  }
  return out;
}

void ViscousEdges::add(const Instant& at, std::span<double> f) {
  force_.resize(dashpots_.size());
  for (std::size_t i = 0; i < dashpots_.size(); ++i) {
    const Dashpot& d = dashpots_[i];
    const Vec2 t = (position(d.stretch.b, at.q) - position(d.stretch.a, at.q)).normalized();
    for (std::size_t end = 0; end < 2; ++end) {
      const double s = end == 0 ? d.stretch.from : d.stretch.to;
      const Vec2 v = d.stretch.at(s, at.v), along = t.dot(v) * t;
      force_[i][end] = -d.shear * along - d.normal * (v - along);
      d.stretch.push(s, force_[i][end], f);
    }
  }
}

double ViscousEdges::half_work(double h, std::span<const double> v) const {
  double power = 0.0;
  for (std::size_t i = 0; i < dashpots_.size(); ++i) {
    const EdgeStretch& s = dashpots_[i].stretch;
    power += force_[i][0].dot(s.at(s.from, v)) + force_[i][1].dot(s.at(s.to, v));
  }
  return 0.5 * h * power;
}

}  // namespace scree::coupling
