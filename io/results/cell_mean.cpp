#include "io/results/cell_mean.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/check.h"
#include "model/geometry.h"

namespace scree::io {

namespace {

Vec2 row(std::span<const double> pairs, std::int32_t point) {
  const auto p = 2 * static_cast<std::size_t>(point);
  return {pairs[p], pairs[p + 1]};
}

Vec2 mean(std::span<const double> place, std::span<const double> value, std::span<const std::int32_t> cell) {
  const Vec2 x0 = row(place, cell.front()), u0 = row(value, cell.front());
  // Relative to the first point: the sums stay small far from the origin and under large displacements.
  Vec2 moment = Vec2::Zero(), sum = Vec2::Zero();
  double twice = 0.0, extent = 0.0;
  for (std::size_t i = 1; i < cell.size(); ++i) {
    const Vec2 d = row(place, cell[i]) - x0, u = row(value, cell[i]) - u0;
    sum += u;
    extent = std::max(extent, d.squaredNorm());
    if (i + 1 == cell.size()) break;
    const Vec2 e = row(place, cell[i + 1]) - x0;
    const double area = d.x() * e.y() - d.y() * e.x();
    twice += area;
    moment += area / 3.0 * (u + row(value, cell[i + 1]) - u0);
  }
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * extent;
  if (std::abs(twice) <= rounding) return u0 + sum / static_cast<double>(cell.size());
  return u0 + moment / twice;
}

}  // namespace

std::vector<double> cell_mean(std::span<const double> place, std::span<const double> value,
                              std::span<const std::int32_t> offsets, std::span<const std::int32_t> connectivity) {
  SCREE_ASSERT(place.size() == value.size());
  std::vector<double> means;
  if (offsets.empty()) return means;
  means.reserve(2 * (offsets.size() - 1));
  for (std::size_t c = 0; c + 1 < offsets.size(); ++c) {
    const auto first = static_cast<std::size_t>(offsets[c]), end = static_cast<std::size_t>(offsets[c + 1]);
    SCREE_ASSERT(first < end);
    const Vec2 m = mean(place, value, connectivity.subspan(first, end - first));
    means.insert(means.end(), {m.x(), m.y()});
  }
  return means;
}

}  // namespace scree::io
