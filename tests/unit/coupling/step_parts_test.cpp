// Parts of contacts, supports and dashpots in the certified step, against frequencies of a block by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "coupling/integrate/step_bound.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::step_parts_test {
namespace {

using namespace coupling;

constexpr double kDensity = 2000.0, kWidth = 1.4, kHeight = 1.0, kMass = kDensity * kWidth * kHeight;

/// Compliance of a DDA block kWidth x kHeight: acceleration of a point at r from the centre per unit force [1/kg].
double compliance(const Vec2& r) {
  return (1.0 + 12.0 * (r.x() * r.x() / (kWidth * kWidth) + r.y() * r.y() / (kHeight * kHeight))) / kMass;
}

/// lambda in the bound h^2 lambda = 4 of a scene's first stage.
double lambda(const Scene& scene, const ExplicitDamping& damping = {}) {
  ByHand hand(scene.model, scene.plan.stages[0]);
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05, damping);
  integrator.enter(hand.state);
  const double h = integrator.stable_step(hand.state, nullptr);
  return 4.0 / (h * h);
}

Scene one_block(double young) {
  Scene scene(young, 0.0, kDensity);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0.0, 0.0, kWidth, kHeight));
  scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  return scene;
}

TEST(StepParts, own_stiffness_of_a_rectangle_is_that_of_its_shorter_side) {
  // With Poisson's ratio 0 the block stretches along its sides at 12 E/(rho a^2) and 12 E/(rho b^2), and shears at
  // 6 E/rho (1/a^2 + 1/b^2): here the shorter side is the stiffest.
  EXPECT_NEAR(lambda(one_block(1e8)) / (12.0 * 1e8 / (kDensity * kHeight * kHeight)), 1.0, 1e-12);
}

TEST(StepParts, slow_step_resolves_half_a_radian_of_the_stiffest_slow_block) {
  Scene scene = one_block(1e8);
  State state;
  state.bodies = initial_records(scene.model, body_requests(scene.model, scene.plan.stages[0]));
  Ghosts ghosts;
  ghosts.slow = {1};
  const coupling::Setup setup(scene.model, methods(), state.bodies, ghosts);
  std::string binding;
  EXPECT_NEAR(slow_step(setup, &binding) * std::sqrt(12.0 * 1e8 / (kDensity * kHeight * kHeight)), 0.5, 1e-12);
  EXPECT_NE(binding.find("block 'block'"), std::string::npos) << binding;
}

TEST(StepParts, support_counts_with_its_stiffness_whichever_axis_it_fixes) {
  const double own = lambda(one_block(1e7)), k = 3e9;
  const Vec2 point(1.1, 0.8);
  const double expected = own + k * compliance(point - Vec2(0.5 * kWidth, 0.5 * kHeight));
  for (const auto& [x, y] : {std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    Scene scene = one_block(1e7);
    scene.model.point_supports.push_back({BlockId{0}, point, x, y, k});
    EXPECT_NEAR(lambda(scene) / expected, 1.0, 1e-12) << x << y;
  }
}

TEST(StepParts, supports_of_one_block_add_up) {
  const double own = lambda(one_block(1e7)), k = 3e9;
  Scene scene = one_block(1e7);
  double expected = own;
  for (const Vec2& point : {Vec2(0.0, 0.0), Vec2(1.1, 0.8), Vec2(0.7, 0.5)}) {
    scene.model.point_supports.push_back({BlockId{0}, point, true, true, k});
    expected += k * compliance(point - Vec2(0.5 * kWidth, 0.5 * kHeight));
  }
  EXPECT_NEAR(lambda(scene) / expected, 1.0, 1e-12);
}

TEST(StepParts, support_without_a_stiffness_has_ten_times_the_modulus_of_its_rock) {
  Scene scene = one_block(1e7);  // nu = 0: K + 4 G/3 = E
  scene.model.point_supports.push_back({BlockId{0}, {0.3, 0.2}, true, false, {}});
  ByHand hand(scene.model, scene.plan.stages[0]);
  const std::vector<PointSpring> springs = point_springs(*hand.setup, hand.state);
  ASSERT_EQ(springs.size(), 1U);
  EXPECT_DOUBLE_EQ(springs[0].k.x(), 10.0 * 1e7);
  EXPECT_EQ(springs[0].k.y(), 0.0);
}

/// A block on one corner, bonded so that the contact never opens: this contact has the only spring.
struct OnATip {
  static constexpr double kPenalty = 5e9;
  Scene scene{1e5, 0.0, kDensity};
  explicit OnATip(double damping) {
    scene.model.gravity = {0.0, 0.0};
    JointLaw& law = scene.model.joints[0];
    law.penalty = kPenalty;
    law.damping = damping;
    law.tensile_strength = std::numeric_limits<double>::infinity();
    scene.add("base", rectangle(-3, -1, 3, 0), true);
    scene.add("block", transformed(rectangle(0, 0, kWidth, kHeight), Vec2(0.0, 0.0), rotation(0.7)));
    scene.stage("dda", Integrator::explicit_, 1.0, std::nullopt);
  }
  [[nodiscard]] double bound() const { return 2.0 / std::sqrt(lambda(scene)); }
  /// Kinetic energy after 3000 steps over that of the start, a tiny velocity in every unknown.
  [[nodiscard]] double growth(double h) const {
    ByHand hand(scene.model, scene.plan.stages[0]);
    Mat2 gradient;
    gradient << 1.0, 0.4, 0.3, -0.7;
    hand.move(1, {3e-10, 2e-10}, 1e-9 * gradient);
    const double before = hand.kinetic();
    CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05);
    integrator.enter(hand.state);
    for (int i = 0; i < 3000; ++i)
      if (integrator.step(hand.state, ticks(h)).status != StepReport::Status::ok) return 1e300;
    return hand.kinetic() / before;
  }
};

TEST(StepParts, contact_counts_with_its_spring_and_shortens_the_step_with_its_damping) {
  const double own = lambda(one_block(1e5)), spring = OnATip::kPenalty * compliance({0.5 * kWidth, 0.5 * kHeight});
  for (const double xi : {0.0, 0.2, 0.5, 1.0}) {
    const double shrink = std::sqrt(1.0 + xi * xi) - xi, h = OnATip(xi).bound();
    EXPECT_NEAR(4.0 / (h * h) / (own + spring / (shrink * shrink)), 1.0, 1e-9) << xi;
  }
}

TEST(StepParts, bound_of_a_damped_contact_is_where_it_begins_to_grow) {
  for (const double xi : {0.0, 0.2, 0.5}) {
    const OnATip tip(xi);
    const double h = tip.bound();
    EXPECT_LT(tip.growth(0.995 * h), 100.0) << xi;
    EXPECT_GT(tip.growth(1.01 * h), 1e6) << xi;
  }
}

TEST(StepParts, contact_with_a_stiffer_shear_spring_counts_with_that) {
  OnATip tip(0.0);
  tip.scene.model.joints[0].shear_penalty = 3.0 * OnATip::kPenalty;
  const double own = lambda(one_block(1e5)), spring = OnATip::kPenalty * compliance({0.5 * kWidth, 0.5 * kHeight});
  EXPECT_NEAR(lambda(tip.scene) / (own + 3.0 * spring), 1.0, 1e-9);
}

TEST(StepParts, two_free_blocks_on_a_spring_count_with_the_compliance_of_both) {
  OnATip tip(0.0);
  tip.scene.model.block_supports.clear();
  const double tip_of_block = compliance({0.5 * kWidth, 0.5 * kHeight});
  // The corner touches the base, 6 x 1 m, in the middle of its top: the bound uses the ends of that edge.
  const double mass = 6.0 * kDensity, end_of_edge = (1.0 + 12.0 * (0.25 + 0.25)) / mass;
  EXPECT_NEAR(lambda(tip.scene) / (lambda(one_block(1e5)) + OnATip::kPenalty * (tip_of_block + end_of_edge)), 1.0,
              1e-3);
}

/// Kinetic energy of a scene's first block after 500 steps over that of the start, a tiny velocity.
double growth_of(const Scene& scene, double h) {
  ByHand hand(scene.model, scene.plan.stages[0]);
  Mat2 gradient;
  gradient << 1.0, 0.4, 0.3, -0.7;
  hand.move(0, {1e-9, 2e-9}, 1e-9 * gradient);
  const double before = hand.kinetic();
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05);
  integrator.enter(hand.state);
  for (int i = 0; i < 500; ++i)
    if (integrator.step(hand.state, ticks(h)).status != StepReport::Status::ok) return 1e300;
  return hand.kinetic() / before;
}

TEST(StepParts, mesh_by_itself_is_stable_below_its_bound_and_not_far_above) {
  Scene scene(1e8, 0.2, kDensity);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0.0, 0.0, kWidth, kHeight));
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.2);
  const double bound = 2.0 / std::sqrt(lambda(scene));
  EXPECT_LT(growth_of(scene, 0.999 * bound), 100.0);
  EXPECT_GT(growth_of(scene, 2.2 * bound), 1e6);  // elements cut by the outline make the bound conservative
}

/// A mesh on a spring far stiffer than the mesh: stable below the bound, unstable not far above.
TEST(StepParts, corner_of_a_mesh_on_a_stiff_spring_counts_with_its_covers) {
  Scene scene(1e6, 0.2, kDensity);
  scene.model.gravity = {0.0, 0.0};
  scene.add("block", rectangle(0.0, 0.0, kWidth, kHeight));
  scene.model.point_supports.push_back({BlockId{0}, {kWidth, kHeight}, true, true, 1e12});
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.3);
  const double bound = 2.0 / std::sqrt(lambda(scene));
  EXPECT_LT(growth_of(scene, 0.999 * bound), 100.0);
  EXPECT_GT(growth_of(scene, 1.25 * bound), 1e6);
}

TEST(StepParts, local_damping_counts_as_stiffness_and_rayleigh_damping_as_a_rate) {
  const double own = lambda(one_block(1e8)), h = 2.0 / std::sqrt(lambda(one_block(1e8), {.stiffness = 1e-4}));
  EXPECT_NEAR(h * h * own + 2.0 * h * 1e-4 * own, 4.0, 1e-9);
  EXPECT_NEAR(lambda(one_block(1e8), {.local = 0.4}) / own, 1.4, 1e-9);
}

TEST(StepParts, dashpots_count_with_the_larger_of_their_two_coefficients) {
  // One edge along x: c_p on y, c_s on x. gamma = sum of c_p L/2 times the compliance at either end.
  const double young = 1e8, own = lambda(one_block(young)), c = std::sqrt(young * kDensity);
  Scene scene = one_block(young);
  scene.model.viscous_edges.push_back({{BlockId{0}, {0, 2}, 0.0, 1.0}});
  const double h = 2.0 / std::sqrt(lambda(scene)),
               gamma = 2.0 * 0.5 * kWidth * c * compliance({0.5 * kWidth, 0.5 * kHeight});
  EXPECT_NEAR(h * h * own + 2.0 * h * gamma, 4.0, 1e-9);
}

}  // namespace
}  // namespace scree::test::step_parts_test
