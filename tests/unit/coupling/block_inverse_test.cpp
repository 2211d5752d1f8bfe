// Inverse of a block against dense algebra, with and without exchanges of rows.
#include "coupling/linear/block_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "model/dense_algebra.h"

namespace scree::coupling::block_inverse_test {
namespace {

using Block = Eigen::Matrix<double, kBlockSide, kBlockSide>;

FloatBlock rounded(const Block& m) {
  FloatBlock out{};
  for (int c = 0; c < kBlockSide; ++c)
    for (int r = 0; r < kBlockSide; ++r) out.column[c][r] = static_cast<float>(m(r, c));
  return out;
}

Block read(const FloatBlock& m) {
  Block out;
  for (int c = 0; c < kBlockSide; ++c)
    for (int r = 0; r < kBlockSide; ++r) out(r, c) = static_cast<double>(m.column[c][r]);
  return out;
}

/// Positive definite, with a part that is not symmetric, as friction makes it.
Block drawn(std::mt19937_64& random, double friction) {
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  Block g, f;
  for (Block* m : {&g, &f})
    for (int c = 0; c < kBlockSide; ++c)
      for (int r = 0; r < kBlockSide; ++r) (*m)(r, c) = number(random);
  return g * g.transpose() + 0.2 * Block::Identity() + friction * f;
}

const std::vector<double> kOnes(kBlockSide, 1.0);

/// Largest number of inverse times block, less one.
double error_of(const Block& m, const std::vector<double>& unit) {
  FloatBlock inverse = rounded(m);
  const Block taken = read(inverse);
  if (!invert(inverse, unit.data())) return std::nan("");
  return (read(inverse) * taken - Block::Identity()).cwiseAbs().maxCoeff();
}

TEST(BlockInverse, of_blocks_drawn_at_random) {
  std::mt19937_64 random(7);
  for (int n = 0; n < 200; ++n) EXPECT_LT(error_of(drawn(random, n % 2 == 0 ? 0.0 : 0.3), kOnes), 1e-4) << n;
}

TEST(BlockInverse, of_rows_in_any_order) {
  // In the given order the first pivot of the exchanged block is zero, or nearly so.
  std::mt19937_64 random(8);
  for (const double first : {0.0, 1e-5, -1e-5, 1e-14}) {
    Block m = drawn(random, 0.0);
    m.row(0).swap(m.row(4));
    m.row(1).swap(m.row(5));
    m(0, 0) = first;
    EXPECT_LT(error_of(m, kOnes), 1e-4) << first;
  }
}

TEST(BlockInverse, of_indefinite_blocks) {
  std::mt19937_64 random(9);
  EXPECT_LT(error_of(-drawn(random, 0.1), kOnes), 1e-4);
  Block m = drawn(random, 0.1);
  m.row(2) *= -1.0;
  EXPECT_LT(error_of(m, kOnes), 1e-4);
}

TEST(BlockInverse, compares_pivots_in_their_units) {
  // Powers of two cause no round-off: the same inverse in other units, where numbers differ by 2^60.
  std::mt19937_64 random(10);
  const std::vector<double> unit{1.0, 1.0, std::ldexp(1.0, 15), std::ldexp(1.0, -15), std::ldexp(1.0, 15), 2.0};
  const Block m = drawn(random, 0.2);
  Block scaled = m;
  for (int c = 0; c < kBlockSide; ++c)
    for (int r = 0; r < kBlockSide; ++r)
      scaled(r, c) *= unit[static_cast<std::size_t>(r)] * unit[static_cast<std::size_t>(c)];
  FloatBlock one = rounded(m), other = rounded(scaled);
  ASSERT_TRUE(invert(one, kOnes.data()));
  ASSERT_TRUE(invert(other, unit.data()));
  for (int c = 0; c < kBlockSide; ++c)
    for (int r = 0; r < kBlockSide; ++r)
      EXPECT_EQ(read(other)(r, c) * unit[static_cast<std::size_t>(r)] * unit[static_cast<std::size_t>(c)],
                read(one)(r, c));
}

TEST(BlockInverse, says_what_it_cannot_invert) {
  std::mt19937_64 random(11);
  const Block good = drawn(random, 0.0);
  EXPECT_TRUE(std::isnan(error_of(Block::Zero(), kOnes)));
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL})
    for (const int at : {0, 7, 16, 35}) {
      Block m = good;
      m(at % kBlockSide, at / kBlockSide) = bad;
      EXPECT_TRUE(std::isnan(error_of(m, kOnes))) << bad << ", " << at;
    }
  Block twice = good;
  twice.row(5) = twice.row(1);
  EXPECT_TRUE(std::isnan(error_of(twice, kOnes)));
}

}  // namespace
}  // namespace scree::coupling::block_inverse_test
