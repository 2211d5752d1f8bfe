#include "io/pictures/frame_field.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace scree::io {

namespace {

constexpr std::array<FieldInfo, 11> kInfo{{{"displacement", "m", false},
                                           {"speed", "m/s", false},
                                           {"stress σxx", "Pa", true},
                                           {"stress σyy", "Pa", true},
                                           {"shear stress σxy", "Pa", true},
                                           {"larger principal stress σ₁", "Pa", true},
                                           {"smaller principal stress σ₃", "Pa", true},
                                           {"block", "", false},
                                           {"method", "", false},
                                           {"material", "", false},
                                           {"stress over rock strength", "1", false}}};

constexpr double kCovered = 0.99;  // of the area, by the range of a stress

std::vector<double> mean_magnitude(const StoredFrame& frame, const std::vector<double>& xy) {
  std::vector<double> values(frame.cells());
  for (std::size_t c = 0; c < values.size(); ++c) {
    for (auto i = static_cast<std::size_t>(frame.offsets[c]); i < static_cast<std::size_t>(frame.offsets[c + 1]); ++i) {
      const auto p = static_cast<std::size_t>(frame.connectivity[i]);
      values[c] += std::hypot(xy[2 * p], xy[2 * p + 1]);
    }
    values[c] /= std::max(1.0, static_cast<double>(frame.offsets[c + 1] - frame.offsets[c]));
  }
  return values;
}

std::vector<double> component(const std::vector<double>& rows, std::size_t width, std::size_t which) {
  std::vector<double> values;
  for (std::size_t i = which; i < rows.size(); i += width) values.push_back(rows[i]);
  return values;
}

std::vector<double> numbers(const std::vector<std::int32_t>& ids) { return {ids.begin(), ids.end()}; }

}  // namespace

const FieldInfo& info(Field field) { return kInfo[static_cast<std::size_t>(field)]; }

std::vector<double> cell_values(const StoredFrame& frame, Field field) {
  switch (field) {
    case Field::displacement:
      return mean_magnitude(frame, frame.displacement);
    case Field::speed:
      return mean_magnitude(frame, frame.velocity);
    case Field::sxx:
      return component(frame.stress, 3, 0);
    case Field::syy:
      return component(frame.stress, 3, 1);
    case Field::sxy:
      return component(frame.stress, 3, 2);
    case Field::s1:
      return component(frame.principal, 2, 0);
    case Field::s3:
      return component(frame.principal, 2, 1);
    case Field::block:
      return numbers(frame.block);
    case Field::method:
      return numbers(frame.method);
    case Field::material:
      return numbers(frame.material);
    case Field::utilisation:
      break;  // it requires the materials: cell_utilisation
  }
  return {};
}

double stress_value(const std::array<double, 3>& stress, Field field) {
  const auto [xx, yy, xy] = stress;
  const double mean = 0.5 * (xx + yy), radius = std::hypot(0.5 * (xx - yy), xy);
  switch (field) {
    case Field::sxx:
      return xx;
    case Field::syy:
      return yy;
    case Field::sxy:
      return xy;
    case Field::s1:
      return mean + radius;
    default:
      return mean - radius;
  }
}

std::pair<double, double> colour_range(const StoredFrame& frame, Field field, const std::vector<double>& values,
                                       const std::vector<char>& skip, double rounding) {
  std::vector<std::pair<double, double>> sized;  // |value|, area
  double area = 0.0;
  for (std::size_t c = 0; c < values.size(); ++c) {
    if (skip[c] || !std::isfinite(values[c])) continue;
    sized.emplace_back(std::abs(values[c]), std::abs(cell_area(frame, c)));
    area += sized.back().second;
  }
  std::sort(sized.begin(), sized.end());
  double most = sized.empty() ? 0.0 : sized.back().first;
  if (info(field).is_signed) {
    double covered = 0.0;
    for (const auto& [value, cell] : sized) {
      most = value;
      covered += cell;
      if (covered >= kCovered * area) break;
    }
  }
  if (!(most > rounding)) most = 1.0;
  return {info(field).is_signed ? -most : 0.0, most};
}

double rounding_of(Field field, const StoredFrame& frame, const std::vector<StoredMaterial>& materials) {
  constexpr double kNoise = 1e-12;  // well above eps times the few hundred operations behind a value
  double scale = 0.0;
  if (field == Field::displacement)
    for (const double x : frame.position) scale = std::max(scale, std::abs(x));
  if (info(field).is_signed)
    for (const StoredMaterial& m : materials) scale = std::max(scale, m.young);
  return kNoise * scale;
}

std::vector<Arrow> arrows_of(const StoredFrame& frame, const std::vector<double>& value, const std::vector<char>& skip,
                             double spacing) {
  struct Extent {
    Vec2 low = Vec2::Constant(1e300), high = Vec2::Constant(-1e300);
  };
  struct Sum {
    Vec2 at = Vec2::Zero(), vector = Vec2::Zero();
    double weight = 0.0;
  };
  std::vector<Vec2> middle;
  std::map<std::int32_t, Extent> extent;  // of the middles of each block's cells
  for (std::size_t c = 0; c < frame.cells(); ++c) {
    middle.push_back(cell_middle(frame, c));
    if (skip[c] || !middle[c].allFinite()) continue;
    Extent& e = extent[frame.block[c]];
    e.low = e.low.cwiseMin(middle[c]), e.high = e.high.cwiseMax(middle[c]);
  }
  std::map<std::tuple<std::int32_t, int, int>, Sum> parts;
  for (std::size_t c = 0; c < frame.cells(); ++c) {
    const Vec2 v(value[2 * c], value[2 * c + 1]);
    if (skip[c] || !middle[c].allFinite() || !v.allFinite()) continue;
    const Extent& e = extent[frame.block[c]];
    const auto place = [&](Eigen::Index axis) {
      const double length = e.high[axis] - e.low[axis], count = std::max(1.0, std::round(length / spacing));
      return length > 0.0 ? static_cast<int>(std::min(count - 1.0, count * (middle[c][axis] - e.low[axis]) / length))
                          : 0;
    };
    Sum& s = parts[{frame.block[c], place(0), place(1)}];
    const double area = std::abs(cell_area(frame, c));
    s.at += area * middle[c], s.vector += area * v, s.weight += area;
  }
  std::vector<Arrow> arrows;
  for (const auto& [key, s] : parts)
    if (s.weight > 0.0) arrows.push_back({s.at / s.weight, s.vector / s.weight});
  return arrows;
}

std::vector<std::pair<std::int64_t, std::int64_t>> outline_edges(const StoredFrame& frame) {
  double extent = 0.0;
  std::vector<double> origin(frame.position.size());
  for (std::size_t i = 0; i < origin.size(); ++i) {
    origin[i] = frame.position[i] - frame.displacement[i];
    extent = std::max(extent, std::abs(origin[i]));
  }
  const double grid = std::max(1e-8 * extent, 1e-300);  // two points nearer than this are one
  using Spot = std::pair<std::int64_t, std::int64_t>;
  const auto spot = [&](std::size_t p) {
    return Spot{std::llround(origin[2 * p] / grid), std::llround(origin[2 * p + 1] / grid)};
  };

  struct Edge {
    int cells = 0;
    std::pair<std::int64_t, std::int64_t> points;
  };
  std::map<std::tuple<std::int32_t, Spot, Spot>, Edge> edges;
  for (std::size_t c = 0; c < frame.cells(); ++c) {
    const auto first = static_cast<std::size_t>(frame.offsets[c]), end = static_cast<std::size_t>(frame.offsets[c + 1]);
    for (std::size_t i = first; i < end; ++i) {
      const std::int64_t a = frame.connectivity[i], b = frame.connectivity[i + 1 < end ? i + 1 : first];
      const Spot sa = spot(static_cast<std::size_t>(a)), sb = spot(static_cast<std::size_t>(b));
      Edge& edge = edges[{frame.block[c], std::min(sa, sb), std::max(sa, sb)}];
      ++edge.cells;
      edge.points = {a, b};
    }
  }
  std::vector<std::pair<std::int64_t, std::int64_t>> outline;
  for (const auto& [key, edge] : edges)
    if (edge.cells == 1) outline.push_back(edge.points);
  return outline;
}

}  // namespace scree::io
