#include "coupling/integrate/gmres.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace scree::coupling {
namespace {

Eigen::MatrixXd random_matrix(Eigen::Index n, std::mt19937_64& random) {
  Eigen::MatrixXd A(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    for (Eigen::Index i = 0; i < n; ++i) A(i, j) = static_cast<double>(random() >> 11) * 0x1p-53 - 0.5;
  return A;
}

TEST(Gmres, solves_what_is_not_symmetric) {
  std::mt19937_64 random(3);
  for (const Eigen::Index n : {1, 2, 7, 60}) {
    const Eigen::MatrixXd A = random_matrix(n, random) + 2.0 * Eigen::MatrixXd::Identity(n, n);
    const Eigen::VectorXd wanted = random_matrix(n, random).col(0);
    Eigen::VectorXd x;
    ASSERT_TRUE(gmres([&](const Eigen::VectorXd& v) { return Eigen::VectorXd(A * v); }, A * wanted, 1e-13, x)) << n;
    EXPECT_LT((x - wanted).norm(), 1e-10 * wanted.norm()) << n;
  }
}

TEST(Gmres, goes_on_after_a_restart) {
  // Eigenvalues from 1 to 16 and a part that is not symmetric: more vectors than are kept.
  std::mt19937_64 random(5);
  const Eigen::Index n = 300;
  Eigen::MatrixXd A = 0.3 * random_matrix(n, random);
  for (Eigen::Index i = 0; i < n; ++i) A(i, i) += 4.0 + 12.0 * static_cast<double>(i) / static_cast<double>(n);
  const Eigen::VectorXd wanted = random_matrix(n, random).col(0);
  Eigen::VectorXd x;
  ASSERT_TRUE(gmres([&](const Eigen::VectorXd& v) { return Eigen::VectorXd(A * v); }, A * wanted, 1e-13, x));
  EXPECT_LT((x - wanted).norm(), 1e-9 * wanted.norm());
}

TEST(Gmres, says_that_a_singular_system_has_no_solution) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Identity(5, 5);
  A(4, 4) = 0.0;
  Eigen::VectorXd x;
  EXPECT_FALSE(
      gmres([&](const Eigen::VectorXd& v) { return Eigen::VectorXd(A * v); }, Eigen::VectorXd::Ones(5), 1e-13, x));
}

}  // namespace
}  // namespace scree::coupling
