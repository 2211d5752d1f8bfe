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
  iteration.begin(unit, false);
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
    iteration.begin(unit, false);
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

/// A linear map of 20 unknowns whose answer changes by a constant and, by `change`, in its matrix.
struct Map {
  Eigen::MatrixXd m, other;
  std::vector<double> unit = std::vector<double>(20, 1.0);
  Map() {
    std::mt19937_64 random(43);
    std::normal_distribution<double> normal;
    m.resize(20, 20);
    other.resize(20, 20);
    for (int i = 0; i < 20; ++i)
      for (int j = 0; j < 20; ++j) {
        m(i, j) = normal(random);
        other(i, j) = normal(random);
      }
    m *= 0.9 / singular_values(m)[0];
    other /= singular_values(other)[0];
  }
  /// Iterations to the fixed point of (m + change other) x + b; -1: more than 60.
  int solve(FixedPoint& iteration, bool use_kept, double change, double b) const {
    const Eigen::MatrixXd of_step = m + change * other;
    const Eigen::VectorXd constant = b * Eigen::VectorXd::LinSpaced(20, -1.0, 2.0);
    const Eigen::VectorXd exact = solve_general(Eigen::MatrixXd::Identity(20, 20) - of_step, constant);
    iteration.begin(unit, use_kept);
    std::vector<double> x(20, 0.0), answer(20);
    for (int k = 1; k <= 60; ++k) {
      const Eigen::Map<const Eigen::VectorXd> now(x.data(), 20);
      Eigen::Map<Eigen::VectorXd>(answer.data(), 20) = of_step * now + constant;
      iteration.next(answer, x);
      if ((now - exact).norm() <= 1e-8 * exact.norm()) return k;
    }
    return -1;
  }
};

TEST(FixedPoint, accepted_iterations_speed_up_those_of_similar_maps) {
  const Map map;
  FixedPoint iteration;
  const int first = map.solve(iteration, true, 0.0, 1.0);
  ASSERT_GT(first, 8);
  iteration.accept();
  EXPECT_LE(map.solve(iteration, true, 0.0, -3.0), 6) << "the same map with another constant";
  EXPECT_LE(map.solve(iteration, true, 1e-3, 2.0), 8) << "a similar map";
  EXPECT_EQ(map.solve(iteration, false, 0.0, 1.0), first) << "kept differences are not used";
}

TEST(FixedPoint, iterations_that_are_not_accepted_leave_no_trace) {
  const Map map;
  FixedPoint iteration, other;
  (void)map.solve(iteration, true, 0.0, 1.0);
  iteration.accept();
  other.kept() = iteration.kept();
  (void)map.solve(iteration, true, 0.7, 1.0);  // given up
  (void)map.solve(iteration, false, 0.3, 1.0);
  EXPECT_EQ(iteration.kept().answers, other.kept().answers);
  EXPECT_EQ(map.solve(iteration, true, 1e-3, 2.0), map.solve(other, true, 1e-3, 2.0));
  iteration.accept();
  other.accept();
  EXPECT_EQ(iteration.kept().answers, other.kept().answers);
  EXPECT_EQ(iteration.kept().residuals, other.kept().residuals);
  EXPECT_LE(iteration.kept().count, 24);
}

}  // namespace
}  // namespace scree::coupling::fixed_point_test
