// Small cuts must not shorten the time step (docs/theory/kinematics-and-nmm.md, "Ties"): 1000 random placements.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "model/dense_algebra.h"
#include "tests/support/nmm_block.h"

namespace scree::test::small_cuts_test {
namespace {

/// Highest eigenvalue of M~^-1 K on the free covers, by a dense solution: no bound, no truncated iteration.
double highest(const NmmBlock& block) {
  const Eigen::MatrixXd K(block.stiffness());
  const auto n = K.rows();
  Eigen::MatrixXd inverse(n, n);  // M~^-1, column by column through the pool's own solution
  int unused = 0;
  const std::vector<int> of = block.unknowns(&unused);
  std::vector<double> f(block.q.size()), a(block.q.size());
  for (std::size_t c = 0; c < of.size(); ++c)
    for (std::size_t d = 0; d < 2; ++d) {
      if (of[c] < 0) continue;
      std::fill(f.begin(), f.end(), 0.0);
      f[2 * c + d] = 1.0;
      block.pool.mass_solve(block.q, f, a);
      for (std::size_t k = 0; k < of.size(); ++k)
        for (int e = 0; e < 2; ++e)
          if (of[k] >= 0) inverse(of[k] + e, of[c] + static_cast<int>(d)) = a[2 * k + static_cast<std::size_t>(e)];
    }
  // The spectrum of M~^-1 K is that of L^T K L with M~^-1 = L L^T.
  const Eigen::MatrixXd L = cholesky_factor(inverse);
  EXPECT_TRUE(L.allFinite());  // the mass is positive definite
  const Eigen::MatrixXd A = L.transpose() * K * L;
  return symmetric_eigenvalues(A)(n - 1);
}

/// Patch test: tractions of a constant stress must give the linear displacement up to a rigid motion. Returns the
/// largest error over the largest displacement.
double patch_error(const NmmBlock& block) {
  Mat2 e;
  e << 1.0, 0.4, 0.4, -0.6;
  const Mat2 stress = block.law().stress(e);
  std::vector<double> f(block.q.size(), 0.0);
  block.add_traction([&](const Vec2&, const Vec2& n) -> Vec2 { return stress * n; }, f);
  int n = 0;
  const std::vector<int> of = block.unknowns(&n);
  Eigen::VectorXd exact = Eigen::VectorXd::Zero(n);
  Eigen::MatrixXd rigid = Eigen::MatrixXd::Zero(n, 3);
  for (std::size_t c = 0; c < of.size(); ++c) {
    if (of[c] < 0) continue;
    const Vec2& X = block.mesh().star[c];
    exact.segment<2>(of[c]) = e * X;
    rigid.block<2, 3>(of[c], 0) << 1, 0, -X.y(), 0, 1, X.x();
  }
  // Rigid motions get a stiffness like that of the block; balanced tractions do not excite them.
  const Eigen::MatrixXd K(block.stiffness());
  const Eigen::Matrix3d L = cholesky_factor(rigid.transpose() * rigid);
  const Eigen::MatrixXd Q = rigid * L.inverse().transpose();  // orthonormal
  const Eigen::VectorXd u = solve_positive(K + K.diagonal().mean() * Q * Q.transpose(), block.folded(f));
  const Eigen::VectorXd strained = exact - Q * (Q.transpose() * exact);
  return (u - strained).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

struct Spread {
  std::vector<double> of;
  [[nodiscard]] double at(double part) {
    std::sort(of.begin(), of.end());
    return of[static_cast<std::size_t>(part * static_cast<double>(of.size() - 1))];
  }
};

TEST(SmallCuts, thousand_placements_keep_the_step_the_mass_and_the_patch) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  const Material rock{"rock", 2.0, 1.0, 0.25};
  Spread real, certified;
  double worst_patch = 0.0, worst_mass = 0.0, worst_inertia = 0.0;
  for (int k = 0; k < 1000; ++k) {
    // Widths from 1.5 to 6 cover sizes, lengths from the width to 8 cover sizes.
    const double width = 1.5 + 4.5 * u(generator), length = width + (8.0 - width) * u(generator);
    const Polygon box{
        {{-length / 2, -width / 2}, {length / 2, -width / 2}, {length / 2, width / 2}, {-length / 2, width / 2}}, {}};
    const Mat2 turn = rotation(2.0 * std::numbers::pi * u(generator));
    const double h = 1.0;
    Formulation form{.cover_size = h};
    form.offset_x = u(generator);
    form.offset_y = u(generator);
    NmmBlock block(transformed(box, {0.0, 0.0}, turn), form, rock);
    ASSERT_FALSE(block.mesh().onefold);
    const double uncut = std::sqrt(3.0) / 2.0 * h / std::sqrt(block.law().p_modulus() / rock.density);
    real.of.push_back(2.0 / std::sqrt(highest(block)) / uncut);
    certified.of.push_back(2.0 / std::sqrt(block.pool.mass_ratio(0) * block.pool.frequency_bound(0)) / uncut);
    EXPECT_LE(certified.of.back(), real.of.back() * (1.0 + 1e-12)) << "placement " << k;
    worst_patch = std::max(worst_patch, patch_error(block));

    AffineMotion m;
    m.c = {30.0, -20.0};
    m.F = rotation(0.3);
    m.vc = {0.3, 0.4};
    m.Fdot = 1.7 * quarter_turn() * m.F;
    std::vector<double> q(block.q.size()), v(q.size());
    block.pool.place(0, m, q, v);
    const BodyTotals t = block.pool.totals(0, q, v);
    const double J = block.shape.second.trace();
    worst_mass = std::max(worst_mass, std::abs(t.mass - block.shape.mass) / block.shape.mass);
    worst_inertia = std::max(worst_inertia, std::abs(t.angular_momentum - cross(t.centre, t.momentum) - 1.7 * J) /
                                                (1.7 * J + t.mass * 18.0));
  }
  std::printf(
      "1000 placements, dt_stable/dt_uncut: min %.3f, median %.3f, max %.3f (certified: min %.3f, median %.3f)\n"
      "largest errors: patch %.1e, mass %.1e, inertia %.1e\n",
      real.at(0.0), real.at(0.5), real.at(1.0), certified.at(0.0), certified.at(0.5), worst_patch, worst_mass,
      worst_inertia);
  EXPECT_GE(real.at(0.0), 0.5);
  EXPECT_LE(worst_patch, 1e-12);
  EXPECT_LE(worst_mass, 1e-14);
  EXPECT_LE(worst_inertia, 1e-14);
}

}  // namespace
}  // namespace scree::test::small_cuts_test
