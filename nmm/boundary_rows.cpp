#include <algorithm>
#include <cmath>

#include "model/outline.h"
#include "nmm/lattice_cut.h"

namespace scree::nmm {
namespace {

/// Fractions of a -> b where it crosses lattice lines and cracks, with both ends.
std::vector<double> crossings(const Lattice* lattice, std::span<const CutLine> cracks, const Vec2& a, const Vec2& b) {
  std::vector<double> t{0.0, 1.0};
  for (const CutLine& c : cracks) {
    const Vec2 d = b - a, e = c.to - c.from;
    const double turn = cross(d, e);
    if (std::abs(turn) < 1e-12 * d.norm() * e.norm()) continue;
    const double along = cross(c.from - a, e) / turn, reach = cross(c.from - a, d) / turn;
    if (reach > -1e-9 && reach < 1.0 + 1e-9) t.push_back(along);
  }
  if (lattice != nullptr) {
    const Vec2 oa = lattice->oblique(a), ob = lattice->oblique(b);
    const std::array<std::pair<double, double>, 3> families{{{oa.x(), ob.x()}, {oa.y(), ob.y()}, {oa.sum(), ob.sum()}}};
    for (const auto& [from, to] : families)
      for (double line = std::ceil(std::min(from, to)); line <= std::max(from, to); line += 1.0)
        if (std::abs(to - from) > 1e-12) t.push_back((line - from) / (to - from));
  }
  std::sort(t.begin(), t.end());
  std::vector<double> out;
  for (double x : t)
    if (x >= 0.0 && x <= 1.0 && (out.empty() || x - out.back() > 1e-9)) out.push_back(x);
  out.back() = 1.0;
  return out;
}

}  // namespace

void make_boundary(const Polygon& outline, const LatticePieces* pieces, std::span<const CutLine> cracks,
                   CoverMesh& mesh) {
  const auto element_at = [&](const Vec2& inside) {
    if (pieces == nullptr) return std::int32_t{0};
    const auto [first, last] = pieces->elements(pieces->lattice.triangle_at(inside));
    if (first == last) return mesh.locate(inside);  // a piece without area was dropped here
    if (first + 1 == last) return first;
    for (std::int32_t e = first; e < last; ++e)
      if (contains(mesh.material(static_cast<std::size_t>(e)), inside)) return e;
    return mesh.locate(inside);
  };
  Boundary& out = mesh.boundary;
  // The last segment ends where the next begins, or, at the mouth of a crack, at a node of its own side.
  const auto end_segment = [&](const Vec2& at, const Row& next) {
    const Row own = mesh.row(out.segments.back().cell, at);
    if (!same_place(own, next)) out.nodes.push_back(own);
    out.segments.back().b = static_cast<std::int32_t>(out.nodes.size()) - (same_place(own, next) ? 0 : 1);
  };
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const Ring& ring = outline.ring(r);
    const auto ring_start = static_cast<std::int32_t>(out.nodes.size());
    bool first_of_ring = true;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()], &before = ring[(i + ring.size() - 1) % ring.size()];
      const Vec2 inward = quarter_turn() * (b - a).normalized();
      out.corners.push_back({static_cast<std::int32_t>(out.nodes.size()), static_cast<std::int32_t>(r),
                             static_cast<std::int32_t>(i), interior_angle(before, a, b)});
      const std::vector<double> t = crossings(pieces == nullptr ? nullptr : &pieces->lattice, cracks, a, b);
      for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        const Vec2 start = a + t[k] * (b - a), middle = a + 0.5 * (t[k] + t[k + 1]) * (b - a);
        const std::int32_t cell = element_at(middle + 1e-3 * (t[k + 1] - t[k]) * (b - a).norm() * inward);
        const Row row = mesh.row(cell, k == 0 ? a : start);
        if (!first_of_ring) end_segment(k == 0 ? a : start, row);
        first_of_ring = false;
        if (k == 0) out.corners.back().node = static_cast<std::int32_t>(out.nodes.size());
        const auto node = static_cast<std::int32_t>(out.nodes.size());
        out.nodes.push_back(row);
        out.segments.push_back(
            {node, node, {static_cast<std::int32_t>(r), static_cast<std::int32_t>(i)}, t[k], t[k + 1], cell});
      }
    }
    const Row first = out.nodes[static_cast<std::size_t>(ring_start)];
    end_segment(ring[0], first);
    if (out.segments.back().b == static_cast<std::int32_t>(out.nodes.size())) out.segments.back().b = ring_start;
  }
}

}  // namespace scree::nmm
