// Manufactured solution on a block in general position on the mesh: body force and tractions on the outline, orders of
// convergence of displacement and stress.
#include <gtest/gtest.h>

#include <cmath>

#include "model/dense_algebra.h"
#include "tests/support/nmm_block.h"
#include "tests/support/order_table.h"

namespace scree::test::convergence_test {
namespace {

/// u = (sin(2x + 1) cos(1.5 y), cos(x) sin(2 y) + x y) times a small number, with its strain, stress and body force.
struct Manufactured {
  Elasticity law;
  static constexpr double kSize = 1e-6;
  [[nodiscard]] static Vec2 displacement(const Vec2& x) {
    return kSize *
           Vec2(std::sin(2 * x.x() + 1) * std::cos(1.5 * x.y()), std::cos(x.x()) * std::sin(2 * x.y()) + x.x() * x.y());
  }
  [[nodiscard]] static Mat2 strain(const Vec2& x) {
    const double uxx = 2 * std::cos(2 * x.x() + 1) * std::cos(1.5 * x.y()),
                 uxy = -1.5 * std::sin(2 * x.x() + 1) * std::sin(1.5 * x.y()),
                 uyx = -std::sin(x.x()) * std::sin(2 * x.y()) + x.y(),
                 uyy = 2 * std::cos(x.x()) * std::cos(2 * x.y()) + x.x();
    return kSize * (Mat2() << uxx, 0.5 * (uxy + uyx), 0.5 * (uxy + uyx), uyy).finished();
  }
  [[nodiscard]] Mat2 stress(const Vec2& x) const { return law.stress(strain(x)); }
  /// -div s = -(lambda + mu) grad div u - mu lap u, second derivatives by hand.
  [[nodiscard]] Vec2 body_force(const Vec2& x) const {
    const double sx = std::sin(2 * x.x() + 1), cx = std::cos(2 * x.x() + 1), sy = std::sin(1.5 * x.y()),
                 cy = std::cos(1.5 * x.y());
    const double u_xx = -4 * sx * cy, u_yy = -2.25 * sx * cy, u_xy = -3 * cx * sy;
    const double v_xx = -std::cos(x.x()) * std::sin(2 * x.y()), v_yy = -4 * std::cos(x.x()) * std::sin(2 * x.y()),
                 v_xy = -2 * std::sin(x.x()) * std::cos(2 * x.y()) + 1.0;
    const double a = law.lambda + law.mu;
    return -kSize * Vec2(a * (u_xx + v_xy) + law.mu * (u_xx + u_yy), a * (u_xy + v_yy) + law.mu * (v_xx + v_yy));
  }
};

struct Errors {
  double displacement, stress, recovered;
};

Errors solve(const Polygon& polygon, double h) {
  NmmBlock block(polygon, {.cover_size = h}, {"rock", 2000.0, 1e9, 0.25});
  const Manufactured exact{block.law()};
  std::vector<double> f(block.q.size(), 0.0);
  block.add_traction([&](const Vec2& x, const Vec2& n) -> Vec2 { return exact.stress(x) * n; }, f);
  block.integrate([&](std::size_t e, const Vec2& x, double w) {
    const auto weights = block.mesh().weights(e, x - block.centre());
    const Vec2 b = w * exact.body_force(x);
    for (std::size_t k = 0; k < 3; ++k)
      for (int d = 0; d < 2; ++d)
        f[2 * static_cast<std::size_t>(block.mesh().cover[e][k]) + static_cast<std::size_t>(d)] += weights[k] * b[d];
  });
  const std::vector<double> u = block.spread(solve_free(block, block.folded(f)));
  std::vector<double> q = block.q;
  for (std::size_t i = 0; i < q.size(); ++i) q[i] += u[i];
  std::vector<double> recovered(3 * q.size() / 2);
  block.pool.recovered_stress(q, std::vector<char>(q.size() / 2, 1), recovered);

  // Rigid motions are arbitrary: the one of least squares is subtracted.
  const auto found = [&](std::size_t e, const Vec2& x) {
    const auto w = block.mesh().weights(e, x - block.centre());
    Vec2 sum = Vec2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = 2 * static_cast<std::size_t>(block.mesh().cover[e][k]);
      sum += w[k] * Vec2(u[i], u[i + 1]);
    }
    return sum;
  };
  Eigen::Matrix3d A = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  block.integrate([&](std::size_t e, const Vec2& x, double w) {
    const Vec2 r = x - block.centre(), d = Manufactured::displacement(x) - found(e, x);
    Eigen::Matrix<double, 2, 3> modes;
    modes << 1, 0, -r.y(), 0, 1, r.x();
    A += w * modes.transpose() * modes;
    b += w * modes.transpose() * d;
  });
  const Eigen::Vector3d rigid = solve_symmetric(A, b);
  Errors sum{0.0, 0.0, 0.0};
  block.integrate([&](std::size_t e, const Vec2& x, double w) {
    const Vec2 r = x - block.centre();
    Eigen::Matrix<double, 2, 3> modes;
    modes << 1, 0, -r.y(), 0, 1, r.x();
    sum.displacement += w * (Manufactured::displacement(x) - found(e, x) - modes * rigid).squaredNorm();
    const Mat2 s = elastic_response(block.law(), block.pool.elements().gradient(e, q), Mat2::Zero()).stress,
               t = exact.stress(x);
    sum.stress += w * (t - s).squaredNorm();
    const auto weights = block.mesh().weights(e, x - block.centre());
    Mat2 smooth = Mat2::Zero();
    for (std::size_t k = 0; k < 3; ++k) {
      const double* n = &recovered[3 * static_cast<std::size_t>(block.mesh().cover[e][k])];
      smooth += weights[k] * (Mat2() << n[0], n[2], n[2], n[1]).finished();
    }
    sum.recovered += w * (t - smooth).squaredNorm();
  });
  return {std::sqrt(sum.displacement), std::sqrt(sum.stress), std::sqrt(sum.recovered)};
}

TEST(Convergence, manufactured_solution_with_cut_boundary) {
  const Polygon square =
      transformed({{{-0.5, -0.5}, {0.5, -0.5}, {0.5, 0.5}, {-0.5, 0.5}}, {}}, {0.013, 0.027}, rotation(0.3));
  Polygon holed = square;
  for (int k = 0; k < 12; ++k)
    holed.holes.resize(1),
        holed.holes[0].push_back(Vec2(0.05, 0.02) + 0.2 * Vec2(std::cos(-k * 0.5236), std::sin(-k * 0.5236)));
  for (const auto& [name, polygon] : {std::pair("turned square", square), std::pair("square with a hole", holed)}) {
    OrderRow displacement{std::string(name) + ": L2 displacement over cover size", {}, {}, 1.9},
        stress{std::string(name) + ": L2 element stress", {}, {}, 0.9},
        recovered{std::string(name) + ": L2 recovered stress", {}, {}, 1.3};
    for (const double h : {1.0 / 6, 1.0 / 12, 1.0 / 24, 1.0 / 48, 1.0 / 96}) {
      const Errors e = solve(polygon, h);
      for (OrderRow* row : {&displacement, &stress, &recovered}) row->size.push_back(h);
      displacement.error.push_back(e.displacement);
      stress.error.push_back(e.stress);
      recovered.error.push_back(e.recovered);
    }
    expect_order(displacement);
    expect_order(stress);
    expect_order(recovered);
  }
}

}  // namespace
}  // namespace scree::test::convergence_test
