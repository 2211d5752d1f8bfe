#include "coupling/integrate/cholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <numeric>
#include <random>

namespace scree::coupling {
namespace {

/// Cells of six unknowns on a square grid, and springs between neighbours: the shape of a system of blocks.
struct Grid {
  static constexpr int kCell = 6;
  int side, n;
  SymmetricPattern pattern;
  std::vector<double> fixed;
  struct Spring {
    std::vector<std::int32_t> dof;
    std::vector<double> h;
    double k;
  };
  std::vector<Spring> springs;
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
      Spring spring{{}, {}, s % 2 == 0 ? 100.0 : 0.0};
      for (const int cell : {a, b})
        for (int k = 0; k < kCell; ++k) {
          spring.dof.push_back(kCell * cell + k);
          spring.h.push_back(normal(random));
        }
      springs.push_back(spring);
    }
  }
  void put(Cholesky& c) const {
    c.begin(fixed);
    for (const Spring& s : springs) c.add_outer(s.dof, s.h, s.k);
  }
  /// A factor of the springs as they are.
  void factorise(Cholesky& c) const {
    c.set_pattern(pattern);
    put(c);
    ASSERT_TRUE(c.factorise());
  }
  /// Switches springs on and off.
  std::vector<Cholesky::Change> flip(int count) {
    std::uniform_int_distribution<std::size_t> pick(0, springs.size() - 1);
    std::vector<Cholesky::Change> changes;
    for (int i = 0; i < count; ++i) {
      Spring& s = springs[pick(random)];
      if (std::any_of(changes.begin(), changes.end(), [&](const auto& c) { return c.h.data() == s.h.data(); }))
        continue;
      const double k = s.k == 0.0 ? 100.0 : 0.0;
      changes.push_back({s.dof, s.h, k - s.k});
      s.k = k;
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

/// Small systems have a factor L D L', large ones dense blocks.
class CholeskyOfGrid : public testing::TestWithParam<int> {};

TEST_P(CholeskyOfGrid, updated_factor_solves_like_a_new_one) {
  Grid grid(GetParam());
  Cholesky updated, anew;
  anew.set_pattern(grid.pattern);
  grid.factorise(updated);
  const std::vector<double> b = grid.load();
  std::vector<double> x(b.size()), y(b.size());
  for (const int count : {1, 2, 5, 40, 3}) {
    ASSERT_TRUE(updated.update(grid.flip(count)));
    updated.solve(b, x);
    grid.put(anew);
    ASSERT_TRUE(anew.factorise());
    anew.solve(b, y);
    EXPECT_LT(difference(x, y), 1e-12) << count;
  }
  EXPECT_EQ(updated.factorisations(), 1);
  EXPECT_EQ(anew.analyses(), 1);
}

TEST_P(CholeskyOfGrid, factorising_anew_forgets_the_updates) {
  Grid grid(GetParam());
  Cholesky c, once;
  grid.factorise(c);
  (void)c.update(grid.flip(7));
  grid.put(c);
  ASSERT_TRUE(c.factorise());
  grid.factorise(once);
  const std::vector<double> b = grid.load();
  std::vector<double> x(b.size()), y(b.size());
  c.solve(b, x);
  once.solve(b, y);
  EXPECT_EQ(x, y);  // bit for bit
}

TEST_P(CholeskyOfGrid, taking_away_more_than_there_is_is_seen) {
  Grid grid(GetParam());
  Cholesky c;
  grid.factorise(c);
  const Cholesky::Change change{grid.springs[0].dof, grid.springs[0].h, -150.0};
  EXPECT_FALSE(c.update(std::array{change}));
  grid.put(c);
  EXPECT_TRUE(c.factorise());
}

TEST_P(CholeskyOfGrid, work_of_an_update_grows_with_its_rank) {
  Grid grid(GetParam());
  Cholesky c;
  grid.factorise(c);
  const std::vector<Cholesky::Change> changes = grid.flip(6);
  double sum = 0.0;
  for (const Cholesky::Change& one : changes) sum += c.relative_work(std::array{one});
  EXPECT_GT(sum, 0.0);
  EXPECT_NEAR(c.relative_work(changes) / sum, 1.0, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Sides, CholeskyOfGrid, testing::Values(3, 24));

}  // namespace
}  // namespace scree::coupling
