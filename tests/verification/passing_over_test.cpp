// A corner that bounces on one edge of another block and lies behind the line of that block's adjacent edge: in the air
// it is outside the block, and the adjacent edge must not push it. The horizontal speed must stay below 1 % of the
// vertical one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/schemes.h"

namespace scree::test::passing_over_test {
namespace {

using namespace coupling;

class PassingOver : public testing::TestWithParam<Scheme> {};

/// A smooth block falls from 0.2 mm on the level tops of two held blocks. Its corner lies 20 mm past the end of the
/// first block, whose end face is parallel to the side of the falling block, at `corner` degrees to the top. No contact
/// has a horizontal force.
TEST_P(PassingOver, nothing_pushes_a_block_that_hops_sideways) {
  for (const double corner : {30.0, 45.0, 72.0, 90.0, 120.0}) {
    SCOPED_TRACE(corner);
    const Vec2 along(std::cos(corner * kDegree), std::sin(corner * kDegree));
    Scene scene(5e9, 0.2, 2600.0, 0.0);
    scene.model.gravity = Vec2(0.0, -9.81);
    scene.add("ledge", {{Vec2(-4, 0), Vec2(-4, -1), -1.0 / along.y() * along, Vec2(0, 0)}, {}}, true);
    scene.add("beyond", {{Vec2(1.5, 0), Vec2(1.5, -1), Vec2(5, -1), Vec2(5, 0)}, {}}, true);
    const Vec2 tip(-0.02, 2e-4), side = 1.0 / along.y() * along;
    const BlockId block = scene.add("block", {{tip, tip + Vec2(3, 0), tip + Vec2(3, 0) + side, tip + side}, {}});
    scene.stage(GetParam().method, GetParam().integrator, 0.4,
                GetParam().implicit() ? std::optional(5e-4) : std::nullopt, 0.5);
    Driver run(scene.model, scene.plan, methods());
    double sideways = 0.0, down = 0.0;
    EveryStep watch;
    watch.see = [&](double) {
      const BodyTotals now = totals_of(run, block);
      sideways = std::max(sideways, std::abs(now.momentum.x()) / now.mass);
      down = std::max(down, std::abs(now.momentum.y()) / now.mass);
    };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    std::printf("%s %g degrees: %.2e m/s sideways, %.2e down\n", GetParam().name, corner, sideways, down);
    EXPECT_LT(sideways, 0.01 * down);
    EXPECT_NEAR(down, std::sqrt(2.0 * 9.81 * 2e-4), 0.05 * down);  // first fall, at steps: later bounces are lower
  }
}

INSTANTIATE_TEST_SUITE_P(schemes, PassingOver, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::test::passing_over_test
