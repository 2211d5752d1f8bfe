// Layout of liners along outlines of blocks: nodes known by hand, and the errors of lines off the outlines.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "model/bolt.h"
#include "model/model.h"

namespace scree::liner_test {
namespace {

void add(Model& model, Polygon polygon) {
  Block b;
  b.polygon = std::move(polygon);
  orient(b.polygon);
  model.blocks.push_back(std::move(b));
}

/// Two squares of 1 m side by side.
Model pair() {
  Model model;
  add(model, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {}});
  add(model, {{{1, 0}, {2, 0}, {2, 1}, {1, 1}}, {}});
  return model;
}

Bolt liner(std::vector<Vec2> along, double spacing, double tolerance = 0.01) {
  Bolt b;
  b.along = std::move(along);
  b.segment = spacing;
  b.tolerance = tolerance;
  b.stiffness = 3.0;
  b.bending = 2.0;
  b.plate = false;
  return b;
}

TEST(Liner, nodes_lie_on_the_outlines_at_most_a_spacing_apart) {
  Bolt b = liner({{0.1, 1.005}, {1.9, 1.005}}, 0.25);
  ASSERT_EQ(lay_out_liner(pair(), {}, b), "");
  ASSERT_EQ(b.nodes.size(), 9U);  // 1.8 m in 8 pieces
  for (std::size_t k = 0; k < b.nodes.size(); ++k) {
    const double x = 0.1 + 0.225 * static_cast<double>(k);
    EXPECT_LT((b.nodes[k].place - Vec2(x, 1.0)).norm(), 1e-14) << k;
    EXPECT_NEAR(b.nodes[k].at, x - 0.1, 1e-14) << k;
    EXPECT_EQ(b.nodes[k].block.value, x <= 1.0 ? 0 : 1) << k;  // the node at x = 1 touches both: the first has it
    EXPECT_EQ(b.nodes[k].length, 0.0);
  }
  EXPECT_EQ(b.turns(), 7U);
  EXPECT_NEAR(b.segment_stiffness(0), 3.0 / 0.225, 1e-12);
  EXPECT_NEAR(b.turn_stiffness(3), 2.0 / 0.225, 1e-12);
}

TEST(Liner, one_round_a_hole_closes_and_has_a_turn_at_every_node) {
  Model model;
  Ring hole;
  for (int k = 0; k < 12; ++k) {
    const double a = k * std::numbers::pi / 6.0;
    hole.push_back(Vec2(std::cos(a), std::sin(a)));
  }
  add(model, {{{-3, -3}, {3, -3}, {3, 3}, {-3, 3}}, {hole}});
  std::vector<Vec2> along = hole;
  along.push_back(hole.front());
  Bolt b = liner(along, 10.0);
  ASSERT_EQ(lay_out_liner(model, {}, b), "");
  EXPECT_TRUE(b.ring());
  ASSERT_EQ(b.nodes.size(), 13U);
  EXPECT_EQ(b.nodes.front().place, b.nodes.back().place);
  EXPECT_EQ(b.turns(), 12U);
  EXPECT_EQ(b.segment_after(11), 0U);
  EXPECT_EQ(b.segment_after(10), 11U);
  EXPECT_NEAR(b.nodes.back().at, 24.0 * std::sin(std::numbers::pi / 12.0), 1e-13);
}

TEST(Liner, blocks_that_are_not_there_carry_none_of_it) {
  const std::vector<char> absent{1, 0};
  Bolt b = liner({{1.0, 0.2}, {1.0, 0.8}}, 0.3);
  ASSERT_EQ(lay_out_liner(pair(), absent, b), "");
  for (const Bolt::Node& n : b.nodes) EXPECT_EQ(n.block.value, 1);
}

TEST(Liner, lines_that_leave_the_outlines_are_told_with_place_and_distance) {
  Bolt far = liner({{0.1, 1.0}, {1.9, 1.2}}, 0.31);  // 1.811 m in 6 pieces
  const std::string wrong = lay_out_liner(pair(), {}, far);
  EXPECT_NE(wrong.find("(0.4, 1.03333)"), std::string::npos) << wrong;
  EXPECT_NE(wrong.find("0.0333 m away"), std::string::npos) << wrong;
  Bolt twice = liner({{0.1, 1.0}, {0.2, 1.0}, {0.2, 1.005}}, 0.3);
  EXPECT_NE(lay_out_liner(pair(), {}, twice).find("meet at (0.2, 1.005)"), std::string::npos);
  Bolt many = liner({{0.1, 1.0}, {1.9, 1.0}}, 1e-5);
  EXPECT_NE(lay_out_liner(pair(), {}, many).find("more than 2000 nodes"), std::string::npos);
}

}  // namespace
}  // namespace scree::liner_test
