#include "coupling/linear/dof_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <random>
#include <vector>

namespace scree::coupling::dof_rows_test {
namespace {

constexpr std::size_t kBody = 6;

/// A row as a table of numbers.
using Table = std::map<std::int32_t, double>;

void expect_row(const DofRow& row, const Table& table) {
  ASSERT_EQ(row.dof.size(), table.size());
  std::size_t k = 0;
  for (const auto& [dof, h] : table) {
    EXPECT_EQ(row.dof[k], dof);
    EXPECT_EQ(row.h[k], h);
    ++k;
  }
}

TEST(DofRows, sum_runs_in_any_order_as_a_table_does) {
  std::mt19937_64 random(71);
  std::uniform_int_distribution<int> body(0, 4), shift(0, 3), runs(0, 4);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  DofRows rows;
  rows.clear();
  std::vector<Table> tables;
  for (int r = 0; r < 2000; ++r) {
    rows.begin_row();
    Table& table = tables.emplace_back();
    // Mostly whole bodies, as in contacts of blocks; some runs begin anywhere, as those of covers.
    const bool whole = r % 4 != 0;
    for (int k = runs(random); k > 0; --k) {
      std::array<double, kBody> h{};
      for (double& x : h) x = number(random);
      const auto first = static_cast<std::int32_t>(kBody) * body(random) + (whole ? 0 : shift(random));
      rows.add_run(first, h);
      for (std::size_t i = 0; i < kBody; ++i) table[first + static_cast<std::int32_t>(i)] += h[i];
    }
  }
  ASSERT_EQ(rows.size(), tables.size());
  for (std::size_t r = 0; r < tables.size(); ++r) expect_row(rows[r], tables[r]);
}

TEST(DofRows, work_on_their_unknowns) {
  DofRows rows;
  rows.clear();
  rows.begin_row();
  rows.add_run(6, std::array{1.0, 2.0, 3.0, 4.0, 5.0, 6.0});
  rows.add_run(0, std::array{-1.0, 0.5, 0.0, 1.0, 2.0, 4.0});
  rows.add_known(0.25);
  rows.begin_row();
  rows.add(3, 2.0);
  rows.add(1, -1.0);
  const std::vector<double> d{1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 11.0, 12.0};
  EXPECT_DOUBLE_EQ(rows[0].change(d),
                   0.25 + (-1.0 + 1.0 + 0.0 + 4.0 + 10.0 + 24.0) + (7.0 + 16.0 + 27.0 + 40.0 + 55.0 + 72.0));
  EXPECT_DOUBLE_EQ(rows[1].change(d), 2.0 * 4.0 - 2.0);
  std::vector<double> out(d.size(), 0.0);
  rows[0].add_force(2.0, out);
  EXPECT_DOUBLE_EQ(out[0], -2.0);
  EXPECT_DOUBLE_EQ(out[11], 12.0);
  // Virtual work: force times change of the row equals the work of the forces on the unknowns.
  double work = 0.0;
  for (std::size_t i = 0; i < d.size(); ++i) work += out[i] * d[i];
  EXPECT_DOUBLE_EQ(work, 2.0 * (rows[0].change(d) - 0.25));
}

TEST(DofRows, are_filled_in_any_order_where_their_sizes_are_known) {
  DofRows rows;
  rows.clear();
  rows.begin_row();
  rows.add(2, 5.0);
  rows.extend(std::array{std::int32_t{3}, std::int32_t{0}, std::int32_t{1}});
  ASSERT_EQ(rows.size(), 4U);
  for (const std::size_t r : {3U, 1U, 2U}) {
    const DofRows::Filled out = rows.fill(r);
    for (std::size_t k = 0; k < out.dof.size(); ++k) {
      out.dof[k] = static_cast<std::int32_t>(10 * r + k);
      out.h[k] = static_cast<double>(r) + 0.25 * static_cast<double>(k);
    }
    *out.known = -static_cast<double>(r);
  }
  expect_row(rows[0], {{2, 5.0}});
  expect_row(rows[1], {{10, 1.0}, {11, 1.25}, {12, 1.5}});
  expect_row(rows[2], {});
  expect_row(rows[3], {{30, 3.0}});
  EXPECT_EQ(rows[2].known, -2.0);
  rows.begin_row();
  rows.add(1, 1.0);
  expect_row(rows[4], {{1, 1.0}});
}

}  // namespace
}  // namespace scree::coupling::dof_rows_test
