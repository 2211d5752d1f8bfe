// The lumped mass: totals of a block, its inverse, and the bound of the row sums, up to round-off.
#include "nmm/lumped_mass.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <span>

#include "tests/unit/nmm/one_block.h"

namespace scree::nmm::lumped_mass_test {
namespace {

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

TEST(LumpedMass, row_sums_add_to_the_block_and_are_bounded_by_the_mass_ratio) {
  for (const double h : {0.7, 0.33}) {
    One one(quadrilateral(), h);
    const std::span<const double> lumped = one.pool.mass().lumped();
    EXPECT_NEAR(std::accumulate(lumped.begin(), lumped.end(), 0.0), one.shape.mass, 1e-12);
    // The two masses differ for affine motion: D <= theta M, and theta - 1 is less than twice the excess found.
    const double theta = one.pool.mass_ratio(0);
    std::mt19937 generator(5);
    std::uniform_real_distribution<double> u(-1.0, 1.0);
    double most = 0.0;
    for (int n = 0; n < 200; ++n) {
      AffineMotion m;
      m.vc = 0.1 * Vec2(u(generator), u(generator));
      m.Fdot << u(generator), u(generator), u(generator), u(generator);
      one.pool.place(0, m, one.q, one.v);
      double twice = 0.0;
      for (std::size_t k = 0; k < lumped.size(); ++k)
        twice += lumped[k] * Vec2(one.v[2 * k], one.v[2 * k + 1]).squaredNorm();
      most = std::max(most, 0.5 * twice / one.pool.totals(0, one.q, one.v).kinetic);
    }
    EXPECT_LE(most, theta * (1.0 + 1e-12)) << h;
    EXPECT_GT(most, 1.0 + 0.5 * (theta - 1.0)) << h;
    EXPECT_GT(theta, 1.001) << h;
  }
}

}  // namespace
}  // namespace scree::nmm::lumped_mass_test
