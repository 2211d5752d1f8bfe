// The consistent mass and the implicit form of one block.
#include "nmm/consistent_mass.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

#include "tests/unit/nmm/one_block.h"

namespace scree::nmm::consistent_mass_test {
namespace {

/// A block whose outline cuts the mesh so that covers are tied.
struct ConsistentBlock {
  Model model;
  NmmPool pool;
  ReferenceShape shape;
  std::size_t size = 0;
  explicit ConsistentBlock(double stretch = 1.0, Kinematics kinematics = Kinematics::corotational) {
    model.materials.push_back(rock());
    Block b;
    b.polygon = quadrilateral();
    b.material = MaterialId{0};
    model.blocks.push_back(b);
    shape = test::shape_of(b.polygon, 2.0);
    shape.second *= stretch;
    pool.add(model,
             {BlockId{0}, "nmm", shape, {.kinematics = kinematics, .mass = MassKind::consistent, .cover_size = 0.27}});
    pool.finish();
    size = 2 * static_cast<std::size_t>(pool.first_node(1));
  }
  [[nodiscard]] std::vector<double> affine(const Vec2& c, const Mat2& G) const {
    std::vector<double> q(size), v(size);
    pool.place(0, {.vc = c, .Fdot = G}, q, v);
    return v;
  }
};

TEST(ConsistentMass, affine_part_is_the_blocks_to_round_off) {
  for (const double stretch : {1.0, 1.001}) {  // 1.001: moments that differ from those of the outline
    const ConsistentBlock b(stretch);
    ASSERT_GT(b.pool.mesh(0).ties.size(), 3U);
    const std::vector<char> counted{1};
    const std::vector<double> q = b.affine({0, 0}, Mat2::Identity());
    const Vec2 c(0.3, -0.7);
    const Mat2 G = (Mat2() << 0.2, -0.4, 0.9, 0.1).finished();
    const double exact = 0.5 * b.shape.mass * c.squaredNorm() + 0.5 * (G * b.shape.second * G.transpose()).trace();
    EXPECT_NEAR(b.pool.kinetic_energy(q, b.affine(c, G), counted) / exact, 1.0, 1e-12);
    const BodyTotals t = b.pool.totals(0, q, b.affine({0, 0}, quarter_turn()));
    EXPECT_NEAR(t.mass / b.shape.mass, 1.0, 1e-12);
    EXPECT_LT(t.momentum.norm(), 1e-12 * b.shape.mass);
    EXPECT_LT(t.centre.norm(), 1e-12);
    EXPECT_NEAR(t.angular_momentum / b.shape.second.trace(), 1.0, 1e-12);
  }
}

TEST(ConsistentMass, solve_undoes_apply_and_ties_follow) {
  const ConsistentBlock b;
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  // A velocity field of the free covers; the mass solve sets the tied covers.
  std::vector<double> f(b.size), v(b.size), back(b.size);
  for (double& x : f) x = any(generator);
  b.pool.mass_solve(f, f, v);
  std::vector<double> gathered = f;
  b.pool.fold_forces(gathered);
  std::vector<double> p(b.size);
  std::vector<char> counted{1};
  b.pool.mass_solve(f, gathered, back);
  for (std::size_t i = 0; i < b.size; ++i) EXPECT_NEAR(v[i], back[i], 1e-12 * 1e3);
  double power = 0.0;
  for (std::size_t i = 0; i < b.size; ++i) power += gathered[i] * v[i];
  EXPECT_NEAR(b.pool.kinetic_energy(f, v, counted) / (0.5 * power), 1.0, 1e-12);
}

/// Dense stiffness from element matrices.
Eigen::MatrixXd dense(const ElementDofs& dofs, const std::vector<double>& values, int n) {
  Eigen::MatrixXd K = Eigen::MatrixXd::Zero(n, n);
  std::size_t at = 0;
  for (std::size_t e = 0; e < dofs.size(); ++e)
    for (auto j = static_cast<std::size_t>(dofs.start[e]); j < static_cast<std::size_t>(dofs.start[e + 1]); ++j)
      for (std::size_t i = j; i < static_cast<std::size_t>(dofs.start[e + 1]); ++i, ++at) {
        K(dofs.dof[i], dofs.dof[j]) += values[at];
        if (i != j) K(dofs.dof[j], dofs.dof[i]) += values[at];
      }
  return K;
}

TEST(ImplicitBody, stiffness_is_the_derivative_of_the_force_through_the_chart) {
  for (const Kinematics kinematics : {Kinematics::corotational, Kinematics::linear}) {
    const ConsistentBlock b(1.0, kinematics);
    const int n = b.pool.dofs(0);
    const ElementDofs dofs = b.pool.element_dofs(0);
    std::vector<double> K(dofs.values()), f(static_cast<std::size_t>(n)), f1 = f, f0 = f;
    std::vector<double> q = b.affine({0.1, 0.2}, rotation(0.7) * (Mat2() << 1.05, 0.02, 0.03, 0.97).finished()), v = q;
    std::mt19937 generator(3);
    std::uniform_real_distribution<double> any(-0.01, 0.01);
    std::vector<double> d(static_cast<std::size_t>(n)), rate(d);
    for (double& x : d) x = any(generator);
    b.pool.retract(0, d, rate, q, v);
    const double U = b.pool.linearise(0, q, Stiffness::exact, K, f);
    const Eigen::MatrixXd matrix = dense(dofs, K, n);
    const double h = 1e-5;
    for (int k = 0; k < n; k += 7) {
      std::fill(d.begin(), d.end(), 0.0);
      d[static_cast<std::size_t>(k)] = h;
      std::vector<double> q1 = q, q0 = q;
      b.pool.retract(0, d, rate, q1, v);
      d[static_cast<std::size_t>(k)] = -h;
      b.pool.retract(0, d, rate, q0, v);
      const double U1 = b.pool.linearise(0, q1, Stiffness::exact, {}, f1),
                   U0 = b.pool.linearise(0, q0, Stiffness::exact, {}, f0);
      EXPECT_NEAR(f[static_cast<std::size_t>(k)], -(U1 - U0) / (2.0 * h), 1e-9);
      for (int i = 0; i < n; ++i)
        EXPECT_NEAR(matrix(i, k), -(f1[static_cast<std::size_t>(i)] - f0[static_cast<std::size_t>(i)]) / (2.0 * h),
                    1e-7);
    }
    // Reference: force and energy of the explicit loop, gathered over the ties.
    std::vector<double> nodes(b.size, 0.0), of_dofs(static_cast<std::size_t>(n));
    EXPECT_NEAR(b.pool.internal_force(q, nodes) / U, 1.0, 1e-12);
    b.pool.fold_forces(nodes);
    b.pool.rates(0, q, nodes, of_dofs);
    for (std::size_t i = 0; i < of_dofs.size(); ++i) EXPECT_NEAR(of_dofs[i], f[i], 1e-13);
  }
}

TEST(ImplicitBody, patch_of_constant_stress_has_force_on_the_outline_only) {
  // Uniform strain, for any cuts and ties: the resultant at every row of the outline equals that of the traction.
  const ConsistentBlock b(1.0, Kinematics::linear);
  const Mat2 F = (Mat2() << 1.001, 0.0005, 0.0005, 0.998).finished();
  std::vector<double> q = b.affine({0, 0}, F), f(static_cast<std::size_t>(b.pool.dofs(0)));
  (void)b.pool.linearise(0, q, Stiffness::exact, {}, f);
  const Elasticity law = b.model.elasticity_of(BlockId{0});
  const Mat2 sigma = law.stress(0.5 * (F + F.transpose()) - Mat2::Identity());
  std::vector<double> traction(b.size, 0.0), of_dofs(f.size());
  const Boundary& outline = b.pool.boundary(0);
  for (const Boundary::Segment& s : outline.segments) {
    const Row &a = outline.nodes[static_cast<std::size_t>(s.a)], &c = outline.nodes[static_cast<std::size_t>(s.b)];
    const std::vector<double> X = b.affine({0, 0}, Mat2::Identity());
    const auto at = [&](const Row& r) {
      Vec2 x = Vec2::Zero();
      for (std::size_t k = 0; k < 3; ++k) x += r.w[k] * node(X, r.node[k]);
      return x;
    };
    const Vec2 along = at(c) - at(a), force = 0.5 * (sigma * Vec2(along.y(), -along.x()));
    for (const Row& r : {a, c})
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t d = 0; d < 2; ++d)
          traction[2 * static_cast<std::size_t>(r.node[k]) + d] += r.w[k] * force[static_cast<Eigen::Index>(d)];
  }
  b.pool.fold_forces(traction);
  b.pool.rates(0, q, traction, of_dofs);
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f[i] + of_dofs[i], 0.0, 1e-12 * 1e-3);
}

}  // namespace
}  // namespace scree::nmm::consistent_mass_test
