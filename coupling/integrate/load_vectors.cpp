#include "coupling/integrate/load_vectors.h"

#include <algorithm>

#include "coupling/integrate/loads.h"
#include "model/parallel.h"

namespace scree::coupling {

std::vector<LoadVector> load_vectors(const Setup& setup, const State& state) {
  std::vector<LoadVector> out;
  const auto vector_of = [&](FunctionId function) -> std::vector<double>& {
    const auto at = std::find_if(out.begin(), out.end(), [&](const LoadVector& v) { return v.function == function; });
    if (at != out.end()) return at->f;
    out.push_back({std::vector<double>(2 * static_cast<std::size_t>(setup.nodes()), 0.0), function});
    return out.back().f;
  };
  for (const PointForce& p : point_forces(setup, state))
    add_force(p.row, p.force, vector_of(load_function(setup.model(), p.load)));
  for (const BodyLoad& load : body_loads(setup)) {
    if (load.column == Column::gravity) continue;
    std::vector<double>& f = vector_of(load.function);
    std::transform(load.force.begin(), load.force.end(), f.begin(), f.begin(), std::plus<>());
  }
  return out;
}

void add_loads(const Setup& setup, std::span<const LoadVector> loads, double time, std::span<double> f) {
  for (const LoadVector& load : loads) {
    const double factor = setup.factor(load.function, time);
    if (factor == 0.0) continue;
    parallel_for(static_cast<std::int64_t>(f.size()), [&](std::int64_t i) {
      f[static_cast<std::size_t>(i)] += factor * load.f[static_cast<std::size_t>(i)];
    });
  }
}

}  // namespace scree::coupling
