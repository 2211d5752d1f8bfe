// Dead loads as vectors of nodal forces, for schemes that solve for all nodes at once.
#pragma once

#include <span>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// Forces that share a time function: f times the function's value.
struct LoadVector {
  std::vector<double> f;  // x, y per node of the state's arrays, at the factor 1 [N]
  FunctionId function;    // invalid: constant
};

/// Point loads, tractions and body accelerations of the model, one vector per time function; gravity is not among them.
/// Loads on driven bodies are left out.
[[nodiscard]] std::vector<LoadVector> load_vectors(const Setup& setup, const State& state);

/// f += the loads at a time [s].
void add_loads(const Setup& setup, std::span<const LoadVector> loads, double time, std::span<double> f);

}  // namespace scree::coupling
