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

/// The element that contains a point of the block.
std::int32_t element_at(const CoverMesh& mesh, const LatticePieces* pieces, const Vec2& inside) {
  if (pieces == nullptr) return 0;
  const auto [first, last] = pieces->elements(pieces->lattice.triangle_at(inside));
  if (first == last) return mesh.locate(inside);  // a piece without area was dropped here
  if (first + 1 == last) return first;
  for (std::int32_t e = first; e < last; ++e)
    if (contains(mesh.material(static_cast<std::size_t>(e)), inside)) return e;
  return mesh.locate(inside);
}

constexpr double kBeside = 1e-3;  // distance beside a stretch at which its element is searched, of its length

}  // namespace

void make_boundary(const Polygon& outline, const LatticePieces* pieces, std::span<const CutLine> cracks,
                   CoverMesh& mesh) {
  Boundary& out = mesh.boundary;
  // The last segment ends at the first node of the next, or, at the mouth of a crack, at a node of its own side.
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
        const std::int32_t cell =
            element_at(mesh, pieces, middle + kBeside * (t[k + 1] - t[k]) * (b - a).norm() * inward);
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

void make_crack_faces(const Polygon& outline, const LatticePieces& pieces, std::span<const CutLine> cracks,
                      CoverMesh& mesh) {
  Boundary& out = mesh.boundary;
  const auto add_node = [&out](const Row& row, std::vector<std::int32_t>& face) {
    face.push_back(static_cast<std::int32_t>(out.nodes.size()));
    out.nodes.push_back(row);
  };
  // Lines that a crack may cross: other cracks and, if it leaves the block or runs through a hole, the outline.
  std::vector<CutLine> lines(cracks.begin(), cracks.end());
  for (std::size_t r = 0; r < outline.rings(); ++r)
    for (std::size_t i = 0; i < outline.ring(r).size(); ++i)
      lines.push_back({outline.ring(r)[i], outline.ring(r)[(i + 1) % outline.ring(r).size()]});
  for (std::size_t c = 0; c < cracks.size(); ++c) {
    const Vec2 &a = cracks[c].from, &b = cracks[c].to;
    const Vec2 to_left = quarter_turn() * (b - a).normalized();
    const std::vector<double> t = crossings(&pieces.lattice, lines, a, b);
    bool open = false;  // the previous stretch was cut
    for (std::size_t k = 0; k + 1 < t.size(); ++k) {
      const Vec2 start = a + t[k] * (b - a), end = a + t[k + 1] * (b - a), middle = 0.5 * (start + end);
      const Vec2 beside = kBeside * (end - start).norm() * to_left;
      const std::int32_t left = element_at(mesh, &pieces, middle + beside),
                         right = element_at(mesh, &pieces, middle - beside);
      // If the crack ends within a triangle, or along an edge that the pieces share, its sides are not separate.
      const bool cut = contains(outline, middle) && !same_place(mesh.row(left, middle), mesh.row(right, middle));
      if (cut) {
        const auto goes_on = [&](const std::vector<std::int32_t>& face, std::int32_t element) {
          return same_place(out.nodes[static_cast<std::size_t>(face.back())], mesh.row(element, start));
        };
        // Another crack that ends on this one divides its side, and new faces begin.
        if (!open || !goes_on(out.cracks.back().left, left) || !goes_on(out.cracks.back().right, right)) {
          out.cracks.push_back({static_cast<std::int32_t>(c), {}, {}});
          add_node(mesh.row(left, start), out.cracks.back().left);
          add_node(mesh.row(right, start), out.cracks.back().right);
        }
        add_node(mesh.row(left, end), out.cracks.back().left);
        add_node(mesh.row(right, end), out.cracks.back().right);
      }
      open = cut;
    }
  }
}

}  // namespace scree::nmm
