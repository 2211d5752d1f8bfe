// Output of manifold blocks: cells, their stresses, and stresses recovered from these.
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <map>

#include "model/planar.h"
#include "nmm/nmm_pool.h"

namespace scree::nmm {
namespace {

Mat2 cauchy_stress(const ElementForces& elements, std::size_t e, std::span<const double> q) {
  Mat2 P = elements.response(e, q).P;
  if (elements.law(e).kinematics == Kinematics::linear) return P;
  const Mat2 F = elements.gradient(e, q);
  return P * F.transpose() / F.determinant();
}

}  // namespace

void NmmPool::topology(MeshPart& mesh) const {
  mesh.offsets.assign(1, 0);
  std::vector<std::int32_t> point_of;  // per cover: the mesh point at its star, if whole triangles have it
  for (int b = 0; b < bodies(); ++b) {
    const Body& body = of(b);
    // The affine map from the reference shape to the block's initial position in the model.
    const AffineMotion origin = affine_fit(body.shape.outline, body.shape.origin);
    const Box box = bounds(body.shape.outline);
    const double grid = 1e-8 * (box.hi - box.lo).maxCoeff();
    std::map<std::pair<std::int64_t, std::int64_t>, std::vector<std::int32_t>> known;  // corners of pieces
    point_of.assign(body.mesh.star.size(), -1);
    const auto add = [&](std::size_t e, const Vec2& X) {
      Row row = body.mesh.row(static_cast<std::int32_t>(e), X);
      for (std::int32_t& n : row.node) n += first_node(b);
      mesh.points.push_back(row);
      mesh.origin.push_back(origin.c + origin.F * X);
      return static_cast<std::int32_t>(mesh.points.size()) - 1;
    };
    const auto close_cell = [&](std::size_t e) {
      mesh.offsets.push_back(static_cast<std::int32_t>(mesh.connectivity.size()));
      mesh.body.push_back(b);
      mesh.explicit_half.push_back(body.mesh.in_explicit_half(e) ? 1 : 0);
    };
    const auto star_point = [&](std::size_t e, std::int32_t cover) {
      std::int32_t& point = point_of[static_cast<std::size_t>(cover)];
      if (point < 0) point = add(e, body.mesh.star[static_cast<std::size_t>(cover)]);
      return point;
    };
    for (std::size_t e = 0; e < body.mesh.elements(); ++e) {
      if (body.mesh.piece[e] < 0) {
        for (const std::int32_t c : body.mesh.cover[e]) mesh.connectivity.push_back(star_point(e, c));
        close_cell(e);
        continue;
      }
      for (const Ring& ring : drawing_cells(body.mesh.material(e))) {
        for (const Vec2& X : ring) {
          // A corner at a star is shared with whole triangles; other corners are shared between pieces of the same
          // covers, in which they move alike, and not across cracks.
          const auto w = body.mesh.weights(e, X);
          const auto most = std::max_element(w.begin(), w.end());
          if (*most > 1.0 - 1e-9) {
            mesh.connectivity.push_back(star_point(e, body.mesh.cover[e][static_cast<std::size_t>(most - w.begin())]));
            continue;
          }
          auto& here = known[{std::llround(X.x() / grid), std::llround(X.y() / grid)}];
          Row row = body.mesh.row(static_cast<std::int32_t>(e), X);
          for (std::int32_t& n : row.node) n += first_node(b);
          const auto same = std::find_if(here.begin(), here.end(), [&](std::int32_t p) {
            return same_place(mesh.points[static_cast<std::size_t>(p)], row);
          });
          if (same == here.end()) {
            here.push_back(add(e, X));
            mesh.connectivity.push_back(here.back());
          } else {
            mesh.connectivity.push_back(*same);
          }
        }
        close_cell(e);
      }
    }
  }
}

void NmmPool::stress(std::span<const double> q, std::span<double> cells) const {
  std::size_t cell = 0;
  for (int b = 0; b < bodies(); ++b)
    for (std::size_t e = 0; e < of(b).mesh.elements(); ++e) {
      const Mat2 cauchy = cauchy_stress(elements_, static_cast<std::size_t>(of(b).first_element) + e, q);
      const std::size_t drawn = of(b).mesh.piece[e] < 0 ? 1 : drawing_cells(of(b).mesh.material(e)).size();
      for (std::size_t k = 0; k < drawn; ++k, ++cell) {
        cells[3 * cell] = cauchy(0, 0);
        cells[3 * cell + 1] = cauchy(1, 1);
        cells[3 * cell + 2] = 0.5 * (cauchy(0, 1) + cauchy(1, 0));
      }
    }
}

void NmmPool::recovered_stress(std::span<const double> q, std::span<const char> wanted, std::span<double> nodes) const {
  // Normal equations of the plane s = a + b.(X - X_star)/h of each cover, over its elements' centroids.
  struct Fit {
    Eigen::Matrix3d A = Eigen::Matrix3d::Zero(), rhs = Eigen::Matrix3d::Zero();
  };
  std::vector<Fit> fit;
  std::vector<char> fits(wanted.begin(), wanted.end());  // per node; a tied one has the weighted sum of its roots
  for (const Tie& t : chart_.ties())
    if (wanted[static_cast<std::size_t>(t.cover)] != 0)
      for (const std::int32_t root : t.root) fits[static_cast<std::size_t>(root)] = 1;
  for (int b = 0; b < bodies(); ++b) {
    const CoverMesh& mesh = of(b).mesh;
    const std::span<const char> here =
        std::span(fits).subspan(static_cast<std::size_t>(first_node(b)), mesh.star.size());
    const auto is_fitted = [&](std::int32_t cover) { return here[static_cast<std::size_t>(cover)] != 0; };
    if (std::all_of(here.begin(), here.end(), [](char is) { return is == 0; })) continue;
    fit.assign(mesh.star.size(), {});
    for (std::size_t e = 0; e < mesh.elements(); ++e) {
      if (std::none_of(mesh.cover[e].begin(), mesh.cover[e].end(), is_fitted)) continue;
      const Mat2 s = cauchy_stress(elements_, static_cast<std::size_t>(of(b).first_element) + e, q);
      const Eigen::RowVector3d values(s(0, 0), s(1, 1), 0.5 * (s(0, 1) + s(1, 0)));
      const Vec2 centroid = mesh.centroid(e);
      const double size = std::sqrt(mesh.triangle_areas[mesh.shape[e]]), weight = mesh.area[e] / (size * size);
      for (const std::int32_t c : mesh.cover[e]) {
        const Vec2 arm = (centroid - mesh.star[static_cast<std::size_t>(c)]) / size;
        const Eigen::Vector3d p(1.0, arm.x(), arm.y());
        fit[static_cast<std::size_t>(c)].A += weight * p * p.transpose();
        fit[static_cast<std::size_t>(c)].rhs += weight * p * values;
      }
    }
    for (std::size_t c = 0; c < mesh.star.size(); ++c) {
      if (here[c] == 0) continue;
      const Fit& f = fit[c];
      Eigen::RowVector3d value = f.rhs.row(0) / f.A(0, 0);  // the mean, if too few elements define no plane
      const Eigen::LDLT<Eigen::Matrix3d> solver(f.A);
      if (solver.info() == Eigen::Success && solver.vectorD().minCoeff() > 1e-3 * f.A(0, 0))
        value = solver.solve(f.rhs).row(0);
      const std::size_t i = 3 * (static_cast<std::size_t>(first_node(b)) + c);
      for (std::size_t d = 0; d < 3; ++d) nodes[i + d] = value[static_cast<Eigen::Index>(d)];
    }
  }
  for (const Tie& t : chart_.ties())
    for (std::size_t d = 0; d < 3 && wanted[static_cast<std::size_t>(t.cover)] != 0; ++d) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) sum += t.w[k] * nodes[3 * static_cast<std::size_t>(t.root[k]) + d];
      nodes[3 * static_cast<std::size_t>(t.cover) + d] = sum;
    }
}

}  // namespace scree::nmm
