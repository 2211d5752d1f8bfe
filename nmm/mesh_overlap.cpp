#include "nmm/mesh_overlap.h"

#include <algorithm>
#include <cmath>

#include "model/cell_grid.h"

namespace scree::nmm {
namespace {

constexpr double kLost = 1e-3;  // fraction of an element's area that intersections may leave out uncorrected

/// The part of a convex polygon inside a counter-clockwise triangle.
Ring clipped(Ring polygon, const std::array<Vec2, 3>& triangle) {
  Ring kept;
  for (std::size_t k = 0; k < 3 && !polygon.empty(); ++k) {
    const Vec2 &a = triangle[k], d = triangle[(k + 1) % 3] - a;
    kept.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec2 &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const double at_p = cross(d, p - a), at_q = cross(d, q - a);
      if (at_p >= 0.0) kept.push_back(p);
      if ((at_p > 0.0 && at_q < 0.0) || (at_p < 0.0 && at_q > 0.0))
        kept.emplace_back(p + at_p / (at_p - at_q) * (q - p));
    }
    std::swap(polygon, kept);
  }
  return polygon;
}

/// Calls see(piece) for the common pieces of elements e of `from` and f of `to`.
template <class See>
void each_common(const CoverMesh& from, std::size_t e, const CoverMesh& to, std::size_t f, See&& see) {
  if (from.piece[e] < 0 && to.piece[f] < 0) {
    const auto of_to = to.stars(f);
    Ring ring = clipped({of_to.begin(), of_to.end()}, from.stars(e));
    if (ring.size() >= 3 && signed_area(ring) > 1e-14 * to.area[f]) see(Polygon{std::move(ring), {}});
    return;
  }
  for (const Polygon& piece : intersection(to.material(f), from.material(e))) see(piece);
}

/// Moments of two pieces together.
Moments joined(const Moments& a, const Moments& b) {
  if (a.area == 0.0) return b;
  Moments sum;
  sum.area = a.area + b.area;
  sum.centroid = (a.area * a.centroid + b.area * b.centroid) / sum.area;
  const Vec2 u = a.centroid - sum.centroid, w = b.centroid - sum.centroid;
  sum.second = a.second + b.second + a.area * u * u.transpose() + b.area * w * w.transpose();
  return sum;
}

}  // namespace

std::vector<Overlap> overlaps(const CoverMesh& from, const CoverMesh& to) {
  const auto box_of = [](const CoverMesh& mesh, std::size_t e) { return bounds(mesh.material(e)); };
  Box extent{from.star.front(), from.star.front()};
  for (const Vec2& X : from.star) {
    extent.lo = extent.lo.cwiseMin(X);
    extent.hi = extent.hi.cwiseMax(X);
  }
  CellGrid grid(extent, from.elements());
  for (std::size_t e = 0; e < from.elements(); ++e) grid.insert(box_of(from, e), static_cast<std::int32_t>(e));
  std::vector<Overlap> out;
  std::vector<std::int32_t> near;
  for (std::size_t f = 0; f < to.elements(); ++f) {
    const Box box = box_of(to, f);
    grid.near(box, near);
    const std::size_t first = out.size();
    double area = 0.0;
    for (const std::int32_t e : near) {
      const Box other = box_of(from, static_cast<std::size_t>(e));
      if ((other.lo.array() > box.hi.array()).any() || (other.hi.array() < box.lo.array()).any()) continue;
      Overlap pair{e, static_cast<std::int32_t>(f), {}};
      each_common(from, static_cast<std::size_t>(e), to, f,
                  [&](const Polygon& piece) { pair.common = joined(pair.common, moments(piece)); });
      if (!(pair.common.area > 0.0)) continue;
      area += pair.common.area;
      out.push_back(pair);
    }
    const double lost = to.area[f] - area;
    if (!(lost > kLost * to.area[f])) continue;
    if (area > 0.5 * to.area[f]) {
      for (std::size_t k = first; k < out.size(); ++k) {
        out[k].common.area *= to.area[f] / area;
        out[k].common.second *= to.area[f] / area;
      }
    } else {
      out.resize(first);
      const Moments own = moments(to.material(f));
      out.push_back({from.locate(own.centroid), static_cast<std::int32_t>(f), own});
    }
  }
  return out;
}

}  // namespace scree::nmm
