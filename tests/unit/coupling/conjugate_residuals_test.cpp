// Conjugate residuals against dense algebra: symmetric and unsymmetric systems, good and poor preconditioners.
#include "coupling/linear/conjugate_residuals.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <random>

#include "model/dense_algebra.h"

namespace scree::coupling::conjugate_residuals_test {
namespace {

Eigen::MatrixXd drawn(int n, double unsymmetric, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Eigen::MatrixXd a(n, n), skew(n, n);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      a(i, j) = normal(random);
      skew(i, j) = normal(random);
    }
  return a * a.transpose() + n * Eigen::MatrixXd::Identity(n, n) + unsymmetric * n * (skew - skew.transpose());
}

struct Solved {
  int iterations = 0;
  double error = 0.0;  // relative to the largest unknown
};

Solved solved(const Eigen::MatrixXd& a, const Eigen::MatrixXd& inverse, const Eigen::VectorXd& b, int most) {
  const auto n = static_cast<std::size_t>(b.size());
  const auto times = [](const Eigen::MatrixXd& m) {
    return [&m](std::span<const double> x, std::span<double> y) {
      Eigen::Map<Eigen::VectorXd>(y.data(), m.rows()) = m * Eigen::Map<const Eigen::VectorXd>(x.data(), m.cols());
    };
  };
  std::vector<double> x(n, 0.0), unit(n, b.cwiseAbs().maxCoeff());
  ConjugateResiduals residuals;
  Solved out;
  out.iterations =
      residuals.solve(times(a), times(inverse), std::span<const double>(b.data(), n), unit, 1e-12, most, x);
  const Eigen::VectorXd exact = solve_general(a, b);
  out.error = (Eigen::Map<const Eigen::VectorXd>(x.data(), b.size()) - exact).cwiseAbs().maxCoeff() /
              exact.cwiseAbs().maxCoeff();
  return out;
}

TEST(ConjugateResiduals, agrees_with_dense_algebra) {
  std::mt19937_64 random(31);
  for (const int n : {1, 2, 7, 30, 80})
    for (const double unsymmetric : {0.0, 0.1, 0.5}) {
      const Eigen::MatrixXd a = drawn(n, unsymmetric, random);
      const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
      const Eigen::MatrixXd symmetric = 0.5 * (a + a.transpose());
      for (const Eigen::MatrixXd& inverse :
           {inverse_of(symmetric), Eigen::MatrixXd(a.diagonal().cwiseInverse().asDiagonal())}) {
        const Solved s = solved(a, inverse, b, 2000);
        EXPECT_GE(s.iterations, 0) << n;
        EXPECT_LT(s.error, 1e-10) << n << ", " << unsymmetric;
      }
    }
}

TEST(ConjugateResiduals, ends_after_as_many_iterations_as_unknowns_and_at_once_with_the_inverse) {
  std::mt19937_64 random(32);
  for (const int n : {3, 10, 25}) {
    const Eigen::MatrixXd a = drawn(n, 0.3, random);
    const Eigen::VectorXd b = Eigen::VectorXd::Random(n);
    const Solved s = solved(a, Eigen::MatrixXd::Identity(n, n), b, 100);
    EXPECT_GE(s.iterations, 1);
    EXPECT_LE(s.iterations, n + 2);  // round-off may cost two more
    EXPECT_LE(solved(a, inverse_of(a), b, 100).iterations, 2);
  }
}

TEST(ConjugateResiduals, keep_corrections_in_single_precision_without_losing_a_bit) {
  std::mt19937_64 random(34);
  constexpr int kUnknowns = 60;
  const Eigen::MatrixXd a = drawn(kUnknowns, 0.4, random), symmetric = 0.5 * (a + a.transpose()),
                        inverse = inverse_of(symmetric);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(kUnknowns);
  const auto rounded = [&](std::span<const double> r, auto z) {
    const Eigen::VectorXd exact = inverse * Eigen::Map<const Eigen::VectorXd>(r.data(), kUnknowns);
    for (std::size_t i = 0; i < z.size(); ++i) z[i] = static_cast<float>(exact[static_cast<Eigen::Index>(i)]);
  };
  const auto times = [&](std::span<const double> x, std::span<double> y) {
    Eigen::Map<Eigen::VectorXd>(y.data(), kUnknowns) = a * Eigen::Map<const Eigen::VectorXd>(x.data(), kUnknowns);
  };
  const std::vector<double> unit(kUnknowns, 1.0);
  const std::span<const double> side(b.data(), kUnknowns);
  std::vector<double> in_double(kUnknowns, 0.0), in_single(kUnknowns, 0.0);
  ConjugateResiduals residuals;
  const int of_double = residuals.solve(
      times, [&](std::span<const double> r, std::span<double> z) { rounded(r, z); }, side, unit, 1e-13, 200, in_double);
  const int of_single = residuals.solve(
      times, [&](std::span<const double> r, std::span<float> z) { rounded(r, z); }, side, unit, 1e-13, 200, in_single);
  EXPECT_GT(of_double, 3);
  EXPECT_EQ(of_single, of_double);
  EXPECT_EQ(in_single, in_double);
}

TEST(ConjugateResiduals, says_where_it_is_not_there_in_time) {
  std::mt19937_64 random(33);
  const Eigen::MatrixXd a = drawn(30, 0.5, random);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(30);
  EXPECT_EQ(solved(a, Eigen::MatrixXd::Identity(30, 30), b, 5).iterations, -1);
  EXPECT_EQ(solved(a, Eigen::MatrixXd::Zero(30, 30), b, 100).iterations, -1);  // a preconditioner that is zero
}

TEST(ConjugateResiduals, residual_is_that_of_the_last_solution) {
  std::mt19937_64 random(5);
  constexpr std::size_t kSize = 30;
  const Eigen::MatrixXd a = drawn(kSize, 0.1, random);
  const Eigen::VectorXd b = Eigen::VectorXd::Random(kSize);
  std::vector<double> x(kSize, 0.0), unit(kSize);
  for (std::size_t i = 0; i < kSize; ++i) unit[i] = 1.0 + static_cast<double>(i);
  ConjugateResiduals residuals;
  const auto product = [&](std::span<const double> u, std::span<double> y) {
    Eigen::Map<Eigen::VectorXd>(y.data(), kSize) = a * Eigen::Map<const Eigen::VectorXd>(u.data(), kSize);
  };
  const auto inverse = [](std::span<const double> r, std::span<double> z) { std::copy(r.begin(), r.end(), z.begin()); };
  constexpr double kEnough = 1e-4;
  ASSERT_GT(residuals.solve(product, inverse, std::span<const double>(b.data(), kSize), unit, kEnough, 200, x), 0);
  const Eigen::VectorXd left = b - a * Eigen::Map<const Eigen::VectorXd>(x.data(), kSize);
  for (std::size_t i = 0; i < kSize; ++i)
    EXPECT_NEAR(residuals.residual()[i], left(static_cast<Eigen::Index>(i)) / unit[i], 1e-12);
  EXPECT_GT(left.cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace scree::coupling::conjugate_residuals_test
