// The block matrix of a pass against dense algebra: springs, contact points with friction and dilation, repeated sums
// of the rows of bodies.
#include "coupling/integrate/block_system.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <random>

#include "tests/support/by_hand.h"

namespace scree::coupling::block_system_test {
namespace {

constexpr int kBodies = 5, kSprings = 3, kPoints = 12;

struct Sample {
  test::Scene scene;
  std::unique_ptr<test::ByHand> hand;
  std::unique_ptr<ImplicitSystem> system;
  DofRows rows;
  std::vector<double> A, k, elongation;
  std::vector<PointTangent> points;
  std::mt19937_64 random{61};
  std::normal_distribution<double> normal;

  explicit Sample(const std::string& method = "dda") {
    scene.add("base", test::rectangle(0.0, -1.0, 10.0, 0.0), true);
    for (int i = 0; i < kBodies; ++i) scene.add("b", test::rectangle(2.0 * i, 0.0, 2.0 * i + 1.0, 1.0));
    hand = std::make_unique<test::ByHand>(scene.model, scene.stage(method, Integrator::implicit, 1.0, 1e-3, 1.0));
    system = std::make_unique<ImplicitSystem>(*hand->setup);
  }
  void draw() {
    A.resize(system->pattern().size());
    for (double& a : A) a = normal(random);
    for (int i = 0; i < kSprings; ++i) {
      add_row(i, i % 2 == 0 ? -1 : i + 1);
      k.push_back(i == 1 ? 0.0 : 3.0 + i);
      elongation.push_back(0.25 * i);
    }
    for (int i = 0; i < kPoints; ++i) {
      const int a = i % kBodies, b = i % 4 == 3 ? -1 : (a + 1 + i % 3) % kBodies;
      for (int twice = 0; twice < 2; ++twice) add_row(a, b);
      // Open, sticking, slipping, slipping and dilating.
      const PointTangent kinds[] = {{}, {2.0, 0.0, 0.0, 1.0}, {2.0, 0.0, -1.2, 0.0}, {1.5, 0.4, 0.9, 0.24}};
      points.push_back(kinds[i % 4]);
    }
  }
  void assemble(BlockSystem& blocks, bool fresh) const {
    blocks.assemble(A, fresh, k, elongation, points.size(), [this](std::int64_t i) {
      return LinearContactForce{points[static_cast<std::size_t>(i)], 0.5 + static_cast<double>(i), -2.0};
    });
  }
  /// Force of a row along its elongation.
  [[nodiscard]] double force(std::size_t r, std::span<const double> x) const {
    if (r < kSprings) return -k[r] * (elongation[r] + rows[r].change(x));
    const std::size_t i = (r - kSprings) / 2;
    const double gap = rows[kSprings + 2 * i].change(x), stretch = rows[kSprings + 2 * i + 1].change(x);
    const PointTangent& of = points[i];
    return (r - kSprings) % 2 == 0 ? 0.5 + static_cast<double>(i) - of.nn * gap - of.nt * stretch
                                   : -2.0 - of.tn * gap - of.tt * stretch;
  }
  void add_row(int a, int b) {
    rows.begin_row();
    for (const int body : {a, b})
      for (int j = 0; body >= 0 && j < 6; ++j) rows.add(6 * body + j, normal(random));
    rows.add_known(0.3);
  }
  [[nodiscard]] Eigen::VectorXd row(std::size_t r) const {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(6 * kBodies);
    for (std::size_t i = 0; i < rows[r].dof.size(); ++i) out(rows[r].dof[i]) = rows[r].h[i];
    return out;
  }
  [[nodiscard]] Eigen::MatrixXd dense() const {
    Eigen::MatrixXd m = Eigen::MatrixXd::Zero(6 * kBodies, 6 * kBodies);
    const SymmetricPattern& p = system->pattern();
    for (std::size_t c = 0; c < static_cast<std::size_t>(p.n); ++c)
      for (auto at = static_cast<std::size_t>(p.column_start[c]); at < static_cast<std::size_t>(p.column_start[c + 1]);
           ++at)
        m(p.row[at], static_cast<Eigen::Index>(c)) = m(static_cast<Eigen::Index>(c), p.row[at]) = A[at];
    for (std::size_t i = 0; i < kSprings; ++i) m += k[i] * row(i) * row(i).transpose();
    for (std::size_t i = 0; i < kPoints; ++i) {
      const Eigen::VectorXd n = row(kSprings + 2 * i), t = row(kSprings + 2 * i + 1);
      const PointTangent& of = points[i];
      m += n * (of.nn * n + of.nt * t).transpose() + t * (of.tn * n + of.tt * t).transpose();
    }
    return m;
  }
};

Eigen::MatrixXd dense_of(const BlockMatrix& m) {
  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(6 * m.rows(), 6 * m.rows());
  for (std::int32_t i = 0; i < m.rows(); ++i)
    for (std::int32_t k = m.row_begin(i); k < m.row_begin(i + 1); ++k)
      out.block<6, 6>(6 * i, 6 * m.column(k)) = Eigen::Map<const Eigen::Matrix<double, 6, 6>>(m.block(k));
  return out;
}

TEST(BlockSystem, sums_springs_and_points_as_dense_algebra_does) {
  Sample s;
  s.draw();
  BlockSystem blocks(*s.system);
  ASSERT_TRUE(blocks.begin(s.rows, kSprings));
  s.assemble(blocks, true);
  const Eigen::MatrixXd exact = s.dense();
  EXPECT_LT((dense_of(blocks.matrix()) - exact).cwiseAbs().maxCoeff(), 1e-13 * exact.cwiseAbs().maxCoeff());
  Eigen::VectorXd x = Eigen::VectorXd::Random(6 * kBodies), y(6 * kBodies);
  blocks.multiply(std::span<const double>(x.data(), 30), std::span<double>(y.data(), 30));
  EXPECT_LT((y - exact * x).cwiseAbs().maxCoeff(), 1e-13 * exact.cwiseAbs().maxCoeff());
  // The same with the forces of springs and points, row by row.
  std::vector<double> left(y.data(), y.data() + y.size());
  double largest = 0.0;
  s.system->pattern().multiply(s.A, std::span<const double>(x.data(), 30), left);
  for (std::size_t r = 0; r < s.rows.size(); ++r) {
    const double force = s.force(r, std::span<const double>(x.data(), 30));
    largest = std::max(largest, std::abs(force));
    s.rows[r].add_force(-force, left);
  }
  blocks.balance(std::span<const double>(x.data(), 30), std::span<double>(y.data(), 30));
  const Eigen::Map<const Eigen::VectorXd> in_turn(left.data(), y.size());
  EXPECT_LT((y - in_turn).cwiseAbs().maxCoeff(), 1e-13 * exact.cwiseAbs().maxCoeff());
  EXPECT_NEAR(blocks.largest_force(), largest, 1e-13 * largest);
}

TEST(BlockSystem, rows_summed_again_have_the_bits_of_a_new_matrix) {
  Sample s;
  s.draw();
  BlockSystem blocks(*s.system);
  ASSERT_TRUE(blocks.begin(s.rows, kSprings));
  s.assemble(blocks, true);
  s.points[1] = {};
  s.points[6] = {2.0, 0.0, 0.0, 1.0};
  s.assemble(blocks, false);
  BlockSystem anew(*s.system);
  ASSERT_TRUE(anew.begin(s.rows, kSprings));
  s.assemble(anew, true);
  EXPECT_EQ(dense_of(blocks.matrix()), dense_of(anew.matrix()));
  const Eigen::MatrixXd exact = s.dense();
  EXPECT_LT((dense_of(blocks.matrix()) - exact).cwiseAbs().maxCoeff(), 1e-13 * exact.cwiseAbs().maxCoeff());
  // The next step has rows of its own.
  for (double& a : s.A) a *= 2.0;
  ASSERT_TRUE(blocks.begin(s.rows, kSprings));
  s.assemble(blocks, true);
  EXPECT_LT((dense_of(blocks.matrix()) - s.dense()).cwiseAbs().maxCoeff(), 1e-13 * exact.cwiseAbs().maxCoeff());
}

TEST(DofRows, runs_of_unknowns_are_added_as_one_by_one) {
  std::mt19937_64 random(62);
  std::normal_distribution<double> normal;
  // In order, repeated, before existing entries, across existing entries.
  for (const std::vector<int>& firsts : {std::vector{0, 6}, {6, 6, 12}, {12, 0, 12, 0}, {3, 0, 6}, {6, 4}}) {
    DofRows runs, single;
    for (DofRows* rows : {&runs, &single}) {
      rows->begin_row();  // a row before, which must stay as it is
      rows->add(6, 1.0);
      rows->begin_row();
    }
    for (const int first : firsts) {
      std::array<double, 6> h{};
      for (double& x : h) x = normal(random);
      runs.add_run(first, h);
      for (std::size_t k = 0; k < h.size(); ++k) single.add(first + static_cast<int>(k), h[k]);
    }
    EXPECT_TRUE(std::ranges::equal(runs.start(), single.start()));
    EXPECT_TRUE(std::ranges::equal(runs.dof(), single.dof()));
    EXPECT_TRUE(std::ranges::equal(runs.h(), single.h()));
  }
}

TEST(DofRows, changes_and_forces_of_whole_bodies_are_those_of_dense_algebra) {
  std::mt19937_64 random(63);
  std::normal_distribution<double> normal;
  for (const std::vector<int>& dofs : {std::vector{0, 1, 2, 3, 4, 5},
                                       {6, 7, 8, 9, 10, 11, 18, 19, 20, 21, 22, 23},
                                       {0, 1, 2, 3, 4, 6},
                                       {0, 1, 2, 3, 4, 5, 6},
                                       {}}) {
    DofRows rows;
    rows.begin_row();
    rows.add_known(0.25);
    for (const int dof : dofs) rows.add(dof, normal(random));
    Eigen::VectorXd d = Eigen::VectorXd::Random(24), h = Eigen::VectorXd::Zero(24), force = Eigen::VectorXd::Zero(24);
    for (std::size_t i = 0; i < dofs.size(); ++i) h(dofs[i]) = rows[0].h[i];
    EXPECT_NEAR(rows[0].change(std::span<const double>(d.data(), 24)), 0.25 + h.dot(d), 1e-14);
    rows[0].add_force(3.0, std::span<double>(force.data(), 24));
    EXPECT_EQ(force, 3.0 * h);
  }
}

TEST(BlockSystem, is_of_whole_bodies_and_of_pairs) {
  Sample s;
  EXPECT_TRUE(s.system->affine());
  s.draw();
  s.rows.begin_row();
  for (int dof = 0; dof < 18; ++dof) s.rows.add(dof, 1.0);  // three bodies
  s.rows.begin_row();
  BlockSystem blocks(*s.system);
  EXPECT_FALSE(blocks.begin(s.rows, kSprings));
  const Sample mesh("nmm");
  EXPECT_FALSE(mesh.system->affine());
}

}  // namespace
}  // namespace scree::coupling::block_system_test
