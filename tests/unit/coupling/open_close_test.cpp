#include "coupling/integrate/open_close.h"

#include <gtest/gtest.h>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::coupling {
namespace {

using test::rectangle;

/// Blocks in running bond, a millimetre apart, that fall on their base.
struct Wall {
  test::Scene scene{1e8, 0.2, 2500.0, 25.0};
  explicit Wall(const std::string& method) {
    scene.add("base", rectangle(-1.0, -1.0, 6.0, 0.0), true);
    for (int j = 0; j < 5; ++j)
      for (int i = 0; i < 4; ++i) {
        const double x = 1.02 * i + (j % 2 == 0 ? 0.0 : 0.45), y = 0.001 * (1.0 + 0.3 * (i % 3)) + 1.002 * j;
        scene.add("b" + std::to_string(10 * j + i), rectangle(x, y, x + 1.0, y + 1.0));
      }
    scene.stage(method, Integrator::implicit, 1.0, 1e-3, 2.0);
  }
};

struct Fall {
  test::ByHand hand;
  Newmark mover;
  StepReport all;

  Fall(const Wall& wall, OpenClose::Factor factor, int steps)
      : hand(wall.scene.model, wall.scene.plan.stages[0]),
        mover(*hand.setup, control(), 0.05, ImplicitOptions{.factor = factor}) {
    hand.state.ledger.open(std::array{mover.enter(hand.state)});
    for (int i = 0; i < steps; ++i) {
      Tick h = ticks(1e-3);
      StepReport report = mover.step(hand.state, h);
      for (; report.status != StepReport::Status::ok && h > 1000; report = mover.step(hand.state, h)) h /= 3;
      EXPECT_EQ(report.status, StepReport::Status::ok) << report.cause;
      all.passes += report.passes;
      all.switches += report.switches;
      all.updates += report.updates;
      all.factorisations += report.factorisations;
    }
    mover.update_ledger(hand.state);
  }
  static StepControl control() {
    StepControl c;
    c.max_displacement = 0.05;
    c.max_passes = 30;
    return c;
  }
};

class OpenCloseUpdates : public testing::TestWithParam<std::string> {};

TEST_P(OpenCloseUpdates, rank_updates_give_the_motion_of_new_factors) {
  const Wall wall(GetParam());
  const Fall with(wall, OpenClose::Factor::updated, 60), without(wall, OpenClose::Factor::anew, 60);
  EXPECT_GT(with.all.updates, 20);
  EXPECT_EQ(without.all.updates, 0);
  EXPECT_LT(with.all.factorisations, without.all.factorisations);
  EXPECT_EQ(with.all.switches, without.all.switches);
  EXPECT_EQ(with.all.passes, without.all.passes);
  const auto &q = with.hand.state.q, &reference = without.hand.state.q;
  for (std::size_t i = 0; i < q.size(); ++i) EXPECT_NEAR(q[i], reference[i], 1e-9) << i;
}

INSTANTIATE_TEST_SUITE_P(Methods, OpenCloseUpdates, testing::Values("dda", "nmm"),
                         [](const auto& p) { return p.param; });

}  // namespace
}  // namespace scree::coupling
