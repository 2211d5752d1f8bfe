// Element forces, compared with differences of the energy, patch tests and the law element by element.
#include "nmm/element_forces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ostream>
#include <random>

#include "tests/unit/nmm/one_block.h"

namespace scree::nmm::element_forces_test {
namespace {

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
  // Tolerance: round-off, E times 1e-16 times the coordinates divided by the cover size.
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

TEST(InternalForce, turned_inside_out_is_not_a_number) {
  One one(quadrilateral(), 0.33);
  AffineMotion m;
  m.F << -1.0, 0.0, 0.0, 1.0;
  one.pool.place(0, m, one.q, one.v);
  std::vector<double> f(one.q.size(), 0.0);
  EXPECT_TRUE(std::isnan(one.pool.internal_force(one.q, f)));
}

TEST(InternalForce, in_situ_stress_balances_weight_exactly) {
  // s_yy = rho g (y - level), confined: -div s = rho b holds exactly, so with the tractions of s every cover balances.
  InitialStress s;
  s.gradient << -2.0 * 9.81 / 3.0, 0.0, 0.0, -2.0 * 9.81;
  s.level = 0.7;
  const Polygon p = quadrilateral();
  const test::NmmBlock block(p, {.mass = MassKind::lumped, .cover_size = 0.3}, rock(1.0, s));
  const NmmPool& pool = block.pool;
  const std::vector<double>& q = block.q;
  std::vector<double> f(q.size(), 0.0), a(q.size());
  pool.internal_force(q, f);
  pool.body_force({0.0, -9.81}, f);
  const Ring& ring = p.outer;
  for (const Boundary::Segment& g : pool.boundary(0).segments) {
    const Vec2 &A = ring[static_cast<std::size_t>(g.edge.edge)],
               &B = ring[(static_cast<std::size_t>(g.edge.edge) + 1) % ring.size()];
    const Vec2 d = (g.s1 - g.s0) * (B - A), n = -quarter_turn() * d;  // normal times length
    for (const double t : {0.5 - 0.5 / std::sqrt(3.0), 0.5 + 0.5 / std::sqrt(3.0)}) {
      const Vec2 x = A + g.s0 * (B - A) + t * d, force = 0.5 * s.at(x) * n;
      const Row row = pool.mesh(0).row(g.cell, x - block.centre());
      for (std::size_t k = 0; k < 3; ++k)
        for (int c = 0; c < 2; ++c) f[2 * std::size_t(row.node[k]) + std::size_t(c)] += row.w[k] * force[c];
    }
  }
  pool.mass_solve(q, f, a);
  double largest = 0.0;
  for (const double x : a) largest = std::max(largest, std::abs(x));
  EXPECT_LT(largest, 1e-11 * 9.81);
}

/// Constant stress: with tractions s n on the outline, the linear field must be in equilibrium at every free cover.
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
      // Traction integrated with the weights at the middle: exact, because the weights are linear along a segment.
      const CoverMesh& mesh = one.pool.mesh(0);
      const Ring& ring = one.shape.outline.ring(static_cast<std::size_t>(s.edge.ring));
      const Vec2 &A = ring[static_cast<std::size_t>(s.edge.edge)],
                 &B = ring[(static_cast<std::size_t>(s.edge.edge) + 1) % ring.size()];
      const Vec2 d = (s.s1 - s.s0) * (B - A), n = -quarter_turn() * d;
      const Row row = mesh.row(s.cell, A + 0.5 * (s.s0 + s.s1) * (B - A));
      for (std::size_t i = 0; i < 3; ++i)
        for (int c = 0; c < 2; ++c) f[2 * std::size_t(row.node[i]) + std::size_t(c)] += row.w[i] * (P * n)[c];
    }
    one.pool.mass_solve(one.q, f, a);                           // also gathers forces over the ties
    const double scale = law.p_modulus() * 1e-2 / (2.0 * 0.4);  // stress over density and cover size
    for (double x : a) worst = std::max(worst, std::abs(x) / scale);
  }
  std::printf("patch test, 100 placements: largest residual acceleration over stress/(rho h): %.1e\n", worst);
  EXPECT_LT(worst, 1e-11);  // round-off of GEOS's cut points: 1e-16 over the strain of 1e-2, times the spread of masses
}

struct Variant {
  Kinematics kinematics;
  bool in_situ;
};
std::ostream& operator<<(std::ostream& out, const Variant& v) {
  return out << (v.kinematics == Kinematics::linear ? "linear" : "corotational") << (v.in_situ ? "_in_situ" : "");
}

class Forces : public testing::TestWithParam<Variant> {
 protected:
  Forces()
      : block_(quadrilateral(), {.kinematics = GetParam().kinematics, .cover_size = 0.2},
               rock(1.0, GetParam().in_situ ? std::optional(deviatoric()) : std::nullopt)) {
    AffineMotion m;
    m.F = GetParam().kinematics == Kinematics::linear ? rotation(0.01) : rotation(0.7);
    block_.pool.place(0, m, block_.q, block_.v);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> u(-0.01, 0.01);
    for (double& x : q_) x += u(generator);
    for (double& x : v_) x = u(generator);
  }
  test::NmmBlock block_;
  const NmmPool& pool_ = block_.pool;
  std::vector<double>&q_ = block_.q, &v_ = block_.v;
};

TEST_P(Forces, strips_of_cells_equal_the_law_element_by_element) {
  std::vector<double> f(q_.size(), 0.0), expected(q_.size(), 0.0);
  const double energy = pool_.internal_force(q_, f);
  double sum = 0.0;
  const ElementForces& elements = pool_.elements();
  for (std::size_t e = 0; e < elements.size(); ++e) {
    const ElasticResponse r = elements.response(e, q_);
    sum += elements.area(e) * r.energy;
    for (int k = 0; k < 3; ++k) {
      const Vec2 force = elements.area(e) * r.P * elements.gradients(e).col(k);
      const auto i = 2 * static_cast<std::size_t>(elements.cover(e)[static_cast<std::size_t>(k)]);
      expected[i] -= force.x();
      expected[i + 1] -= force.y();
    }
  }
  EXPECT_NEAR(energy, sum, 1e-13 * std::abs(sum));
  for (std::size_t i = 0; i < f.size(); ++i) EXPECT_NEAR(f[i], expected[i], 1e-14);
}

TEST_P(Forces, are_the_gradient_of_the_energy) {
  std::vector<double> f(q_.size(), 0.0), scratch(q_.size());
  pool_.internal_force(q_, f);
  for (std::size_t i = 0; i < q_.size(); i += 7) {
    const double h = 1e-6, keep = q_[i];
    q_[i] = keep + h;
    const double plus = pool_.internal_force(q_, scratch);
    q_[i] = keep - h;
    const double minus = pool_.internal_force(q_, scratch);
    q_[i] = keep;
    EXPECT_NEAR(f[i], -(plus - minus) / (2.0 * h), 1e-8);
  }
}

TEST_P(Forces, stiffness_damping_only_dissipates_and_spares_rigid_motion) {
  std::vector<double> f(q_.size(), 0.0), g(q_.size(), 0.0), spin(q_.size());
  pool_.stiffness_damping(q_, v_, 0.3, f);
  double power = 0.0, torque = 0.0, size = 0.0;
  for (std::size_t i = 0; i < f.size(); ++i) power += f[i] * v_[i];
  EXPECT_LT(power, 0.0);
  for (std::size_t k = 0; k < f.size() / 2; ++k) {
    spin[2 * k] = 3.0 - 2.0 * q_[2 * k + 1];
    spin[2 * k + 1] = 2.0 * q_[2 * k];
    torque += q_[2 * k] * f[2 * k + 1] - q_[2 * k + 1] * f[2 * k];
    size += std::abs(q_[2 * k] * f[2 * k + 1]);
  }
  if (GetParam().kinematics == Kinematics::linear) return;
  EXPECT_LT(std::abs(torque), 1e-13 * size);
  pool_.stiffness_damping(q_, spin, 0.3, g);
  for (const double x : g) EXPECT_NEAR(x, 0.0, 1e-14);
}

INSTANTIATE_TEST_SUITE_P(all, Forces,
                         testing::Values(Variant{Kinematics::corotational, false},
                                         Variant{Kinematics::corotational, true}, Variant{Kinematics::linear, false},
                                         Variant{Kinematics::linear, true}),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace scree::nmm::element_forces_test
