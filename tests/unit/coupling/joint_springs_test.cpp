// Springs of contact points from joint laws and the two blocks: governing law, stiffness and length, by hand.
#include "coupling/contact/law/joint_springs.h"

#include <gtest/gtest.h>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::joint_springs_test {
namespace {

using namespace coupling;

/// Two stacked blocks: 4 x 1 m below, 2 x 3 m above, of two materials, with two laws in addition to the default.
struct Pair {
  Scene scene{2e9, 0.2, 2500.0, 45.0};
  JointId one, two;
  Pair() {
    scene.model.materials.push_back({"soft", 2500.0, 1e9, 0.2});
    scene.add("lower", rectangle(0, 0, 4, 1));
    scene.add("upper", rectangle(1, 1, 3, 4));
    scene.model.blocks[1].material = MaterialId{1};
    one = law("one", 30.0);
    two = law("two", 20.0);
    scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  }
  JointId law(const char* name, double friction_deg) {
    JointLaw l;
    l.name = name;
    l.friction = friction_deg * kDegree;
    scene.model.joints.push_back(l);
    return JointId{static_cast<std::int32_t>(scene.model.joints.size()) - 1};
  }
  /// Calls `ask` with the top edge of the lower block and the bottom edge of the upper one.
  template <class Ask>
  auto with(Ask&& ask) const {
    const ByHand hand(scene.model, scene.plan.stages[0]);
    const JointSprings springs(*hand.setup);
    return ask(springs, hand.setup->edge_of(0, 0, 2), hand.setup->edge_of(1, 0, 0));
  }
  /// The law between the two blocks, which must not depend on their order.
  [[nodiscard]] JointId law_of(JointId lower, JointId upper) {
    scene.model.blocks[0].joint = lower;
    scene.model.blocks[1].joint = upper;
    JointId found[2];
    for (const bool reversed : {false, true})
      found[reversed ? 1 : 0] = with(
          [&](const JointSprings& s, EdgeIndex a, EdgeIndex b) { return reversed ? s.law_of(b, a) : s.law_of(a, b); });
    EXPECT_EQ(found[0].value, found[1].value);
    return found[0];
  }
};

TEST(JointSprings, law_of_two_edges_is_that_of_the_one_that_names_one) {
  Pair pair;
  EXPECT_EQ(pair.law_of({}, {}).value, pair.scene.model.default_joint.value);
  EXPECT_EQ(pair.law_of(pair.one, {}).value, pair.one.value);
  EXPECT_EQ(pair.law_of({}, pair.two).value, pair.two.value);
}

TEST(JointSprings, law_of_two_edges_that_both_name_one_has_the_smaller_friction) {
  Pair pair;
  EXPECT_EQ(pair.law_of(pair.one, pair.two).value, pair.two.value);
  EXPECT_EQ(pair.law_of(pair.two, pair.one).value, pair.two.value);
  // Equal friction: the law that is first in the model governs, whatever else differs.
  const JointId third = pair.law("three", 20.0);
  pair.scene.model.joints[third.index()].cohesion = 1e6;
  EXPECT_EQ(pair.law_of(third, pair.two).value, pair.two.value);
  EXPECT_EQ(pair.law_of(pair.two, third).value, pair.two.value);
}

TEST(JointSprings, auto_stiffness_is_the_larger_modulus_over_width_of_the_two_blocks) {
  Pair pair;
  const double lower = pair.scene.model.elasticity_of(BlockId{0}).p_modulus() / 1.0,
               upper = pair.scene.model.elasticity_of(BlockId{1}).p_modulus() / 3.0;
  EXPECT_GT(lower, upper);
  pair.with([&](const JointSprings& s, EdgeIndex a, EdgeIndex b) {
    EXPECT_DOUBLE_EQ(s.normal_stiffness(pair.one, a, b), lower);
    EXPECT_DOUBLE_EQ(s.normal_stiffness(pair.one, b, a), lower);
    EXPECT_DOUBLE_EQ(s.width(a), 1.0);  // along the edge's normal
    EXPECT_DOUBLE_EQ(s.width(b), 3.0);
    const Springs half = s.springs(pair.one, a, b, 0.5);
    EXPECT_DOUBLE_EQ(half.kn, 0.5 * lower);
    EXPECT_DOUBLE_EQ(half.kt, 0.5 * lower);
    EXPECT_DOUBLE_EQ(half.tributary, 0.5);
  });
}

TEST(JointSprings, corner_stands_for_a_tenth_of_the_smaller_block) {
  Pair pair;
  pair.with([&](const JointSprings& s, EdgeIndex a, EdgeIndex b) {
    EXPECT_DOUBLE_EQ(s.corner_length(pair.one, a, b), 0.1 * 2.0);  // from the root of 4 m2, not of 6 m2
    EXPECT_DOUBLE_EQ(s.corner_length(pair.one, b, a), 0.1 * 2.0);
  });
  pair.scene.model.joints[pair.one.index()].contact_length = 0.07;
  pair.with([&](const JointSprings& s, EdgeIndex a, EdgeIndex b) {
    EXPECT_DOUBLE_EQ(s.corner_length(pair.one, a, b), 0.07);
  });
}

TEST(JointSprings, given_stiffness_is_per_area_and_a_penalty_a_point) {
  Pair pair;
  JointLaw& law = pair.scene.model.joints[pair.one.index()];
  law.normal_stiffness = 3e9;
  law.shear_stiffness = 1e9;
  pair.with([&](const JointSprings& s, EdgeIndex a, EdgeIndex b) {
    const Springs found = s.springs(pair.one, a, b, 0.4);
    EXPECT_DOUBLE_EQ(found.kn, 1.2e9);
    EXPECT_DOUBLE_EQ(found.kt, 0.4e9);
    EXPECT_TRUE(s.per_area(pair.one));
  });
  law.penalty = 5e10;
  law.shear_penalty = 2e10;
  pair.with([&](const JointSprings& s, EdgeIndex a, EdgeIndex b) {
    const Springs found = s.springs(pair.one, a, b, 0.4);
    EXPECT_DOUBLE_EQ(found.kn, 5e10);
    EXPECT_DOUBLE_EQ(found.kt, 2e10);
    EXPECT_DOUBLE_EQ(found.tributary, 0.4);
    EXPECT_FALSE(s.per_area(pair.one));
  });
}

}  // namespace
}  // namespace scree::test::joint_springs_test
