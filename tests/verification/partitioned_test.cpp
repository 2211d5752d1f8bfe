// Explicit and implicit bodies in one step: momentum, energy, and the motion of either scheme alone.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test {
namespace {

using namespace scree::coupling;

struct Sides {
  const char* name;
  const char *explicit_method, *implicit_method;
  std::int32_t substeps;
};
std::ostream& operator<<(std::ostream& out, const Sides& s) { return out << s.name; }

class Partitioned2 : public testing::TestWithParam<Sides> {};

/// Two blocks that fly at each other, the left one explicit.
Scene two_blocks(const Sides& sides, double speed, double dt, double duration) {
  Scene scene(1e9, 0.2, 2600.0, 20.0);
  scene.model.gravity = Vec2(0.0, 0.0);
  const BlockId left = scene.add("left", rectangle(0.0, 0.0, 1.0, 1.0)),
                right = scene.add("right", rectangle(1.001, 0.3, 2.001, 1.3));
  scene.model.initial_velocities.push_back({left, Vec2(speed, 0.0), 0.0});
  scene.model.initial_velocities.push_back({right, Vec2(-speed, 0.2 * speed), 0.0});
  Stage& stage = scene.stage(sides.implicit_method, Integrator::partitioned, duration, dt, 0.4);
  stage.rules.push_back({{left}, sides.explicit_method, 0.0, false});
  stage.partition.explicit_blocks = {left};
  stage.partition.substeps = sides.substeps;
  return scene;
}

TEST_P(Partitioned2, impact_keeps_momentum_and_closes_the_ledger) {
  const double speed = 1.0;
  const Scene scene = two_blocks(GetParam(), speed, 2e-5 * std::max(1, GetParam().substeps), 0.02);
  Driver run(scene.model, scene.plan, methods());
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const BodyTotals a = totals_of(run, BlockId{0}), b = totals_of(run, BlockId{1});
  const double m = a.mass, scale = m * speed;
  EXPECT_LT((a.momentum + b.momentum - Vec2(0.0, 0.2 * scale)).norm(), 1e-12 * scale);
  EXPECT_LT(a.momentum.x(), 0.0) << "they have not hit each other";
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-11);
  std::printf("steps %ld cuts %ld iterations %ld closure %.1e momentum %.1e angular %.3e restitution %.4f\n",
              static_cast<long>(run.stats().steps), static_cast<long>(run.stats().cuts), static_cast<long>(run.stats().iterations),
              run.state().ledger.relative_closure(), (a.momentum + b.momentum - Vec2(0.0, 0.2 * scale)).norm() / scale,
              a.angular_momentum + b.angular_momentum, (b.momentum - a.momentum).x() / (2.0 * scale));
}

INSTANTIATE_TEST_SUITE_P(All, Partitioned2,
                         testing::Values(Sides{"dda_dda_1", "dda", "dda", 1}, Sides{"dda_dda_5", "dda", "dda", 5},
                                         Sides{"nmm_nmm_1", "nmm", "nmm", 1}, Sides{"nmm_nmm_5", "nmm", "nmm", 5},
                                         Sides{"nmm_dda_5", "nmm", "dda", 5}, Sides{"dda_nmm_5", "dda", "nmm", 5}),
                         [](const auto& p) { return std::string(p.param.name); });

}  // namespace
}  // namespace scree::test
