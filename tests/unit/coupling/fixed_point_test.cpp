// Anderson's iteration against dense algebra: contracting and non-contracting linear maps, units, a nonlinear map.
#include "coupling/linear/fixed_point.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <random>

#include "model/dense_algebra.h"

namespace scree::coupling::fixed_point_test {
namespace {

/// Iterations until the fixed point of T(x) = M x + b is within 1e-10 of the solution; -1: not within `most`.
int iterations(const Eigen::MatrixXd& m, const Eigen::VectorXd& b, std::span<const double> unit, int most) {
  const Eigen::Index n = b.size();
  const Eigen::VectorXd exact = solve_general(Eigen::MatrixXd::Identity(n, n) - m, b);
  std::vector<double> x(static_cast<std::size_t>(n), 0.0), answer(x.size());
  FixedPoint iteration;
  iteration.begin(unit);
  for (int k = 1; k <= most; ++k) {
    const Eigen::Map<const Eigen::VectorXd> now(x.data(), n);
    Eigen::Map<Eigen::VectorXd>(answer.data(), n) = m * now + b;
    iteration.next(answer, x);
    if ((now - exact).norm() <= 1e-10 * exact.norm()) return k;
  }
  return -1;
}

TEST(FixedPoint, solves_linear_maps_in_as_many_iterations_as_unknowns) {
  std::mt19937_64 random(41);
  std::normal_distribution<double> normal;
  for (const int n : {1, 2, 5, 9})
    for (const double size : {0.3, 0.9, 3.0}) {  // the last does not contract: plain iteration diverges
      Eigen::MatrixXd m(n, n);
      for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) m(i, j) = normal(random);
      m *= size / singular_values(m)[0];
      const std::vector<double> unit(static_cast<std::size_t>(n), 1.0);
      const int taken = iterations(m, Eigen::VectorXd::Random(n), unit, 60);
      EXPECT_GE(taken, 1) << n << ", " << size;
      EXPECT_LE(taken, n + 3) << n << ", " << size;
    }
}

TEST(FixedPoint, units_of_the_unknowns_do_not_matter) {
  std::mt19937_64 random(42);
  std::normal_distribution<double> normal;
  constexpr int n = 6;
  Eigen::MatrixXd m(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) m(i, j) = 0.3 * normal(random);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
  Eigen::VectorXd scale(n);
  for (int i = 0; i < n; ++i) scale[i] = std::pow(10.0, 2 * i - 5);
  const Eigen::MatrixXd scaled = scale.asDiagonal() * m * scale.cwiseInverse().asDiagonal();
  const std::vector<double> ones(n, 1.0), units(scale.data(), scale.data() + n);
  const int plain = iterations(m, b, ones, 60), other = iterations(scaled, scale.cwiseProduct(b), units, 60);
  EXPECT_GE(plain, 1);
  EXPECT_GE(other, 1);
  EXPECT_LE(std::abs(plain - other), 2);
}

TEST(FixedPoint, nonlinear_map_and_a_beginning_afresh) {
  FixedPoint iteration;
  const std::vector<double> unit{1.0};
  for (int again = 0; again < 2; ++again) {
    iteration.begin(unit);
    std::vector<double> x{again == 0 ? 1.0 : 0.2};
    int taken = 0;
    while (std::abs(std::cos(x[0]) - x[0]) > 1e-14 && taken < 50) {
      const std::vector<double> answer{std::cos(x[0])};
      iteration.next(answer, x);
      ++taken;
    }
    EXPECT_NEAR(x[0], 0.73908513321516064, 1e-13);
    EXPECT_LE(taken, 20);  // plain iteration needs 80
  }
}

}  // namespace
}  // namespace scree::coupling::fixed_point_test
