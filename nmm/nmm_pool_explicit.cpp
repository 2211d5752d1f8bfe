// The explicit operator of manifold blocks: forces, masses, damping and step bound.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "nmm/nmm_pool.h"

namespace scree::nmm {

double NmmPool::internal_force(std::span<const double> q, std::span<double> f) const {
  double energy = elements_.add_force(q, f);
  for (const auto& body : bodies_)
    for (const EdgeHold& h : body->holds) {
      const HoldResponse r = hold_response(h, element_of(*body, h.element), covers_of(*body, h.element, q));
      energy += r.energy;
      const auto& cover = elements_.cover(static_cast<std::size_t>(body->first_element) + h.element);
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = 2 * static_cast<std::size_t>(cover[k]);
        f[i] += r.force[2 * static_cast<Eigen::Index>(k)];
        f[i + 1] += r.force[2 * static_cast<Eigen::Index>(k) + 1];
      }
    }
  return energy;
}

Vec2 NmmPool::edge_reaction(int body, std::size_t support, double s, std::span<const double> q) const {
  const EdgeHold* nearest = nullptr;
  const auto off = [s](const EdgeHold& h) { return std::max({h.from - s, s - h.to, 0.0}); };
  for (const EdgeHold& h : of(body).holds)
    if (h.support == support && (nearest == nullptr || off(h) < off(*nearest))) nearest = &h;
  if (nearest == nullptr) return {0.0, 0.0};
  const double along = std::clamp((s - nearest->from) / (nearest->to - nearest->from), 0.0, 1.0);
  return hold_traction(*nearest, element_of(of(body), nearest->element), covers_of(of(body), nearest->element, q),
                       along);
}

double NmmPool::edge_energy(int body, std::span<const double> q) const {
  const Body& b = of(body);
  double energy = 0.0;
  for (const EdgeHold& h : b.holds)
    energy += hold_response(h, element_of(b, h.element), covers_of(b, h.element, q)).energy;
  return energy;
}

void NmmPool::shift_edges(int body, std::span<const double> shift) {
  shift_holds(shift, bodies_[static_cast<std::size_t>(body)]->holds);
}

Fault NmmPool::find_fault(std::span<const double> q) const {
  if (Fault fault = Pool::find_fault(q); fault.body >= 0) return fault;
  for (int b = 0; b < bodies(); ++b)
    for (std::size_t e = 0; e < of(b).mesh.elements(); ++e) {
      const std::size_t i = static_cast<std::size_t>(of(b).first_element) + e;
      if (elements_.law(i).kinematics == Kinematics::linear || elements_.gradient(i, q).determinant() > 0.0) continue;
      return {b, place_of(b, e) + " is turned inside out"};
    }
  return {};
}

void NmmPool::stiffness_damping(std::span<const double> q, std::span<const double> v, double rate,
                                std::span<double> f) const {
  elements_.add_rate_force(q, v, rate, f);
}

void NmmPool::body_force(const Vec2& acceleration, std::span<double> f) const {
  for (int b = 0; b < bodies(); ++b) add_weight(b, acceleration, f);
}

void NmmPool::add_weight(int b, const Vec2& g, std::span<double> f) const {
  if (of(b).onefold) {
    of(b).onefold->add_weight(g, f);
    return;
  }
  if (lumps(of(b).form)) mass_.add_weight(first_node(b), first_node(b + 1), g, f);
  if (has_consistent(of(b).form)) of(b).consistent.add_weight(g, f);
}

void NmmPool::apply_mass(int b, std::span<const double> v, std::span<double> p) const {
  if (of(b).onefold) {
    of(b).onefold->mass_apply(v, p);
    return;
  }
  if (lumps(of(b).form)) mass_.apply(first_node(b), first_node(b + 1), v, p);
  if (has_consistent(of(b).form)) of(b).consistent.apply(v, p);
}

double NmmPool::kinetic_of(int b, std::span<const double> v) const {
  if (of(b).onefold) return of(b).onefold->kinetic_energy(v);
  double sum = 0.0;
  if (lumps(of(b).form)) sum += mass_.kinetic_energy(first_node(b), first_node(b + 1), v);
  if (has_consistent(of(b).form)) sum += of(b).consistent.kinetic_energy(v);
  return sum;
}

void NmmPool::mass_solve(std::span<const double>, std::span<const double> f, std::span<double> a) const {
  mass_.solve(chart_, f, a);
  for (const auto& body : bodies_) {
    if (body->onefold)
      body->onefold->mass_solve(f, a);
    else if (has_consistent(body->form))
      body->consistent.solve(f, a);
  }
}

double NmmPool::mass_ratio(int body) const {
  return of(body).onefold ? 1.0 : mass_.theta(first_node(body), first_node(body + 1));
}

double NmmPool::kinetic_energy(std::span<const double>, std::span<const double> v,
                               std::span<const char> counted) const {
  double sum = 0.0;
  for (int b = 0; b < bodies(); ++b)
    if (counted[static_cast<std::size_t>(b)] != 0) sum += kinetic_of(b, v);
  return sum;
}

double NmmPool::damp(double factor, double rate, std::span<const double> along, std::span<double> v,
                     std::span<double> f, std::span<double> a) const {
  if (bodies() > 0 && lumps(of(0).form)) return mass_.damp(factor, rate, along, v, f, a);
  double power = 0.0;
  for (const auto& body : bodies_)
    if (!body->onefold) power += body->consistent.damp(factor, rate, along, v, f, a);
  return power;
}

double NmmPool::compliance(int body, const Row& row) const {
  if (of(body).onefold) return of(body).onefold->compliance(row);
  std::vector<Share> folded;
  double sum = 0.0;
  if (of(body).whole) {
    Row own = row;
    for (std::int32_t& n : own.node) n -= first_node(body);
    of(body).whole_chart.fold(own, folded);
    for (const Share& s : folded) sum += s.w * s.w * of(body).whole_inverse[static_cast<std::size_t>(s.cover)];
    return sum;
  }
  chart_.fold(row, folded);
  for (const Share& s : folded) sum += s.w * s.w * mass_.inverse()[static_cast<std::size_t>(s.cover)];
  return sum;
}

void NmmPool::bound_groups(int body, const Row& row, std::vector<std::int32_t>& groups) const {
  if (of(body).onefold) {
    groups.assign(1, first_node(body));
    return;
  }
  std::vector<Share> folded;
  chart_.fold(row, folded);
  groups.clear();
  for (const Share& s : folded)
    if (std::abs(s.w) > 1e-12) groups.push_back(s.cover);
}

}  // namespace scree::nmm
