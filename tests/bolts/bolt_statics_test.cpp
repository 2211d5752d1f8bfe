// Bolts against statics, in both methods, explicit and implicit.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>

#include "tests/support/bolted.h"

namespace scree::test {
namespace {

using namespace coupling;

constexpr double kPart = 5e-3;  // of statics: the bound that the task sets

class Bolts : public testing::TestWithParam<Way> {};
INSTANTIATE_TEST_SUITE_P(All, Bolts,
                         testing::Values(Way{"dda", Integrator::explicit_}, Way{"dda", Integrator::implicit},
                                         Way{"nmm", Integrator::explicit_}, Way{"nmm", Integrator::implicit}),
                         [](const auto& info) { return info.param.name(); });

/// A block 2 m x 1 m that hangs beside a held one, 0.5 m away, on an ungrouted bolt through the middle; pulled.
struct Pull : Bolted {
  BlockId wall, block;
  explicit Pull(const Way& way, double force) {
    model.gravity = {0.0, 0.0};
    wall = add("wall", rectangle(-2, 0, 0, 1), true);
    block = add("block", rectangle(0.5, 0, 2.5, 1));
    model.point_loads.push_back({block, {1.5, 0.5}, {force, 0.0}, FunctionId{}});
    rest(way, 0.4);
  }
  [[nodiscard]] double moved(const Driver& run) const { return centre_of(run, block).x() - 1.5; }
};

TEST_P(Bolts, point_to_point_carries_the_pull_by_its_stiffness) {
  const double force = 50e3;
  Pull scene(GetParam(), force);
  Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  scene.bolt(b);
  const Driver& run = scene.run();
  EXPECT_NEAR(scene.memory().force[0] / force, 1.0, kPart);
  EXPECT_NEAR(scene.moved(run) / (force * 3.0 / b.stiffness), 1.0, kPart);
  scene.expect_closed();
}

TEST_P(Bolts, yields_at_its_strength_and_keeps_what_it_was_stretched_by) {
  // Pushed away by 20 mm and let go: the rest stage leaves the plastic part.
  Pull scene(GetParam(), 0.0);
  scene.model.point_loads.clear();
  Bolt b = bar({1.5, 0.5}, {-1.5, 0.5});
  b.yield = 80e3;
  scene.bolt(b);
  scene.model.initial_velocities.push_back({scene.block, {0.5, 0.0}, 0.0});
  scene.plan.stages[0].rest = false;
  scene.plan.stages[0].duration = ticks(0.08);
  const Driver& run = scene.run();
  // Energy: 1/2 m v^2 = Ny^2/(2k) + Ny p at the farthest, from where it springs back.
  const double mass = 2.0 * 2600.0, k = b.stiffness / 3.0;
  const double plastic = (0.5 * mass * 0.25 - 0.5 * b.yield * b.yield / k) / b.yield;
  EXPECT_NEAR(scene.memory().plastic[0] / plastic, 1.0, kPart);
  EXPECT_NEAR(run.state().ledger[Column::bolt_yield] / (b.yield * plastic), 1.0, kPart);
  scene.expect_closed();
}

}  // namespace
}  // namespace scree::test
