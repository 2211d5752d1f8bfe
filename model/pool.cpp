// Defaults of the roles for methods that do not override them.
#include "model/pool.h"

#include <algorithm>
#include <cmath>

namespace scree {

void ExplicitOperator::turn(double, std::span<const double>, std::span<double>, std::span<double>) const {}

double ExplicitOperator::damp(double, double, std::span<const double>, std::span<double>, std::span<double> f,
                              std::span<double>) const {
  std::fill(f.begin(), f.end(), 0.0);
  return 0.0;
}
std::string ExplicitOperator::binding(int) const { return {}; }
void BodySet::add_again(const Model& model, const BodyRecord& record, const BodySet&, int) { add(model, record); }

std::span<const BodySet::InterfaceConstraint> BodySet::interface_constraints(int) const { return {}; }

std::span<const std::int32_t> BodySet::undivided(int) const { return {}; }

void BodySet::settle(int, std::span<double>, std::span<double>) const {}

bool BodySet::idle(std::int32_t) const { return false; }

Fault BodySet::find_fault(std::span<const double> q) const {
  for (int b = 0; b < bodies(); ++b)
    for (std::int32_t k = first_node(b); k < first_node(b + 1); ++k) {
      const auto i = 2 * static_cast<std::size_t>(k);
      if (!std::isfinite(q[i]) || !std::isfinite(q[i + 1])) return {b, "a position is not finite"};
    }
  return {};
}
void ExplicitOperator::stiffness_damping(std::span<const double>, std::span<const double>, double,
                                         std::span<double>) const {}
bool BodyTransfer::holds_edges(int) const { return false; }
Vec2 BodyTransfer::edge_reaction(int, std::size_t, double, std::span<const double>) const { return {0.0, 0.0}; }
double BodyTransfer::edge_energy(int, std::span<const double>) const { return 0.0; }
void BodyTransfer::shift_edges(int, std::span<const double>) {}
void BodyOutput::recovered_stress(std::span<const double>, std::span<const char>, std::span<double> nodes) const {
  std::fill(nodes.begin(), nodes.end(), 0.0);
}
int ImplicitOperator::dofs(int) const { return 0; }
bool ImplicitOperator::nonlinear(int) const { return false; }
bool ImplicitOperator::constant_chart(int) const { return false; }
std::string ImplicitOperator::implicit_obstacle(int) const { return {}; }
ElementDofs ImplicitOperator::element_dofs(int) const { return {}; }
ChartRow ImplicitOperator::chart_row(int, const Row&, std::span<const double>) const { return {}; }
void ImplicitOperator::element_masses(int, std::span<const double>, std::span<double>) const {}
void ImplicitOperator::rates(int, std::span<const double>, std::span<const double>, std::span<double>) const {}
double ImplicitOperator::linearise(int, std::span<const double>, Stiffness, std::span<double>,
                                   std::span<double>) const {
  return 0.0;
}
void ImplicitOperator::retract(int, std::span<const double>, std::span<const double>, std::span<double>,
                               std::span<double>) const {}

}  // namespace scree
