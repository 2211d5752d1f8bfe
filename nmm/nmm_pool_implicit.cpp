// The implicit operator of manifold blocks: charts, element masses, linearisation, retraction.
#include "nmm/nmm_pool.h"

namespace scree::nmm {

std::string NmmPool::implicit_obstacle(int body) const {
  if (of(body).onefold || of(body).form.mass != MassKind::affine_exact) return {};
  return "its mass is affine-exact, which couples all covers of a block; implicit steps take mass = \"consistent\" or "
         "\"lumped\"";
}

ChartRow NmmPool::chart_row(int body, const Row& row, std::span<const double>) const {
  return of(body).onefold ? of(body).onefold->chart_row(row) : of(body).implicit.chart_row(row);
}

void NmmPool::element_masses(int body, std::span<const double>, std::span<double> mass) const {
  if (of(body).onefold)
    of(body).onefold->form().mass(mass);
  else
    of(body).implicit.element_masses(mass);
}

void NmmPool::rates(int body, std::span<const double>, std::span<const double> v, std::span<double> rate) const {
  if (of(body).onefold)
    of(body).onefold->rates(v, rate);
  else
    of(body).implicit.rates(v, rate);
}

double NmmPool::linearise(int body, std::span<const double> q, Stiffness kind, std::span<double> stiffness,
                          std::span<double> force) const {
  if (const auto& cover = of(body).onefold) return cover->form().linearise(cover->gradient(q), kind, stiffness, force);
  const auto first = static_cast<std::size_t>(of(body).first_element), count = of(body).mesh.elements();
  double energy = of(body).implicit.linearise(
      elements_.covers().subspan(first, count), q, kind, stiffness, force, [&](std::size_t e) {
        const std::size_t i = first + e;
        return StiffElement{elements_.gradients(i), elements_.area(i), of(body).law, of(body).form.kinematics,
                            elements_.initial_stress(i)};
      });
  for (std::size_t k = 0; k < of(body).holds.size(); ++k) {
    const EdgeHold& h = of(body).holds[k];
    const StiffElement element = element_of(of(body), h.element);
    const std::array<Vec2, 3> x = covers_of(of(body), h.element, q);
    const HoldResponse r = hold_response(h, element, x);
    energy += r.energy;
    // Damping by the material's stiffness does not include supports.
    const bool wanted = !stiffness.empty() && kind != Stiffness::material;
    of(body).implicit.add_hold(k, wanted ? hold_stiffness(h, element, x) : Mat6::Zero(), r.force,
                               wanted ? stiffness : std::span<double>(), force);
  }
  return energy;
}

void NmmPool::retract(int body, std::span<const double> d, std::span<const double> rate, std::span<double> q,
                      std::span<double> v) const {
  if (of(body).onefold)
    of(body).onefold->retract(d, rate, q, v);
  else
    of(body).implicit.retract(d, rate, q, v);
}

}  // namespace scree::nmm
