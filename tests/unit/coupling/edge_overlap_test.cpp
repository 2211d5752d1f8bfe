// Tributary lengths in the overlap of two edges, against moments of the overlap by hand.
#include "coupling/contact/geometry/edge_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tests/support/scene.h"

namespace scree::test::edge_overlap_test {
namespace {

using coupling::EdgeIndex;
using coupling::EdgeOverlap;
using coupling::leaving;
using coupling::OutlineNode;
using coupling::Outlines;
using coupling::OverlapPoint;
using coupling::VertexIndex;

/// Edges made of points alone, which is all that EdgeOverlap reads from outlines.
struct Lines {
  Outlines outlines;
  IndexedVector<OutlineNode, Vec2> x;

  /// The points of an edge in its own direction, at least two.
  EdgeIndex add(const std::vector<Vec2>& points) {
    Outlines::Edge e;
    const EdgeIndex edge = outlines.edges.next();
    e.body = BodyIndex{edge.value};
    e.first_segment = leaving(outlines.vertices.next());
    e.segments = static_cast<std::int32_t>(points.size()) - 1;
    e.end_vertex = e.first_vertex() + e.segments;
    for (const Vec2& p : points) {
      outlines.vertices.push_back({x.next(), e.body, {}, edge, edge, false});
      x.push_back(p);
    }
    outlines.edges.push_back(e);
    return edge;
  }
  [[nodiscard]] double along(const OverlapPoint& p, const Vec2& t) const {
    return t.dot(x[outlines.vertices[p.vertex].node]);
  }
};

/// Integral of |s - k| over [low, high].
double integral_of_kink(double k, double low, double high) {
  const auto half = [](double a, double b) { return 0.5 * (b * b - a * a); };
  if (k <= low) return half(low - k, high - k);
  if (k >= high) return half(k - high, k - low);
  return half(0.0, k - low) + half(0.0, high - k);
}

std::vector<double> kinks(std::mt19937_64& random, double low, double high, int between) {
  std::vector<double> s{low, high};
  for (int i = 0; i < between; ++i)
    s.push_back(low + (high - low) * (static_cast<double>(random() % 997) + 1.0) / 999.0);
  std::sort(s.begin(), s.end());
  s.erase(std::unique(s.begin(), s.end()), s.end());
  return s;
}

/// Edge a along +x at height 0, edge b against it at height gap, both turned by Q.
struct Facing {
  Lines lines;
  EdgeIndex a, b;
  Vec2 t;
  double low = 0.0, high = 0.0;
  std::vector<double> sa, sb;
  explicit Facing(std::uint64_t seed, double tilt = 0.0) {
    std::mt19937_64 random(seed);
    const auto number = [&] { return static_cast<double>(random() % 10000) / 1e4; };
    sa = kinks(random, -number(), 1.0 + number(), static_cast<int>(random() % 6));
    sb = kinks(random, -0.5 + number(), 0.9 + number(), static_cast<int>(random() % 6));
    const Mat2 Q = rotation(6.28 * number()), Qb = rotation(tilt);
    t = Q * Vec2(1.0, 0.0);
    std::vector<Vec2> pa, pb;
    for (const double s : sa) pa.push_back(Q * Vec2(s, 0.0));
    for (const double s : sb) pb.push_back(Q * (Qb * Vec2(s, 1e-3)));
    std::reverse(pb.begin(), pb.end());
    a = lines.add(pa);
    b = lines.add(pb);
    low = std::max(t.dot(pa.front()), t.dot(pb.back()));
    high = std::min(t.dot(pa.back()), t.dot(pb.front()));
  }
};

TEST(EdgeOverlap, shares_are_positive_and_add_to_the_overlap) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Facing f(seed, seed % 3 == 0 ? 4.0 * kDegree : 0.0);
    for (const bool middle : {true, false}) {
      EdgeOverlap overlap;
      double sum = 0.0;
      for (const OverlapPoint& p : overlap.divide(f.lines.outlines, f.lines.x, f.a, f.b, f.t, middle)) {
        EXPECT_GT(p.tributary, 0.0);
        EXPECT_EQ(p.edge, f.lines.outlines.vertices[p.vertex].edge_out == f.a ? f.b : f.a);
        sum += p.tributary;
      }
      EXPECT_NEAR(sum, f.high - f.low, 1e-14) << "seed " << seed;
    }
  }
}

/// Pressures linear between the vertices pass exactly: shares integrate s and every |s - s_k| with s_k a vertex.
TEST(EdgeOverlap, pressures_with_kinks_at_vertices_pass_exactly) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Facing f(seed);
    EdgeOverlap overlap;
    const auto points = overlap.divide(f.lines.outlines, f.lines.x, f.a, f.b, f.t, true);
    double first = 0.0;
    for (const OverlapPoint& p : points) first += p.tributary * f.lines.along(p, f.t);
    EXPECT_NEAR(first, 0.5 * (f.high * f.high - f.low * f.low), 1e-14);
    for (const std::vector<double>* s : {&f.sa, &f.sb})
      for (const double k : *s) {
        double moment = 0.0;
        for (const OverlapPoint& p : points) moment += p.tributary * std::abs(f.lines.along(p, f.t) - k);
        EXPECT_NEAR(moment, integral_of_kink(k, f.low, f.high), 2e-14) << "seed " << seed << " kink " << k;
      }
  }
}

/// The points and their tributary lengths are the same if the sides are exchanged or mirrored.
TEST(EdgeOverlap, sides_may_be_exchanged_and_mirrored) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) {
    const Facing f(seed);
    EdgeOverlap overlap;
    std::map<VertexIndex, double> one, other, image;
    for (const OverlapPoint& p : overlap.divide(f.lines.outlines, f.lines.x, f.a, f.b, f.t, true))
      one[p.vertex] = p.tributary;
    for (const OverlapPoint& p : overlap.divide(f.lines.outlines, f.lines.x, f.b, f.a, -f.t, true))
      other[p.vertex] = p.tributary;
    // A reflection in the line across t reverses the direction of both edges.
    Lines mirror;
    const auto reflected = [&](EdgeIndex edge) {
      std::vector<Vec2> points;
      const Outlines::Edge& e = f.lines.outlines.edges[edge];
      for (std::int32_t k = e.segments; k >= 0; --k) {
        const Vec2& p = f.lines.x[f.lines.outlines.vertices[e.vertex(k)].node];
        points.emplace_back(p - 2.0 * f.t.dot(p) * f.t);
      }
      return mirror.add(points);
    };
    const EdgeIndex a = reflected(f.a), b = reflected(f.b);
    for (const OverlapPoint& p : overlap.divide(mirror.outlines, mirror.x, a, b, f.t, true)) {
      const Outlines::Edge& e = mirror.outlines.edges[p.edge == b ? a : b];
      image[e.end_vertex - (p.vertex - e.first_vertex())] = p.tributary;
    }
    ASSERT_EQ(one.size(), other.size()) << "seed " << seed;
    ASSERT_EQ(one.size(), image.size()) << "seed " << seed;
    for (const auto& [vertex, share] : one) {
      EXPECT_NEAR(other[vertex], share, 1e-14);
      EXPECT_NEAR(image[vertex], share, 1e-14);
    }
  }
}

TEST(EdgeOverlap, vertices_that_match_exactly_count_once) {
  Lines lines;
  const std::vector<Vec2> points{{0.0, 0.0}, {0.25, 0.0}, {0.75, 0.0}, {1.0, 0.0}};
  const EdgeIndex a = lines.add(points), b = lines.add({points.rbegin(), points.rend()});
  EdgeOverlap overlap;
  std::map<double, double> at;
  std::size_t ends = 0;
  for (const OverlapPoint& p : overlap.divide(lines.outlines, lines.x, a, b, Vec2(1.0, 0.0), true)) {
    const double s = lines.along(p, Vec2(1.0, 0.0));
    at[s] += p.tributary;
    ends += s == 0.0 || s == 1.0 ? 1U : 0U;
  }
  EXPECT_EQ(at, (std::map<double, double>{{0.0, 0.125}, {0.25, 0.375}, {0.75, 0.375}, {1.0, 0.125}}));
  EXPECT_EQ(ends, 2U);  // one of the two coincident vertices
}

TEST(EdgeOverlap, edges_beside_each_other_share_nothing) {
  Lines lines;
  const EdgeIndex a = lines.add({{0.0, 0.0}, {1.0, 0.0}}), touching = lines.add({{2.0, 0.0}, {1.0, 0.0}}),
                  apart = lines.add({{3.0, 0.0}, {1.5, 0.0}});
  EdgeOverlap overlap;
  EXPECT_TRUE(overlap.divide(lines.outlines, lines.x, a, touching, Vec2(1.0, 0.0), true).empty());
  EXPECT_TRUE(overlap.divide(lines.outlines, lines.x, a, apart, Vec2(1.0, 0.0), true).empty());
}

}  // namespace
}  // namespace scree::test::edge_overlap_test
