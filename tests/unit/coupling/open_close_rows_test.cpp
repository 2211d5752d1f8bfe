// Rows of gap and stretch of affine bodies, filled by several threads, against rows added one unknown at a time.
#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::coupling::open_close_rows_test {
namespace {

using test::rectangle;

/// Blocks in a heap after some steps, on a base that is held or follows a motion.
struct Heap {
  test::Scene scene{1e8, 0.2, 2500.0, 25.0};
  Heap() {
    std::mt19937_64 random(17);
    std::uniform_real_distribution<double> shift(0.0, 0.3);
    // The base is last: unknowns of a block precede or follow those of the body it touches.
    for (int j = 0; j < 4; ++j)
      for (int i = 0; i < 4; ++i) {
        const double x = 1.02 * i + shift(random), y = 1.002 * j;
        scene.add("b" + std::to_string(10 * j + i), rectangle(x, y, x + 0.9, y + 1.0));
      }
    scene.add("base", rectangle(-1.0, -1.0, 6.0, 0.0), true);
    scene.stage("dda", Integrator::implicit, 1.0, 1e-3, 2.0);
  }
};

TEST(OpenCloseRows, of_affine_bodies_are_those_of_any_bodies) {
  const Heap heap;
  test::ByHand hand(heap.scene.model, heap.scene.plan.stages[0]);
  StepControl control;
  control.max_displacement = 0.05;
  control.max_passes = 30;
  Newmark integrator(*hand.setup, control, 0.05, ImplicitOptions{});
  hand.state.ledger.open(std::array{integrator.enter(hand.state)});
  for (int i = 0; i < 40; ++i) ASSERT_EQ(integrator.step(hand.state, ticks(5e-4)).status, StepReport::Status::ok);
  const ImplicitSystem& system = integrator.system();
  ASSERT_TRUE(system.affine());

  // The driven base moves sideways in the step.
  const std::vector<Vec2> moves(hand.setup->bodies().size(), Vec2(2e-4, -1e-4));
  OpenClose contacts(*hand.setup, control, system, true, OpenClose::Factor::chosen);
  const StepSprings none;
  contacts.begin(integrator.list(), hand.state.q, moves, none);

  const Outlines& o = hand.setup->outlines();
  int of_two = 0, of_one = 0;
  for (std::size_t i = 0; i < integrator.list().points.size(); ++i) {
    const ContactPoint& p = integrator.list().points[i];
    DofRows expected;
    expected.clear();
    for (const ContactRow& row : {gap_row(p.at), stretch_row(p.at, integrator.list().memory[i].anchor)}) {
      expected.begin_row();
      for (std::size_t k = 0; k < 3; ++k) {
        const BodyIndex body = o.node_body[p.node[k]];
        if (hand.setup->body(body).driven)
          expected.add_known(row[k].dot(moves[body.index()]));
        else
          ImplicitSystem::add_point(system.chart(body, o.nodes[p.node[k]], hand.state.q), row[k], expected);
      }
    }
    for (const auto& [is, was] :
         {std::pair(contacts.normal(i), expected[0]), std::pair(contacts.tangential(i), expected[1])}) {
      EXPECT_TRUE(std::ranges::equal(is.dof, was.dof)) << i;
      EXPECT_TRUE(std::ranges::equal(is.h, was.h)) << i;
      EXPECT_EQ(is.known, was.known) << i;
    }
    (expected[0].dof.size() == 12 ? of_two : of_one) += 1;
  }
  EXPECT_GT(of_two, 20);
  EXPECT_GT(of_one, 4);
}

}  // namespace
}  // namespace scree::coupling::open_close_rows_test
