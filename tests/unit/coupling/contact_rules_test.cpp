// Rules of the contact search, each at its threshold: which edge holds a corner, which points are listed, when a corner
// becomes part of an overlap.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "coupling/contact/contact_energy.h"
#include "coupling/contact/table/contact_finder.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::contact_rules_test {
namespace {

using namespace coupling;

/// A held block 0 and a free block 1 that can be placed anywhere.
struct Two {
  static constexpr double kDetection = 0.02;
  Scene scene{1e9, 0.2, 2500.0};
  std::unique_ptr<ByHand> hand;
  std::unique_ptr<ContactFinder> finder;
  Two(const Polygon& held, const Polygon& free, const char* method = "dda") {
    scene.add("held", held, true);
    scene.add("free", free);
    scene.stage(method, Integrator::explicit_, 1.0, std::nullopt);
    hand = std::make_unique<ByHand>(scene.model, scene.plan.stages[0]);
    finder = std::make_unique<ContactFinder>(*hand->setup, kDetection);
  }
  /// The list with the free block displaced by u from its position in the model.
  ContactList at(const Vec2& u, const ContactList& known) {
    const Body& b = hand->setup->bodies()[1];
    const std::span<const double> t = hand->setup->pool_of(b).translation(b.index);
    std::vector<double> q = hand->state.q;
    for (std::size_t k = 0; k < t.size(); ++k)
      for (std::size_t d = 0; d < 2; ++d)
        q[2 * (static_cast<std::size_t>(b.first_node) + k) + d] += t[k] * u[static_cast<Eigen::Index>(d)];
    ContactList out;
    finder->find(q, known, false, out);
    return out;
  }
  ContactList at(const Vec2& u) { return at(u, {}); }
};

/// Index of the contact point of a vertex of block `p` and an edge of block `e`; -1: none.
std::ptrdiff_t index_of(const ContactList& list, std::int32_t p, std::int32_t vertex, std::int32_t e,
                        std::int32_t edge) {
  const auto found = std::find_if(list.points.begin(), list.points.end(), [&](const ContactPoint& c) {
    return c.key.block_p == p && c.key.vertex == vertex && c.key.block_e == e && c.key.edge == edge;
  });
  return found == list.points.end() ? -1 : found - list.points.begin();
}

void close(ContactList& list, std::ptrdiff_t i, double gap) {
  ContactMemory& m = list.memory[static_cast<std::size_t>(i)];
  m.status = ContactStatus::stick;
  m.gap0 = 0.0;
  m.gap = gap;
}

/// A corner in the corner of another block is held by its present edge until the other edge is twice as near.
TEST(CornerRules, edge_that_holds_a_corner_keeps_it_until_the_other_is_twice_as_near) {
  constexpr std::int32_t kRight = 1, kTop = 2;
  for (const std::int32_t holds : {kTop, kRight}) {
    Two two(rectangle(-2, -2, 0, 0), rectangle(0, 0, 1, 1));
    // 1 mm behind the edge that holds the corner.
    const auto moved = [&](double other) { return holds == kTop ? Vec2(-other, -0.001) : Vec2(-0.001, -other); };
    ContactList known = two.at(moved(0.01));
    const std::ptrdiff_t held = index_of(known, 1, 0, 0, holds);
    ASSERT_GE(held, 0);
    for (ContactMemory& m : known.memory) {
      m.gap0 = 0.0;
      m.gap = 1e-4;  // just open
    }
    close(known, held, -0.001);
    for (const double other : {0.0030, 0.0009, 0.0006, 0.0004, 0.0001}) {
      const bool kept = other > 0.0005;
      const ContactList now = two.at(moved(other), known);
      const std::ptrdiff_t h = index_of(now, 1, 0, 0, holds), o = index_of(now, 1, 0, 0, holds == kTop ? kRight : kTop);
      ASSERT_GE(h, 0);
      ASSERT_GE(o, 0);
      EXPECT_NE(now.points[static_cast<std::size_t>(h)].suppressed, kept) << holds << ' ' << other;
      EXPECT_EQ(now.points[static_cast<std::size_t>(o)].suppressed, kept) << holds << ' ' << other;
    }
  }
}

/// Neither edge holds the corner yet: the nearer one does.
TEST(CornerRules, corner_that_nothing_holds_leaves_by_the_nearer_edge) {
  Two two(rectangle(-2, -2, 0, 0), rectangle(0, 0, 1, 1));
  ContactList known = two.at({-0.01, -0.001});
  for (ContactMemory& m : known.memory) {
    m.gap0 = 0.0;
    m.gap = 1e-4;
  }
  for (const double other : {0.0009, 0.0011}) {
    const ContactList now = two.at({-other, -0.001}, known);
    EXPECT_EQ(now.points[static_cast<std::size_t>(index_of(now, 1, 0, 0, 2))].suppressed, other < 0.001);
    EXPECT_EQ(now.points[static_cast<std::size_t>(index_of(now, 1, 0, 0, 1))].suppressed, other > 0.001);
  }
}

/// The tip of a thin wedge is pressed into the block below: the block's corner is above the wedge's upper side, which
/// cannot hold it since the block's rock lies below that side; the lower side continues to carry.
TEST(CornerRules, wide_corner_does_not_touch_the_side_above_it) {
  Two two({{{-5, -2}, {10, -2}, {10, -0.7}, {0, 0}, {-5, 0}}, {}}, {{{0, 0}, {10, -0.7}, {10, 0}}, {}});
  constexpr std::int32_t kCorner = 3, kLower = 0, kUpper = 2;
  const ContactList now = two.at({-1e-7, -4e-7});
  EXPECT_EQ(index_of(now, 0, kCorner, 1, kUpper), -1);
  const std::ptrdiff_t carries = index_of(now, 0, kCorner, 1, kLower);
  ASSERT_GE(carries, 0);
  EXPECT_FALSE(now.points[static_cast<std::size_t>(carries)].suppressed);
  EXPECT_LT(now.points[static_cast<std::size_t>(carries)].at.gap, 0.0);
}

/// A corner that is more than half way through a plate when first detected has entered over the plate's end.
TEST(CornerRules, corner_first_seen_beyond_the_middle_of_a_plate_is_not_pressed_through) {
  Two two(rectangle(-1, 0, 1, 0.01), rectangle(0.95, 0.01, 2, 1));
  EXPECT_GE(index_of(two.at({0.0, -0.004}), 1, 0, 0, 2), 0);
  EXPECT_EQ(index_of(two.at({0.0, -0.006}), 1, 0, 0, 2), -1);
  // A corner that was detected before it went so far is held.
  const ContactList before = two.at({0.0, 0.001});
  ASSERT_GE(index_of(before, 1, 0, 0, 2), 0);
  EXPECT_GE(index_of(two.at({0.0, -0.006}, before), 1, 0, 0, 2), 0);
}

/// A tip that was pressed far deeper than the search distance is still held by the edge of its closed contact point.
TEST(CornerRules, closed_corner_is_held_however_deep) {
  Two two(rectangle(-2, -2, 2, 0), {{{0, 0}, {0.05, 0.1}, {-0.05, 0.1}}, {}});  // small: all of it is this deep
  ContactList known = two.at({0.0, 0.001});
  const std::ptrdiff_t tip = index_of(known, 1, 0, 0, 2);
  ASSERT_GE(tip, 0);
  EXPECT_EQ(index_of(two.at({0.0, -0.5}, known), 1, 0, 0, 2), -1);  // open, and beyond the search distance
  close(known, tip, -0.45);
  const ContactList now = two.at({0.0, -0.5}, known);
  const std::ptrdiff_t held = index_of(now, 1, 0, 0, 2);
  ASSERT_GE(held, 0);
  EXPECT_NEAR(now.memory[static_cast<std::size_t>(held)].gap, -0.5, 1e-12);
}

/// A corner that begins to face an edge stays a corner until the tributary length of the overlap reaches that of the
/// corner, or half of the largest of the vertex; then its springs change and its force does not.
TEST(CornerRules, corner_becomes_part_of_an_overlap_once_that_is_worth_as_much) {
  Two two(rectangle(-2, -2, 2, 0), rectangle(0, 0, 1, 1));
  const double stiffness = 4e8;  // per length
  const auto adopted = [&](double had, double overlap, double largest) {
    ContactList list;
    ContactPoint& p = list.points.emplace_back();
    p.edge_edge = true;
    p.largest_tributary = largest;
    p.springs = {overlap, overlap * stiffness, overlap * stiffness};
    p.at.length = 1.0;
    ContactMemory& m = list.memory.emplace_back();
    m.status = ContactStatus::stick;
    m.tributary = had;
    m.kn = had * stiffness;
    m.kt = 0.5 * had * stiffness;
    m.gap = -1e-4;
    m.stretch = 3e-5;
    const double fn = m.kn * m.gap, ft = m.kt * m.stretch,
                 before = 0.5 * (m.kn * m.gap * m.gap + m.kt * m.stretch * m.stretch);
    const double change = two.finder->adopt_kinds(list);
    EXPECT_NEAR(m.kn * m.gap / fn, 1.0, 1e-12);
    EXPECT_NEAR(m.kt * m.stretch / ft, 1.0, 1e-12);
    EXPECT_NEAR(change, 0.5 * (m.kn * m.gap * m.gap + m.kt * m.stretch * m.stretch) - before, 1e-12 * before);
    return m.edge_edge == 1;
  };
  EXPECT_FALSE(adopted(0.1, 0.09, 1.0));  // less than the corner had
  EXPECT_TRUE(adopted(0.1, 0.11, 1.0));
  EXPECT_FALSE(adopted(0.4, 0.24, 0.5));  // half of the largest length is 0.25, less than the corner had
  EXPECT_TRUE(adopted(0.4, 0.26, 0.5));
}

TEST(CornerRules, corner_at_the_far_end_of_a_short_edge_begins_without_force) {
  // A wedge with a side of 0.1 m at its end, against a block whose corner touches the upper end of that side: the
  // corner is 0.1 m behind the line of the wedge's lower side, above its end.
  const Polygon wedge{{{0, 0}, {2, 0}, {2, 0.1}, {0, 3}}, {}}, tall{{{2, -1}, {3, -1}, {3, -0.4}, {2, 0.1}}, {}};
  for (const bool wedge_first : {true, false}) {
    Scene scene(1e9, 0.2, 2500.0);
    scene.add("one", wedge_first ? wedge : tall);
    scene.add("other", wedge_first ? tall : wedge);
    scene.stage("dda", Integrator::implicit, 1.0, 1e-3);
    const ByHand hand(scene.model, scene.plan.stages[0]);
    ContactFinder finder(*hand.setup, 0.15);
    ContactList list;
    finder.find(hand.state.q, {}, true, list);
    bool beside = false;
    for (std::size_t i = 0; i < list.points.size(); ++i) {
      EXPECT_EQ(contact_energy(list), 0.0) << wedge_first;
      EXPECT_TRUE(list.memory[i].gap >= 0.0 || list.points[i].suppressed || list.points[i].beyond) << wedge_first;
      beside = beside || list.points[i].at.gap < -0.09;
    }
    EXPECT_TRUE(beside) << wedge_first;
  }
}

/// Dashpots of a corner that stands on a held edge: the law's fraction of critical, 2 sqrt(k/mu), of either spring.
TEST(CornerRules, dashpots_of_a_corner_are_the_fraction_of_critical_that_its_law_gives) {
  const double width = 1.4, height = 1.0, mass = 2500.0 * width * height, fraction = 0.3;
  for (const double shear : {2e9, 5e9}) {
    Scene scene(1e9, 0.2, 2500.0);
    scene.model.joints[0].penalty = 5e9;
    scene.model.joints[0].shear_penalty = shear;
    scene.model.joints[0].damping = fraction;
    scene.add("held", rectangle(-3, -1, 3, 0), true);
    scene.add("free", transformed(rectangle(0, 0, width, height), Vec2(0, 0), rotation(0.7)));
    scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
    const ByHand hand(scene.model, scene.plan.stages[0]);
    ContactFinder finder(*hand.setup, 0.02);
    ContactList list;
    finder.find(hand.state.q, {}, true, list);
    ASSERT_EQ(list.points.size(), 1U);
    // Compliance of a corner of a rectangle: 1/m, and 12 (1/4 + 1/4)/m of its two stretches; the held block adds none.
    const double compliance = 7.0 / mass;
    EXPECT_NEAR(list.points[0].cn, 2.0 * fraction * std::sqrt(5e9 / compliance), 1e-3);
    EXPECT_NEAR(list.points[0].ct, 2.0 * fraction * std::sqrt(shear / compliance), 1e-3);
  }
}

/// The segment of a divided edge that lies below a vertex is looked for from where it was last time, however far away.
TEST(ContactFinder, segment_below_a_vertex_is_the_same_from_wherever_it_was_before) {
  Two two(rectangle(0, -1, 6, 0), rectangle(2, 0, 3, 1), "nmm");
  const std::array ways{-1.7, -0.6, 0.0, 0.3, 1.1, 2.6};
  int apart = 0, compared = 0;
  for (const double from : ways)
    for (const double to : ways) {
      const ContactList known = two.at({from, 1e-3}), fresh = two.at({to, 1e-3}), now = two.at({to, 1e-3}, known);
      ASSERT_EQ(now.points.size(), fresh.points.size());
      for (std::size_t i = 0; i < now.points.size(); ++i) {
        ASSERT_EQ(now.points[i].key, fresh.points[i].key);
        EXPECT_EQ(now.points[i].segment, fresh.points[i].segment) << from << ' ' << to;
        if (now.points[i].from < 0) continue;
        ++compared;
        const ContactPoint& was = known.points[static_cast<std::size_t>(now.points[i].from)];
        apart = std::max(apart, std::abs(was.segment - now.points[i].segment));
      }
    }
  EXPECT_GE(compared, 60);
  EXPECT_GE(apart, 7);
}

/// A vertex between two edges in line faces one edge with both: its share is the sum of theirs, also where shares are
/// updated without sorting the pairs again.
TEST(ContactPairs, share_of_a_vertex_between_two_edges_in_line_is_that_of_both) {
  Two two(rectangle(-2, -1, 4, 0), {{{0, 0}, {0.6, 0}, {1, 0}, {1, 1}, {0, 1}}, {}});
  const Outlines& o = two.hand->setup->outlines();
  const JointSprings springs(*two.hand->setup);
  const KnownContacts none(o);
  ContactPairs pairs(*two.hand->setup, springs, 0.2);
  IndexedVector<OutlineNode, Vec2> x;
  for (const Row& node : o.nodes) x.push_back(position(node, two.hand->state.q));
  for (int step = 0; step < 5; ++step) {
    const auto now = pairs.update(x, none);
    const auto middle = std::max_element(
        now.begin(), now.end(), [](const VertexEdge& p, const VertexEdge& q) { return p.tributary < q.tributary; });
    ASSERT_NE(middle, now.end());
    EXPECT_NEAR(x[o.vertices[middle->vertex].node].x(), 0.6 + 0.01 * step, 1e-12);
    EXPECT_NEAR(middle->tributary, 0.5, 1e-12) << "step " << step;
    EXPECT_NEAR(middle->behind + middle->ahead, 1.0, 1e-12) << "step " << step;
    ContactPairs fresh(*two.hand->setup, springs, 0.2);
    const auto anew = fresh.update(x, none);
    EXPECT_TRUE(std::equal(now.begin(), now.end(), anew.begin(), anew.end())) << "step " << step;
    for (const OutlineNode i : x.indices())
      if (o.node_body[i].index() == 1) x[i] += Vec2(0.01, 0.0);
  }
}

}  // namespace
}  // namespace scree::test::contact_rules_test
