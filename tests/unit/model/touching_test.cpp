// Pairs of touching blocks, the length and law of each contact, and the distance of the nearest block not touching.
#include "model/touching.h"

#include <gtest/gtest.h>

#include <cmath>

#include "model/random.h"

namespace scree::touching_test {
namespace {

Block block(const Ring& outer, int joint = -1) {
  Block b;
  b.polygon.outer = outer;
  orient(b.polygon);
  b.material = MaterialId{0};
  if (joint >= 0) b.joint = JointId{joint};
  return b;
}

Ring square(double x, double y, double side = 1.0) {
  return {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
}

TEST(Touching, edges_that_lie_against_each_other_have_their_common_length_and_normal) {
  Model m;
  m.blocks = {block(square(0, 0, 2)), block({{0.5, 2}, {1.25, 2}, {1.25, 3}, {0.5, 3}})};
  const auto found = touching_blocks(m);
  ASSERT_EQ(found.size(), 1U);
  ASSERT_EQ(found[0].facing.size(), 1U);
  EXPECT_DOUBLE_EQ(found[0].facing[0].length, 0.75);
  EXPECT_NEAR((found[0].facing[0].normal - Vec2(0, 1)).norm(), 0.0, 1e-15);
}

TEST(Touching, a_corner_on_an_edge_touches_at_a_point) {
  Model m;
  m.blocks = {block(square(0, 0, 2)), block({{1, 2}, {2, 3}, {1, 4}, {0, 3}})};
  const auto found = touching_blocks(m);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].facing.empty());
}

TEST(Touching, a_gap_of_a_thousandth_of_the_smaller_block_is_the_limit) {
  for (const double gap : {0.5e-3, 2e-3}) {
    Model m;
    m.blocks = {block(square(0, 0, 10)), block(square(3, 10 + gap, 1))};
    EXPECT_EQ(touching_blocks(m).size(), gap < 1e-3 ? 1U : 0U) << gap;
    const Neighbour next = nearest_other(m, {BlockId{1}});
    EXPECT_EQ(next.block.value, 0);
    EXPECT_NEAR(next.gap, gap, 1e-12);
  }
}

TEST(Touching, a_lining_touches_the_hole_it_stands_in) {
  Model m;
  m.blocks = {block(square(0, 0, 4)), block(square(1, 1, 1))};
  m.blocks[0].polygon.holes.push_back(square(1, 1, 1));
  orient(m.blocks[0].polygon);
  const auto found = touching_blocks(m);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].facing.size(), 4U);
}

TEST(Touching, of_two_laws_the_one_with_less_friction_holds) {
  Model m;
  m.joints.resize(3);
  m.joints[0].friction = 0.3, m.joints[1].friction = 0.2, m.joints[2].friction = 0.2;
  m.default_joint = JointId{0};
  EXPECT_EQ(law_between(m, {}, {}), JointId{0});
  EXPECT_EQ(law_between(m, {}, JointId{2}), JointId{2});
  EXPECT_EQ(law_between(m, JointId{0}, JointId{1}), JointId{1});
  EXPECT_EQ(law_between(m, JointId{2}, JointId{1}), JointId{1});
  m.blocks = {block(square(0, 0), 0), block(square(1, 0), 1)};
  EXPECT_EQ(touching_blocks(m).at(0).facing.at(0).law, JointId{1});
}

TEST(Touching, is_that_of_all_pairs_looked_at_one_by_one) {
  Random random(7);
  Model m;
  for (int i = 0; i < 12; ++i)
    for (int j = 0; j < 12; ++j)
      if (random.uniform() < 0.7) m.blocks.push_back(block(square(i, j + (i % 2 == 0 ? 0.5 : 0.0))));
  std::size_t pairs = 0;
  for (std::size_t a = 0; a < m.blocks.size(); ++a)
    for (std::size_t b = a + 1; b < m.blocks.size(); ++b) {
      const Vec2 d = m.blocks[b].polygon.outer[0] - m.blocks[a].polygon.outer[0];
      if (std::abs(d.x()) < 1.0 + 1e-9 && std::abs(d.y()) < 1.0 + 1e-9) ++pairs;
    }
  const auto found = touching_blocks(m);
  EXPECT_EQ(found.size(), pairs);
  EXPECT_GT(pairs, 100U);
  for (std::size_t i = 1; i < found.size(); ++i)
    EXPECT_TRUE(found[i - 1].a < found[i].a || (found[i - 1].a == found[i].a && found[i - 1].b < found[i].b));
}

}  // namespace
}  // namespace scree::touching_test
