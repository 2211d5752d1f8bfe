#include "model/geometry.h"

#include <algorithm>
#include <cmath>

namespace scree {

Mat2 rotation(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Mat2() << c, -s, s, c).finished();
}

double signed_area(const Ring& ring) {
  double sum = 0.0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 a = ring[i] - ring[0], b = ring[(i + 1) % ring.size()] - ring[0];
    sum += cross(a, b);
  }
  return 0.5 * sum;
}

namespace {

/// Zeroth, first and second moments about `origin`, summed over the triangles (origin, a, b) of every edge.
struct RawMoments {
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  Mat2 second = Mat2::Zero();
};

RawMoments raw_moments(const Polygon& polygon, const Vec2& origin) {
  RawMoments r;
  for (std::size_t k = 0; k < polygon.rings(); ++k) {
    const Ring& ring = polygon.ring(k);
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 a = ring[i] - origin, b = ring[(i + 1) % ring.size()] - origin;
      const double d = cross(a, b);
      r.area += d / 2.0;
      r.first += d / 6.0 * (a + b);
      r.second +=
          d / 24.0 * (2.0 * a * a.transpose() + 2.0 * b * b.transpose() + a * b.transpose() + b * a.transpose());
    }
  }
  return r;
}

}  // namespace

Moments moments(const Polygon& polygon) {
  // Twice: about a vertex to find the centroid, then about the centroid, so that no large numbers cancel.
  const Vec2 near = polygon.outer.front();
  const RawMoments rough = raw_moments(polygon, near);
  const Vec2 origin = near + rough.first / rough.area;
  const RawMoments fine = raw_moments(polygon, origin);
  Moments m;
  m.area = fine.area;
  const Vec2 shift = fine.first / fine.area;
  m.centroid = origin + shift;
  m.second = fine.second - fine.area * shift * shift.transpose();
  return m;
}

std::vector<std::size_t> orient(Polygon& polygon) {
  std::vector<std::size_t> turned;
  for (std::size_t k = 0; k < polygon.rings(); ++k) {
    const double area = signed_area(polygon.ring(k));
    if ((k == 0) == (area < 0.0)) {
      std::reverse(polygon.ring(k).begin(), polygon.ring(k).end());
      turned.push_back(k);
    }
  }
  return turned;
}

Polygon transformed(const Polygon& polygon, const Vec2& c, const Mat2& F) {
  Polygon image = polygon;
  for (std::size_t k = 0; k < image.rings(); ++k)
    for (Vec2& x : image.ring(k)) x = c + F * x;
  return image;
}

Box bounds(const Polygon& polygon) {
  Box box{polygon.outer.front(), polygon.outer.front()};
  for (const Vec2& x : polygon.outer) {
    box.lo = box.lo.cwiseMin(x);
    box.hi = box.hi.cwiseMax(x);
  }
  return box;
}

bool contains(const Polygon& polygon, const Vec2& point) {
  bool inside = false;
  for (std::size_t k = 0; k < polygon.rings(); ++k) {
    const Ring& ring = polygon.ring(k);
    for (std::size_t i = 0, j = ring.size() - 1; i < ring.size(); j = i++) {
      const Vec2 &a = ring[i], &b = ring[j];
      if ((a.y() > point.y()) != (b.y() > point.y()) &&
          point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x())
        inside = !inside;
    }
  }
  return inside;
}

}  // namespace scree
