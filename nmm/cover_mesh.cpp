#include "nmm/cover_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <tuple>

#include "model/check.h"
#include "model/outline.h"
#include "model/planar.h"
#include "nmm/lattice.h"

namespace scree::nmm {

Eigen::Matrix<double, 2, 3> Element::gradients() const {
  const double twice = cross(star[1] - star[0], star[2] - star[0]);
  Eigen::Matrix<double, 2, 3> g;
  for (int k = 0; k < 3; ++k) {
    const Vec2 &a = star[std::size_t(k + 1) % 3], &b = star[std::size_t(k + 2) % 3];
    g.col(k) << (a.y() - b.y()) / twice, (b.x() - a.x()) / twice;
  }
  return g;
}

std::array<double, 3> Element::weights(const Vec2& X) const {
  const double twice = cross(star[1] - star[0], star[2] - star[0]);
  const double w1 = cross(X - star[0], star[2] - star[0]) / twice;
  const double w2 = cross(star[1] - star[0], X - star[0]) / twice;
  return {1.0 - w1 - w2, w1, w2};
}

std::int32_t CoverMesh::locate(const Vec2& X) const {
  std::int32_t best = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < elements.size(); ++e) {
    if (contains(elements[e].piece, X)) return static_cast<std::int32_t>(e);
    const double d = (elements[e].centroid - X).squaredNorm();
    if (d < distance) {
      distance = d;
      best = static_cast<std::int32_t>(e);
    }
  }
  return best;
}

Row CoverMesh::row(std::int32_t element, const Vec2& X) const {
  const Element& e = elements[static_cast<std::size_t>(element)];
  return {e.cover, e.weights(X)};
}

namespace {

using Piece = std::pair<LatticeTriangle, std::size_t>;  // triangle and element index

Element make_element(const std::array<Vec2, 3>& star, Polygon piece, double full_area) {
  Element e;
  e.star = star;
  const Moments m = moments(piece);
  e.area = m.area;
  e.centroid = m.centroid;
  e.fraction = m.area / full_area;
  e.piece = std::move(piece);
  return e;
}

/// Intersects every lattice triangle near the block with it.
std::vector<Piece> cut_elements(const Polygon& outline, const Lattice& lattice, CoverMesh& mesh) {
  const Clipper clipper(outline);
  const Box box = bounds(outline);
  const double full = lattice.triangle_area();
  const std::array<Vec2, 4> corners{lattice.oblique(box.lo), lattice.oblique(box.hi),
                                    lattice.oblique({box.lo.x(), box.hi.y()}),
                                    lattice.oblique({box.hi.x(), box.lo.y()})};
  Vec2 lo = corners[0], hi = corners[0];
  for (const Vec2& c : corners) {
    lo = lo.cwiseMin(c);
    hi = hi.cwiseMax(c);
  }
  std::vector<Piece> pieces;
  for (auto j = static_cast<std::int32_t>(std::floor(lo.y())); j <= static_cast<std::int32_t>(std::floor(hi.y()));
       ++j) {
    // Only the columns that the box covers in this row.
    const auto i0 =
        static_cast<std::int32_t>(std::floor(lattice.oblique({box.lo.x(), lattice.position({0, j + 1}).y()}).x()));
    const auto i1 =
        static_cast<std::int32_t>(std::floor(lattice.oblique({box.hi.x(), lattice.position({0, j}).y()}).x()));
    for (std::int32_t i = i0; i <= i1; ++i)
      for (std::int32_t down = 0; down < 2; ++down) {
        const LatticeTriangle t{j, i, down};
        const auto nodes = Lattice::corners(t);
        const std::array<Vec2, 3> star{lattice.position(nodes[0]), lattice.position(nodes[1]),
                                       lattice.position(nodes[2])};
        const Ring cell(star.begin(), star.end());
        const Clipper::Relation relation = clipper.relation(cell);
        if (relation == Clipper::Relation::outside) continue;
        std::vector<Polygon> parts;
        if (relation == Clipper::Relation::inside)
          parts.push_back({cell, {}});
        else
          parts = clipper.intersection(cell);
        for (Polygon& part : parts) {
          Element e = make_element(star, std::move(part), full);
          if (e.fraction < 1e-13) continue;  // touches along a line only
          pieces.emplace_back(t, mesh.elements.size());
          mesh.elements.push_back(std::move(e));
        }
      }
  }
  return pieces;
}

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t find(std::size_t a) {
    while (parent_[a] != a) a = parent_[a] = parent_[parent_[a]];
    return a;
  }
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::size_t> parent_;
};

/// A stretch of a mesh edge that bounds a piece: from and to are fractions of the edge.
struct Stretch {
  std::size_t element;
  double from, to;
};

/// Physical covers: pieces of neighbouring triangles that share an edge length share the two covers at its ends.
void number_covers(const std::vector<Piece>& pieces, const Lattice& lattice, CoverMesh& mesh) {
  std::map<std::pair<LatticeNode, LatticeNode>, std::vector<Stretch>> edges;
  const double tolerance = 1e-9;
  for (const auto& [t, index] : pieces) {
    const auto nodes = Lattice::corners(t);
    for (std::size_t k = 0; k < 3; ++k) {
      const LatticeNode a = std::min(nodes[k], nodes[(k + 1) % 3]), b = std::max(nodes[k], nodes[(k + 1) % 3]);
      const Vec2 pa = lattice.position(a), d = lattice.position(b) - pa;
      const double length2 = d.squaredNorm();
      const Polygon& piece = mesh.elements[index].piece;
      for (std::size_t r = 0; r < piece.rings(); ++r) {
        const Ring& ring = piece.ring(r);
        for (std::size_t m = 0; m < ring.size(); ++m) {
          const Vec2 u = ring[m] - pa, w = ring[(m + 1) % ring.size()] - pa;
          if (std::abs(cross(d, u)) > tolerance * length2 || std::abs(cross(d, w)) > tolerance * length2) continue;
          const double s = u.dot(d) / length2, e = w.dot(d) / length2;
          if (std::abs(e - s) > tolerance) edges[{a, b}].push_back({index, std::min(s, e), std::max(s, e)});
        }
      }
    }
  }
  // A (piece, corner) pair starts as a cover of its own; shared edge lengths join them.
  const auto corner_of = [&](std::size_t element, const LatticeNode& n) {
    const auto nodes = Lattice::corners(pieces[element].first);
    return 3 * element + static_cast<std::size_t>(std::find(nodes.begin(), nodes.end(), n) - nodes.begin());
  };
  UnionFind sets(3 * mesh.elements.size());
  for (const auto& [ends, stretches] : edges)
    for (std::size_t i = 0; i < stretches.size(); ++i)
      for (std::size_t j = i + 1; j < stretches.size(); ++j) {
        const Stretch &a = stretches[i], &b = stretches[j];
        if (a.element == b.element || pieces[a.element].first == pieces[b.element].first) continue;
        if (std::min(a.to, b.to) - std::max(a.from, b.from) <= tolerance) continue;
        sets.join(corner_of(a.element, ends.first), corner_of(b.element, ends.first));
        sets.join(corner_of(a.element, ends.second), corner_of(b.element, ends.second));
      }
  std::vector<std::int32_t> number(3 * mesh.elements.size(), -1);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t root = sets.find(3 * e + k);
      if (number[root] < 0) {
        number[root] = static_cast<std::int32_t>(mesh.star.size());
        mesh.star.push_back(mesh.elements[e].star[k]);
      }
      mesh.elements[e].cover[k] = number[root];
    }
}

constexpr double kRootFraction = 0.5;  // nmm.md: least step 0.69 of the uncut mesh's on 1000 placements

/// Ties every cover without a root element to the nearest root that is reached over the fewest elements: nearest in the
/// material, so that the two sides of a slot are never tied to each other.
bool tie_covers(CoverMesh& mesh) {
  std::vector<std::vector<std::size_t>> at(mesh.star.size());
  std::vector<char> good(mesh.star.size(), 0);
  for (std::size_t e = 0; e < mesh.elements.size(); ++e)
    for (std::int32_t c : mesh.elements[e].cover) {
      at[static_cast<std::size_t>(c)].push_back(e);
      if (mesh.elements[e].fraction >= kRootFraction) good[static_cast<std::size_t>(c)] = 1;
    }
  if (std::find(good.begin(), good.end(), 1) == good.end()) return false;
  for (std::size_t c = 0; c < mesh.star.size(); ++c) {
    if (good[c] != 0) continue;
    std::vector<char> seen(mesh.elements.size(), 0);
    std::vector<std::size_t> front = at[c];
    for (std::size_t e : front) seen[e] = 1;
    const Element* root = nullptr;
    double distance = std::numeric_limits<double>::infinity();
    while (root == nullptr && !front.empty()) {
      std::vector<std::size_t> next;
      for (std::size_t e : front) {
        const Element& element = mesh.elements[e];
        const Vec2 middle = (element.star[0] + element.star[1] + element.star[2]) / 3.0;
        if (const double d = (middle - mesh.star[c]).squaredNorm(); element.fraction >= kRootFraction && d < distance) {
          distance = d;
          root = &element;
        }
        for (std::int32_t k : element.cover)
          for (std::size_t n : at[static_cast<std::size_t>(k)])
            if (seen[n] == 0) {
              seen[n] = 1;
              next.push_back(n);
            }
      }
      front = std::move(next);
    }
    if (root == nullptr) return false;  // a part of the block that no root element reaches
    mesh.ties.push_back({static_cast<std::int32_t>(c), root->cover, root->weights(mesh.star[c])});
  }
  return true;
}

/// Fractions of a -> b where it crosses lattice lines, with both ends.
std::vector<double> crossings(const Lattice* lattice, const Vec2& a, const Vec2& b) {
  std::vector<double> t{0.0, 1.0};
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

void make_boundary(const Polygon& outline, const Lattice* lattice, const std::vector<Piece>& pieces, CoverMesh& mesh) {
  std::multimap<LatticeTriangle, std::size_t> by_triangle(pieces.begin(), pieces.end());
  const auto element_at = [&](const Vec2& inside) {
    if (lattice == nullptr) return std::int32_t{0};
    const auto [first, last] = by_triangle.equal_range(lattice->triangle_at(inside));
    if (first == last) return mesh.locate(inside);  // a piece without area was dropped here
    if (std::next(first) == last) return static_cast<std::int32_t>(first->second);
    for (auto it = first; it != last; ++it)
      if (contains(mesh.elements[it->second].piece, inside)) return static_cast<std::int32_t>(it->second);
    return mesh.locate(inside);
  };
  Boundary& out = mesh.boundary;
  for (std::size_t r = 0; r < outline.rings(); ++r) {
    const Ring& ring = outline.ring(r);
    const auto ring_start = static_cast<std::int32_t>(out.nodes.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()], &before = ring[(i + ring.size() - 1) % ring.size()];
      const Vec2 inward = quarter_turn() * (b - a).normalized();
      out.corners.push_back({static_cast<std::int32_t>(out.nodes.size()), static_cast<std::int32_t>(r),
                             static_cast<std::int32_t>(i), interior_angle(before, a, b)});
      const std::vector<double> t = crossings(lattice, a, b);
      for (std::size_t k = 0; k + 1 < t.size(); ++k) {
        const Vec2 start = a + t[k] * (b - a), middle = a + 0.5 * (t[k] + t[k + 1]) * (b - a);
        const std::int32_t cell = element_at(middle + 1e-3 * (t[k + 1] - t[k]) * (b - a).norm() * inward);
        const auto node = static_cast<std::int32_t>(out.nodes.size());
        out.nodes.push_back(mesh.row(cell, k == 0 ? a : start));
        out.segments.push_back(
            {node, node + 1, {static_cast<std::int32_t>(r), static_cast<std::int32_t>(i)}, t[k], t[k + 1], cell});
      }
    }
    out.segments.back().b = ring_start;
  }
}

}  // namespace

CoverMesh make_onefold(const Polygon& outline) {
  CoverMesh mesh;
  mesh.onefold = true;
  double radius = 0.0;
  for (const Vec2& x : outline.outer) radius = std::max(radius, x.norm());
  std::array<Vec2, 3> star;  // equilateral, its inscribed circle holds the block
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = std::numbers::pi * (0.5 + 2.0 * static_cast<double>(k) / 3.0);
    star[k] = 2.0 * radius * Vec2(std::cos(angle), std::sin(angle));
  }
  Element e = make_element(star, outline, moments(outline).area);
  e.cover = {0, 1, 2};
  mesh.star.assign(star.begin(), star.end());
  mesh.elements.push_back(std::move(e));
  make_boundary(outline, nullptr, {}, mesh);
  return mesh;
}

CoverMesh make_cover_mesh(const Polygon& outline, double cover_size) {
  SCREE_ASSERT(cover_size > 0.0);
  // Off the centre by no round fraction, so that edges of regular blocks seldom run along mesh lines.
  const Lattice lattice(cover_size, cover_size * Vec2(-0.317, -0.271));
  CoverMesh mesh;
  const std::vector<Piece> pieces = cut_elements(outline, lattice, mesh);
  number_covers(pieces, lattice, mesh);
  if (!tie_covers(mesh)) return make_onefold(outline);
  make_boundary(outline, &lattice, pieces, mesh);
  return mesh;
}

}  // namespace scree::nmm
