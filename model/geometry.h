// Polygons with holes: exact moments, simple predicates. World or material coordinates, m.
#pragma once

#include <Eigen/Core>
#include <vector>

namespace scree {

using Vec2 = Eigen::Vector2d;
using Mat2 = Eigen::Matrix2d;
using Ring = std::vector<Vec2>;  // not closed: the last vertex is joined to the first

/// The quarter turn W = [[0,-1],[1,0]]: W a is a turned by +90 degrees.
[[nodiscard]] inline Mat2 quarter_turn() { return (Mat2() << 0.0, -1.0, 1.0, 0.0).finished(); }
/// z component of a x b.
[[nodiscard]] inline double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }
/// Rotation by an angle [rad], counter-clockwise.
[[nodiscard]] Mat2 rotation(double angle);

/// Outer ring counter-clockwise, holes clockwise (orient() makes it so).
struct Polygon {
  Ring outer;
  std::vector<Ring> holes;

  /// Outer ring first, then the holes.
  [[nodiscard]] std::size_t rings() const { return 1 + holes.size(); }
  [[nodiscard]] const Ring& ring(std::size_t i) const { return i == 0 ? outer : holes[i - 1]; }
  [[nodiscard]] Ring& ring(std::size_t i) { return i == 0 ? outer : holes[i - 1]; }
  bool operator==(const Polygon&) const = default;
};

/// Integrals over a polygon.
struct Moments {
  double area = 0.0;           // [m2]
  Vec2 centroid{0.0, 0.0};     // [m]
  Mat2 second = Mat2::Zero();  // int (x-c)(x-c)^T dA about the centroid [m4]
};

/// Signed area of a ring [m2], positive counter-clockwise.
[[nodiscard]] double signed_area(const Ring& ring);

/// Exact moments by simplex integration: every edge spans a triangle with a fixed point near the polygon.
/// @pre outer counter-clockwise, holes clockwise, area > 0
/// @source [Shi1988], simplex integration; [Qu2013] 3.3.1
[[nodiscard]] Moments moments(const Polygon& polygon);

/// Reverses rings so that the outer one runs counter-clockwise and the holes clockwise. Returns the rings that were
/// reversed.
std::vector<std::size_t> orient(Polygon& polygon);

/// Image of the polygon under x -> c + F x.
[[nodiscard]] Polygon transformed(const Polygon& polygon, const Vec2& c, const Mat2& F);

struct Box {
  Vec2 lo{0.0, 0.0}, hi{0.0, 0.0};
};
[[nodiscard]] Box bounds(const Polygon& polygon);

/// True where the point lies inside the polygon (boundary points may count as inside or outside).
[[nodiscard]] bool contains(const Polygon& polygon, const Vec2& point);

}  // namespace scree
