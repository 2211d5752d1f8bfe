// Decompositions compared with their definitions, on matrices for which a wrong transposition or order gives an error.
#include "model/dense_algebra.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <vector>

namespace scree::dense_algebra_test {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

MatrixXd drawn(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  MatrixXd A(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j)
    for (Eigen::Index i = 0; i < rows; ++i) A(i, j) = normal(random);
  return A;
}
MatrixXd symmetric(Eigen::Index n, unsigned seed) {
  const MatrixXd A = drawn(n, n, seed);
  return A + A.transpose();
}
MatrixXd positive(Eigen::Index n, unsigned seed) {
  const MatrixXd A = drawn(n, n, seed);
  return A * A.transpose() + 0.5 * MatrixXd::Identity(n, n);
}
/// Orthonormal columns, by Gram and Schmidt, twice.
MatrixXd orthonormal(Eigen::Index rows, Eigen::Index columns, unsigned seed) {
  MatrixXd Q = drawn(rows, columns, seed);
  for (int again = 0; again < 2; ++again)
    for (Eigen::Index j = 0; j < columns; ++j) {
      for (Eigen::Index i = 0; i < j; ++i) Q.col(j) -= Q.col(i).dot(Q.col(j)) * Q.col(i);
      Q.col(j).normalize();
    }
  return Q;
}
double apart(const MatrixXd& a, const MatrixXd& b) {
  EXPECT_EQ(a.rows(), b.rows());
  EXPECT_EQ(a.cols(), b.cols());
  return (a - b).cwiseAbs().maxCoeff();
}
bool ascends(const VectorXd& v) { return std::is_sorted(v.data(), v.data() + v.size()); }

TEST(DenseAlgebra, symmetric_modes_are_orthonormal_and_ascend) {
  for (const int n : {1, 2, 5, 40}) {
    const MatrixXd A = symmetric(n, 1), I = MatrixXd::Identity(n, n);
    const Modes m = symmetric_modes(A);
    EXPECT_LT(apart(A * m.vectors, m.vectors * m.values.asDiagonal()), 1e-12) << n;
    EXPECT_LT(apart(m.vectors.transpose() * m.vectors, I), 1e-12) << n;
    EXPECT_TRUE(ascends(m.values)) << n;
    EXPECT_LT(apart(symmetric_eigenvalues(A), m.values), 1e-12) << n;
  }
}

TEST(DenseAlgebra, symmetric_eigenvalues_of_a_fixed_size_and_of_the_lower_triangle) {
  const Eigen::Matrix2d A = (Eigen::Matrix2d() << 2.0, 1e9, 1.0, 2.0).finished();  // the upper triangle is not used
  EXPECT_LT(apart(symmetric_eigenvalues(A), Eigen::Vector2d(1.0, 3.0)), 1e-15);
}

TEST(DenseAlgebra, generalized_modes_are_orthonormal_in_the_second_matrix) {
  for (const int n : {1, 2, 5, 40}) {
    const MatrixXd A = symmetric(n, 2), B = positive(n, 3), I = MatrixXd::Identity(n, n);
    const Modes m = generalized_modes(A, B);
    const double size = m.values.cwiseAbs().maxCoeff() * (B * m.vectors).cwiseAbs().maxCoeff();
    EXPECT_LT(apart(A * m.vectors, B * m.vectors * m.values.asDiagonal()), 1e-12 * size) << n;
    EXPECT_LT(apart(m.vectors.transpose() * B * m.vectors, I), 1e-11) << n;
    EXPECT_TRUE(ascends(m.values)) << n;
    EXPECT_LT(apart(generalized_eigenvalues(A, B), m.values), 1e-11 * m.values.cwiseAbs().maxCoeff()) << n;
  }
}

TEST(DenseAlgebra, eigenvalues_of_a_general_matrix_may_be_complex) {
  // Blocks [a b; -b a] with eigenvalues a +- i b and one real eigenvalue, after a change of basis.
  MatrixXd D = MatrixXd::Zero(5, 5);
  D.topLeftCorner<2, 2>() << 1.0, 2.0, -2.0, 1.0;
  D.block<2, 2>(2, 2) << -3.0, 0.5, -0.5, -3.0;
  D(4, 4) = 0.25;
  D(0, 4) = 7.0;  // makes the matrix non-normal
  const MatrixXd T = drawn(5, 5, 4) + 4.0 * MatrixXd::Identity(5, 5);
  const Eigen::VectorXcd found = eigenvalues(T * D * inverse_of(T));
  ASSERT_EQ(found.size(), 5);
  std::vector<std::complex<double>> left(found.data(), found.data() + found.size());
  for (const std::complex<double> z : {std::complex(1.0, 2.0), std::complex(1.0, -2.0), std::complex(-3.0, 0.5),
                                       std::complex(-3.0, -0.5), std::complex(0.25, 0.0)}) {
    const auto at = std::min_element(left.begin(), left.end(),
                                     [&](const auto& a, const auto& b) { return std::abs(a - z) < std::abs(b - z); });
    EXPECT_LT(std::abs(*at - z), 1e-11) << z;
    left.erase(at);
  }
}

TEST(DenseAlgebra, singular_values_descend_and_are_those_that_were_put_in) {
  const VectorXd s = (VectorXd(4) << 9.0, 3.0, 0.5, 1e-3).finished();
  const MatrixXd A = orthonormal(7, 4, 5) * s.asDiagonal() * orthonormal(4, 4, 6).transpose();
  EXPECT_LT(apart(singular_values(A), s), 1e-14);
  EXPECT_LT(apart(singular_values(A.transpose()), s), 1e-14);
}

TEST(DenseAlgebra, cholesky_factor_is_lower_and_has_the_matrix_as_its_square) {
  for (const int n : {1, 2, 5, 40}) {
    MatrixXd A = positive(n, 7);
    const MatrixXd L = cholesky_factor(A);
    EXPECT_LT(apart(L * L.transpose(), A), 1e-12 * A.cwiseAbs().maxCoeff()) << n;
    EXPECT_EQ(apart(L.triangularView<Eigen::Lower>(), L), 0.0) << n;
    EXPECT_GT(L.diagonal().minCoeff(), 0.0) << n;
    A(n - 1, n - 1) *= -1.0;
    EXPECT_TRUE(cholesky_factor(A).array().isNaN().all()) << n;
  }
  EXPECT_EQ(cholesky_factor(MatrixXd(0, 0)).size(), 0);
}

TEST(DenseAlgebra, solutions_leave_no_residual) {
  for (const int n : {1, 2, 5, 40}) {
    const MatrixXd B = drawn(n, 3, 8), A = positive(n, 9), G = drawn(n, n, 10), I = MatrixXd::Identity(n, n);
    EXPECT_LT(apart(A * solve_positive(A, B), B), 1e-10) << n;
    EXPECT_LT(apart(A * solve_symmetric(A, B), B), 1e-10) << n;
    EXPECT_LT(apart(-A * solve_symmetric(-A, B), B), 1e-10) << n;
    EXPECT_LT(apart(G * solve_general(G, B), B), 1e-10) << n;
    EXPECT_LT(apart(G * inverse_of(G), I), 1e-10) << n;
    EXPECT_LT(apart(G * least_squares(G, B), B), 1e-10) << n;
    const VectorXd x = solve_general(G, B.col(0));  // one right-hand side
    EXPECT_LT(apart(G * x, B.col(0)), 1e-10) << n;
  }
}

TEST(DenseAlgebra, least_squares_leaves_a_residual_across_the_columns) {
  const MatrixXd A = drawn(9, 4, 11), B = drawn(9, 2, 12), X = least_squares(A, B);
  ASSERT_EQ(X.rows(), 4);
  ASSERT_EQ(X.cols(), 2);
  EXPECT_LT((A.transpose() * (A * X - B)).cwiseAbs().maxCoeff(), 1e-13);
  EXPECT_GT((A * X - B).norm(), 0.1);
}

}  // namespace
}  // namespace scree::dense_algebra_test
