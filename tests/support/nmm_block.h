// One block discretised by the NMM, and its dense or sparse operators, for tests that do not use the time schemes.
#pragma once

#include <Eigen/Dense>
#include <Eigen/SparseCholesky>
#include <string>
#include <vector>

#include "nmm/nmm_pool.h"

namespace scree::test {

/// Reference shape of a polygon about its centre of mass.
inline ReferenceShape shape_of(const Polygon& p, double density) {
  const Moments m = moments(p);
  ReferenceShape s;
  s.outline = transformed(p, -m.centroid, Mat2::Identity());
  s.origin = p;
  s.mass = density * m.area;
  s.area = m.area;
  s.second = density * m.second;
  return s;
}

struct NmmBlock {
  Model model;
  nmm::NmmPool pool;
  ReferenceShape shape;
  std::vector<double> q, v;  // at rest, in the block's place in the model

  NmmBlock(const Polygon& polygon, const Formulation& form, const Material& material, Plane plane = Plane::strain,
           std::vector<Crack> cracks = {}, std::vector<EdgeSupport> supports = {}) {
    model.plane = plane;
    model.materials.push_back(material);
    Block b;
    b.name = "block";
    b.polygon = polygon;
    b.material = MaterialId{0};
    model.blocks.push_back(b);
    model.cracks = std::move(cracks);
    model.edge_supports = std::move(supports);
    shape = shape_of(polygon, material.density);
    pool.add(model, {BlockId{0}, "nmm", shape, form});
    pool.finish();
    q.assign(2 * static_cast<std::size_t>(pool.first_node(1)), 0.0);
    v = q;
    AffineMotion m;
    m.c = moments(polygon).centroid;
    pool.place(0, m, q, v);
  }
  [[nodiscard]] const nmm::CoverMesh& mesh() const { return pool.mesh(0); }
  [[nodiscard]] Elasticity law() const { return model.elasticity_of(BlockId{0}); }
  [[nodiscard]] Vec2 centre() const { return moments(model.blocks[0].polygon).centroid; }

  /// Unknowns: two per free cover, in the order of the covers; -1 for tied covers.
  [[nodiscard]] std::vector<int> unknowns(int* count) const {
    std::vector<int> of(static_cast<std::size_t>(pool.first_node(1)), -1);
    *count = 0;
    for (std::int32_t c = 0; c < pool.first_node(1); ++c)
      if (!pool.chart().tied(c)) {
        of[static_cast<std::size_t>(c)] = *count;
        *count += 2;
      }
    return of;
  }
  /// Stiffness of small strains about rest on the free covers, from gradients and areas alone: A B^T C B, ties folded.
  [[nodiscard]] Eigen::SparseMatrix<double> stiffness() const {
    int n = 0;
    const std::vector<int> of = unknowns(&n);
    Eigen::Matrix3d C;
    const Elasticity l = law();
    C << l.p_modulus(), l.lambda, 0.0, l.lambda, l.p_modulus(), 0.0, 0.0, 0.0, l.mu;
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t e = 0; e < pool.elements().size(); ++e) {
      std::vector<std::pair<int, Vec2>> terms;
      for (std::size_t k = 0; k < 3; ++k)
        for (const nmm::Share& s : pool.chart().shares(pool.elements().cover(e)[k]))
          terms.emplace_back(of[static_cast<std::size_t>(s.cover)],
                             s.w * pool.elements().gradients(e).col(static_cast<int>(k)));
      for (const auto& [i, gi] : terms)
        for (const auto& [j, gj] : terms) {
          Eigen::Matrix<double, 3, 2> Bi, Bj;
          Bi << gi.x(), 0.0, 0.0, gi.y(), gi.y(), gi.x();
          Bj << gj.x(), 0.0, 0.0, gj.y(), gj.y(), gj.x();
          const Mat2 K = pool.elements().area(e) * Bi.transpose() * C * Bj;
          for (int a = 0; a < 2; ++a)
            for (int b = 0; b < 2; ++b) entries.emplace_back(i + a, j + b, K(a, b));
        }
    }
    Eigen::SparseMatrix<double> K(n, n);
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
  }
  /// Forces on covers folded to the unknowns: C^T f.
  [[nodiscard]] Eigen::VectorXd folded(const std::vector<double>& f) const {
    int n = 0;
    const std::vector<int> of = unknowns(&n);
    Eigen::VectorXd out = Eigen::VectorXd::Zero(n);
    for (std::int32_t c = 0; c < pool.first_node(1); ++c)
      for (const nmm::Share& s : pool.chart().shares(c))
        for (int d = 0; d < 2; ++d)
          out[of[static_cast<std::size_t>(s.cover)] + d] +=
              s.w * f[2 * static_cast<std::size_t>(c) + static_cast<std::size_t>(d)];
    return out;
  }
  /// Values on all covers from the unknowns: C u.
  [[nodiscard]] std::vector<double> spread(const Eigen::VectorXd& u) const {
    int n = 0;
    const std::vector<int> of = unknowns(&n);
    std::vector<double> out(q.size(), 0.0);
    for (std::int32_t c = 0; c < pool.first_node(1); ++c)
      for (const nmm::Share& s : pool.chart().shares(c))
        for (int d = 0; d < 2; ++d)
          out[2 * static_cast<std::size_t>(c) + static_cast<std::size_t>(d)] +=
              s.w * u[of[static_cast<std::size_t>(s.cover)] + d];
    return out;
  }
  /// f += integral of w t over the outline; t(x, n) in the frame of the model, by two Gauss points per segment.
  template <class Traction>
  void add_traction(Traction&& t, std::vector<double>& f) const {
    const Polygon& p = model.blocks[0].polygon;
    for (const Boundary::Segment& s : pool.boundary(0).segments) {
      const Ring& ring = p.ring(static_cast<std::size_t>(s.edge.ring));
      const Vec2 &A = ring[static_cast<std::size_t>(s.edge.edge)],
                 &B = ring[(static_cast<std::size_t>(s.edge.edge) + 1) % ring.size()];
      const Vec2 d = (s.s1 - s.s0) * (B - A), n = (-quarter_turn() * d).normalized();
      for (const double g : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
        const Vec2 x = A + s.s0 * (B - A) + g * d;
        const Row row = mesh().row(s.cell, x - centre());
        const Vec2 force = 0.5 * d.norm() * t(x, n);
        for (std::size_t k = 0; k < 3; ++k) {
          f[2 * static_cast<std::size_t>(row.node[k])] += row.w[k] * force.x();
          f[2 * static_cast<std::size_t>(row.node[k]) + 1] += row.w[k] * force.y();
        }
      }
    }
  }
  /// Sum of function(element, x, weight) over points that integrate quintics over each element's material.
  template <class Function>
  void integrate(Function&& function) const {
    // [Dunavant1985], degree 5, seven points.
    const double a1 = 0.059715871789770, b1 = 0.470142064105115, w1 = 0.132394152788506;
    const double a2 = 0.797426985353087, b2 = 0.101286507323456, w2 = 0.125939180544827, w0 = 0.225;
    const double points[7][4] = {{1.0 / 3, 1.0 / 3, 1.0 / 3, w0},
                                 {a1, b1, b1, w1},
                                 {b1, a1, b1, w1},
                                 {b1, b1, a1, w1},
                                 {a2, b2, b2, w2},
                                 {b2, a2, b2, w2},
                                 {b2, b2, a2, w2}};
    for (std::size_t e = 0; e < mesh().elements(); ++e)
      for (const Ring& r : triangulate(mesh().material(e))) {
        const double area = std::abs(signed_area(r));
        for (const auto& p : points) function(e, Vec2(p[0] * r[0] + p[1] * r[1] + p[2] * r[2] + centre()), p[3] * area);
      }
  }
};

/// A x = b for a singular stiffness: rigid motions are fixed by orthogonality to them.
inline Eigen::VectorXd solve_free(const NmmBlock& block, const Eigen::VectorXd& b) {
  const Eigen::SparseMatrix<double> K = block.stiffness();
  const auto n = static_cast<int>(K.rows());
  // Rigid modes as extra rows and columns make the matrix regular: [K sR; sR^T 0].
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < n; ++j)
    for (Eigen::SparseMatrix<double>::InnerIterator it(K, j); it; ++it) entries.emplace_back(it.row(), j, it.value());
  int unused = 0;
  const std::vector<int> of = block.unknowns(&unused);
  const double scale = K.diagonal().maxCoeff();
  for (std::size_t c = 0; c < of.size(); ++c) {
    if (of[c] < 0) continue;
    const Vec2 X = block.mesh().star[c];
    const double modes[3][2] = {{1.0, 0.0}, {0.0, 1.0}, {-X.y(), X.x()}};
    for (int m = 0; m < 3; ++m)
      for (int d = 0; d < 2; ++d) {
        entries.emplace_back(n + m, of[c] + d, scale * modes[m][d]);
        entries.emplace_back(of[c] + d, n + m, scale * modes[m][d]);
      }
  }
  Eigen::SparseMatrix<double> A(n + 3, n + 3);
  A.setFromTriplets(entries.begin(), entries.end());
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(A);
  Eigen::VectorXd rhs = Eigen::VectorXd::Zero(n + 3);
  rhs.head(n) = b;
  return solver.solve(rhs).head(n);
}

}  // namespace scree::test
