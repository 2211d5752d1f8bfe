// Edge pairs that are skipped as quiet: none of them would have yielded a contact of a vertex and an edge.
#include "coupling/contact/table/quiet_pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "coupling/contact/table/contact_pairs.h"
#include "tests/support/by_hand.h"

namespace scree::test::quiet_pairs_test {
namespace {

using namespace coupling;

EdgePair edges(std::int32_t a, std::int32_t b) { return {EdgeIndex{a}, EdgeIndex{b}}; }

struct Quiet : ::testing::Test {
  std::vector<Vec2> x{{0.0, 0.0}, {1.0, 0.0}, {2.0, 0.0}};
  std::vector<IndexRange<OutlineNode>> moving{{OutlineNode{0}, OutlineNode{2}}};  // the last node rests
  std::vector<EdgePair> near{edges(0, 3), edges(1, 3), edges(2, 5)};
  QuietPairs pairs;

  void go(const Vec2& way, bool listed_anew = false) {
    x[1] += way;
    pairs.begin(OutlinePositions(x), moving, near, listed_anew);
  }
};

TEST_F(Quiet, until_a_node_has_gone_as_far_on_whatever_way) {
  go(Vec2(0.0, 0.0));
  EXPECT_FALSE(pairs.quiet(0));
  pairs.set(0, 1.0);
  pairs.set(1, -1.0);
  EXPECT_TRUE(pairs.quiet(0));
  EXPECT_FALSE(pairs.quiet(1));
  go(Vec2(0.3, 0.4));
  EXPECT_TRUE(pairs.quiet(0));
  go(Vec2(-0.3, -0.4));  // the path counts, not the position
  EXPECT_FALSE(pairs.quiet(0));
}

TEST_F(Quiet, until_whoever_examines_them_forgets) {
  go(Vec2(0.0, 0.0));
  pairs.set(0, 1.0);
  pairs.forget();
  go(Vec2(0.0, 0.0));
  EXPECT_FALSE(pairs.quiet(0));
}

TEST_F(Quiet, by_their_edges_when_they_are_listed_anew) {
  go(Vec2(0.0, 0.0));
  pairs.set(1, 1.0);
  pairs.set(2, 2.0);
  near = {edges(0, 2), edges(1, 3), edges(1, 4), edges(2, 5)};
  go(Vec2(0.1, 0.0), true);
  EXPECT_FALSE(pairs.quiet(0));
  EXPECT_TRUE(pairs.quiet(1));
  EXPECT_FALSE(pairs.quiet(2));
  EXPECT_TRUE(pairs.quiet(3));
  go(Vec2(1.0, 0.0));
  EXPECT_FALSE(pairs.quiet(1));
  EXPECT_TRUE(pairs.quiet(3));
}

TEST_F(Quiet, not_beside_positions_that_are_not_finite) {
  go(Vec2(0.0, 0.0));
  pairs.set(0, 1.0);
  go(Vec2(std::numeric_limits<double>::quiet_NaN(), 0.0));
  EXPECT_FALSE(pairs.quiet(0));
}

/// Polygons of 3 to 6 corners, some of them sharp, in a heap with overlapping boxes; the first is held.
Scene heap(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() % 100003) / 100003.0;
  };
  Scene scene(1e9, 0.2, 2500.0);
  scene.add("base", rectangle(-4.0, -1.0, 4.0, 0.0), true);
  for (int i = 0; i < 5; ++i) {
    const auto corners = 3 + static_cast<int>(random() % 4);
    const Vec2 centre(uniform(-2.0, 2.0), uniform(0.4, 2.0));
    const double size = uniform(0.3, 1.0), turn = uniform(0.0, 6.3), flat = uniform(0.3, 1.0);
    Polygon block;
    for (int k = 0; k < corners; ++k) {
      const double angle = turn + 6.283185307179586 * k / corners;
      block.outer.emplace_back(centre + size * Vec2(std::cos(angle), flat * std::sin(angle)));
    }
    scene.add("b" + std::to_string(i), block);
  }
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  return scene;
}

/// Bodies drift and turn within the search's slack and beyond it: with and without skipping, the pairs of each step are
/// the same.
TEST(QuietPairs, yield_what_examining_all_of_them_yields) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const Scene scene = heap(seed);
    const ByHand hand(scene.model, scene.plan.stages[0]);
    const JointSprings springs(*hand.setup);
    const Outlines& o = hand.setup->outlines();
    const KnownContacts none(o);
    ContactPairs in_turn(*hand.setup, springs, 0.2), all(*hand.setup, springs, 0.2);
    std::mt19937_64 random(seed);
    const auto uniform = [&] { return 2.0 * static_cast<double>(random() % 100003) / 100003.0 - 1.0; };
    IndexedVector<OutlineNode, Vec2> x;
    for (const Row& node : o.nodes) x.push_back(position(node, hand.state.q));
    std::vector<Vec2> way(hand.setup->bodies().size(), Vec2(0.0, 0.0));
    std::vector<double> spin(way.size(), 0.0);
    for (int step = 0; step < 300; ++step) {
      for (std::size_t b = 1; b < way.size() && step % 50 == 0; ++b) {
        way[b] = 0.004 * Vec2(uniform(), uniform());
        spin[b] = 0.01 * uniform();
      }
      for (const OutlineNode i : x.indices()) {
        const std::size_t b = o.node_body[i].index();
        const Vec2 from_centre = x[i] - hand.setup->bodies()[b].centre;
        x[i] += way[b] + spin[b] * Vec2(-from_centre.y(), from_centre.x());
      }
      const auto one = in_turn.update(x, none, ContactPairs::Of::all_in_turn);
      const auto other = all.update(x, none, ContactPairs::Of::all);
      ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end())) << seed << " step " << step;
      found += one.size();
    }
  }
  EXPECT_GT(found, 10000U);
}

/// Inclined slabs of 20 x 0.2 m: all boxes overlap, but each slab has only two neighbours.
TEST(QuietPairs, slabs_that_dip_are_pairs_of_their_neighbours_alone) {
  constexpr int kSlabs = 40;
  Scene scene(1e9, 0.2, 2500.0);
  const Mat2 turned = rotation(-0.5);
  for (int i = 0; i < kSlabs; ++i)
    scene.add("slab" + std::to_string(i), transformed(rectangle(0, 0.2 * i, 20, 0.2 * (i + 1)), Vec2(0, 0), turned));
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  const ByHand hand(scene.model, scene.plan.stages[0]);
  const JointSprings springs(*hand.setup);
  const Outlines& o = hand.setup->outlines();
  const KnownContacts none(o);
  ContactPairs in_turn(*hand.setup, springs, 0.1), all(*hand.setup, springs, 0.1);
  IndexedVector<OutlineNode, Vec2> x;
  for (const Row& node : o.nodes) x.push_back(position(node, hand.state.q));
  for (int step = 0; step < 100; ++step) {
    for (const OutlineNode i : x.indices())  // they part along the dip, and fan out
      x[i] += 1e-4 * static_cast<double>(o.node_body[i].index()) * (turned * Vec2(1.0, 0.02 * x[i].x()));
    const auto one = in_turn.update(x, none, ContactPairs::Of::all_in_turn);
    const auto other = all.update(x, none, ContactPairs::Of::all);
    ASSERT_TRUE(std::equal(one.begin(), one.end(), other.begin(), other.end())) << "step " << step;
    // Two per joint while the slabs lie flush, more where their ends part: proportional to the number of slabs.
    if (step == 0) {
      EXPECT_GE(one.size(), 2U * (kSlabs - 1));
    }
    EXPECT_LE(one.size(), 16U * kSlabs) << "step " << step;
  }
}

}  // namespace
}  // namespace scree::test::quiet_pairs_test
