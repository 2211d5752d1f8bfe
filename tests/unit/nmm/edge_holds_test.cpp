// Held edges: exact gradient and tangent, patch tests on random cuts, order of convergence, coercivity, step bound.
#include "nmm/edge_holds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/dense_algebra.h"
#include "model/random.h"
#include "tests/support/nmm_block.h"

namespace scree::nmm::edge_holds_test {
namespace {

using test::NmmBlock;

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

/// The square [0, a]^2 turned by an angle and moved; edge 0 is its bottom, 3 its left.
Polygon square(double a, double angle, const Vec2& by) {
  const Mat2 R = rotation(angle);
  return transformed({{{0.0, 0.0}, {a, 0.0}, {a, a}, {0.0, a}}, {}}, by, R);
}

EdgeSupport held(std::int32_t edge, const Mat2& directions) {
  return {{BlockId{0}, {0, edge}, 0.0, 1.0}, directions, std::nullopt};
}

Mat2 along(const Vec2& a) { return a * a.transpose(); }

Material stiff() { return {"rock", 2000.0, 4e9, 0.25, std::nullopt}; }

Formulation linear(double h) {
  Formulation f;
  f.cover_size = h;
  f.kinematics = Kinematics::linear;
  f.mass = MassKind::consistent;
  return f;
}

/// Stiffness and force of the pool on its unknowns, from linearise().
struct System {
  Eigen::MatrixXd K;
  Eigen::VectorXd f;
};
System system_of(const NmmBlock& b, Stiffness kind = Stiffness::exact) {
  const int n = b.pool.dofs(0);
  const ElementDofs dofs = b.pool.element_dofs(0);
  std::vector<double> lower(dofs.values()), force(static_cast<std::size_t>(n));
  (void)b.pool.linearise(0, b.q, kind, lower, force);
  System out{Eigen::MatrixXd::Zero(n, n), Eigen::Map<Eigen::VectorXd>(force.data(), n)};
  std::size_t at = 0;
  for (std::size_t e = 0; e < dofs.size(); ++e)
    for (auto j = static_cast<std::size_t>(dofs.start[e]); j < static_cast<std::size_t>(dofs.start[e + 1]); ++j)
      for (std::size_t i = j; i < static_cast<std::size_t>(dofs.start[e + 1]); ++i, ++at) {
        out.K(dofs.dof[i], dofs.dof[j]) += lower[at];
        if (dofs.dof[i] != dofs.dof[j]) out.K(dofs.dof[j], dofs.dof[i]) += lower[at];
      }
  return out;
}

/// Moves the block to equilibrium under nodal forces; linear kinematics.
void balance(NmmBlock& b, const std::vector<double>& load) {
  const System s = system_of(b);
  const Eigen::VectorXd f = s.f + b.folded(load);
  const Eigen::VectorXd u = solve_symmetric(s.K, f);
  const std::vector<double> move = b.spread(u);
  for (std::size_t i = 0; i < b.q.size(); ++i) b.q[i] += move[i];
}

TEST(EdgeHolds, force_is_the_gradient_of_the_energy_and_the_matrix_its_derivative) {
  Random random(3);
  for (const Kinematics kinematics : {Kinematics::linear, Kinematics::corotational}) {
    Formulation form = linear(0.4);
    form.kinematics = kinematics;
    Material rock = stiff();
    rock.initial_stress = InitialStress{(Mat2() << -3e6, 1e6, 1e6, -5e6).finished(), Mat2::Zero(), 0.0};
    NmmBlock b(square(1.0, 0.3, {0.02, 0.05}), form, rock, Plane::strain, {},
               {held(0, Mat2::Identity()), held(1, along({0.6, 0.8}))});
    std::vector<double> d(b.q.size(), 0.0);
    for (double& x : b.q) x += 1e-3 * between(random, -1.0, 1.0);
    b.pool.settle(0, b.q, d);
    std::vector<double> f(b.q.size(), 0.0), scratch(b.q.size());
    (void)b.pool.internal_force(b.q, f);
    for (std::size_t i = 0; i < b.q.size(); ++i) {
      std::vector<double> q = b.q;
      const double step = 1e-6;
      q[i] += step;
      const double up = b.pool.internal_force(q, scratch);
      q[i] -= 2.0 * step;
      const double down = b.pool.internal_force(q, scratch);
      EXPECT_NEAR(f[i], -(up - down) / (2.0 * step), 1e-6 * 4e9 * 1e-3) << i;
    }
    // Change along a random direction of the unknowns: K is exact for linear kinematics, else up to the strains.
    const System s = system_of(b);
    Eigen::VectorXd u = Eigen::VectorXd::Zero(s.K.rows());
    for (double& x : u) x = between(random, -1.0, 1.0);
    const double step = 1e-6;
    const std::vector<double> move = b.spread(u);
    NmmBlock moved = NmmBlock(square(1.0, 0.3, {0.02, 0.05}), form, rock, Plane::strain, {},
                              {held(0, Mat2::Identity()), held(1, along({0.6, 0.8}))});
    moved.q = b.q;
    for (std::size_t i = 0; i < move.size(); ++i) moved.q[i] += step * move[i];
    const Eigen::VectorXd change = (system_of(moved).f - s.f) / step;
    EXPECT_LT((change + s.K * u).norm(), (kinematics == Kinematics::linear ? 1e-6 : 0.03) * change.norm());
  }
}

TEST(EdgeHolds, energies_of_totals_and_of_forces_agree) {
  NmmBlock b(square(1.0, 0.3, {0.02, 0.05}), linear(0.4), stiff(), Plane::strain, {}, {held(0, Mat2::Identity())});
  for (std::size_t i = 0; i < b.q.size(); ++i) b.q[i] += 1e-4 * std::sin(double(i));
  std::vector<double> f(b.q.size(), 0.0);
  EXPECT_NEAR(b.pool.internal_force(b.q, f), b.pool.totals(0, b.q, b.v).elastic, 1e-9 * 4e9 * 1e-8);
}

TEST(EdgeHolds, patch_test_on_rollers_holds_on_any_cut) {
  // Constant stress s1, s2 along the sides of a rotated square with rollers at its bottom and its left.
  Random random(17);
  double worst = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    const double angle = between(random, 0.0, std::numbers::pi), h = between(random, 0.12, 0.45);
    const Mat2 R = rotation(angle);
    NmmBlock b(square(1.0, angle, {between(random, -1.0, 1.0), between(random, -1.0, 1.0)}), linear(h), stiff(),
               Plane::strain, {}, {held(0, along(R.col(1))), held(3, along(R.col(0)))});
    const Mat2 stress = R * (Mat2() << -7e6, 0.0, 0.0, 3e6).finished() * R.transpose();
    const Mat2 strain = b.law().strain(stress);
    std::vector<double> load(b.q.size(), 0.0);
    const auto q0 = b.q;
    b.add_traction(
        [&](const Vec2&, const Vec2& n) {
          const Vec2 local = R.transpose() * n;
          return local.x() + local.y() > 0.0 ? Vec2(stress * n) : Vec2(0.0, 0.0);
        },
        load);
    balance(b, load);
    const Vec2 corner = b.model.blocks[0].polygon.outer[0];
    for (std::int32_t c = 0; c < b.pool.first_node(1); ++c) {
      const Vec2 x = node(q0, c), exact = strain * (x - corner);
      worst = std::max(worst, (node(b.q, c) - x - exact).norm() / strain.norm());
    }
    for (std::size_t e = 0; e < b.pool.elements().size(); ++e)
      worst = std::max(worst, (b.pool.elements().response(e, b.q).P - stress).norm() / stress.norm());
    // The reaction at the bottom equals the traction of that stress.
    const Vec2 traction = b.pool.edge_reaction(0, 0, 0.37, b.q);
    worst = std::max(worst, (traction - stress * -R.col(1)).norm() / stress.norm());
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-10);
}

TEST(EdgeHolds, patch_test_with_all_edges_held_on_an_affine_field) {
  // Anchors moved by an affine displacement with shear and rotation: the field inside must be the same affine field.
  Random random(23);
  double worst = 0.0;
  for (int trial = 0; trial < 60; ++trial) {
    const double angle = between(random, 0.0, std::numbers::pi), h = between(random, 0.12, 0.45);
    std::vector<EdgeSupport> all;
    all.reserve(4);
    for (std::int32_t edge = 0; edge < 4; ++edge) all.push_back(held(edge, Mat2::Identity()));
    NmmBlock b(square(1.0, angle, {between(random, -1.0, 1.0), between(random, -1.0, 1.0)}), linear(h), stiff(),
               Plane::strain, {}, all);
    const Mat2 H = 1e-3 * (Mat2() << between(random, -1, 1), between(random, -1, 1), between(random, -1, 1),
                           between(random, -1, 1))
                              .finished();
    std::vector<double> shift;
    const Ring& ring = b.model.blocks[0].polygon.outer;
    for (std::size_t edge = 0; edge < 4; ++edge)
      for (const Vec2& x : {ring[edge], ring[(edge + 1) % 4]}) {
        const Vec2 u = H * x;
        shift.insert(shift.end(), {u.x(), u.y()});
      }
    b.pool.shift_edges(0, shift);
    const auto q0 = b.q;
    balance(b, std::vector<double>(b.q.size(), 0.0));
    for (std::int32_t c = 0; c < b.pool.first_node(1); ++c)
      worst = std::max(worst, (node(b.q, c) - node(q0, c) - H * node(q0, c)).norm() / H.norm());
  }
  RecordProperty("worst", std::to_string(worst));
  EXPECT_LT(worst, 1e-10);
}

TEST(EdgeHolds, matrix_is_positive_definite_wherever_the_mesh_cuts) {
  Random random(31);
  for (int trial = 0; trial < 150; ++trial) {
    const double angle = between(random, 0.0, std::numbers::pi), h = between(random, 0.15, 0.6);
    std::vector<EdgeSupport> all;
    all.reserve(4);
    for (std::int32_t edge = 0; edge < 4; ++edge) all.push_back(held(edge, Mat2::Identity()));
    NmmBlock b(square(1.0, angle, {between(random, -1.0, 1.0), between(random, -1.0, 1.0)}), linear(h), stiff(),
               Plane::strain, {}, all);
    if (b.mesh().onefold) continue;
    const Eigen::VectorXd eigen = symmetric_eigenvalues(system_of(b).K);
    EXPECT_GT(eigen[0], 1e-4 * 4e9) << angle << ' ' << h;  // coercive: of the order of E (h/a)^2, far from zero
  }
}

TEST(EdgeHolds, displacements_converge_with_order_two) {
  // u = (y sin(2 x + 1), y (1 + y) cos(1.5 x)) in the axes of a square that is clamped at y = 0.
  const double angle = 0.3, size = 1e-3;
  const Mat2 R = rotation(angle);
  const Vec2 by(0.013, 0.027);
  const auto local = [&](const Vec2& x) -> Vec2 { return R.transpose() * (x - by); };
  const auto u = [&](const Vec2& p) -> Vec2 {
    return size * Vec2(p.y() * std::sin(2.0 * p.x() + 1.0), p.y() * (1.0 + p.y()) * std::cos(1.5 * p.x()));
  };
  const auto gradient = [&](const Vec2& p) -> Mat2 {
    const double s = std::sin(2.0 * p.x() + 1.0), c = std::cos(2.0 * p.x() + 1.0), x15 = 1.5 * p.x();
    return size * (Mat2() << 2.0 * p.y() * c, s, -1.5 * p.y() * (1.0 + p.y()) * std::sin(x15),
                   (1.0 + 2.0 * p.y()) * std::cos(x15))
                      .finished();
  };
  std::vector<double> error, spacing{0.2, 0.1, 0.05};
  for (const double h : spacing) {
    NmmBlock b(square(1.0, angle, by), linear(h), stiff(), Plane::strain, {}, {held(0, Mat2::Identity())});
    const Elasticity law = b.law();
    const auto stress = [&](const Vec2& p) -> Mat2 {
      const Mat2 g = gradient(p);
      return law.stress(0.5 * (g + g.transpose()));
    };
    std::vector<double> load(b.q.size(), 0.0);
    b.add_traction(
        [&](const Vec2& x, const Vec2& n) -> Vec2 {
          const Vec2 m = R.transpose() * n;
          return m.y() < -0.5 ? Vec2(0.0, 0.0) : Vec2(R * stress(local(x)) * m);
        },
        load);
    b.integrate([&](std::size_t e, const Vec2& x, double weight) {
      const Vec2 p = local(x);
      const double d = 1e-5;
      const Vec2 divergence = (stress(p + Vec2(d, 0)) - stress(p - Vec2(d, 0))).col(0) / (2.0 * d) +
                              (stress(p + Vec2(0, d)) - stress(p - Vec2(0, d))).col(1) / (2.0 * d);
      const Vec2 force = -weight * (R * divergence);
      const auto w = b.mesh().weights(e, x - b.centre());
      for (std::size_t k = 0; k < 3; ++k) {
        const auto i = 2 * static_cast<std::size_t>(b.mesh().cover[e][k]);
        load[i] += w[k] * force.x();
        load[i + 1] += w[k] * force.y();
      }
    });
    const auto q0 = b.q;
    const System s = system_of(b);
    const Eigen::SparseMatrix<double> K = s.K.sparseView();
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(K);
    const std::vector<double> move = b.spread(factor.solve(s.f + b.folded(load)));
    double squared = 0.0;
    b.integrate([&](std::size_t e, const Vec2& x, double weight) {
      const auto w = b.mesh().weights(e, x - b.centre());
      Vec2 found(0.0, 0.0);
      for (std::size_t k = 0; k < 3; ++k) found += w[k] * node(move, b.mesh().cover[e][k]);
      squared += weight * (found - R * u(local(x))).squaredNorm();
    });
    error.push_back(std::sqrt(squared));
  }
  for (std::size_t i = 1; i < error.size(); ++i)
    EXPECT_GT(std::log(error[i - 1] / error[i]) / std::log(spacing[i - 1] / spacing[i]), 1.85) << error[i];
}

TEST(EdgeHolds, a_bedding_gives_way_by_the_traction_over_it) {
  EdgeSupport bed = held(0, Mat2::Identity());
  bed.bedding = 2e9;
  NmmBlock b(square(1.0, 0.0, {0.02, 0.05}), linear(0.21), stiff(), Plane::strain, {}, {bed});
  std::vector<double> load(b.q.size(), 0.0);
  const auto q0 = b.q;
  b.add_traction([](const Vec2&, const Vec2& n) { return n.y() > 0.5 ? Vec2(0.0, -1e6) : Vec2(0.0, 0.0); }, load);
  balance(b, load);
  double mean = 0.0;
  const auto w0 = b.mesh().boundary.segments;
  for (const Boundary::Segment& s : w0) {
    if (s.edge.edge != 0) continue;
    for (const double g : {s.s0, s.s1}) {
      const Row row = b.mesh().row(s.cell, b.model.blocks[0].polygon.outer[0] + Vec2(g, 0.0) - b.centre());
      for (std::size_t k = 0; k < 3; ++k)
        mean += 0.5 * (s.s1 - s.s0) * row.w[k] * (node(b.q, row.node[k]) - node(q0, row.node[k])).y();
    }
  }
  EXPECT_NEAR(mean, -1e6 / 2e9, 1e-12 * 1e6 / 2e9 * 1e4);
  EXPECT_NEAR(b.pool.edge_reaction(0, 0, 0.5, b.q).y(), 1e6, 2e5);
}

TEST(EdgeHolds, frequency_bound_holds_with_held_edges) {
  Random random(5);
  for (int trial = 0; trial < 25; ++trial) {
    Formulation form = linear(between(random, 0.15, 0.4));
    form.mass = MassKind::lumped;
    const double angle = between(random, 0.0, std::numbers::pi);
    NmmBlock b(square(1.0, angle, {between(random, -1.0, 1.0), between(random, -1.0, 1.0)}), form, stiff(),
               Plane::strain, {}, {held(0, Mat2::Identity()), held(1, along({0.6, 0.8}))});
    if (b.mesh().onefold) continue;
    const System s = system_of(b);
    const ElementDofs dofs = b.pool.element_dofs(0);
    std::vector<double> lower(dofs.values());
    b.pool.element_masses(0, b.q, lower);
    Eigen::VectorXd M = Eigen::VectorXd::Zero(s.K.rows());
    std::size_t at = 0;
    for (std::size_t e = 0; e < dofs.size(); ++e)
      for (auto j = static_cast<std::size_t>(dofs.start[e]); j < static_cast<std::size_t>(dofs.start[e + 1]); ++j)
        for (std::size_t i = j; i < static_cast<std::size_t>(dofs.start[e + 1]); ++i, ++at)
          if (dofs.dof[i] == dofs.dof[j]) M[dofs.dof[i]] += lower[at];
    const Eigen::VectorXd root = M.cwiseSqrt().cwiseInverse();
    const double exact = symmetric_eigenvalues(root.asDiagonal() * s.K * root.asDiagonal()).maxCoeff();
    const double bound = b.pool.mass_ratio(0) * b.pool.frequency_bound(0);
    EXPECT_GE(bound, exact);
    EXPECT_LT(bound, 8.0 * exact);  // the bound is also sharp enough to be useful
  }
}

}  // namespace
}  // namespace scree::nmm::edge_holds_test
