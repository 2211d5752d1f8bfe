// Block matrix and its incomplete factor against dense algebra.
#include "coupling/linear/block_ilu.h"

#include <gtest/gtest.h>
#include <omp.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

#include "coupling/linear/conjugate_residuals.h"
#include "model/dense_algebra.h"

namespace scree::coupling::block_ilu_test {
namespace {

using Pairs = std::vector<BlockMatrix::Pair>;

/// Bodies in a row, each coupled to the next.
Pairs chain(int n) {
  Pairs out;
  for (int i = 0; i + 1 < n; ++i) out.push_back({i, i + 1});
  return out;
}

/// Pairs drawn at random, some repeatedly and in both orders.
Pairs drawn_pairs(int n, int count, std::mt19937_64& random) {
  std::uniform_int_distribution<int> body(0, n - 1);
  Pairs out;
  while (static_cast<int>(out.size()) < count) {
    const int i = body(random), j = body(random);
    if (i == j) continue;
    out.push_back({i, j});
    if (out.size() % 3 == 0) out.push_back({j, i});
  }
  return out;
}

/// A system like that of contacts: a positive definite block per body and springs k h h^T between the bodies of each
/// pair, some with friction h_t k tan(phi) h_n^T.
struct System {
  BlockMatrix blocks;
  Eigen::MatrixXd dense;
  std::vector<double> unit;

  System(int n, const Pairs& pairs, double stiffness, double friction, std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    blocks.set_pattern(n, pairs);
    unit.assign(6 * static_cast<std::size_t>(n), 1.0);
    dense = Eigen::MatrixXd::Zero(6 * n, 6 * n);
    for (int i = 0; i < n; ++i) {
      Eigen::Matrix<double, 6, 6> g;
      for (double& x : g.reshaped()) x = normal(random);
      dense.block<6, 6>(6 * i, 6 * i) = g * g.transpose() + Eigen::Matrix<double, 6, 6>::Identity();
    }
    for (const BlockMatrix::Pair& p : pairs) {
      Eigen::VectorXd h = Eigen::VectorXd::Zero(6 * n), t = h;
      for (const int i : p)
        for (int k = 0; k < 6; ++k) {
          h(6 * i + k) = normal(random);
          t(6 * i + k) = normal(random);
        }
      dense += stiffness * h * h.transpose() + friction * stiffness * t * h.transpose();
    }
    for (int i = 0; i < n; ++i)
      for (std::int32_t k = blocks.row_begin(i); k < blocks.row_begin(i + 1); ++k)
        Eigen::Map<Eigen::Matrix<double, 6, 6>>(blocks.block(k)) = dense.block<6, 6>(6 * i, 6 * blocks.column(k));
  }
  [[nodiscard]] Eigen::VectorXd drawn_side(std::mt19937_64& random) const {
    std::normal_distribution<double> normal;
    Eigen::VectorXd b(dense.rows());
    for (double& x : b) x = normal(random);
    return b;
  }
};

std::span<const double> span_of(const Eigen::VectorXd& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }
std::span<double> span_of(Eigen::VectorXd& x) { return {x.data(), static_cast<std::size_t>(x.size())}; }

Eigen::VectorXd preconditioned(BlockIlu& ilu, const Eigen::VectorXd& r) {
  std::vector<float> z(static_cast<std::size_t>(r.size()));
  ilu.solve(span_of(r), z);
  return Eigen::Map<const Eigen::VectorXf>(z.data(), r.size()).cast<double>();
}

double relative_error(const Eigen::VectorXd& x, const Eigen::VectorXd& exact) {
  return (x - exact).cwiseAbs().maxCoeff() / exact.cwiseAbs().maxCoeff();
}

TEST(BlockMatrix, multiplies_as_the_dense_matrix) {
  std::mt19937_64 random(51);
  for (const int n : {1, 2, 5, 24}) {
    const System s(n, n > 1 ? drawn_pairs(n, 3 * n, random) : Pairs{}, 10.0, 0.5, random);
    const Eigen::VectorXd x = s.drawn_side(random);
    Eigen::VectorXd y = Eigen::VectorXd::Constant(x.size(), std::numeric_limits<double>::quiet_NaN());
    s.blocks.multiply(span_of(x), span_of(y));
    // 200 products at most in a sum, each to half a unit in its last place.
    EXPECT_LT(relative_error(y, s.dense * x), 1e-13) << n;
  }
}

TEST(BlockMatrix, has_a_place_for_every_pair_in_both_orders_and_for_no_other) {
  BlockMatrix m;
  m.set_pattern(4, Pairs{{2, 0}, {0, 2}, {3, 2}, {2, 0}});
  EXPECT_EQ(m.rows(), 4);
  EXPECT_EQ(m.blocks(), 8u);
  for (const auto& [i, j] : Pairs{{0, 2}, {2, 0}, {2, 3}, {3, 2}, {0, 0}, {1, 1}}) {
    ASSERT_GE(m.find(i, j), 0);
    EXPECT_EQ(m.column(m.find(i, j)), j);
    EXPECT_GE(m.find(i, j), m.row_begin(i));
    EXPECT_LT(m.find(i, j), m.row_begin(i + 1));
  }
  EXPECT_EQ(m.diagonal(1), m.find(1, 1));
  EXPECT_EQ(m.find(0, 1), -1);
  EXPECT_EQ(m.find(3, 0), -1);
  m.block(m.find(2, 0))[7] = 3.0;
  m.block(m.find(0, 2))[7] = 4.0;
  m.clear_row(2);
  EXPECT_EQ(m.block(m.find(2, 0))[7], 0.0);
  EXPECT_EQ(m.block(m.find(0, 2))[7], 4.0);
  m.set_pattern(0, {});
  EXPECT_EQ(m.rows(), 0);
}

TEST(BlockMatrix, recognises_the_pairs_of_its_pattern_in_any_order) {
  BlockMatrix m;
  const Pairs pairs{{2, 0}, {3, 2}, {1, 4}};
  Pairs places;
  const auto has_pattern = [&](int n, const Pairs& of) {
    m.find(of, places);
    return m.has_pattern(n, of, places);
  };
  m.set_pattern(5, pairs);
  EXPECT_TRUE(has_pattern(5, pairs));
  for (std::size_t p = 0; p < pairs.size(); ++p)
    EXPECT_EQ(places[p], (BlockMatrix::Pair{m.find(pairs[p][0], pairs[p][1]), m.find(pairs[p][1], pairs[p][0])}));
  EXPECT_TRUE(has_pattern(5, Pairs{{4, 1}, {0, 2}, {4, 1}, {2, 3}, {2, 2}, {1, 4}}));
  EXPECT_FALSE(has_pattern(5, Pairs{{2, 0}, {3, 2}}));                  // one is missing
  EXPECT_FALSE(has_pattern(5, Pairs{{2, 0}, {3, 2}, {0, 2}}));          // the same, one listed twice
  EXPECT_FALSE(has_pattern(5, Pairs{{2, 0}, {3, 2}, {1, 4}, {1, 0}}));  // one more
  EXPECT_FALSE(has_pattern(6, pairs));
  m.set_pattern(2, {});
  EXPECT_TRUE(has_pattern(2, {}));
}

TEST(BlockIlu, exchanges_rows_where_a_pivot_is_zero) {
  // Columns of the unit matrix in another order, with factors: every pivot but the last is zero where rows stay.
  const std::array<int, 6> order{3, 0, 5, 1, 2, 4};
  BlockMatrix m;
  m.set_pattern(1, {});
  std::fill_n(m.block(0), kBlockSize, 0.0);
  for (int c = 0; c < 6; ++c) m.block(0)[6 * c + order[static_cast<std::size_t>(c)]] = std::ldexp(1.0, c);
  BlockIlu ilu;
  ASSERT_TRUE(ilu.factorise(m, std::vector<double>(6, 1.0)));
  Eigen::VectorXd b(6), x(6);
  for (int c = 0; c < 6; ++c) {
    x(c) = c + 1.0;
    b(order[static_cast<std::size_t>(c)]) = std::ldexp(x(c), c);
  }
  EXPECT_EQ(preconditioned(ilu, b), x);
}

TEST(BlockIlu, is_the_inverse_where_elimination_fills_nothing) {
  std::mt19937_64 random(52);
  for (const int n : {1, 2, 3, 30})
    for (const double friction : {0.0, 0.6}) {
      const System s(n, chain(n), 20.0, friction, random);
      BlockIlu ilu;
      ASSERT_TRUE(ilu.factorise(s.blocks, s.unit));
      const Eigen::VectorXd b = s.drawn_side(random);
      // Single precision, times a condition of some hundreds.
      EXPECT_LT(relative_error(preconditioned(ilu, b), solve_general(s.dense, b)), 2e-4) << n << ", " << friction;
    }
}

TEST(BlockIlu, has_the_numbers_of_the_matrix_on_its_pattern_and_where_that_fills) {
  std::mt19937_64 random(53);
  const int n = 12;
  const System s(n, drawn_pairs(n, 14, random), 2.0, 0.3, random);
  BlockIlu ilu;
  ASSERT_TRUE(ilu.factorise(s.blocks, s.unit));
  Eigen::MatrixXd inverse(6 * n, 6 * n);
  for (int k = 0; k < 6 * n; ++k) inverse.col(k) = preconditioned(ilu, Eigen::VectorXd::Unit(6 * n, k));
  const Eigen::MatrixXd product = inverse_of(inverse);
  const auto kept = [&](int i, int j) {
    bool out = s.blocks.find(i, j) >= 0;
    for (int k = 0; k < std::min(i, j); ++k) out = out || (s.blocks.find(i, k) >= 0 && s.blocks.find(k, j) >= 0);
    return out;
  };
  double apart = 0.0, beside = 0.0;
  int filled = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double difference = (product - s.dense).block<6, 6>(6 * i, 6 * j).cwiseAbs().maxCoeff();
      (kept(i, j) ? apart : beside) = std::max(kept(i, j) ? apart : beside, difference);
      filled += kept(i, j) && s.blocks.find(i, j) < 0 ? 1 : 0;
    }
  EXPECT_GT(filled, 4);
  EXPECT_LT(apart, 1e-4 * s.dense.cwiseAbs().maxCoeff());
  EXPECT_GT(beside, 1e-3 * s.dense.cwiseAbs().maxCoeff());  // the factor is not that of A
}

/// A wall of blocks whose springs are a hundred times as stiff as the blocks; each has six neighbours.
struct Wall {
  BlockMatrix blocks;
  std::vector<double> unit, right_side;

  Wall(int courses, int width, std::mt19937_64& random) {
    Pairs pairs;
    for (int j = 0; j < courses; ++j)
      for (int i = 0; i < width; ++i) {
        const int b = width * j + i;
        if (i + 1 < width) pairs.push_back({b, b + 1});
        if (j + 1 < courses) pairs.push_back({b, b + width});
        if (j + 1 < courses && i > 0) pairs.push_back({b, b + width - 1});
      }
    const int n = courses * width;
    blocks.set_pattern(n, pairs);
    unit.assign(6 * static_cast<std::size_t>(n), 1.0);
    std::normal_distribution<double> normal;
    right_side.resize(unit.size());
    for (double& x : right_side) x = normal(random);
    using Block = Eigen::Map<Eigen::Matrix<double, 6, 6>>;
    for (int i = 0; i < n; ++i) {
      blocks.clear_row(i);
      Block(blocks.block(blocks.diagonal(i))).setIdentity();
    }
    for (const BlockMatrix::Pair& p : pairs)
      for (int spring = 0; spring < 4; ++spring) {
        std::array<Eigen::Vector<double, 6>, 2> h;
        for (auto& v : h)
          for (double& x : v) x = normal(random);
        for (int a = 0; a < 2; ++a)
          for (int b = 0; b < 2; ++b)
            Block(blocks.block(blocks.find(p[static_cast<std::size_t>(a)], p[static_cast<std::size_t>(b)]))) +=
                100.0 * h[static_cast<std::size_t>(a)] * h[static_cast<std::size_t>(b)].transpose();
      }
  }
  /// Iterations until no number of the residual is above 1e-9.
  int solve(BlockIlu& ilu, std::vector<double>& x) const {
    ConjugateResiduals residuals;
    x.assign(unit.size(), 0.0);
    return residuals.solve([&](std::span<const double> v, std::span<double> y) { blocks.multiply(v, y); },
                           [&](std::span<const double> r, std::span<float> z) { ilu.solve(r, z); }, right_side, unit,
                           1e-9, 400, x);
  }
};

TEST(BlockIlu, couples_the_parts_of_a_large_matrix) {
  // 2,970 rows stay whole, 3,025 are two parts and a separator. Where the coupling of parts was left out, the number of
  // iterations was three times as large.
  std::mt19937_64 random(57);
  std::vector<double> x;
  BlockIlu ilu;
  const Wall whole(54, 55, random), cut(55, 55, random);
  ASSERT_TRUE(ilu.factorise(whole.blocks, whole.unit));
  const int of_whole = whole.solve(ilu, x);
  ASSERT_TRUE(ilu.factorise(cut.blocks, cut.unit));  // of another pattern
  const int of_cut = cut.solve(ilu, x);
  EXPECT_GT(of_whole, 4);
  EXPECT_GE(of_cut, 4);
  EXPECT_LE(of_cut, 1.5 * of_whole) << of_whole;
}

TEST(BlockIlu, has_the_same_bits_for_any_number_of_threads) {
  std::mt19937_64 random(58);
  const Wall wall(70, 60, random);
  const int threads = omp_get_max_threads();
  std::vector<double> first, x;
  for (const int count : {1, 2, 3}) {
    omp_set_num_threads(count);
    BlockIlu ilu;
    ASSERT_TRUE(ilu.factorise(wall.blocks, wall.unit));
    EXPECT_GT(wall.solve(ilu, x), 0);
    if (count == 1) first = x;
    EXPECT_EQ(x, first) << count;
  }
  omp_set_num_threads(threads);
}

TEST(BlockIlu, does_not_depend_on_the_units_of_the_unknowns) {
  std::mt19937_64 random(54);
  const int n = 12;
  const System s(n, drawn_pairs(n, 25, random), 5.0, 0.5, random);
  // The unknowns of rotation and strain multiply lengths: their values depend on the unit of length. Powers of two
  // cause no round-off.
  Eigen::VectorXd unit(6 * n);
  for (int k = 0; k < 6 * n; ++k) unit(k) = k % 6 < 2 ? 1.0 : 1024.0;
  const std::vector<double> units(unit.data(), unit.data() + unit.size());
  BlockMatrix other = s.blocks;
  for (int i = 0; i < n; ++i)
    for (std::int32_t k = other.row_begin(i); k < other.row_begin(i + 1); ++k)
      for (int c = 0; c < 6; ++c)
        for (int r = 0; r < 6; ++r) other.block(k)[6 * c + r] *= unit(6 * i + r) * unit(6 * other.column(k) + c);
  BlockIlu first, second;
  ASSERT_TRUE(first.factorise(s.blocks, s.unit));
  ASSERT_TRUE(second.factorise(other, units));
  const Eigen::VectorXd b = s.drawn_side(random);
  const Eigen::VectorXd z = preconditioned(first, b), scaled = preconditioned(second, b.cwiseProduct(unit));
  for (int k = 0; k < 6 * n; ++k) EXPECT_EQ(scaled(k) * unit(k), z(k)) << k;
}

TEST(BlockIlu, says_where_a_pivot_fails) {
  std::mt19937_64 random(55);
  const System s(5, chain(5), 10.0, 0.0, random);
  const auto spoilt = [&](auto&& spoil) {
    BlockMatrix m = s.blocks;
    spoil(m);
    BlockIlu ilu;
    const bool made = ilu.factorise(m, s.unit);
    EXPECT_EQ(made, ilu.made());
    return !made;
  };
  EXPECT_FALSE(spoilt([](BlockMatrix&) {}));
  EXPECT_TRUE(spoilt([](BlockMatrix& m) { m.clear_row(3); }));
  EXPECT_TRUE(spoilt([](BlockMatrix& m) { m.block(m.diagonal(2))[0] = std::numeric_limits<double>::quiet_NaN(); }));
  EXPECT_TRUE(spoilt([](BlockMatrix& m) { m.block(m.diagonal(1))[14] = std::numeric_limits<double>::infinity(); }));
  EXPECT_FALSE(spoilt([](BlockMatrix& m) { m.block(m.diagonal(4))[21] = -1e3; }));  // an indefinite one has a factor
  EXPECT_TRUE(spoilt([](BlockMatrix& m) {  // two unknowns that single precision cannot tell apart
    m.clear_row(0);
    for (int k = 0; k < 6; ++k) m.block(m.diagonal(0))[7 * k] = 1.0;
    m.block(m.diagonal(0))[1] = m.block(m.diagonal(0))[6] = 1.0 - 1e-9;
  }));
}

TEST(BlockIlu, makes_conjugate_residuals_meet_the_dense_solution) {
  std::mt19937_64 random(56);
  ConjugateResiduals residuals;
  // Springs ten times as stiff as a block. At a hundred times, in directions drawn at random, the factor of single
  // precision no longer leads to a solution within 200 iterations for 80 blocks with friction: such passes fall back to
  // a complete one.
  for (const int n : {2, 20, 80})
    for (const double friction : {0.0, 0.6}) {
      const System s(n, drawn_pairs(n, 2 * n, random), 10.0, friction, random);
      BlockIlu ilu;
      ASSERT_TRUE(ilu.factorise(s.blocks, s.unit));
      const Eigen::VectorXd b = s.drawn_side(random);
      const std::vector<double> unit(static_cast<std::size_t>(b.size()), b.cwiseAbs().maxCoeff());
      Eigen::VectorXd x = Eigen::VectorXd::Zero(b.size());
      const int taken =
          residuals.solve([&](std::span<const double> v, std::span<double> y) { s.blocks.multiply(v, y); },
                          [&](std::span<const double> r, std::span<float> z) { ilu.solve(r, z); }, span_of(b), unit,
                          1e-13, 200, span_of(x));
      EXPECT_GE(taken, 1) << n << ", " << friction;
      EXPECT_LT(taken, 100) << n << ", " << friction;
      EXPECT_LT(relative_error(x, solve_general(s.dense, b)), 1e-10) << n << ", " << friction;
    }
}

}  // namespace
}  // namespace scree::coupling::block_ilu_test
