#include "nmm/cover_mesh.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/check.h"
#include "nmm/lattice_cut.h"

namespace scree::nmm {

Gradients gradients_of(const std::array<Vec2, 3>& star) {
  const double twice = cross(star[1] - star[0], star[2] - star[0]);
  Gradients g;
  for (int k = 0; k < 3; ++k) {
    const Vec2 &a = star[std::size_t(k + 1) % 3], &b = star[std::size_t(k + 2) % 3];
    g.col(k) << (a.y() - b.y()) / twice, (b.x() - a.x()) / twice;
  }
  return g;
}

std::array<Vec2, 3> CoverMesh::stars(std::size_t e) const {
  const auto& c = cover[e];
  return {star[static_cast<std::size_t>(c[0])], star[static_cast<std::size_t>(c[1])],
          star[static_cast<std::size_t>(c[2])]};
}

Polygon CoverMesh::material(std::size_t e) const {
  if (piece[e] >= 0) return pieces[static_cast<std::size_t>(piece[e])];
  const auto s = stars(e);
  return {{s.begin(), s.end()}, {}};
}

Vec2 CoverMesh::centroid(std::size_t e) const {
  if (piece[e] >= 0) return moments(pieces[static_cast<std::size_t>(piece[e])]).centroid;
  const auto s = stars(e);
  return (s[0] + s[1] + s[2]) / 3.0;
}

std::array<double, 3> CoverMesh::weights(std::size_t e, const Vec2& X) const {
  const auto s = stars(e);
  const double twice = cross(s[1] - s[0], s[2] - s[0]);
  const double w1 = cross(X - s[0], s[2] - s[0]) / twice;
  const double w2 = cross(s[1] - s[0], X - s[0]) / twice;
  return {1.0 - w1 - w2, w1, w2};
}

std::int32_t CoverMesh::locate(const Vec2& X) const {
  std::int32_t best = 0;
  double distance = std::numeric_limits<double>::infinity();
  for (std::size_t e = 0; e < elements(); ++e) {
    if (piece[e] < 0) {
      const auto w = weights(e, X);
      if (*std::min_element(w.begin(), w.end()) >= 0.0) return static_cast<std::int32_t>(e);
    } else if (contains(pieces[static_cast<std::size_t>(piece[e])], X)) {
      return static_cast<std::int32_t>(e);
    }
    const double d = (centroid(e) - X).squaredNorm();
    if (d < distance) {
      distance = d;
      best = static_cast<std::int32_t>(e);
    }
  }
  return best;
}

Row CoverMesh::row(std::int32_t element, const Vec2& X) const {
  const auto e = static_cast<std::size_t>(element);
  return {cover[e], weights(e, X)};
}

bool same_place(const Row& a, const Row& b) {
  for (std::size_t k = 0; k < 3; ++k) {
    double difference = a.w[k];
    for (std::size_t m = 0; m < 3; ++m)
      if (b.node[m] == a.node[k]) difference -= b.w[m];
    if (std::abs(difference) > 1e-6) return false;
  }
  return true;
}

CoverMesh make_onefold(const Polygon& outline) { return make_onefold(outline, onefold_triangle(outline.outer)); }

CoverMesh make_onefold(const Polygon& outline, const std::array<Vec2, 3>& star) {
  CoverMesh mesh;
  mesh.onefold = true;
  mesh.star.assign(star.begin(), star.end());
  mesh.component = {0, 0, 0};
  mesh.components = 1;
  mesh.cover = {{0, 1, 2}};
  mesh.shape = {0};
  mesh.area = {moments(outline).area};
  mesh.piece = {0};
  mesh.shapes = {gradients_of(star)};
  mesh.triangle_areas = {0.5 * cross(star[1] - star[0], star[2] - star[0])};
  mesh.pieces = {outline};
  make_boundary(outline, nullptr, {}, mesh);
  return mesh;
}

namespace {

/// Centroid of an element whose covers are not numbered yet.
Vec2 centroid_of(const CoverMesh& mesh, const LatticePieces& pieces, std::size_t e) {
  if (mesh.piece[e] >= 0) return moments(mesh.pieces[static_cast<std::size_t>(mesh.piece[e])]).centroid;
  Vec2 sum = Vec2::Zero();
  for (const LatticeNode& n : Lattice::corners(pieces.triangle[e])) sum += pieces.lattice.position(n);
  return sum / 3.0;
}

}  // namespace

double CoverMesh::drawn_area() const {
  double sum = 0.0;
  for (const double a : area) sum += a;
  return sum + area_left_out;
}

CoverMesh half_of(const CoverMesh& mesh, bool explicit_half) {
  const auto in_half = [&](std::int32_t c) {
    return (mesh.explicit_part[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(c)])] != 0) ==
           explicit_half;
  };
  CoverMesh out = mesh;
  std::size_t kept = 0;
  std::vector<std::int32_t> number(mesh.elements(), -1);
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    if (mesh.in_explicit_half(e) != explicit_half) {
      out.area_left_out += mesh.area[e];
      continue;
    }
    number[e] = static_cast<std::int32_t>(kept);
    out.cover[kept] = mesh.cover[e];
    out.shape[kept] = mesh.shape[e];
    out.area[kept] = mesh.area[e];
    out.piece[kept] = mesh.piece[e];
    ++kept;
  }
  out.cover.resize(kept);
  out.shape.resize(kept);
  out.area.resize(kept);
  out.piece.resize(kept);
  std::erase_if(out.ties, [&](const Tie& t) { return !in_half(t.cover); });
  for (Boundary::Segment& s : out.boundary.segments)
    if (s.cell >= 0) s.cell = number[static_cast<std::size_t>(s.cell)];
  return out;
}

CoverMesh make_cover_mesh(const Polygon& outline, double cover_size, const Vec2& offset,
                          std::span<const CutLine> cracks, const std::function<bool(const Vec2&)>& explicit_at) {
  SCREE_ASSERT(cover_size > 0.0);
  const Lattice lattice(cover_size, -cover_size * offset);
  CoverMesh mesh;
  const LatticePieces pieces = cut_lattice(outline, cracks, lattice, mesh);
  if (mesh.elements() == 0) return make_onefold(outline);  // no element in the lattice
  std::vector<char> is_explicit;
  if (explicit_at)
    for (std::size_t e = 0; e < mesh.elements(); ++e)
      is_explicit.push_back(explicit_at(centroid_of(mesh, pieces, e)) ? 1 : 0);
  number_covers(pieces, cracks, is_explicit, mesh);
  for (const CutLine& c : cracks) mesh.trimmed_length += (c.to - c.from).norm();
  mesh.trimmed_length = std::max(0.0, mesh.trimmed_length - mesh.crack_length);
  tie_covers(mesh);
  if (!cracks.empty()) loosen_ties(mesh);
  if (mesh.onefold) return make_onefold(outline);
  make_boundary(outline, &pieces, cracks, mesh);
  make_crack_faces(outline, pieces, cracks, mesh);
  return mesh;
}

}  // namespace scree::nmm
