#include "coupling/linear/cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace scree::coupling::cholesky_test {
namespace {

/// Cells of six unknowns on a square grid, and springs between neighbours: the shape of a system of blocks.
struct Grid {
  static constexpr int kCell = 6;
  int side, n;
  SymmetricPattern pattern;
  std::vector<double> fixed;
  DofRows springs;
  std::vector<double> k;  // stiffness of the springs
  std::mt19937 random{3};

  explicit Grid(int grid_side) : side(grid_side), n(kCell * grid_side * grid_side) {
    std::vector<std::int32_t> diagonal(static_cast<std::size_t>(n));
    std::iota(diagonal.begin(), diagonal.end(), 0);
    (void)pattern.make(n, diagonal, diagonal);
    fixed.assign(static_cast<std::size_t>(n), 1.0);
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) {
        if (i + 1 < side) add(side * j + i, side * j + i + 1);
        if (j + 1 < side) add(side * j + i, side * j + i + side);
      }
  }
  void add(int a, int b) {
    std::normal_distribution<double> normal;
    for (int s = 0; s < 4; ++s) {
      springs.begin_row();
      for (const int cell : {a, b})
        for (int i = 0; i < kCell; ++i) springs.add(kCell * cell + i, normal(random));
      k.push_back(s % 2 == 0 ? 100.0 : 0.0);
    }
  }
  /// Factorises the matrix with the current springs.
  void factorise(Cholesky& c) const { ASSERT_TRUE(c.factorise(fixed, springs, k)); }
  /// Switches springs on and off.
  std::vector<Cholesky::Change> flip(int count) {
    std::uniform_int_distribution<std::size_t> pick(0, springs.size() - 1);
    std::vector<Cholesky::Change> changes;
    for (int i = 0; i < count; ++i) {
      const std::size_t s = pick(random);
      if (std::any_of(changes.begin(), changes.end(), [&](const auto& c) { return c.row == s; })) continue;
      const double now = k[s] == 0.0 ? 100.0 : 0.0;
      changes.push_back({s, now - k[s]});
      k[s] = now;
    }
    return changes;
  }
  std::vector<double> load() {
    std::normal_distribution<double> normal;
    std::vector<double> b(static_cast<std::size_t>(n));
    for (double& x : b) x = normal(random);
    return b;
  }
};

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  const Eigen::Map<const Eigen::VectorXd> x(a.data(), static_cast<Eigen::Index>(a.size())),
      y(b.data(), static_cast<Eigen::Index>(b.size()));
  return (x - y).norm() / y.norm();
}

/// Small systems have a factor L D L', large ones a factor of dense blocks.
class CholeskyOfGrid : public testing::TestWithParam<int> {};

TEST_P(CholeskyOfGrid, updated_factor_solves_like_a_new_one) {
  Grid grid(GetParam());
  Cholesky updated, anew;
  updated.set_pattern(grid.pattern);
  anew.set_pattern(grid.pattern);
  grid.factorise(updated);
  const std::vector<double> b = grid.load();
  std::vector<double> x(b.size()), y(b.size());
  for (const int count : {1, 2, 5, 40, 3}) {
    ASSERT_TRUE(updated.update(grid.springs, grid.flip(count)));
    updated.solve(b, x);
    grid.factorise(anew);
    anew.solve(b, y);
    EXPECT_LT(difference(x, y), 1e-12) << count;
  }
  EXPECT_EQ(updated.factorisations(), 1);
  EXPECT_EQ(anew.analyses(), 1);
}

TEST_P(CholeskyOfGrid, without_the_updates_it_is_what_it_was) {
  Grid grid(GetParam());
  Cholesky c;
  c.set_pattern(grid.pattern);
  grid.factorise(c);
  const std::vector<double> b = grid.load();
  std::vector<double> x(b.size()), y(b.size()), z(b.size());
  c.solve(b, x);
  ASSERT_TRUE(c.update(grid.springs, grid.flip(7)));
  c.solve(b, y);
  c.drop_updates();
  c.solve(b, z);
  EXPECT_NE(x, y);
  EXPECT_EQ(x, z);  // bit for bit
}

TEST_P(CholeskyOfGrid, factor_of_a_matrix_that_travelled_has_the_same_bits) {
  Grid grid(GetParam());
  Cholesky first, later;
  for (Cholesky* c : {&first, &later}) c->set_pattern(grid.pattern);
  grid.factorise(first);
  // Fewer springs: the analysis of all springs has places for them, a new analysis would hold them alone.
  DofRows some;
  for (std::size_t s = 0; s < grid.springs.size(); s += 3) some.add_row(grid.springs[s]);
  const std::vector<double> k(some.size(), 70.0);
  ASSERT_TRUE(first.factorise(grid.fixed, some, k));
  EXPECT_EQ(first.analyses(), 1);
  ASSERT_TRUE(later.factorise(first.matrix()));
  const std::vector<double> b = grid.load();
  std::vector<double> x(b.size()), y(b.size());
  first.solve(b, x);
  later.solve(b, y);
  EXPECT_EQ(x, y);
  // Later factorisations of both agree.
  for (Cholesky* c : {&first, &later}) grid.factorise(*c);
  first.solve(b, x);
  later.solve(b, y);
  EXPECT_EQ(x, y);
}

TEST_P(CholeskyOfGrid, spring_without_a_place_makes_a_new_analysis) {
  Grid grid(GetParam());
  Cholesky c;
  c.set_pattern(grid.pattern);
  grid.factorise(c);
  grid.add(0, grid.side * grid.side - 1);
  grid.factorise(c);
  EXPECT_EQ(c.analyses(), 2);
}

TEST_P(CholeskyOfGrid, taking_away_more_than_there_is_is_seen) {
  Grid grid(GetParam());
  Cholesky c;
  c.set_pattern(grid.pattern);
  grid.factorise(c);
  const Cholesky::Change change{0, -150.0};
  EXPECT_FALSE(c.update(grid.springs, std::array{change}));
  grid.factorise(c);
}

TEST_P(CholeskyOfGrid, work_of_an_update_grows_with_its_rank) {
  Grid grid(GetParam());
  Cholesky c;
  c.set_pattern(grid.pattern);
  grid.factorise(c);
  const std::vector<Cholesky::Change> changes = grid.flip(6);
  double sum = 0.0;
  for (const Cholesky::Change& one : changes) sum += c.relative_work(grid.springs, std::array{one});
  EXPECT_GT(sum, 0.0);
  EXPECT_NEAR(c.relative_work(grid.springs, changes) / sum, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sides, CholeskyOfGrid, testing::Values(3, 24));

TEST(Cholesky, system_without_unknowns_is_solved) {
  SymmetricPattern none;
  (void)none.make(0, std::vector<std::int32_t>{}, std::vector<std::int32_t>{});
  Cholesky c;
  c.set_pattern(none);
  EXPECT_TRUE(c.factorise(std::span<const double>{}, DofRows(), {}));
  c.solve({}, {});
  EXPECT_TRUE(c.factored());
}

}  // namespace
}  // namespace scree::coupling::cholesky_test
