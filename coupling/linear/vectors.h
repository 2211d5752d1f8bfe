// Products and norms of vectors, summed in the order of their components.
#pragma once

#include <cmath>
#include <span>

namespace scree::coupling {

/// @pre a and b have the same number of components
[[nodiscard]] inline double dot(std::span<const double> a, std::span<const double> b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

/// Largest |x|; not a number if one of them is not.
[[nodiscard]] inline double largest_of(std::span<const double> values) {
  double most = 0.0;
  for (const double x : values)
    if (!(std::abs(x) <= most)) most = std::abs(x);
  return most;
}

}  // namespace scree::coupling
