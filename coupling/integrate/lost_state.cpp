#include "coupling/integrate/lost_state.h"

#include <fmt/format.h>

#include <cmath>

#include "model/local_origin.h"

namespace scree::coupling {

LostPlace lost_place(const Setup& setup, std::span<const double> q) {
  for (const std::size_t p : setup.own_pools()) {
    const Fault fault = setup.pool(p).find_fault(setup.part(q, p));
    if (fault.body < 0) continue;
    const auto& bodies = setup.bodies();
    for (std::size_t b = 0; b < bodies.size(); ++b)
      if (bodies[b].pool == static_cast<std::int32_t>(p) && bodies[b].index == fault.body)
        return {BodyIndex::of(b), fault.where};
  }
  return {};
}

LostPlace not_finite_at(const Setup& setup, std::span<const double> values, const std::string& name,
                        std::span<const double> q) {
  for (std::size_t b = 0; b < setup.bodies().size(); ++b) {
    const Body& body = setup.bodies()[b];
    if (body.driven) continue;
    for (std::int32_t k = body.first_node; k < body.first_node + body.nodes; ++k) {
      const auto i = 2 * static_cast<std::size_t>(k);
      if (std::isfinite(values[i]) && std::isfinite(values[i + 1])) continue;
      return {BodyIndex::of(b), fmt::format("{} of node {} near {} is not finite", name, k - body.first_node,
                                            place_text({q[i], q[i + 1]}, setup.model().origin))};
    }
  }
  return {};
}

StepReport lost_state(const LostPlace& place, double t) {
  StepReport report;
  report.status = StepReport::Status::non_finite;
  report.body = place.body;
  report.cause = fmt::format(
      "at t = {:.6g} s {}; likely causes: loads or impacts beyond what a linear elastic material can carry (stress "
      "of the order of Young's modulus), a step above the stable one, or a mesh too coarse for them; the last good "
      "state is kept",
      t, !place.body.valid() ? "a velocity is not finite" : place.what);
  return report;
}

}  // namespace scree::coupling
