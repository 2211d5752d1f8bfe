#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "nmm/lattice_cut.h"

namespace scree::nmm {
namespace {

constexpr double kRootFraction = 0.5;  // least step 0.69 of the uncut mesh's on 1000 placements: small_cuts_test.cpp

/// Elements of each cover.
struct Stars {
  std::vector<std::int32_t> first, element;
  explicit Stars(const CoverMesh& mesh) : first(mesh.star.size() + 1, 0), element(3 * mesh.elements()) {
    for (const auto& covers : mesh.cover)
      for (const std::int32_t c : covers) ++first[static_cast<std::size_t>(c) + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    std::vector<std::int32_t> next(first.begin(), first.end() - 1);
    for (std::size_t e = 0; e < mesh.elements(); ++e)
      for (const std::int32_t c : mesh.cover[e])
        element[static_cast<std::size_t>(next[static_cast<std::size_t>(c)]++)] = static_cast<std::int32_t>(e);
  }
  [[nodiscard]] std::span<const std::int32_t> of(std::int32_t cover) const {
    const auto begin = static_cast<std::size_t>(first[static_cast<std::size_t>(cover)]),
               end = static_cast<std::size_t>(first[static_cast<std::size_t>(cover) + 1]);
    return std::span(element).subspan(begin, end - begin);
  }
};

/// Gives each part of the block without a root element a onefold cover in place of its covers.
void make_parts_onefold(const std::vector<char>& rooted, CoverMesh& mesh) {
  std::vector<std::vector<Vec2>> points(rooted.size());
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const auto part = static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(mesh.cover[e][0])]);
    if (rooted[part] != 0) continue;
    const Polygon material = mesh.material(e);
    points[part].insert(points[part].end(), material.outer.begin(), material.outer.end());
  }
  // The covers of other parts keep their order; those of onefold parts are last.
  std::vector<std::int32_t> number(mesh.star.size(), -1);
  std::vector<Vec2> star;
  std::vector<std::int32_t> component, first(rooted.size(), -1), shape(rooted.size(), -1);
  for (std::size_t c = 0; c < mesh.star.size(); ++c) {
    if (rooted[static_cast<std::size_t>(mesh.component[c])] == 0) continue;
    number[c] = static_cast<std::int32_t>(star.size());
    star.push_back(mesh.star[c]);
    component.push_back(mesh.component[c]);
  }
  for (std::size_t part = 0; part < rooted.size(); ++part) {
    if (rooted[part] != 0) continue;
    first[part] = static_cast<std::int32_t>(star.size());
    shape[part] = static_cast<std::int32_t>(mesh.shapes.size());
    const std::array<Vec2, 3> triangle = onefold_triangle(points[part]);
    star.insert(star.end(), triangle.begin(), triangle.end());
    component.insert(component.end(), 3, static_cast<std::int32_t>(part));
    mesh.shapes.push_back(gradients_of(triangle));
    mesh.triangle_areas.push_back(0.5 * cross(triangle[1] - triangle[0], triangle[2] - triangle[0]));
  }
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    auto& covers = mesh.cover[e];
    const auto part = static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(covers[0])]);
    if (rooted[part] != 0) {
      for (std::int32_t& c : covers) c = number[static_cast<std::size_t>(c)];
      continue;
    }
    if (mesh.piece[e] < 0) {  // its triangle is now that of the onefold cover
      mesh.piece[e] = static_cast<std::int32_t>(mesh.pieces.size());
      mesh.pieces.push_back(mesh.material(e));
    }
    covers = {first[part], first[part] + 1, first[part] + 2};
    mesh.shape[e] = static_cast<std::uint16_t>(shape[part]);
  }
  mesh.star = std::move(star);
  mesh.component = std::move(component);
  mesh.onefold = mesh.components == 1;
}

}  // namespace

std::array<Vec2, 3> onefold_triangle(std::span<const Vec2> points) {
  Vec2 lo = points[0], hi = points[0];
  for (const Vec2& x : points) {
    lo = lo.cwiseMin(x);
    hi = hi.cwiseMax(x);
  }
  const Vec2 middle = 0.5 * (lo + hi);
  double radius = 0.0;
  for (const Vec2& x : points) radius = std::max(radius, (x - middle).norm());
  std::array<Vec2, 3> star;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = std::numbers::pi * (0.5 + 2.0 * static_cast<double>(k) / 3.0);
    star[k] = middle + 2.0 * radius * Vec2(std::cos(angle), std::sin(angle));
  }
  return star;
}

void tie_covers(CoverMesh& mesh) {
  std::vector<char> good(mesh.star.size(), 0), rooted(static_cast<std::size_t>(mesh.components), 0);
  for (std::size_t e = 0; e < mesh.elements(); ++e)
    if (mesh.fraction(e) >= kRootFraction)
      for (const std::int32_t c : mesh.cover[e]) {
        good[static_cast<std::size_t>(c)] = 1;
        rooted[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(c)])] = 1;
      }
  const Stars stars(mesh);
  std::vector<std::int32_t> seen(mesh.elements(), -1), front, next;
  for (std::size_t c = 0; c < mesh.star.size(); ++c) {
    if (good[c] != 0 || rooted[static_cast<std::size_t>(mesh.component[c])] == 0) continue;
    const auto mark = static_cast<std::int32_t>(c);
    const auto around = stars.of(mark);
    front.assign(around.begin(), around.end());
    for (const std::int32_t e : front) seen[static_cast<std::size_t>(e)] = mark;
    std::int32_t root = -1;
    double distance = std::numeric_limits<double>::infinity();
    while (root < 0) {
      next.clear();
      for (const std::int32_t e : front) {
        const auto i = static_cast<std::size_t>(e);
        if (mesh.fraction(i) >= kRootFraction) {
          const auto star = mesh.stars(i);
          const Vec2 middle = (star[0] + star[1] + star[2]) / 3.0;
          if (const double d = (middle - mesh.star[c]).squaredNorm(); d < distance) {
            distance = d;
            root = e;
          }
        }
        for (const std::int32_t k : mesh.cover[i])
          for (const std::int32_t n : stars.of(k))
            if (seen[static_cast<std::size_t>(n)] != mark) {
              seen[static_cast<std::size_t>(n)] = mark;
              next.push_back(n);
            }
      }
      std::swap(front, next);
    }
    const auto r = static_cast<std::size_t>(root);
    mesh.ties.push_back({mark, mesh.cover[r], mesh.weights(r, mesh.star[c])});
  }
  if (std::find(rooted.begin(), rooted.end(), 0) == rooted.end()) return;
  // The covers of onefold parts are numbered last, so that the numbers in ties only shift.
  std::vector<std::int32_t> shift(mesh.star.size());
  std::int32_t kept = 0;
  for (std::size_t c = 0; c < mesh.star.size(); ++c)
    shift[c] = rooted[static_cast<std::size_t>(mesh.component[c])] != 0 ? kept++ : -1;
  for (Tie& t : mesh.ties) {
    t.cover = shift[static_cast<std::size_t>(t.cover)];
    for (std::int32_t& root : t.root) root = shift[static_cast<std::size_t>(root)];
  }
  make_parts_onefold(rooted, mesh);
}

void loosen_ties(CoverMesh& mesh) {
  constexpr double kLeast = 1e-2;  // of its own mass that a root must keep
  std::vector<double> own(mesh.star.size(), 0.0), all;
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    const std::array<double, 3> w = mesh.weights(e, mesh.centroid(e));
    for (std::size_t k = 0; k < 3; ++k) own[static_cast<std::size_t>(mesh.cover[e][k])] += mesh.area[e] * w[k];
  }
  for (bool loosened = true; loosened;) {
    all = own;
    for (const Tie& t : mesh.ties)
      for (std::size_t k = 0; k < 3; ++k)
        all[static_cast<std::size_t>(t.root[k])] += t.w[k] * own[static_cast<std::size_t>(t.cover)];
    const auto taken = [&](const Tie& t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const auto root = static_cast<std::size_t>(t.root[k]);
        if (t.w[k] < 0.0 && all[root] < kLeast * own[root]) return true;
      }
      return false;
    };
    loosened = std::erase_if(mesh.ties, taken) > 0;
  }
}

}  // namespace scree::nmm
