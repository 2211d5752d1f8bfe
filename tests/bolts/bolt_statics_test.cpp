// Bolts against closed-form statics, by both methods, explicit and implicit.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "coupling/bolts/bolt_rows.h"
#include "tests/support/bolted.h"

namespace scree::test::bolt_statics_test {
namespace {

using namespace coupling;

constexpr double kPart = 5e-3;  // relative, of the forces and displacements of statics

class Bolts : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(All, Bolts,
                         testing::Values(Way{"dda", Integrator::explicit_}, Way{"dda", Integrator::implicit},
                                         Way{"nmm", Integrator::explicit_}, Way{"nmm", Integrator::implicit}),
                         [](const auto& of) { return of.param.name(); });

/// A block 2 m x 1 m half a metre beside a held wall, with a bolt along its middle from x = 1.5 m into the wall.
struct Pull : Bolted {
  BlockId wall, block;
  double mass = 2.0 * 2600.0;
  Pull() {
    model.gravity = {0.0, 0.0};
    wall = add("wall", rectangle(-4, 0, 0, 1), true);
    block = add("block", rectangle(0.5, 0, 2.5, 1));
  }
  void pull(double force) { model.point_loads.push_back({block, {1.5, 0.5}, {force, 0.0}, FunctionId{}}); }
  /// Grouted over the last 2 m, in the wall.
  static Bolt grouted() {
    Bolt b = bar({1.5, 0.5}, {-3.0, 0.5});
    b.bond_length = 2.0;
    b.bond_stiffness = 200e6;
    b.segment = 0.05;
    return b;
  }
  /// Displacement of the head away from the wall since the model.
  [[nodiscard]] double head_moved() const {
    return position(bolt_rows(driver->setup(), driver->state(), 0).row[0], driver->state().q).x() - 1.5;
  }
};

TEST_P(Bolts, anchored_bar_carries_the_pull_by_its_stiffness) {
  Pull scene;
  scene.pull(50e3);
  const Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  scene.bolt(b);
  scene.rest(GetParam(), 2.0);
  scene.run();
  EXPECT_NEAR(scene.memory().force[0] / 50e3, 1.0, kPart);
  EXPECT_NEAR(scene.head_moved() / (50e3 * 3.0 / b.stiffness), 1.0, kPart);
  scene.expect_closed();
}

TEST_P(Bolts, bonded_bar_is_pulled_by_what_its_grout_gives) {
  // EA u'' = k u along the bond: at its start u = F lambda/EA coth(L/lambda), lambda^2 = EA/k.
  Pull scene;
  scene.pull(80e3);
  const Bolt b = Pull::grouted();
  scene.bolt(b);
  scene.rest(GetParam(), 2.0);
  scene.run();
  const double lambda = std::sqrt(b.stiffness / b.bond_stiffness);
  const double expected = 80e3 / b.stiffness * (2.5 + lambda / std::tanh(2.0 / lambda));
  EXPECT_NEAR(scene.head_moved() / expected, 1.0, kPart);
  // Force of the bar in the bond F sinh((L - x)/lambda)/sinh(L/lambda), compared half way, at a depth of 1 m.
  std::size_t middle = 0;
  while (scene.model.bolts[0].nodes[middle].at < 3.5) ++middle;
  const double at = scene.model.bolts[0].nodes[middle - 1].at + 0.025 - 2.5;
  EXPECT_NEAR(scene.memory().force[middle - 1] / (80e3 * std::sinh((2.0 - at) / lambda) / std::sinh(2.0 / lambda)), 1.0,
              kPart);
  scene.expect_closed();
}

TEST_P(Bolts, bond_pulls_out_at_its_strength_times_its_length) {
  Pull holds, slides;
  Bolt b = Pull::grouted();
  b.bond_strength = 50e3;  // 100 kN over the whole bond
  for (Pull* scene : {&holds, &slides}) scene->bolt(b);
  holds.pull(99e3);
  holds.rest(GetParam(), 3.0);
  holds.run();
  EXPECT_NEAR(holds.memory().force[0] / 99e3, 1.0, kPart);
  EXPECT_LT(holds.head_moved(), 0.02);
  // A pull of one and a half times the bond's strength.
  slides.pull(150e3);
  slides.go(GetParam(), 0.3);
  const Driver& run = slides.run();
  EXPECT_NEAR(slides.memory().force[0] / 100e3, 1.0, 1e-9);
  for (std::size_t i = 1; i < slides.memory().bond.size(); ++i) EXPECT_LT(slides.memory().slipped[i], 0.0);
  const Ledger& ledger = run.state().ledger;
  EXPECT_NEAR(ledger[Column::bolt_yield] / (100e3 * -slides.memory().slipped.back()), 1.0, kPart);
  slides.expect_closed();
}

TEST_P(Bolts, bar_yields_at_its_strength_and_keeps_its_stretch) {
  // Thrown away from the wall: 1/2 m v^2 = Ny^2/(2k) + Ny p at the turning point.
  Pull scene;
  Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  b.yield = 80e3;
  scene.bolt(b);
  scene.model.initial_velocities.push_back({scene.block, {0.5, 0.0}, 0.0});
  scene.go(GetParam(), 0.08, 2e-5);
  const Driver& run = scene.run();
  const double k = b.stiffness / 3.0, energy = 0.5 * scene.mass * 0.25;
  const double plastic = (energy - 0.5 * b.yield * b.yield / k) / b.yield;
  EXPECT_NEAR(scene.memory().plastic[0] / plastic, 1.0, kPart);
  EXPECT_NEAR(run.state().ledger[Column::bolt_yield] / (b.yield * plastic), 1.0, kPart);
  scene.expect_closed();
}

TEST_P(Bolts, pull_beyond_the_yield_accelerates_by_the_difference) {
  Pull scene;
  Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  b.yield = 80e3;
  b.pretension = 79.9999e3;
  scene.bolt(b);
  scene.pull(100e3);
  // The pretension balances the pull but for a fifth: the net force is 20 kN on 5.2 t.
  scene.go(GetParam(), 0.05, 1e-4);
  scene.run();
  EXPECT_NEAR(totals_of(*scene.driver, scene.block).momentum.x() / 0.05 / 20e3, 1.0, kPart);
  scene.expect_closed();
}

/// A block on a frictionless base, with an upright bolt through the joint, bonded in both.
struct Sheared : Bolted {
  BlockId base, block;
  double mass = 2600.0;
  Sheared() : Bolted(0.0) {
    base = add("base", rectangle(-1, -1, 2, 0), true);
    block = add("block", rectangle(0, 0, 1, 1));
  }
  static Bolt dowel() {
    Bolt b = bar({0.5, 0.9}, {0.5, -0.9});
    b.plate = false;
    b.bond_length = 1.8;
    b.bond_stiffness = 1e9;
    b.shear_stiffness = 50e6;
    return b;
  }
  void push(double force) { model.point_loads.push_back({block, {0.5, 0.0}, {force, 0.0}, FunctionId{}}); }
};

TEST_P(Bolts, joint_is_held_by_the_shear_stiffness_of_the_bar) {
  Sheared scene;
  scene.bolt(Sheared::dowel());
  scene.push(10e3);
  scene.rest(GetParam(), 2.0);
  scene.run();
  const BoltRows rows = bolt_rows(scene.driver->setup(), scene.driver->state(), 0);
  const std::span<const double> q(scene.driver->state().q);
  const double moved = position(rows.row[rows.leaves(0)], q).x() - position(rows.row[rows.leaves(0) + 1], q).x();
  EXPECT_NEAR(moved / (10e3 / 50e6), 1.0, kPart);
  EXPECT_NEAR(std::abs(scene.memory().shear[0]) / 10e3, 1.0, kPart);
  scene.expect_closed();
}

TEST_P(Bolts, shear_beyond_the_strength_accelerates_by_the_difference) {
  Sheared scene;
  Bolt b = Sheared::dowel();
  b.stiffness = 1e4;  // no tension by the bent bar: the dowel alone acts
  b.segment = 0.1;
  b.shear_strength = 8e3;
  b.shear_stiffness = 5e9;
  scene.bolt(b);
  scene.push(20e3);
  scene.go(GetParam(), 0.05, 1e-4);
  scene.run();
  EXPECT_NEAR(totals_of(*scene.driver, scene.block).momentum.x() / 0.05 / 12e3, 1.0, kPart);
  EXPECT_NEAR(std::abs(scene.memory().shear[0]) / 8e3, 1.0, 1e-9);
  scene.expect_closed();
}

TEST_P(Bolts, pretension_presses_a_joint_and_loses_what_the_joint_gives) {
  // Bar k over joint K: the lock-off force P falls to P/(1 + k/K).
  Bolted scene(30.0, 5e12);
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-2, 0, 0, 1), true);
  const BlockId block = scene.add("block", rectangle(0, 0, 1, 1));
  const double K = 1e9;
  scene.model.joints[0].normal_stiffness = K;
  scene.model.joints[0].shear_stiffness = K;
  Bolt b = bar({1.0, 0.5}, {-1.0, 0.5});
  b.stiffness = 400e6;
  b.pretension = 100e3;
  scene.bolt(b);
  scene.rest(GetParam(), 1.0);
  const Driver& run = scene.run();
  const double expected = 100e3 / (1.0 + 200e6 / K);
  EXPECT_NEAR(scene.memory().force[0] / expected, 1.0, kPart);
  double pressed = 0.0;
  for (const ContactMemory& m : run.state().contacts) pressed += m.fn;
  EXPECT_NEAR(pressed / expected, 1.0, kPart);
  EXPECT_NEAR(run.state().ledger[Column::bolt_tension] / (0.5 * 100e3 * 100e3 / 200e6), 1.0, 1e-12);
  EXPECT_NEAR(centre_of(run, block).x() - 0.5, -expected / K, 0.01 * expected / K);
  scene.expect_closed();
}

TEST_P(Bolts, pretension_decides_whether_a_block_holds_on_a_slope) {
  // The bolt force T acts at the angle b below the upslope direction; the block slides while
  //   W sin a - T cos b > (W cos a + T sin b) tan phi.
  // The bar is so soft that its force hardly changes with the displacement of the block: an active force.
  const double a = 35.0 * kDegree, phi = 25.0, b = 50.0 * kDegree, weight = 2600.0 * 9.81;
  const double limit = weight * (std::sin(a) - std::cos(a) * std::tan(phi * kDegree)) /
                       (std::cos(b) + std::sin(b) * std::tan(phi * kDegree));
  const Vec2 up(std::cos(a), std::sin(a)), out(-std::sin(a), std::cos(a));
  for (const double part : {0.98, 1.02}) {
    Bolted scene(phi);
    scene.add("base", transformed(rectangle(-3, -8, 8, 0), {0.0, 0.0}, rotation(a)), true);
    const BlockId block = scene.add("block", transformed(rectangle(0, 0, 1, 1), {0.0, 0.0}, rotation(a)));
    // The bolt starts above the middle of the base of the block, about which the weight keeps the block flat.
    const Vec2 head = 0.5 * up + 0.5 * out, toe = head + 5.0 * (std::cos(b) * up - std::sin(b) * out);
    Bolt bolt = bar(head, toe);
    bolt.stiffness = 2e4;
    bolt.pretension = part * limit;
    scene.bolt(bolt);
    scene.go(GetParam(), 0.5, 1e-3);
    const Driver& run = scene.run();
    const double slid = -(centre_of(run, block) - (0.5 * up + 0.5 * out)).dot(up);
    // 2 % of the limit on the block: about 0.04 m/s2, 5 mm in 0.5 s.
    const double rate = (1.0 - part) * limit * (std::cos(b) + std::sin(b) * std::tan(phi * kDegree)) / 2600.0;
    if (part > 1.0)
      EXPECT_LT(std::abs(slid), 2e-4);
    else
      EXPECT_NEAR(slid / (0.5 * rate * 0.25), 1.0, 0.2);
    scene.expect_closed();
  }
}

TEST_P(Bolts, breaks_at_its_strain_and_lets_go) {
  Pull scene;
  Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  b.yield = 80e3;
  b.rupture_strain = 1e-3;
  scene.bolt(b);
  scene.model.initial_velocities.push_back({scene.block, {0.5, 0.0}, 0.0});
  scene.go(GetParam(), 0.08, 2e-5);
  Watched told(EventKind::bolt_broken);
  scene.sink = &told;
  const Driver& run = scene.run();
  ASSERT_EQ(told.lines.size(), 1U);
  EXPECT_NE(told.lines[0].find("bolt 'bolt' breaks"), std::string::npos) << told.lines[0];
  EXPECT_EQ(scene.memory().force[0], 0.0);
  // 3 mm of yield, then the elastic energy is lost.
  const double k = b.stiffness / 3.0, lost = 0.5 * b.yield * b.yield / k, yielded = b.yield * 3e-3;
  EXPECT_NEAR(run.state().ledger[Column::bolts_broken] / lost, 1.0, 1e-6);
  EXPECT_NEAR(run.state().ledger[Column::bolt_yield] / yielded, 1.0, 0.01);
  const double energy = 0.5 * scene.mass * 0.25 - lost - run.state().ledger[Column::bolt_yield];
  EXPECT_NEAR(totals_of(run, scene.block).kinetic / energy, 1.0, kPart);
  scene.expect_closed();
}

TEST_P(Bolts, slack_bar_does_not_push) {
  Pull scene;
  scene.bolt(bar({1.5, 0.5}, {-1.5, 0.5}));
  scene.model.initial_velocities.push_back({scene.block, {-0.1, 0.0}, 0.0});
  scene.go(GetParam(), 0.2, 1e-3);
  const Driver& run = scene.run();
  EXPECT_NEAR(centre_of(run, scene.block).x(), 1.5 - 0.02, 1e-9);
  scene.expect_closed();
}

}  // namespace
}  // namespace scree::test::bolt_statics_test
