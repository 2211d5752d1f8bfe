// Lines of joint sets: known positions, and statistics of random sets compared with their input.
#include "model/joint_network.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::joint_network_test {
namespace {

const Polygon kSquare{{{0, 0}, {10, 0}, {10, 10}, {0, 10}}, {}};

JointSet set_of(double dip, double spacing) {
  JointSet set;
  set.dip_deg.mean = dip;
  set.spacing.mean = spacing;
  return set;
}

std::vector<JointLine> lines_of(const JointSet& set, const Polygon& domain = kSquare) {
  JointNetwork network;
  network.sets.push_back(set);
  return draw_lines(network, domain);
}

TEST(JointSet, without_deviation_runs_through_its_origin_at_equal_spacing) {
  JointSet set = set_of(0.0, 2.0);
  set.origin = Vec2(3.0, 1.0);
  const std::vector<JointLine> lines = lines_of(set);
  ASSERT_EQ(lines.size(), 5U);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    EXPECT_EQ(lines[i].from, Vec2(0.0, 1.0 + 2.0 * static_cast<double>(i)));
    EXPECT_EQ(lines[i].to, Vec2(10.0, 1.0 + 2.0 * static_cast<double>(i)));
  }
}

TEST(JointSet, at_forty_five_degrees_has_lines_at_the_spacing) {
  JointSet set = set_of(45.0, 1.0);
  const std::vector<JointLine> lines = lines_of(set);
  // Distances from the diagonal: |k| < 10/sqrt(2) = 7.07.
  EXPECT_EQ(lines.size(), 15U);
  for (const JointLine& l : lines) EXPECT_NEAR((l.to - l.from).normalized().x(), std::sqrt(0.5), 1e-13);
}

TEST(JointSet, traces_alternate_with_gaps_and_stagger_from_line_to_line) {
  JointSet set = set_of(0.0, 4.0);
  set.origin = Vec2(0.0, 2.0);
  set.length = Spread{3.0};
  set.gap.mean = 1.0;
  set.stagger = 0.5;
  const std::vector<JointLine> lines = lines_of(set);
  // y = 2: 0-3, 4-7, 8-10; y = 6 (moved by 2): 0-1, 2-5, 6-9.
  ASSERT_EQ(lines.size(), 6U);
  const double expected[6][3] = {{2, 0, 3}, {2, 4, 7}, {2, 8, 10}, {6, 0, 1}, {6, 2, 5}, {6, 6, 9}};
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(lines[i].from.y(), expected[i][0]);
    EXPECT_NEAR(lines[i].from.x(), expected[i][1], 1e-14);
    EXPECT_NEAR(lines[i].to.x(), expected[i][2], 1e-14);
  }
}

TEST(JointSet, stays_within_its_region_and_the_domain) {
  JointSet set = set_of(90.0, 1.0);
  set.region = Ring{{-5, 4}, {5.5, 4}, {5.5, 6}, {-5, 6}};
  const std::vector<JointLine> lines = lines_of(set);
  ASSERT_GE(lines.size(), 5U);
  for (const JointLine& l : lines) {
    EXPECT_NEAR((l.to - l.from).norm(), 2.0, 1e-14);
    EXPECT_LE(l.from.x(), 5.5);
  }
}

TEST(JointSet, same_seed_gives_the_same_lines_and_another_gives_others) {
  JointSet set = set_of(30.0, 1.0);
  set.dip_deg.deviation = 5.0;
  set.spacing = {1.0, 0.0, Distribution::exponential};
  const std::vector<JointLine> a = lines_of(set), b = lines_of(set);
  set.seed = 2;
  const std::vector<JointLine> c = lines_of(set);
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(a[i].from == b[i].from && a[i].to == b[i].to);
  EXPECT_FALSE(a.size() == c.size() && a.front().from == c.front().from);
}

TEST(JointSet, mean_spacing_of_many_lines_is_the_stated_one) {
  JointSet set = set_of(0.0, 0.01);
  set.spacing = {0.01, 0.0, Distribution::exponential};
  // 1000 lines expected, Poisson distributed with a standard deviation of 32; tolerance about three of them.
  EXPECT_NEAR(static_cast<double>(lines_of(set).size()), 1000.0, 100.0);
}

/// Number of crossings of the drawn lines, counted pair by pair.
int crossings_of(const JointSet& first, const JointSet& second, const Polygon& domain) {
  int count = 0;
  for (const JointLine& l : lines_of(first, domain))
    for (const JointLine& m : lines_of(second, domain)) {
      const Vec2 d = l.to - l.from, e = m.to - m.from;
      const auto apart = [](const Vec2& a, const Vec2& along, const Vec2& p, const Vec2& q) {
        return cross(along, p - a) * cross(along, q - a) < 0.0;
      };
      count += apart(l.from, d, m.from, m.to) && apart(m.from, e, l.from, l.to) ? 1 : 0;
    }
  return count;
}

TEST(ExpectedCrossings, are_those_of_drawn_lines_within_some_percent) {
  const Polygon frame{{{0, 0}, {40, 0}, {40, 30}, {0, 30}}, {{{10, 10}, {10, 20}, {25, 20}, {25, 10}}}};
  const JointSet first = set_of(20.0, 0.7);
  JointSet second = set_of(80.0, 0.9);
  EXPECT_NEAR(expected_crossings(first, second, frame), crossings_of(first, second, frame), 30.0);  // of 1,443
  second.length = Spread{3.0};
  second.gap = Spread{1.5};
  EXPECT_NEAR(expected_crossings(first, second, frame), crossings_of(first, second, frame), 40.0);  // of 962
  second.region = Ring{{0, 0}, {10, 0}, {10, 30}, {0, 30}};
  EXPECT_NEAR(expected_crossings(first, second, frame), crossings_of(first, second, frame), 20.0);  // of 275
  EXPECT_EQ(expected_crossings(first, first, frame), 0.0);
}

TEST(Clipped, concave_polygon_gives_pieces_in_order) {
  const Polygon u{{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}, {}};
  const std::vector<Segment> pieces = clipped({{-1, 3}, {7, 3}}, u);
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_NEAR(pieces[0].a.x(), 0.0, 1e-15);
  EXPECT_NEAR(pieces[0].b.x(), 2.0, 1e-15);
  EXPECT_NEAR(pieces[1].a.x(), 4.0, 1e-15);
  EXPECT_NEAR(pieces[1].b.x(), 6.0, 1e-14);
  EXPECT_EQ(clipped({{1, 1}, {5, 1}}, u).size(), 1U);
  EXPECT_TRUE(clipped({{-2, 1}, {-1, 1}}, u).empty());
}

TEST(Clipped, holes_interrupt_the_line) {
  const Polygon ring{{{0, 0}, {6, 0}, {6, 6}, {0, 6}}, {{{2, 2}, {2, 4}, {4, 4}, {4, 2}}}};
  EXPECT_EQ(clipped({{-1, 3}, {7, 3}}, ring).size(), 2U);
}

TEST(Arc, full_circle_closes_exactly) {
  Arc arc;
  arc.centre = {5, 5};
  arc.radius = 2.0;
  arc.chords = 8;
  const std::vector<Vec2> points = chord_points(arc);
  ASSERT_EQ(points.size(), 9U);
  EXPECT_EQ(points.front(), points.back());
  EXPECT_EQ(points[2], Vec2(5, 7));
}

}  // namespace
}  // namespace scree::joint_network_test
