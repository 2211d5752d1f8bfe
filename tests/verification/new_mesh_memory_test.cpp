// A joint that has slipped and failed, between blocks that are remeshed: its new contact points keep slip and failure.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupling/integrate/newmark.h"
#include "coupling/transfer/transfer.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::new_mesh_memory_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2600.0;

TEST(NewMeshMemory, mesh_vertices_on_a_joint_that_has_slipped_take_its_slip_and_its_failure) {
  Scene scene(1e9, 0.2, kDensity, 30.0);
  JointLaw& law = scene.model.joints[0];
  law.cohesion = 2e3;
  law.residual_friction = 10.0 * kDegree;
  law.weakening_slip = 0.02;
  law.damping = 0.5;
  scene.add("base", rectangle(-1, -1, 4, 0), true);
  const BlockId block = scene.add("block", rectangle(0, 0, 1.5, 0.6));
  scene.model.initial_velocities.push_back({block, {1.0, 0.0}, 0.0});
  scene.stage("dda", Integrator::implicit, 0.06, 1e-3);
  scene.stage("nmm", Integrator::explicit_, 0.04, std::nullopt, 0.3);
  scene.plan.output.every = ticks(0.02);
  Driver run(scene.model, scene.plan, methods());
  double least = std::numeric_limits<double>::infinity(), most = 0.0, speed = 0.0;
  int added = 0, before_failed = 0, before = 0;
  bool meshed = false;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.state->stage == 0) {  // the first stage ends with a frame, and the second begins with one
      least = std::numeric_limits<double>::infinity();
      most = 0.0;
      before = before_failed = 0;
      for (const ContactMemory& m : view.state->contacts) {
        if (m.status == ContactStatus::open) continue;
        least = std::min(least, m.slip);
        most = std::max(most, m.slip);
        ++before;
        before_failed += m.failed;
      }
      speed = totals_of(run, block).momentum.x() / (kDensity * 0.9);
      return;
    }
    if (meshed) return;
    meshed = true;
    for (const ContactMemory& m : view.state->contacts) {
      if (m.status == ContactStatus::open || m.key.part == 0) continue;
      ++added;
      EXPECT_GE(m.slip, least - 1e-12) << m.key.part;
      EXPECT_LE(m.slip, most + 1e-12) << m.key.part;
      EXPECT_EQ(m.failed, 1) << m.key.part;
    }
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_GE(before, 2);
  EXPECT_EQ(before_failed, before);
  EXPECT_GT(least, 0.03);  // slipped beyond the weakening
  EXPECT_TRUE(meshed);
  EXPECT_GE(added, 3);
  // It slides on with the residual friction and without cohesion; with both restored it would slow down seven times as
  // fast.
  const double now = totals_of(run, block).momentum.x() / (kDensity * 0.9);
  EXPECT_NEAR((speed - now) / (kGravity * std::tan(10.0 * kDegree) * 0.04), 1.0, 0.25);
}

/// Slip and gap of new points are linear between the values of the two corners; the failure flag is that of the nearer
/// corner.
TEST(NewMeshMemory, between_two_corners_slip_is_linear_and_failure_that_of_the_nearer) {
  Scene scene(1e9, 0.2, kDensity, 20.0);
  scene.model.joints[0].cohesion = 1e3;
  scene.add("base", rectangle(-1, -1, 4, 0), true);
  scene.add("block", rectangle(0, 0, 1.5, 0.4));
  const Stage dda = scene.stage("dda", Integrator::implicit, 0.1, 1e-3);
  Stage nmm = scene.stage("nmm", Integrator::explicit_, 0.1, std::nullopt, 0.3);
  nmm.rules.push_back({{BlockId{0}}, "dda", 0.0});  // the base stays as it is
  ByHand hand(scene.model, dda);
  Newmark integrator(*hand.setup, {.max_displacement = 0.1}, 0.05, {.dynamics = 0.0});
  (void)integrator.enter(hand.state);
  for (int i = 0; i < 10; ++i) ASSERT_EQ(integrator.step(hand.state, ticks(1e-3)).status, StepReport::Status::ok);
  integrator.leave(hand.state);
  for (ContactMemory& m : hand.state.contacts) {
    ASSERT_NE(m.status, ContactStatus::open);
    m.slip = m.key.vertex == 0 ? 0.01 : 0.04;  // corners 0 and 1 of the block: left and right
    m.failed = m.key.vertex == 0 ? 0 : 1;
  }
  ASSERT_EQ(hand.state.contacts.size(), 2U);
  const TransferReport handed = transfer_bodies(scene.model, hand.methods, *hand.setup, nmm, hand.state);
  ContactFinder finder(*handed.setup, 0.05);
  ContactList known, now;
  finder.restore(hand.state.contacts.memory, known);
  finder.find(hand.state.q, known, false, now);
  int added = 0;
  double force = 0.0;
  const Outlines& o = handed.setup->outlines();
  for (std::size_t i = 0; i < now.points.size(); ++i) {
    const ContactMemory& m = now.memory[i];
    if (m.status == ContactStatus::open) continue;
    force -= m.kn * m.gap;
    const double x = position(o.nodes[now.points[i].node[0]], hand.state.q).x();
    EXPECT_NEAR(m.slip, 0.01 + 0.03 * x / 1.5, 1e-5) << x;
    EXPECT_EQ(m.failed, x < 0.75 ? 0 : 1) << x;
    added += m.key.part > 0 ? 1 : 0;
  }
  EXPECT_GE(added, 3);
  EXPECT_NEAR(force / (kDensity * kGravity * 0.6), 1.0, 1e-3);
}

/// A block on a sheared joint without slip reaches the next block of its base: its contact points there begin with the
/// shear of the joint, so that the traction is continuous across the joint of the base.
TEST(NewContactMemory, points_that_reach_the_next_block_of_a_sheared_joint_take_its_shear) {
  constexpr double kShear = 1e-4;  // [m]
  Scene scene(1e9, 0.2, kDensity, 60.0);
  scene.add("base", rectangle(-2, -1, 0.7, 0), true);
  scene.add("next", rectangle(0.7, -1, 3, 0), true);
  scene.add("block", rectangle(-0.5, 0, 0.5, 0.4));
  scene.stage("dda", Integrator::implicit, 0.1, 1e-3);
  const ByHand hand(scene.model, scene.plan.stages[0]);
  const auto moved = [&](double x, double y) {
    std::vector<double> q = hand.state.q;
    const Body& b = hand.setup->bodies()[2];
    AffineMotion m;
    m.c = b.centre + Vec2(x, y);
    std::vector<double> v(q.size());
    const auto p = static_cast<std::size_t>(b.pool);
    hand.setup->pool_of(b).place(b.index, m, hand.setup->part(std::span<double>(q), p),
                                 hand.setup->part(std::span<double>(v), p));
    return q;
  };
  ContactFinder finder(*hand.setup, 0.05);
  ContactList none, known, now;
  finder.find(moved(0.19, 0.0), none, true, known);  // the corner stands 1 cm before the end of the first base
  int before = 0;
  for (std::size_t i = 0; i < known.points.size(); ++i) {
    ContactMemory& m = known.memory[i];
    if (m.status == ContactStatus::open) continue;
    EXPECT_EQ(m.key.block_e == 1 || m.key.block_p == 1, false) << "the next block is reached too early";
    m.status = ContactStatus::stick;
    m.stretch = kShear;
    m.anchor = known.points[i].at.xi - m.stretch / known.points[i].at.length;
    ++before;
  }
  EXPECT_GE(before, 2);
  finder.find(moved(0.21, -1e-5), known, false, now);
  int added = 0;
  for (const ContactMemory& m : now.memory) {
    if (m.status == ContactStatus::open || (m.key.block_e != 1 && m.key.block_p != 1)) continue;
    ++added;
    EXPECT_NEAR(std::abs(m.stretch), kShear, 1e-12);
    EXPECT_EQ(m.status, ContactStatus::stick);
  }
  EXPECT_GE(added, 1);
}

}  // namespace
}  // namespace scree::test::new_mesh_memory_test
