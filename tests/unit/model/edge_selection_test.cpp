// Parts of outlines on a line: known cases, and random rotated rectangles with holes compared with sampled points.
#include "model/edge_selection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/random.h"

namespace scree::edge_selection_test {
namespace {

constexpr BlockId kBlock{3};

double between(Random& random, double low, double high) { return low + (high - low) * random.uniform(); }

/// A rectangle from (0, 0) with a rectangular hole.
Polygon framed() {
  Polygon p{{{0, 0}, {4, 0}, {4, 2}, {0, 2}}, {{{1, 0.5}, {1, 1.5}, {3, 1.5}, {3, 0.5}}}};
  orient(p);
  return p;
}

double length_of(const Polygon& polygon, const std::vector<EdgeSpan>& spans) {
  double length = 0.0;
  for (const EdgeSpan& s : spans) {
    const auto [from, to] = ends_of(polygon, s.edge);
    length += (s.s1 - s.s0) * (to - from).norm();
  }
  return length;
}

TEST(EdgesOnLine, whole_edge_is_found_whichever_way_the_line_runs) {
  for (const bool turned : {false, true}) {
    const Vec2 a = turned ? Vec2(4, 2) : Vec2(0, 2), b = turned ? Vec2(0, 2) : Vec2(4, 2);
    const auto spans = edges_on_line(kBlock, framed(), a, b, 1e-6);
    ASSERT_EQ(spans.size(), 1u);
    EXPECT_EQ(spans[0].block, kBlock);
    EXPECT_EQ(spans[0].edge, (OutlineEdge{0, 2}));
    EXPECT_EQ(spans[0].s0, 0.0);
    EXPECT_EQ(spans[0].s1, 1.0);
  }
}

TEST(EdgesOnLine, part_of_an_edge_counts_along_the_edge) {
  // Edge 2 runs from (4, 2) to (0, 2): x = 1 to 2 is s = 0.5 to 0.75.
  const auto spans = edges_on_line(kBlock, framed(), {1, 2}, {2, 2}, 1e-6);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].s0, 0.5);
  EXPECT_EQ(spans[0].s1, 0.75);
}

TEST(EdgesOnLine, line_that_runs_on_takes_what_there_is) {
  const auto spans = edges_on_line(kBlock, framed(), {-5, 2}, {2, 2}, 1e-6);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].s0, 0.5);
  EXPECT_EQ(spans[0].s1, 1.0);
}

TEST(EdgesOnLine, holes_have_edges_too) {
  const Polygon p = framed();
  const auto spans = edges_on_line(kBlock, p, {3, 0.5}, {1, 0.5}, 1e-6);
  ASSERT_EQ(spans.size(), 1u);
  EXPECT_EQ(spans[0].edge.ring, 1);
  EXPECT_EQ(length_of(p, spans), 2.0);
  EXPECT_EQ(outward_normal(p, spans[0].edge), Vec2(0, 1));  // out of the rock, into the hole
}

TEST(EdgesOnLine, several_edges_on_one_line_are_all_found) {
  // A notch in the top: two edges at y = 2 beside it.
  const Polygon p{{{0, 0}, {4, 0}, {4, 2}, {3, 2}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}, {}};
  const auto spans = edges_on_line(kBlock, p, {0, 2}, {4, 2}, 1e-6);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_EQ(spans[0].edge, (OutlineEdge{0, 2}));
  EXPECT_EQ(spans[1].edge, (OutlineEdge{0, 6}));
}

TEST(EdgesOnLine, edges_across_or_beside_the_line_do_not_count) {
  const Polygon p = framed();
  EXPECT_TRUE(edges_on_line(kBlock, p, {2, -1}, {2, 3}, 1e-6).empty());             // across
  EXPECT_TRUE(edges_on_line(kBlock, p, {0, 2.00001}, {4, 2.00001}, 1e-6).empty());  // beside
  EXPECT_EQ(edges_on_line(kBlock, p, {0, 2.0000009}, {4, 2}, 1e-6).size(), 1u);
  EXPECT_TRUE(edges_on_line(kBlock, p, {4, 2}, {8, 2}, 1e-6).empty());    // only a corner in common
  EXPECT_TRUE(edges_on_line(kBlock, p, {0, 2}, {4, 2.1}, 1e-6).empty());  // leaves the edge at once
}

TEST(NearestEdge, tells_how_far_the_line_strays) {
  const NearestEdge n = nearest_edge(framed(), {0, 2.25}, {4, 2.125});
  EXPECT_EQ(n.edge, (OutlineEdge{0, 2}));
  EXPECT_EQ(n.distance, 0.25);
  EXPECT_EQ(nearest_edge(framed(), {1, 1.25}, {3, 1.25}).edge.ring, 1);
}

TEST(OutwardNormal, points_out_of_the_solid) {
  Random random(7);
  for (int trial = 0; trial < 100; ++trial) {
    const Polygon p = transformed(framed(), {between(random, -5, 5), between(random, -5, 5)},
                                  rotation(between(random, 0.0, 2.0 * std::numbers::pi)));
    for (std::int32_t r = 0; r < 2; ++r)
      for (std::int32_t e = 0; e < 4; ++e) {
        const auto [from, to] = ends_of(p, {r, e});
        const Vec2 n = outward_normal(p, {r, e}), middle = 0.5 * (from + to);
        EXPECT_NEAR(n.norm(), 1.0, 1e-15);
        EXPECT_TRUE(contains(p, middle - 1e-3 * n));
        EXPECT_FALSE(contains(p, middle + 1e-3 * n));
      }
  }
}

// Rectangles with a hole, of random size, rotated and shifted. The line is a random part of a random edge, in either
// direction; in half of the trials it extends beyond the corners of the edge. The result must be that part, cut off at
// the corners, of that edge and of no other. Reference: the distance of sampled outline points from the line. Points
// near an end of the line are left out, because they may differ by the tolerance.
TEST(EdgesOnLine, random_stretches_of_turned_rectangles_come_back) {
  Random random(20261121);
  for (int trial = 0; trial < 2000; ++trial) {
    const double size = std::pow(10.0, between(random, -2.0, 3.0));
    const double width = size * between(random, 0.2, 5.0), height = size * between(random, 0.2, 5.0);
    const double x0 = width * between(random, 0.1, 0.4), x1 = width * between(random, 0.6, 0.9),
                 y0 = height * between(random, 0.1, 0.4), y1 = height * between(random, 0.6, 0.9);
    Polygon flat{{{0, 0}, {width, 0}, {width, height}, {0, height}}, {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}}};
    orient(flat);
    const Polygon p = transformed(flat, {size * between(random, -20, 20), size * between(random, -20, 20)},
                                  rotation(between(random, 0.0, 2.0 * std::numbers::pi)));
    const double tolerance = 1e-6 * std::max(width, height);

    const OutlineEdge wanted{between(random, 0, 1) < 0.5 ? 0 : 1, static_cast<std::int32_t>(between(random, 0, 4))};
    const auto [from, to] = ends_of(p, wanted);
    double s0 = between(random, 0.0, 0.45), s1 = between(random, 0.55, 1.0);
    if (between(random, 0, 1) < 0.5) s0 = -between(random, 0.0, 0.05), s1 = 1.0 + between(random, 0.0, 0.05);
    Vec2 a = from + s0 * (to - from), b = from + s1 * (to - from);
    if (between(random, 0, 1) < 0.5) std::swap(a, b);

    const auto spans = edges_on_line(kBlock, p, a, b, tolerance);
    ASSERT_EQ(spans.size(), 1u) << trial;
    EXPECT_EQ(spans[0].edge, wanted) << trial;
    const double hair = tolerance / (to - from).norm();
    EXPECT_NEAR(spans[0].s0, std::max(0.0, s0), hair) << trial;
    EXPECT_NEAR(spans[0].s1, std::min(1.0, s1), hair) << trial;
    EXPECT_LT(nearest_edge(p, a, b).distance, 0.06 * (to - from).norm());

    // Every sampled point of the outline is in a span if and only if it is on the line, except near the ends.
    for (std::int32_t r = 0; r < 2; ++r)
      for (std::int32_t e = 0; e < 4; ++e)
        for (double s = 0.005; s < 1.0; s += 0.01) {
          const auto [u, w] = ends_of(p, {r, e});
          const Vec2 x = u + s * (w - u);
          const bool end = std::min((x - a).norm(), (x - b).norm()) < 2.0 * tolerance;
          const bool found = spans[0].edge == OutlineEdge{r, e} && s >= spans[0].s0 && s <= spans[0].s1;
          EXPECT_TRUE(end || found == (distance_to_segment(x, a, b) <= tolerance)) << trial;
        }

    // The same line shifted by more than the tolerance selects nothing; the reported distance is the shift.
    const Vec2 shift = 5.0 * tolerance * outward_normal(p, wanted);
    EXPECT_TRUE(edges_on_line(kBlock, p, a + shift, b + shift, tolerance).empty()) << trial;
    const double strays = nearest_edge(p, a + shift, b + shift).distance;
    EXPECT_TRUE(s0 < 0.0 || std::abs(strays - 5.0 * tolerance) < 1e-3 * tolerance) << trial << ": " << strays;
  }
}

/// Blocks 1 x 1 side by side from x = 0, `rows` layers of them from y = 0.
Model bricks(int columns, int rows) {
  Model m;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      Block b;
      b.polygon = {{{i + 0.0, j + 0.0}, {i + 1.0, j + 0.0}, {i + 1.0, j + 1.0}, {i + 0.0, j + 1.0}}, {}};
      m.blocks.push_back(b);
    }
  return m;
}

double total(const Model& m, const std::vector<EdgeSpan>& spans) {
  double sum = 0.0;
  for (const EdgeSpan& s : spans) sum += scree::length_of(m, s);
  return sum;
}

TEST(FreeEdges, joints_are_passed_over_and_borders_are_found) {
  const Model m = bricks(4, 3);
  EXPECT_NEAR(total(m, free_edges_on_line(m, {0, 0}, {4, 0}, 1e-6)), 4.0, 1e-9);
  EXPECT_NEAR(total(m, free_edges_on_line(m, {4, 0}, {0.5, 0}, 1e-6)), 3.5, 1e-9);
  EXPECT_TRUE(free_edges_on_line(m, {0, 1}, {4, 1}, 1e-6).empty());
  EXPECT_NEAR(total(m, free_edges_in_box(m, {{-1, -1}, {5, 4}}, 1e-6)), 14.0, 1e-9);
  EXPECT_NEAR(total(m, free_edges_in_box(m, {{-0.1, -0.1}, {4.1, 0.25}}, 1e-6)), 4.5, 1e-5);
}

TEST(FreeEdges, a_face_is_free_beside_a_shorter_block) {
  // A block 1 m wide on a block 3 m wide: 2 m of the upper face are free, in two parts.
  Model m;
  Block low, high;
  low.polygon = {{{0, 0}, {3, 0}, {3, 1}, {0, 1}}, {}};
  high.polygon = {{{1.2, 1}, {2.2, 1}, {2.2, 2}, {1.2, 2}}, {}};
  m.blocks = {low, high};
  const auto spans = free_edges_on_line(m, {0, 1}, {3, 1}, 1e-6);
  ASSERT_EQ(spans.size(), 2u);
  EXPECT_NEAR(total(m, spans), 2.0, 1e-9);
  // Edge 2 runs from (3, 1) to (0, 1). Parts of one edge are sorted from a to b.
  EXPECT_NEAR(spans[0].s0 * 3.0, 1.8, 1e-9);
  EXPECT_NEAR(spans[0].s1 * 3.0, 3.0, 1e-9);
  EXPECT_NEAR(spans[1].s0 * 3.0, 0.0, 1e-9);
  EXPECT_NEAR(spans[1].s1 * 3.0, 0.8, 1e-9);
}

TEST(FreeEdges, water_presses_on_what_looks_out) {
  Model m = bricks(3, 1);
  Block step;  // stands on the left block and has an opening
  step.polygon = {{{0, 1}, {1, 1}, {1, 3}, {0, 3}}, {{{0.4, 1.5}, {0.4, 2.0}, {0.6, 2.0}, {0.6, 1.5}}}};
  m.blocks.push_back(step);
  // The top of the step 1, its right face 2, the tops of two bricks 2; not the opening, the sides and the bottom.
  EXPECT_NEAR(total(m, outer_faces(m, 1e-6)), 5.0, 1e-9);
}

}  // namespace
}  // namespace scree::edge_selection_test
