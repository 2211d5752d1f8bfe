// Explicit steps allocate no memory from the third on: every operator new of this program is counted.
#include <gtest/gtest.h>

#include "tests/allocation/counting_new.h"
#include "tests/support/by_hand.h"

namespace scree::test::allocation_test {
namespace {

using namespace coupling;

/// Allocations in steps 3 to 200; `closed`: whether contacts take part.
std::int64_t allocations(const Scene& scene, const ExplicitDamping& damping, bool closed = false) {
  ByHand hand(scene.model, scene.plan.stages[0]);
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.02}, 0.05, damping);
  integrator.enter(hand.state);
  const Tick h = ticks(0.5 * integrator.stable_step(hand.state, nullptr));
  std::int64_t begin = 0;
  for (int i = 1; i <= 200; ++i) {
    if (i == 3) begin = allocations_so_far();
    EXPECT_EQ(integrator.step(hand.state, h).status, StepReport::Status::ok);
  }
  const std::int64_t end = allocations_so_far();
  EXPECT_EQ(closed, !hand.state.contacts.empty());
  EXPECT_EQ(closed, hand.state.ledger[Column::friction] > 0.0);
  return end - begin;
}

TEST(Allocation, is_counted) {
  const std::int64_t before = allocations_so_far();
  const auto p = std::make_unique<double>(1.0);
  EXPECT_GT(allocations_so_far(), before);
}

class Allocation : public testing::TestWithParam<const char*> {};

TEST_P(Allocation, of_a_loaded_and_damped_block_is_none) {
  Scene scene(1e8, 0.2, 2000.0);
  const BlockId id = scene.add("block", rectangle(0, 0, 3, 2));
  TimeFunction table;
  table.shape = TimeFunction::Shape::table;
  table.time = {0.0, 1.0};
  table.table = {0.0, 5.0};
  scene.model.functions.push_back(table);
  scene.model.point_loads.push_back({id, {1.0, 1.0}, {1e3, 0.0}, FunctionId{0}});
  scene.model.tractions.push_back({{id, {0, 1}, 0.2, 0.8}, {1e3, 0.0}, {}});
  scene.model.body_accelerations.push_back({{}, {1.0, 0.0}, FunctionId{0}});
  scene.model.viscous_edges.push_back({{id, {0, 0}, 0.0, 1.0}});
  scene.model.point_supports.push_back({id, {0.0, 2.0}, true, true, 1e6});
  scene.stage(GetParam(), Integrator::explicit_, 1.0, std::nullopt, 0.2);
  EXPECT_EQ(allocations(scene, {}), 0);
  EXPECT_EQ(allocations(scene, {.mass = 10.0, .stiffness = 1e-6, .local = 0.1}), 0);
  EXPECT_EQ(allocations(scene, {.mass = 10.0, .rigid = true}), 0);
}

TEST_P(Allocation, of_sliding_blocks_is_none) {
  Scene scene(1e8, 0.2, 2000.0, 15.0);
  const auto turned = [](const Polygon& p) { return transformed(p, {0, 0}, rotation(-0.5)); };
  scene.add("plane", turned(rectangle(-2, -1, 12, 0)), true);
  scene.add("lower", turned(rectangle(0, 0, 2, 1)));
  scene.add("upper", turned(rectangle(0.3, 1, 1.7, 1.8)));
  scene.add("other", turned(rectangle(2.05, 0.001, 3, 0.8)));
  scene.model.initial_velocities.push_back({BlockId{1}, rotation(-0.5) * Vec2(2.0, 0.0), 0.0});
  scene.stage(GetParam(), Integrator::explicit_, 1.0, std::nullopt, 0.5);
  EXPECT_LE(allocations(scene, {}, true), 1);  // an allocation by the first window of the friction check
}
INSTANTIATE_TEST_SUITE_P(methods, Allocation, testing::Values("nmm", "dda"));

}  // namespace
}  // namespace scree::test::allocation_test
