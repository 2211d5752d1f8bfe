// Bodies that are held or moved as a whole keep their shape: explicit steps skip their interior. The reference is the
// same slide on a base with fewer nodes: equal positions, and at most twice the processor time.
#include <gtest/gtest.h>
#include <time.h>  // NOLINT(modernize-deprecated-headers): clock_gettime

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/by_hand.h"

namespace scree::test::held_bodies_test {
namespace {

using namespace coupling;

constexpr double kCover = 0.25, kThickness = 3.0;

/// A block that slides on a held base; a longer base does not change its motion.
Scene slide(double half_length) {
  Scene scene(1e9, 0.2, 2600.0, 20.0);
  scene.model.gravity = {3.0, -9.0};
  scene.add("base", rectangle(-half_length, -kThickness, half_length, 0.0), true);
  scene.add("block", rectangle(-1.0, 0.0, 1.0, 1.0));
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, kCover);
  return scene;
}

double processor_time() {
  timespec t{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

struct Stepped {
  double seconds = std::numeric_limits<double>::infinity();  // least processor time of three rounds
  std::vector<double> block, base;                           // positions of the nodes
  std::size_t nodes = 0;
};

Stepped stepped(double half_length, int steps) {
  const Scene scene = slide(half_length);
  Stepped out;
  for (int round = 0; round < 3; ++round) {
    ByHand hand(scene.model, scene.plan.stages[0]);
    CentralDifference integrator(*hand.setup, {.max_displacement = 0.1}, 0.05, {});
    integrator.enter(hand.state);
    const Tick h = ticks(0.5 * integrator.stable_step(hand.state, nullptr));
    const double begin = processor_time();
    for (int i = 0; i < steps; ++i) EXPECT_EQ(integrator.step(hand.state, h).status, StepReport::Status::ok);
    out.seconds = std::min(out.seconds, processor_time() - begin);
    const auto nodes_of = [&](const Body& b) {
      const auto at = hand.state.q.begin() + 2 * static_cast<std::ptrdiff_t>(b.first_node);
      return std::vector<double>(at, at + 2 * static_cast<std::ptrdiff_t>(b.nodes));
    };
    out.base = nodes_of(hand.setup->bodies()[0]);
    out.block = nodes_of(hand.setup->bodies()[1]);
    out.nodes = hand.state.q.size() / 2;
  }
  return out;
}

TEST(HeldBodies, steps_cost_what_moves) {
  const Stepped small = stepped(5.0, 3000), large = stepped(150.0, 3000);
  ASSERT_GT(large.nodes, 15 * small.nodes);
  EXPECT_LT(large.seconds, 2.0 * small.seconds) << large.nodes << " nodes, " << small.nodes;
  ASSERT_EQ(small.block.size(), large.block.size());
  for (std::size_t i = 0; i < small.block.size(); ++i) EXPECT_NEAR(small.block[i], large.block[i], 1e-12) << i;
}

TEST(HeldBodies, stay_to_the_last_bit) {
  const Scene scene = slide(5.0);
  const ByHand hand(scene.model, scene.plan.stages[0]);
  const Body& base = hand.setup->bodies()[0];
  // An odd number of steps: positions are kept in two arrays in turn.
  const Stepped after = stepped(5.0, 51);
  for (std::size_t i = 0; i < after.base.size(); ++i)
    EXPECT_EQ(after.base[i], hand.state.q[2 * static_cast<std::size_t>(base.first_node) + i]) << i;
}

TEST(HeldBodies, have_pools_apart_from_those_that_move) {
  Scene scene = slide(5.0);
  scene.model.motions.push_back(
      {{0.0, 0.01, 0.03, 0.04}, {0.0, 1.0, -1.0, 0.0}, {1.0, 0.0}, {0.0, Between::linear, "shake", StageId{}}});
  scene.add("table", rectangle(20.0, 0.0, 22.0, 1.0));
  scene.model.block_supports.push_back({BlockId{2}, MotionId{0}});
  const ByHand hand(scene.model, scene.plan.stages[0]);
  const coupling::Setup& setup = *hand.setup;
  ASSERT_EQ(setup.own_pools().size(), 1U);
  const std::size_t own = setup.own_pools()[0];
  for (std::size_t b = 0; b < 3; ++b) {
    const Body& body = setup.bodies()[b];
    EXPECT_EQ(body.pool == static_cast<std::int32_t>(own), b == 1) << b;
    EXPECT_EQ(body.resting, b == 0) << b;
    EXPECT_EQ(setup.kind(body.first_node), b == 0   ? coupling::Setup::NodeKind::resting
                                           : b == 1 ? coupling::Setup::NodeKind::free
                                                    : coupling::Setup::NodeKind::driven);
  }
  const Outlines& o = setup.outlines();
  std::size_t moving = 0;
  for (const IndexRange<coupling::OutlineNode> r : o.moving_nodes)
    for (const coupling::OutlineNode i : r) {
      EXPECT_NE(o.node_body[i], BodyIndex{0});
      ++moving;
    }
  EXPECT_EQ(moving, static_cast<std::size_t>(std::count_if(o.node_body.begin(), o.node_body.end(),
                                                           [](BodyIndex body) { return body != BodyIndex{0}; })));
}

}  // namespace
}  // namespace scree::test::held_bodies_test
