// A block that fits a notch of a held block exactly: its convex corners stand in reentrant ones, both edges of which
// touch it. Its settlement must be that of the unit block on level ground, within the factors of each notch.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/schemes.h"

namespace scree::test::notch_test {
namespace {

using namespace coupling;

struct Notch {
  const char* name;
  Polygon held, block;
  double turn = 0.0;               // [deg]
  double friction = 30.0;          // [deg]
  double least = 1.0, most = 1.0;  // bounds of the settlement over that of the unit block on level ground
};

Polygon ring(std::vector<Vec2> corners) {
  Polygon p;
  p.outer = std::move(corners);
  return p;
}

const Polygon kUnit = ring({{0, 0}, {1, 0}, {1, 1}, {0, 1}});
const Polygon kPit = ring({{-2, -1}, {3, -1}, {3, 1}, {1, 1}, {1, 0}, {0, 0}, {0, 1}, {-2, 1}});

/// Smooth rigid walls would reduce the block's own strain by (1 - nu)^2 - (1 - 2 nu) = nu^2 over (1 - nu)^2, 6 %. That
/// strain is a fifth of the settlement, of which the walls take 1.3 %. The normal springs of two sides at 45 degrees
/// are as stiff vertically as those of one level base; affine strain differs by 5 %, and friction of the sides reduces
/// the settlement by a third. A block that overhangs is heavier.
const std::vector<Notch>& notches() {
  static const std::vector<Notch> kAll{
      {"pit", kPit, kUnit, 0.0, 30.0, 0.98, 1.05},
      {"smooth_pit", kPit, kUnit, 0.0, 0.0, 0.987, 1.0},
      {"turned_pit", kPit, kUnit, 20.0, 30.0, 0.8, 1.05},
      {"groove", kPit, kUnit, 45.0, 30.0, 0.5, 0.8},
      {"smooth_groove", kPit, kUnit, 45.0, 0.0, 0.93, 1.0},
      {"step", ring({{-2, -1}, {3, -1}, {3, 0}, {0, 0}, {0, 1}, {-2, 1}}), kUnit, 0.0, 30.0, 0.98, 1.05},
      {"key", ring({{-3, -1}, {4, -1}, {4, 1}, {1.5, 1}, {1, 0}, {0, 0}, {-0.5, 1}, {-3, 1}}),
       ring({{0, 0}, {1, 0}, {1.5, 1}, {-0.5, 1}}), 0.0, 10.0, 1.0, 1.5},
      {"tee", kPit, ring({{0, 0}, {1, 0}, {1, 1}, {1.5, 1}, {1.5, 1.5}, {-0.5, 1.5}, {-0.5, 1}, {0, 1}}), 0.0, 30.0,
       1.0, 2.0}};
  return kAll;
}

struct Rest {
  Vec2 moved;             // of the centroid [m]
  double speed, closure;  // speed [m/s]; closure of the ledger
};

Rest rest_of(const Scheme& scheme, const Notch& n) {
  Scene scene(5e9, 0.2, 2600.0, n.friction);
  scene.model.gravity = Vec2(0.0, -9.81);
  const Mat2 R = rotation(n.turn * kDegree);
  scene.add("held", transformed(n.held, Vec2::Zero(), R), true);
  const BlockId block = scene.add("block", transformed(n.block, Vec2::Zero(), R));
  scene.stage(scheme.method, scheme.integrator, 0.3, scheme.implicit() ? std::optional(1e-3) : std::nullopt, 0.25);
  const Vec2 before = moments(scene.model.blocks[block.index()].polygon).centroid;
  Driver run(scene.model, scene.plan, methods());
  EXPECT_EQ(run.run().status, RunEnd::Status::done);
  const BodyTotals totals = totals_of(run, block);
  return {totals.centre - before, totals.momentum.norm() / totals.mass, run.state().ledger.relative_closure()};
}

class NotchRest : public testing::TestWithParam<Scheme> {};

TEST_P(NotchRest, block_stands_on_what_carries_it) {
  const Notch level{"level", ring({{-2, -1}, {3, -1}, {3, 0}, {-2, 0}}), kUnit};
  const double settlement = -rest_of(GetParam(), level).moved.y();
  for (const Notch& n : notches()) {
    SCOPED_TRACE(n.name);
    const Rest rest = rest_of(GetParam(), n);
    EXPECT_GE(-rest.moved.y(), n.least * settlement);
    EXPECT_LE(-rest.moved.y(), n.most * settlement);
    EXPECT_LT(std::abs(rest.moved.x()), 0.25 * settlement);
    EXPECT_LT(rest.speed, 1e-6);
    EXPECT_LT(rest.closure, 1e-11);
    std::printf("%s %s: %.4f of the settlement on level ground, %.1e m/s\n", GetParam().name, n.name,
                -rest.moved.y() / settlement, rest.speed);
  }
}

INSTANTIATE_TEST_SUITE_P(schemes, NotchRest, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::test::notch_test
