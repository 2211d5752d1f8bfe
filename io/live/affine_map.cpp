#include "io/live/affine_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "model/geometry.h"

namespace scree::io {

std::array<double, 2> AffineMap::place(const LiveMesh& mesh, std::size_t first, std::size_t point) const {
  const double X = mesh.start_x[point] - mesh.start_x[first], Y = mesh.start_y[point] - mesh.start_y[first];
  return {mesh.start_x[point] + double{ux} + double{xx} * X + double{xy} * Y,
          mesh.start_y[point] + double{uy} + double{yx} * X + double{yy} * Y};
}

std::optional<AffineMap> affine_map(const LiveMesh& mesh, std::size_t body, std::span<const double> position) {
  const std::span<const std::int32_t> points = mesh.points_of(body);
  if (points.empty()) return std::nullopt;
  const auto at = [](std::int32_t p) { return static_cast<std::size_t>(p); };
  const std::size_t first = at(points.front());
  const auto arm = [&](std::size_t p) {
    return Vec2(mesh.start_x[p] - mesh.start_x[first], mesh.start_y[p] - mesh.start_y[first]);
  };
  const auto moved = [&](std::size_t p) {
    return Vec2(position[2 * p] - mesh.start_x[p], position[2 * p + 1] - mesh.start_y[p]);
  };

  //   min sum |u + H X - d|^2:   H S = sum (d - d_mean) (X - X_mean)^T,  S = sum (X - X_mean) (X - X_mean)^T
  Vec2 mean_arm = Vec2::Zero(), mean_moved = Vec2::Zero();
  for (const std::int32_t p : points) mean_arm += arm(at(p)), mean_moved += moved(at(p));
  mean_arm /= static_cast<double>(points.size());
  mean_moved /= static_cast<double>(points.size());
  Mat2 S = Mat2::Zero(), C = Mat2::Zero();
  for (const std::int32_t p : points) {
    const Vec2 X = arm(at(p)) - mean_arm;
    S += X * X.transpose();
    C += (moved(at(p)) - mean_moved) * X.transpose();
  }
  constexpr double kFlat = 1e-12;  // points on a line: the map across the line is not determined
  const double trace = S.trace();
  if (!(S.determinant() > kFlat * trace * trace)) return std::nullopt;
  const Mat2 H = C * S.inverse();
  const Vec2 u = mean_moved - H * mean_arm;
  AffineMap map;
  map.ux = static_cast<float>(u.x()), map.uy = static_cast<float>(u.y());
  map.xx = static_cast<float>(H(0, 0)), map.xy = static_cast<float>(H(0, 1));
  map.yx = static_cast<float>(H(1, 0)), map.yy = static_cast<float>(H(1, 1));

  // The rounding of u and H is half a unit of float32 each, that of positions a few units of double.
  constexpr double kFloat = 0x1p-24, kDouble = 0x1p-53;
  double reach = 0.0, far = 0.0;
  for (const std::int32_t p : points) {
    reach = std::max(reach, arm(at(p)).norm());
    far = std::max({far, std::abs(mesh.start_x[at(p)]), std::abs(mesh.start_y[at(p)])});
  }
  const double allowed = 4.0 * kFloat * (u.norm() + H.norm() * reach) + 64.0 * kDouble * far;
  for (const std::int32_t p : points) {
    const auto [x, y] = map.place(mesh, first, at(p));
    // Written so that NaN is rejected.
    if (!(std::abs(x - position[2 * at(p)]) <= allowed && std::abs(y - position[2 * at(p) + 1]) <= allowed))
      return std::nullopt;
  }
  return map;
}

}  // namespace scree::io
