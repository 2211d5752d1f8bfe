#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>

#include "nmm/nmm_pool.h"
#include "nmm/step_bound.h"

namespace scree::nmm {
namespace {

Polygon quadrilateral() { return {{{-1.1, -0.7}, {1.3, -0.6}, {1.0, 0.6}, {-0.8, 0.7}}, {}}; }

/// Reference shape about the centre of mass.
ReferenceShape shape_of(const Polygon& p, double density) {
  const Moments m = moments(p);
  ReferenceShape s;
  s.outline = s.origin = transformed(p, -m.centroid, Mat2::Identity());
  s.mass = density * m.area;
  s.area = m.area;
  s.second = density * m.second;
  return s;
}

struct One {
  Model model;
  NmmPool pool;
  ReferenceShape shape;
  std::vector<double> q, v;
  explicit One(const Polygon& p, double cover, double young = 1.0, double poisson = 0.25) {
    model.materials.push_back({"rock", 2.0, young, poisson});
    Block b;
    b.polygon = p;
    b.material = MaterialId{0};
    model.blocks.push_back(b);
    shape = shape_of(p, 2.0);
    pool.add(model, {BlockId{0}, "nmm", shape, {.cover_size = cover}});
    pool.finish();
    q.assign(2 * static_cast<std::size_t>(pool.first_node(1)), 0.0);
    v = q;
  }
};

TEST(CoverMesh, elements_fill_the_block) {
  for (double h : {0.7, 0.33, 0.17}) {
    const ReferenceShape s = shape_of(quadrilateral(), 1.0);
    const CoverMesh mesh = make_cover_mesh(s.outline, h);
    double area = 0.0;
    for (const double a : mesh.area) area += a;
    EXPECT_NEAR(area, s.area, 1e-13 * s.area);
  }
}

TEST(CoverMesh, slot_separates_its_two_sides) {
  // A U: the arms are nearer to each other than a cover, so stars there must be doubled.
  const Polygon u{{{0, 0}, {3, 0}, {3, 3}, {1.6, 3}, {1.6, 1}, {1.4, 1}, {1.4, 3}, {0, 3}}, {}};
  const CoverMesh mesh = make_cover_mesh(shape_of(u, 1.0).outline, 0.5);
  int doubled = 0;
  for (std::size_t i = 0; i < mesh.star.size(); ++i)
    for (std::size_t j = i + 1; j < mesh.star.size(); ++j)
      doubled += (mesh.star[i] - mesh.star[j]).norm() < 1e-9 ? 1 : 0;
  EXPECT_GE(doubled, 3);
  for (const Tie& t : mesh.ties)
    for (std::size_t e = 0; e < mesh.elements(); ++e)
      if (mesh.cover[e] == t.root) {  // a tie never reaches across the slot
        const double side = mesh.centroid(e).x() + moments(u).centroid.x();
        for (std::size_t own = 0; own < mesh.elements(); ++own)
          for (const std::int32_t c : mesh.cover[own])
            if (c == t.cover && mesh.centroid(own).y() + moments(u).centroid.y() > 1.5) {
              EXPECT_EQ(side > 1.5, mesh.centroid(own).x() + moments(u).centroid.x() > 1.5);
            }
      }
}

TEST(LumpedMass, mass_centre_and_inertia_are_exact) {
  for (double h : {5.0, 0.7, 0.33, 0.17}) {  // 5.0: onefold
    One one(quadrilateral(), h);
    AffineMotion m;
    m.c = {3.0, -2.0};
    m.vc = {0.3, 0.4};
    m.Fdot = 1.7 * quarter_turn();
    one.pool.place(0, m, one.q, one.v);
    const BodyTotals t = one.pool.totals(0, one.q, one.v);
    EXPECT_NEAR(t.mass, one.shape.mass, 1e-13);
    EXPECT_NEAR((t.centre - m.c).norm(), 0.0, 1e-13);
    const double J = one.shape.second.trace();
    EXPECT_NEAR(t.kinetic, 0.5 * t.mass * 0.25 + 0.5 * J * 1.7 * 1.7, 1e-12);
    EXPECT_NEAR(t.angular_momentum - cross(t.centre, t.momentum), J * 1.7, 1e-12);
  }
}

TEST(LumpedMass, solve_inverts_apply_and_body_force_gives_g) {
  One one(quadrilateral(), 0.33);
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  std::vector<double> f(one.q.size(), 0.0), a(f.size()), p(f.size());
  for (double& x : f) x = u(generator);
  for (const Tie& t : one.pool.mesh(0).ties) f[2 * std::size_t(t.cover)] = f[2 * std::size_t(t.cover) + 1] = 0.0;
  one.pool.mass_solve(one.q, f, a);
  one.pool.mass().apply(0, one.pool.first_node(1), a, p);
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(p[i], f[i], 1e-12);
  std::fill(f.begin(), f.end(), 0.0);
  one.pool.body_force({0.5, -9.81}, f);
  one.pool.mass_solve(one.q, f, a);
  for (std::size_t k = 0; k < a.size() / 2; ++k) {
    EXPECT_NEAR(a[2 * k], 0.5, 1e-12);
    EXPECT_NEAR(a[2 * k + 1], -9.81, 1e-12);
  }
}

TEST(InternalForce, rigid_motion_gives_none) {
  One one(quadrilateral(), 0.33, 1e9);
  AffineMotion m;
  m.c = {100.0, 50.0};
  m.F = rotation(2.0);
  one.pool.place(0, m, one.q, one.v);
  std::vector<double> f(one.q.size(), 0.0);
  const double energy = one.pool.internal_force(one.q, f);
  double largest = 0.0;
  for (double x : f) largest = std::max(largest, std::abs(x));
  // Round-off: E times 1e-16 times the coordinates over the cover size.
  EXPECT_LT(largest, 1e9 * 1e-15 * 150.0 / 0.33);
  EXPECT_LT(energy, 1e-9);
}

TEST(InternalForce, is_the_gradient_of_the_energy) {
  One one(quadrilateral(), 0.5);
  AffineMotion m;
  m.F = rotation(0.7);
  one.pool.place(0, m, one.q, one.v);
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> u(-0.05, 0.05);
  for (double& x : one.q) x += u(generator);
  std::vector<double> f(one.q.size(), 0.0), scratch(one.q.size());
  one.pool.internal_force(one.q, f);
  for (std::size_t i = 0; i < one.q.size(); i += 3) {
    const double h = 1e-6, keep = one.q[i];
    one.q[i] = keep + h;
    const double plus = one.pool.internal_force(one.q, scratch);
    one.q[i] = keep - h;
    const double minus = one.pool.internal_force(one.q, scratch);
    one.q[i] = keep;
    EXPECT_NEAR(f[i], -(plus - minus) / (2.0 * h), 1e-8);
  }
}

/// Constant stress: with tractions s n on the outline the linear field must be in equilibrium on every free cover.
TEST(PatchTest, constant_stress_is_in_equilibrium_for_random_placements) {
  std::mt19937 generator(11);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  double worst = 0.0;
  for (int k = 0; k < 100; ++k) {
    Polygon p = transformed(quadrilateral(), {u(generator), u(generator)}, rotation(3.14 * u(generator)));
    One one(p, 0.4);
    const Elasticity law = one.model.elasticity_of(BlockId{0});
    Mat2 e;
    e << 1e-2, 4e-3, 4e-3, -6e-3;  // constant F gives constant P at any strain
    AffineMotion m;
    m.F = Mat2::Identity() + e;
    one.pool.place(0, m, one.q, one.v);
    std::vector<double> f(one.q.size(), 0.0), a(one.q.size());
    one.pool.internal_force(one.q, f);
    const Mat2 P = elastic_response(law, m.F, Mat2::Zero()).P;
    const Boundary& b = one.pool.boundary(0);
    for (const Boundary::Segment& s : b.segments) {
      // Traction integrated with the weights at the middle: exact, the weights are linear along a segment.
      const CoverMesh& mesh = one.pool.mesh(0);
      const Ring& ring = one.shape.outline.ring(static_cast<std::size_t>(s.edge.ring));
      const Vec2 &A = ring[static_cast<std::size_t>(s.edge.edge)],
                 &B = ring[(static_cast<std::size_t>(s.edge.edge) + 1) % ring.size()];
      const Vec2 d = (s.s1 - s.s0) * (B - A), n = -quarter_turn() * d;
      const Row row = mesh.row(s.cell, A + 0.5 * (s.s0 + s.s1) * (B - A));
      for (std::size_t i = 0; i < 3; ++i)
        for (int c = 0; c < 2; ++c) f[2 * std::size_t(row.node[i]) + std::size_t(c)] += row.w[i] * (P * n)[c];
    }
    one.pool.mass_solve(one.q, f, a);                           // folds the ties
    const double scale = law.p_modulus() * 1e-2 / (2.0 * 0.4);  // stress over density and cover size
    for (double x : a) worst = std::max(worst, std::abs(x) / scale);
  }
  std::printf("patch test, 100 placements: largest residual acceleration over stress/(rho h): %.1e\n", worst);
  EXPECT_LT(worst, 1e-11);  // round-off of GEOS's cut points, 1e-16 over the strain of 1e-2, times the spread of masses
}

double true_highest(const One& one) {
  // Power iteration on M~^-1 K by differences of the internal force about rest.
  std::vector<double> q = one.q, f(q.size()), a(q.size()), x(q.size());
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  for (double& v : x) v = u(generator);
  one.pool.mass_solve(q, x, a);
  x = a;
  double lambda = 0.0;
  for (int it = 0; it < 3000; ++it) {
    double norm = 0.0;
    for (double v : x) norm = std::max(norm, std::abs(v));
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = one.q[i] + 1e-6 * x[i] / norm;
    std::fill(f.begin(), f.end(), 0.0);
    one.pool.internal_force(q, f);
    one.pool.mass_solve(q, f, a);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      x[i] = -a[i] / 1e-6;
      largest = std::max(largest, std::abs(x[i]));
    }
    lambda = largest;
  }
  return lambda;
}

TEST(StepBound, is_certified_and_small_cuts_do_not_cost_the_step) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  const double h = 1.0;
  double least = 1e9, least_true = 1e9;
  for (int k = 0; k < 40; ++k) {
    const Polygon box{{{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}}, {}};
    One one(transformed(box, {u(generator), u(generator)}, rotation(3.14159 * u(generator))), h);
    AffineMotion m;
    one.pool.place(0, m, one.q, one.v);
    const double bound = 2.0 / std::sqrt(one.pool.mass_ratio(0) * one.pool.frequency_bound(0));
    const double real = 2.0 / std::sqrt(true_highest(one));
    EXPECT_LE(bound, real * (1.0 + 1e-3));  // the power iteration approaches from below
    const Elasticity law = one.model.elasticity_of(BlockId{0});
    const double uncut = 0.866 * h / std::sqrt(law.p_modulus() / 2.0);
    least = std::min(least, bound / uncut);
    least_true = std::min(least_true, real / uncut);
  }
  std::printf("least stable step over that of the uncut mesh: %.3f true, %.3f certified\n", least_true, least);
  EXPECT_GE(least_true, 0.5);
}

TEST(Release, affine_part_and_remainder_carry_everything) {
  One one(quadrilateral(), 0.33, 1e3);
  AffineMotion m;
  m.c = {1.0, 2.0};
  m.F = rotation(0.4) * (Mat2::Identity() + (Mat2() << 0.01, 0.003, 0.003, -0.02).finished());
  m.vc = {1.0, -0.5};
  m.Fdot = 2.0 * quarter_turn();
  one.pool.place(0, m, one.q, one.v);
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> u(-0.01, 0.01);
  std::vector<double> dv(one.q.size()), dq(one.q.size()), none(one.q.size());
  for (double& x : dv) x = u(generator);
  for (double& x : dq) x = 0.1 * u(generator);
  std::vector<double> av(dv.size()), aq(dv.size());
  one.pool.mass_solve(one.q, dv, av);  // compatible with the ties
  one.pool.mass_solve(one.q, dq, aq);
  for (std::size_t i = 0; i < dv.size(); ++i) {
    one.v[i] += 0.01 * av[i];
    one.q[i] += 0.01 * aq[i];
  }
  const BodyTotals before = one.pool.totals(0, one.q, one.v);
  const Release r = one.pool.release(0, one.q, one.v);
  const double affine = 0.5 * r.shape.mass * r.motion.vc.squaredNorm() +
                        0.5 * (r.motion.Fdot * r.shape.second * r.motion.Fdot.transpose()).trace();
  EXPECT_NEAR(affine + r.kinetic_rest, before.kinetic, 1e-12 * before.kinetic);
  const double elastic =
      r.shape.area * elastic_response(one.model.elasticity_of(BlockId{0}), r.motion.F, Mat2::Zero()).energy;
  EXPECT_NEAR(elastic + r.elastic_rest + r.elastic_cross, before.elastic, 1e-12 * before.elastic);
  EXPECT_GT(r.kinetic_rest, 0.0);
  EXPECT_GT(r.elastic_rest, 0.0);
  EXPECT_LT(std::abs(r.elastic_cross), 0.1 * r.elastic_rest + 1e-3 * before.elastic);
  EXPECT_NEAR((r.shape.mass * r.motion.vc - before.momentum).norm(), 0.0, 1e-12);
}

}  // namespace
}  // namespace scree::nmm
