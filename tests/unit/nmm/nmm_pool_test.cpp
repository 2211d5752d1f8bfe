// Release, recovered stress and outline rows of NMM blocks: exact for linear fields, up to round-off.
#include "nmm/nmm_pool.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tests/unit/nmm/one_block.h"

namespace scree::nmm::nmm_pool_test {
namespace {

TEST(Release, affine_part_and_remainder_carry_everything) {
  One one(quadrilateral(), 0.33, 1e3);
  AffineMotion m;
  m.c = {1.0, 2.0};
  m.F = rotation(0.4) * (Mat2::Identity() + (Mat2() << 0.01, 0.003, 0.003, -0.02).finished());
  m.vc = {1.0, -0.5};
  m.Fdot = 2.0 * quarter_turn();
  one.pool.place(0, m, one.q, one.v);
  std::mt19937 generator(9);
  std::uniform_real_distribution<double> u(-0.01, 0.01);
  std::vector<double> dv(one.q.size()), dq(one.q.size()), none(one.q.size());
  for (double& x : dv) x = u(generator);
  for (double& x : dq) x = 0.1 * u(generator);
  std::vector<double> av(dv.size()), aq(dv.size());
  one.pool.mass_solve(one.q, dv, av);  // compatible with the ties
  one.pool.mass_solve(one.q, dq, aq);
  for (std::size_t i = 0; i < dv.size(); ++i) {
    one.v[i] += 0.01 * av[i];
    one.q[i] += 0.01 * aq[i];
  }
  const BodyTotals before = one.pool.totals(0, one.q, one.v);
  const Release r = one.pool.release(0, one.q, one.v);
  const double affine = 0.5 * r.shape.mass * r.motion.vc.squaredNorm() +
                        0.5 * (r.motion.Fdot * r.shape.second * r.motion.Fdot.transpose()).trace();
  EXPECT_NEAR(affine + r.kinetic_rest, before.kinetic, 1e-12 * before.kinetic);
  const double elastic =
      r.shape.area * elastic_response(one.model.elasticity_of(BlockId{0}), r.motion.F, Mat2::Zero()).energy;
  EXPECT_NEAR(elastic + r.elastic_rest + r.elastic_cross, before.elastic, 1e-12 * before.elastic);
  EXPECT_GT(r.kinetic_rest, 0.0);
  EXPECT_GT(r.elastic_rest, 0.0);
  EXPECT_LT(std::abs(r.elastic_cross), 0.1 * r.elastic_rest + 1e-3 * before.elastic);
  EXPECT_NEAR((r.shape.mass * r.motion.vc - before.momentum).norm(), 0.0, 1e-12);
}

/// All that depends on the mesh of the first body.
void expect_same_mesh(const NmmPool& a, const NmmPool& b) {
  const CoverMesh &one = a.mesh(0), &other = b.mesh(0);
  EXPECT_EQ(one.star, other.star);
  EXPECT_EQ(one.cover, other.cover);
  EXPECT_EQ(one.area, other.area);
  EXPECT_EQ(one.ties.size(), other.ties.size());
  ASSERT_EQ(one.boundary.nodes.size(), other.boundary.nodes.size());
  for (std::size_t k = 0; k < one.boundary.nodes.size(); ++k) {
    EXPECT_EQ(one.boundary.nodes[k].node, other.boundary.nodes[k].node);
    EXPECT_EQ(one.boundary.nodes[k].w, other.boundary.nodes[k].w);
  }
  ASSERT_EQ(one.boundary.segments.size(), other.boundary.segments.size());
  for (std::size_t k = 0; k < one.boundary.segments.size(); ++k)
    EXPECT_EQ(one.boundary.segments[k].cell, other.boundary.segments[k].cell);
}

TEST(AddAgain, gives_the_mesh_of_add_where_shape_and_form_are_the_same_and_where_not) {
  const test::NmmBlock block(quadrilateral(), {.cover_size = 0.33}, rock());
  const BodyRecord same{BlockId{0}, "nmm", block.shape, {.cover_size = 0.33}};
  NmmPool earlier;  // where nodes and elements of the body do not begin at 0
  earlier.add(block.model, {BlockId{0}, "nmm", block.shape, {.cover_size = 0.5}});
  earlier.add(block.model, same);
  earlier.finish();

  NmmPool again;
  again.add_again(block.model, same, earlier, 1);
  again.finish();
  expect_same_mesh(block.pool, again);

  BodyRecord strained = same;
  for (Vec2& x : strained.shape.outline.outer) x.x() *= 1.01;
  BodyRecord finer = same;
  finer.form.cover_size = 0.25;
  BodyRecord consistent = same;
  consistent.form.mass = MassKind::consistent;
  for (const BodyRecord& other : {strained, finer, consistent}) {
    NmmPool made, copied;
    made.add(block.model, other);
    made.finish();
    copied.add_again(block.model, other, earlier, 1);
    copied.finish();
    expect_same_mesh(made, copied);
  }
}

TEST(RecoveredStress, is_exact_for_linear_stress_at_points_of_the_block) {
  // Element stresses are set by an in-situ stress that grows linearly with depth: the recovered field is the same.
  const InitialStress s = deviatoric();
  const test::NmmBlock block(quadrilateral(), {.cover_size = 0.2}, rock(1.0, s));
  std::vector<double> nodes(block.q.size() / 2 * 3);
  block.pool.recovered_stress(block.q, std::vector<char>(block.q.size() / 2, 1), nodes);
  for (const Vec2& x : {Vec2(0.0, 0.0), Vec2(0.5, 0.3), Vec2(-0.6, -0.2), Vec2(0.9, 0.1)}) {
    const Row row = block.pool.row_at(0, x - block.centre());
    Eigen::Vector3d found = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < 3; ++k)
      for (int d = 0; d < 3; ++d) found[d] += row.w[k] * nodes[3 * std::size_t(row.node[k]) + std::size_t(d)];
    const Mat2 exact = s.at(x);
    EXPECT_NEAR(found[0], exact(0, 0), 1e-12);
    EXPECT_NEAR(found[1], exact(1, 1), 1e-12);
    EXPECT_NEAR(found[2], exact(0, 1), 1e-12);
  }
}

TEST(RecoveredStress, of_wanted_nodes_alone_has_the_same_bits) {
  const InitialStress s = deviatoric();
  const test::NmmBlock block(quadrilateral(), {.cover_size = 0.33}, rock(1.0, s));
  const auto& ties = block.mesh().ties;
  ASSERT_FALSE(ties.empty());
  const std::size_t n = block.q.size() / 2;
  std::vector<double> all(3 * n), some(3 * n);
  block.pool.recovered_stress(block.q, std::vector<char>(n, 1), all);
  for (std::size_t tied = 0; tied < 2; ++tied) {
    const auto one = tied != 0 ? static_cast<std::size_t>(ties.front().cover) : n / 2;
    std::vector<char> wanted(n, 0);
    wanted[one] = 1;
    std::fill(some.begin(), some.end(), 0.0);
    block.pool.recovered_stress(block.q, wanted, some);
    for (std::size_t d = 3 * one; d < 3 * one + 3; ++d) {
      EXPECT_NE(all[d], 0.0);
      EXPECT_EQ(some[d], all[d]);
    }
  }
}

TEST(ChartRow, of_an_outline_node_gives_linear_fields_exactly_over_ties_too) {
  test::NmmBlock block(quadrilateral(), {.mass = MassKind::consistent, .cover_size = 0.33}, rock());
  ASSERT_FALSE(block.mesh().ties.empty());
  std::vector<double> star(static_cast<std::size_t>(block.pool.dofs(0)));
  block.pool.rates(0, block.q, block.q, star);  // positions expressed in the unknowns
  for (const Row& row : block.pool.boundary(0).nodes) {
    const ChartRow chart = block.pool.chart_row(0, row, block.q);
    Vec2 x = Vec2::Zero(), expected = Vec2::Zero();
    for (int k = 0; k < chart.n; ++k) {
      const auto i = static_cast<std::size_t>(k);
      x += Vec2(chart.tx[i], chart.ty[i]) * star[static_cast<std::size_t>(chart.dof[i])];
    }
    for (std::size_t k = 0; k < 3; ++k) expected += row.w[k] * node(block.q, row.node[k]);
    EXPECT_NEAR((x - expected).norm(), 0.0, 1e-12);
  }
}

}  // namespace
}  // namespace scree::nmm::nmm_pool_test
