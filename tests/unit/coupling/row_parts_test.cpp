// Parts of the rows of a block matrix.
#include "coupling/linear/row_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace scree::coupling::row_parts_test {
namespace {

using Pairs = std::vector<BlockMatrix::Pair>;

/// Rows of a grid, each coupled to those beside, above and below it, numbered in an order that is given.
BlockMatrix grid(int width, int height, const std::vector<std::int32_t>& number) {
  Pairs pairs;
  const auto row = [&](int i, int j) {
    return number[static_cast<std::size_t>(width) * static_cast<std::size_t>(j) + static_cast<std::size_t>(i)];
  };
  for (int j = 0; j < height; ++j)
    for (int i = 0; i < width; ++i) {
      if (i + 1 < width) pairs.push_back({row(i, j), row(i + 1, j)});
      if (j + 1 < height) pairs.push_back({row(i, j), row(i, j + 1)});
    }
  BlockMatrix out;
  out.set_pattern(width * height, pairs);
  return out;
}

std::vector<std::int32_t> in_turn(std::int32_t n) {
  std::vector<std::int32_t> out(static_cast<std::size_t>(n));
  std::iota(out.begin(), out.end(), 0);
  return out;
}

/// Every row once, and no block between two parts.
void expect_independent(const BlockMatrix& A, const RowParts& of) {
  std::vector<std::int32_t> sorted = of.order;
  std::ranges::sort(sorted);
  EXPECT_EQ(sorted, in_turn(A.rows()));
  ASSERT_EQ(of.begin.front(), 0);
  ASSERT_TRUE(std::ranges::is_sorted(of.begin));
  ASSERT_LE(of.separator(), A.rows());
  std::vector<std::int32_t> part(sorted.size(), -1);  // of a row; -1: in the separator
  for (std::int32_t p = 0; p < of.parts(); ++p)
    for (auto i = static_cast<std::size_t>(of.begin[static_cast<std::size_t>(p)]);
         i < static_cast<std::size_t>(of.begin[static_cast<std::size_t>(p) + 1]); ++i)
      part[static_cast<std::size_t>(of.order[i])] = p;
  for (std::int32_t i = 0; i < A.rows(); ++i)
    for (std::int32_t k = A.row_begin(i); k < A.row_begin(i + 1); ++k) {
      const std::int32_t p = part[static_cast<std::size_t>(i)], q = part[static_cast<std::size_t>(A.column(k))];
      EXPECT_TRUE(p == q || p < 0 || q < 0) << i << ", " << A.column(k);
    }
}

TEST(RowParts, leaves_one_part_in_its_own_order) {
  const BlockMatrix A = grid(4, 3, in_turn(12));
  const RowParts of = cut_rows(A, 1);
  EXPECT_EQ(of.order, in_turn(12));
  EXPECT_EQ(of.parts(), 1);
  EXPECT_EQ(of.separator(), 12);
}

TEST(RowParts, cuts_a_strip_into_equal_parts_across_its_width) {
  // Whatever the order of the rows: distances from one end, not numbers, decide.
  std::mt19937_64 random(59);
  std::vector<std::int32_t> number = in_turn(5 * 200);
  for (const bool shuffled : {false, true}) {
    if (shuffled) std::ranges::shuffle(number, random);
    const BlockMatrix A = grid(5, 200, number);
    for (const std::int32_t parts : {2, 4, 8}) {
      const RowParts of = cut_rows(A, parts);
      ASSERT_EQ(of.parts(), parts);
      expect_independent(A, of);
      EXPECT_LE(A.rows() - of.separator(), 5 * (parts - 1));
      const std::int32_t equal = A.rows() / parts;
      for (std::size_t p = 0; p < static_cast<std::size_t>(parts); ++p)
        EXPECT_NEAR(of.begin[p + 1] - of.begin[p], equal, 5) << p;
    }
  }
}

TEST(RowParts, cuts_pieces_that_are_not_connected_and_rows_that_touch_nothing) {
  Pairs pairs;
  for (int piece = 0; piece < 7; ++piece)
    for (int i = 0; i + 1 < 20; ++i) pairs.push_back({30 * piece + i, 30 * piece + i + 1});
  BlockMatrix A;
  A.set_pattern(7 * 30, pairs);
  for (const std::int32_t parts : {2, 3, 8}) {
    const RowParts of = cut_rows(A, parts);
    expect_independent(A, of);
    EXPECT_LT(A.rows() - of.separator(), parts);
  }
  A.set_pattern(3, {});
  expect_independent(A, cut_rows(A, 8));  // more parts than rows
  A.set_pattern(0, {});
  expect_independent(A, cut_rows(A, 2));
}

}  // namespace
}  // namespace scree::coupling::row_parts_test
