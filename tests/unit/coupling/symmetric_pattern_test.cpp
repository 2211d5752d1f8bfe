// Sparse symmetric systems: places of summed matrices, and the factor that keeps its analysis.
#include "coupling/linear/symmetric_pattern.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Dense>
#include <optional>
#include <random>

#include "coupling/linear/cholesky.h"

namespace scree::coupling::symmetric_pattern_test {
namespace {

TEST(SymmetricPattern, sums_of_random_entries_equal_a_dense_matrix) {
  std::mt19937 generator(11);
  std::uniform_int_distribution<std::int32_t> index(0, 19);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<std::int32_t> i, j;
  std::vector<double> x;
  Eigen::MatrixXd dense = Eigen::MatrixXd::Zero(20, 20);
  for (int k = 0; k < 300; ++k) {
    i.push_back(index(generator));
    j.push_back(index(generator));
    x.push_back(any(generator));
    dense(i.back(), j.back()) += x.back();
    if (i.back() != j.back()) dense(j.back(), i.back()) += x.back();
  }
  SymmetricPattern pattern;
  const std::vector<std::int32_t> place = pattern.make(20, i, j);
  std::vector<double> values(pattern.size(), 0.0), v(20), y(20);
  for (std::size_t k = 0; k < x.size(); ++k) values[static_cast<std::size_t>(place[k])] += x[k];
  for (double& a : v) a = any(generator);
  pattern.multiply(values, v, y);
  pattern.multiply_add(2.0, values, v, y);
  const Eigen::VectorXd expected = 3.0 * dense * Eigen::Map<const Eigen::VectorXd>(v.data(), 20);
  EXPECT_LT((Eigen::Map<const Eigen::VectorXd>(y.data(), 20) - expected).norm(), 1e-13);
  for (std::size_t c = 0; c < 20; ++c)
    for (auto k = pattern.column_start[c]; k + 1 < pattern.column_start[c + 1]; ++k)
      EXPECT_LT(pattern.row[static_cast<std::size_t>(k)], pattern.row[static_cast<std::size_t>(k) + 1]);
}

TEST(SymmetricPattern, products_of_many_independent_blocks_have_the_same_bits_on_threads) {
  // Blocks of six unknowns; two that lie where a range of 1,024 unknowns would end are coupled.
  constexpr std::int32_t kBlocks = 2000, kUnknowns = 6 * kBlocks;
  std::vector<std::int32_t> i, j;
  for (std::int32_t b = 0; b < kBlocks; ++b)
    for (std::int32_t c = 0; c < 6; ++c)
      for (std::int32_t r = c; r < 6; ++r) {
        i.push_back(6 * b + r);
        j.push_back(6 * b + c);
      }
  i.push_back(1030);
  j.push_back(1020);
  SymmetricPattern pattern;
  const std::vector<std::int32_t> place = pattern.make(kUnknowns, i, j);
  std::mt19937 generator(12);
  std::uniform_real_distribution<double> any(-1.0, 1.0);
  std::vector<double> values(pattern.size()), x(kUnknowns), y(kUnknowns), first;
  for (double& a : values) a = any(generator);
  for (double& a : x) a = any(generator);
  std::vector<double> expected(kUnknowns, 0.0);
  for (std::size_t k = 0; k < i.size(); ++k) {
    const double a = values[static_cast<std::size_t>(place[k])];
    const auto row = static_cast<std::size_t>(i[k]), column = static_cast<std::size_t>(j[k]);
    expected[row] += a * x[column];
    if (row != column) expected[column] += a * x[row];
  }
  const int threads = omp_get_max_threads();
  for (const int count : {1, 2, 3}) {
    omp_set_num_threads(count);
    pattern.multiply(values, x, y);
    if (count == 1) first = y;
    EXPECT_EQ(y, first) << count;
  }
  omp_set_num_threads(threads);
  for (std::size_t k = 0; k < expected.size(); ++k) ASSERT_NEAR(y[k], expected[k], 1e-14) << k;
}

TEST(Cholesky, springs_join_the_fixed_part_and_only_new_lists_are_analysed) {
  // A chain of three unknowns; a spring between its ends comes, stays with another stiffness, and goes.
  SymmetricPattern chain;
  (void)chain.make(3, std::vector<std::int32_t>{0, 1, 1, 2, 2}, std::vector<std::int32_t>{0, 0, 1, 1, 2});
  const std::vector<double> values{2.0, -1.0, 2.0, -1.0, 2.0}, b{1.0, 2.0, 3.0};
  Eigen::Matrix3d A;
  A << 2.0, -1.0, 0.0, -1.0, 2.0, -1.0, 0.0, -1.0, 2.0;
  const Eigen::Vector3d ends(1.0, 0.0, -0.5);
  Cholesky cholesky;
  cholesky.set_pattern(chain);
  std::vector<double> x(3);
  const auto check = [&](std::optional<double> k) {
    DofRows rows;
    std::vector<double> scale;
    if (k) {
      rows.begin_row();
      rows.add(2, -0.5);
      rows.add(0, 1.0);
      scale.push_back(*k);
    }
    ASSERT_TRUE(cholesky.factorise(values, rows, scale));
    cholesky.solve(b, x);
    const Eigen::Vector3d expected =
        (A + k.value_or(0.0) * ends * ends.transpose()).inverse() * Eigen::Vector3d(1, 2, 3);
    EXPECT_LT((Eigen::Map<const Eigen::Vector3d>(x.data()) - expected).norm(), 1e-14);
  };
  check({});
  check(5.0);
  EXPECT_EQ(cholesky.analyses(), 2);
  check(0.0);
  check(7.0);
  EXPECT_EQ(cholesky.analyses(), 2);
  check({});  // there is a place more than it needs
  EXPECT_EQ(cholesky.analyses(), 2);
  const std::vector<double> indefinite{-1.0, 0.0, 1.0, 0.0, 1.0};
  EXPECT_FALSE(cholesky.factorise(indefinite, DofRows(), {}));
  EXPECT_FALSE(cholesky.factored());
}

}  // namespace
}  // namespace scree::coupling::symmetric_pattern_test
