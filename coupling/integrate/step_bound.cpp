#include "coupling/integrate/step_bound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace scree::coupling {

double certified_step(const Setup& setup, const ContactList& contacts, std::span<const PointSpring> springs,
                      std::string* binding) {
  const Outlines& o = setup.outlines();
  const auto& bodies = setup.bodies();
  std::vector<double> sum(static_cast<std::size_t>(setup.nodes()), 0.0);  // a group: by its first node
  std::vector<std::int32_t> groups;
  const auto load = [&](std::int32_t body, std::span<const Row> rows, double stiffness) {
    const Body& b = bodies[static_cast<std::size_t>(body)];
    if (b.driven) return;
    std::vector<std::int32_t> touched;
    for (const Row& row : rows) {
      setup.pool_of(b).bound_groups(b.index, setup.local(b, row), groups);
      touched.insert(touched.end(), groups.begin(), groups.end());
    }
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    const std::int32_t first = setup.pool_first(static_cast<std::size_t>(b.pool));
    for (std::int32_t g : touched) {
      const std::int32_t node = first + g;
      sum[static_cast<std::size_t>(node)] += stiffness;
    }
  };
  const auto compliance = [&](std::int32_t body, const Row& row) {
    const Body& b = bodies[static_cast<std::size_t>(body)];
    return b.driven ? 0.0 : setup.pool_of(b).compliance(b.index, setup.local(b, row));
  };
  for (std::size_t i = 0; i < contacts.points.size(); ++i) {
    const ContactPoint& p = contacts.points[i];
    const std::array<Row, 3> row{o.nodes[static_cast<std::size_t>(p.node[0])],
                                 o.nodes[static_cast<std::size_t>(p.node[1])],
                                 o.nodes[static_cast<std::size_t>(p.node[2])]};
    const std::int32_t body_p = o.node_body[static_cast<std::size_t>(p.node[0])],
                       body_e = o.node_body[static_cast<std::size_t>(p.node[1])];
    // The foot lies between the ends (or a little beyond): its compliance is at most that of a combination of the two.
    const double reach = std::max({1.0, std::abs(p.at.xi), std::abs(1.0 - p.at.xi)});
    const double mu =
        compliance(body_p, row[0]) + reach * reach * std::max(compliance(body_e, row[1]), compliance(body_e, row[2]));
    // A damped spring has h = (2/w)(sqrt(1 + xi^2) - xi) (thesis 5.3.2): as if it were stiffer.
    const double xi = setup.model().joints[static_cast<std::size_t>(contacts.memory[i].joint)].damping;
    const double shrink = std::sqrt(1.0 + xi * xi) - xi;
    const double k = (std::max(contacts.memory[i].kn, contacts.memory[i].kt) + p.margin) / (shrink * shrink);
    load(body_p, std::span(row).first(1), k * mu);
    load(body_e, std::span(row).last(2), k * mu);
  }
  for (const PointSpring& s : springs) load(s.body, {&s.row, 1}, s.k.maxCoeff() * compliance(s.body, s.row));

  double highest = 0.0;
  for (const Body& b : bodies) {
    if (b.driven) continue;
    const auto first = sum.begin() + b.first_node;
    const double loaded = *std::max_element(first, first + b.nodes);
    const Pool& pool = setup.pool_of(b);
    const double own = pool.frequency_bound(b.index), lambda = pool.mass_ratio(b.index) * (own + loaded);
    if (lambda <= highest) continue;
    highest = lambda;
    if (binding != nullptr)
      *binding = fmt::format("block '{}', {:.0f} % of it by contacts and supports",
                             setup.model().blocks[b.block.index()].name, 100.0 * loaded / (own + loaded));
  }
  return highest > 0.0 ? 2.0 / std::sqrt(highest) : std::numeric_limits<double>::infinity();
}

}  // namespace scree::coupling
