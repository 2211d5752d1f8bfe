// Narrow blocks whose mesh depends on the mass matrix of the stage: a onefold cover with one, covers with the other.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::narrow_block_test {
namespace {

using coupling::Integrator;

TEST(NarrowBlock, goes_on_in_flight_where_its_mesh_comes_or_goes_with_its_mass) {
  int changed = 0;
  for (int i = 0; i < 60; ++i)
    for (const bool explicit_first : {true, false}) {
      Scene scene;
      scene.model.gravity = Vec2(0.0, 0.0);
      const BlockId id = scene.add("b", rectangle(0, 0, 0.4 + 0.007 * i, 0.1 + 0.004 * i));
      scene.model.initial_velocities.push_back({id, Vec2(1.0, 0.5), 0.3});
      for (const bool first : {true, false})
        scene.stage("nmm", first == explicit_first ? Integrator::explicit_ : Integrator::implicit, 2e-4,
                    first == explicit_first ? std::nullopt : std::optional(1e-4), 0.5);
      scene.plan.audit = true;
      coupling::Driver run(scene.model, scene.plan, methods());
      std::int32_t nodes = 0;
      Watch watch;
      watch.see = [&](const coupling::FrameView& view) {
        const auto now = static_cast<std::int32_t>(view.state->q.size());
        changed += nodes != 0 && now != nodes ? 1 : 0;
        nodes = now;
      };
      run.add_sink(watch);
      const coupling::RunEnd end = run.run();
      ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << i << ": " << end.reason;
      const BodyTotals now = totals_of(run, id);
      EXPECT_LT((now.momentum / now.mass - Vec2(1.0, 0.5)).norm(), 1e-9) << i;
      EXPECT_LT((now.centre - moments(scene.model.blocks[0].polygon).centroid - 4e-4 * Vec2(1.0, 0.5)).norm(), 1e-9)
          << i;
      EXPECT_LT(now.elastic, 1e-3 * now.kinetic) << i;
    }
  EXPECT_GE(changed, 10);
}

}  // namespace
}  // namespace scree::test::narrow_block_test
