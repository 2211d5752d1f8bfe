// How far nodes may move while a corner cannot touch an edge, and which part of an edge is near a place.
#include "coupling/contact/table/contact_finder_rules.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/by_hand.h"

namespace scree::test::contact_finder_rules_test {
namespace {

using namespace coupling;

struct Uniform {
  std::mt19937_64 random{7};
  double operator()(double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100003) / 100003.0;
  }
  Vec2 direction() {
    const double angle = (*this)(0.0, 6.283185307179586);
    return {std::cos(angle), std::sin(angle)};
  }
};

bool leans(const std::array<Vec2, 4>& x) {  // corner, next node of its outline, ends of the segment
  const ContactGeometry at = contact_geometry(x[0], x[2], x[3]);
  return at.n.dot((x[1] - x[0]).normalized()) < -kWedgeTolerance;
}

TEST(AvertedRoom, is_none_for_a_side_that_does_not_lean_into_the_edge) {
  const ContactGeometry at = contact_geometry({0.5, 0.01}, {0.0, 0.0}, {1.0, 0.0});
  const Vec2 outwards = at.n;
  EXPECT_EQ(averted_room(outwards, at), 0.0);
  EXPECT_EQ(averted_room(at.t - 0.99 * kWedgeTolerance * at.n, at), 0.0);
  EXPECT_GT(averted_room(-outwards, at), 0.1);
}

/// Every node moves by the room in any direction: the side leans into the edge still. Four times as far, some do not.
TEST(AvertedRoom, is_how_far_all_nodes_may_move) {
  Uniform uniform;
  int leaning = 0, no_longer = 0;
  for (int trial = 0; trial < 200000; ++trial) {
    std::array<Vec2, 4> x{Vec2(0.0, 0.0), uniform(0.05, 3.0) * uniform.direction(),
                          uniform(0.05, 3.0) * uniform.direction(), Vec2(0.0, 0.0)};
    x[3] = x[2] + uniform(0.05, 3.0) * uniform.direction();
    if (!leans(x)) continue;
    const double room = averted_room(x[1] - x[0], contact_geometry(x[0], x[2], x[3]));
    EXPECT_GE(room, 0.0);
    for (const double part : {uniform(0.0, 1.0), 1.0}) {
      std::array<Vec2, 4> moved = x;
      for (Vec2& node : moved) node += part * room * uniform.direction();
      ASSERT_TRUE(leans(moved)) << trial;
    }
    ++leaning;
    std::array<Vec2, 4> too_far = x;
    for (Vec2& node : too_far) node += 4.0 * room * uniform.direction();
    no_longer += leans(too_far) ? 0 : 1;
  }
  EXPECT_GT(leaning, 50000);
  EXPECT_GT(no_longer, 1000);  // the room is no smaller than necessary by a large factor
}

/// All vertices within reach of a place along the edge are between those found, and at most one beyond on either side.
TEST(PartNear, contains_what_is_within_reach_of_a_place) {
  Scene scene(1e9, 0.2, 2500.0);
  scene.add("bar", rectangle(0.0, 0.0, 10.0, 1.0));
  scene.stage("nmm", Integrator::explicit_, 1.0, 0.25);
  ByHand hand(scene.model, scene.plan.stages[0]);
  const Outlines& o = hand.setup->outlines();
  IndexedVector<OutlineNode, Vec2> x(o.nodes.size());
  for (const OutlineNode i : o.nodes.indices()) x[i] = position(o.nodes[i], hand.state.q);
  Uniform uniform;
  int several = 0;
  for (const EdgeIndex e : o.edges.indices()) {
    const Outlines::Edge& edge = o.edges[e];
    const auto place = [&](std::int32_t k) { return x[o.vertices[edge.vertex(k)].node]; };
    const Vec2 along = (place(edge.segments) - place(0)).normalized();
    several += edge.segments > 10 ? 1 : 0;
    for (std::int32_t k = 0; k <= edge.segments; ++k) EXPECT_EQ(part_of(o, edge.vertex(k), e), k);
    for (int trial = 0; trial < 500; ++trial) {
      const double s = uniform(-1.0, 11.0), reach = uniform(0.01, 2.0);
      const Vec2 at = place(0) + s * along + uniform(-0.1, 0.1) * Vec2(-along.y(), along.x());
      std::int32_t nearest = 0;
      for (std::int32_t k = 0; k <= edge.segments; ++k)
        if ((place(k) - at).norm() < (place(nearest) - at).norm()) nearest = k;
      const auto [first, last] = part_near(o, x, edge, along, nearest, at, reach);
      ASSERT_LE(0, first);
      ASSERT_LE(last, edge.segments);
      for (std::int32_t k = 0; k <= edge.segments; ++k) {
        const bool within = std::abs(along.dot(place(k) - at)) < reach;
        const bool between = first <= k && k <= last, inside = first < k && k < last;
        ASSERT_TRUE(between || !within) << k;
        ASSERT_TRUE(within || !inside) << k;
      }
    }
  }
  EXPECT_EQ(several, 2);
}

}  // namespace
}  // namespace scree::test::contact_finder_rules_test
