#include <algorithm>
#include <cmath>
#include <numeric>

#include "nmm/lattice_cut.h"

namespace scree::nmm {
namespace {

class UnionFind {
 public:
  explicit UnionFind(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::int32_t{0}); }
  std::int32_t find(std::int32_t a) {
    while (at(a) != a) a = at(a) = at(at(a));
    return a;
  }
  void join(std::int32_t a, std::int32_t b) {
    a = find(a);
    b = find(b);
    if (a != b) at(std::max(a, b)) = std::min(a, b);
  }

 private:
  std::int32_t& at(std::int32_t a) { return parent_[static_cast<std::size_t>(a)]; }
  std::vector<std::int32_t> parent_;
};

constexpr double kTolerance = 1e-9;  // fraction of a mesh edge

/// A part of a line, from and to as fractions of a mesh edge.
struct Stretch {
  double from, to;
};

/// Appends the part of a -> b along p -> p + d, if a -> b lies on that edge.
void add_stretch(const Vec2& p, const Vec2& d, const Vec2& a, const Vec2& b, std::vector<Stretch>& out) {
  const double length2 = d.squaredNorm();
  const Vec2 u = a - p, w = b - p;
  if (std::abs(cross(d, u)) > kTolerance * length2 || std::abs(cross(d, w)) > kTolerance * length2) return;
  const double s = std::clamp(u.dot(d) / length2, 0.0, 1.0), e = std::clamp(w.dot(d) / length2, 0.0, 1.0);
  if (std::abs(e - s) > kTolerance) out.push_back({std::min(s, e), std::max(s, e)});
}

std::vector<Stretch> along(const CoverMesh& mesh, std::size_t element, const Vec2& p, const Vec2& d) {
  if (mesh.piece[element] < 0) return {{0.0, 1.0}};
  std::vector<Stretch> out;
  const Polygon& piece = mesh.pieces[static_cast<std::size_t>(mesh.piece[element])];
  for (std::size_t r = 0; r < piece.rings(); ++r)
    for (std::size_t m = 0; m < piece.ring(r).size(); ++m)
      add_stretch(p, d, piece.ring(r)[m], piece.ring(r)[(m + 1) % piece.ring(r).size()], out);
  return out;
}

/// True if two pieces share a length of the edge that is not on a crack.
bool share_length(const std::vector<Stretch>& a, const std::vector<Stretch>& b, const std::vector<Stretch>& cracks) {
  for (const Stretch& s : a)
    for (const Stretch& t : b) {
      double from = std::max(s.from, t.from);
      const double to = std::min(s.to, t.to);
      for (const Stretch& c : cracks) {  // sorted
        if (c.from - from > kTolerance) break;
        from = std::max(from, c.to);
      }
      if (to - from > kTolerance) return true;
    }
  return false;
}

/// Finds the halves of the components, and the pairs of covers, one of each half, that would be one cover of the
/// undivided block.
void find_interface_constraints(UnionFind& undivided, std::span<const char> is_explicit, CoverMesh& mesh) {
  mesh.explicit_part.assign(static_cast<std::size_t>(mesh.components), 0);
  struct Corner {
    std::int32_t root, cover;
    bool is_explicit;
    auto operator<=>(const Corner&) const = default;
  };
  std::vector<Corner> corners;
  for (std::size_t e = 0; e < mesh.elements(); ++e)
    for (std::size_t c = 0; c < 3; ++c) {
      const std::int32_t cover = mesh.cover[e][c];
      corners.push_back({undivided.find(static_cast<std::int32_t>(3 * e + c)), cover, is_explicit[e] != 0});
      if (is_explicit[e] != 0)
        mesh.explicit_part[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(cover)])] = 1;
    }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  for (auto begin = corners.begin(), end = begin; begin != corners.end(); begin = end) {
    end = std::find_if(begin, corners.end(), [&](const Corner& c) { return c.root != begin->root; });
    const auto first = [&](bool half) {
      return std::find_if(begin, end, [&](const Corner& c) { return c.is_explicit == half; });
    };
    const auto e = first(true), i = first(false);
    if (e == end || i == end) continue;
    // Just enough interface constraints to connect all of these covers.
    for (auto c = begin; c != end; ++c)
      if (!c->is_explicit)
        mesh.interface_constraints.push_back({e->cover, c->cover});
      else if (c != e)
        mesh.interface_constraints.push_back({c->cover, i->cover});
  }
}

/// Calls join(a, b, node) for every pair of elements that share a part of an inner edge which no crack covers, with
/// each of the edge's two lattice nodes.
template <class Join>
void for_joined(const LatticePieces& pieces, std::span<const CutLine> cracks, const CoverMesh& mesh, Join&& join) {
  std::vector<Stretch> on_crack;
  // Every inner edge once: each triangle that points up has three neighbours that point down.
  for (std::size_t k = 0; k < mesh.elements(); ++k) {
    const LatticeTriangle& t = pieces.triangle[k];
    if (t.down != 0) continue;
    const auto nodes = Lattice::corners(t);
    const std::array<LatticeTriangle, 3> neighbour{
        {{t.j - 1, t.i, 1}, {t.j, t.i, 1}, {t.j, t.i - 1, 1}}};  // across the edges 0-1, 1-2, 2-0
    const auto a = static_cast<std::int32_t>(k);
    for (std::size_t side = 0; side < 3; ++side) {
      const LatticeNode &n0 = nodes[side], &n1 = nodes[(side + 1) % 3];
      const auto [first, last] = pieces.elements(neighbour[side]);
      if (first == last) continue;
      const bool cracked = pieces.cracked[pieces.index(t)] != 0 || pieces.cracked[pieces.index(neighbour[side])] != 0;
      const bool whole =
          !cracked && last - first == 1 && mesh.piece[k] < 0 && mesh.piece[static_cast<std::size_t>(first)] < 0;
      const Vec2 p = pieces.lattice.position(n0), d = pieces.lattice.position(n1) - p;
      on_crack.clear();
      if (cracked) {
        for (const CutLine& c : cracks) add_stretch(p, d, c.from, c.to, on_crack);
        std::sort(on_crack.begin(), on_crack.end(), [](const Stretch& s, const Stretch& u) { return s.from < u.from; });
      }
      const std::vector<Stretch> mine = whole ? std::vector<Stretch>{} : along(mesh, k, p, d);
      for (std::int32_t b = first; b < last; ++b)
        if (whole || share_length(mine, along(mesh, static_cast<std::size_t>(b), p, d), on_crack)) {
          join(a, b, n0);
          join(a, b, n1);
        }
    }
  }
}

}  // namespace

void number_covers(const LatticePieces& pieces, std::span<const CutLine> cracks, std::span<const char> is_explicit,
                   CoverMesh& mesh) {
  const std::size_t count = mesh.elements();
  UnionFind slots(3 * count);  // an element's corner starts as a cover of its own
  UnionFind undivided(is_explicit.empty() ? 0 : 3 * count);
  for_joined(pieces, cracks, mesh, [&](std::int32_t a, std::int32_t b, const LatticeNode& n) {
    const auto slot = [&](std::int32_t e) {
      const auto nodes = Lattice::corners(pieces.triangle[static_cast<std::size_t>(e)]);
      return 3 * e + static_cast<std::int32_t>(std::find(nodes.begin(), nodes.end(), n) - nodes.begin());
    };
    if (is_explicit.empty() || is_explicit[static_cast<std::size_t>(a)] == is_explicit[static_cast<std::size_t>(b)])
      slots.join(slot(a), slot(b));
    if (!is_explicit.empty()) undivided.join(slot(a), slot(b));
  });

  // Covers are numbered by lattice row, then along it; several covers of one star by their first element.
  struct Cover {
    LatticeNode node;
    std::int32_t root;
  };
  std::vector<Cover> covers;
  for (std::size_t e = 0; e < count; ++e) {
    const auto nodes = Lattice::corners(pieces.triangle[e]);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto slot = static_cast<std::int32_t>(3 * e + c);
      if (slots.find(slot) == slot) covers.push_back({nodes[c], slot});
    }
  }
  const auto in_order = [](const Cover& a, const Cover& b) {
    return std::tuple(a.node.j, a.node.i, a.root) < std::tuple(b.node.j, b.node.i, b.root);
  };
  std::sort(covers.begin(), covers.end(), in_order);
  std::vector<std::int32_t> number(3 * count, -1);
  mesh.star.clear();
  for (const Cover& c : covers) {
    number[static_cast<std::size_t>(c.root)] = static_cast<std::int32_t>(mesh.star.size());
    mesh.star.push_back(pieces.lattice.position(c.node));
  }
  mesh.cover.resize(count);
  UnionFind parts(covers.size());
  for (std::size_t e = 0; e < count; ++e) {
    for (std::size_t c = 0; c < 3; ++c)
      mesh.cover[e][c] = number[static_cast<std::size_t>(slots.find(static_cast<std::int32_t>(3 * e + c)))];
    parts.join(mesh.cover[e][0], mesh.cover[e][1]);
    parts.join(mesh.cover[e][0], mesh.cover[e][2]);
  }
  mesh.component.assign(covers.size(), -1);
  mesh.components = 0;
  for (std::size_t c = 0; c < covers.size(); ++c) {
    const auto root = static_cast<std::size_t>(parts.find(static_cast<std::int32_t>(c)));
    if (mesh.component[root] < 0) mesh.component[root] = mesh.components++;
    mesh.component[c] = mesh.component[root];
  }
  if (is_explicit.empty()) return;
  find_interface_constraints(undivided, is_explicit, mesh);
  // The covers of the undivided block are numbered in the same order.
  std::vector<Cover> one;
  for (std::size_t e = 0; e < count; ++e) {
    const auto nodes = Lattice::corners(pieces.triangle[e]);
    for (std::size_t c = 0; c < 3; ++c)
      if (const auto slot = static_cast<std::int32_t>(3 * e + c); undivided.find(slot) == slot)
        one.push_back({nodes[c], slot});
  }
  std::sort(one.begin(), one.end(), in_order);
  std::vector<std::int32_t> rank(3 * count, -1);
  for (std::size_t k = 0; k < one.size(); ++k)
    rank[static_cast<std::size_t>(one[k].root)] = static_cast<std::int32_t>(k);
  mesh.undivided.assign(covers.size(), -1);
  for (std::size_t e = 0; e < count; ++e)
    for (std::size_t c = 0; c < 3; ++c)
      mesh.undivided[static_cast<std::size_t>(mesh.cover[e][c])] =
          rank[static_cast<std::size_t>(undivided.find(static_cast<std::int32_t>(3 * e + c)))];
}

}  // namespace scree::nmm
