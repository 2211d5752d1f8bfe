// What the implicit side of partitioned steps takes from one step to the next: start values and the tangent.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

#include "coupling/integrate/partitioned.h"
#include "tests/support/by_hand.h"

namespace scree::coupling::newmark_interface_test {
namespace {

using test::rectangle;

/// Two explicit blocks, one on the other, over an implicit meshed base.
struct Slide {
  test::Scene scene{1e9, 0.2, 2600.0, 20.0};
  std::unique_ptr<test::ByHand> start;
  std::unique_ptr<Partitioned> integrator;

  /// @param drop  height of the lower block over the base [m]
  Slide(OpenClose::Factor factor, double drop) {
    const BlockId base = scene.add("base", rectangle(0.0, -1.0, 6.0, 0.0)),
                  low = scene.add("low", rectangle(1.0, drop, 3.0, 1.0 + drop)),
                  high = scene.add("high", rectangle(1.5, 1.0 + drop, 2.5, 1.6 + drop));
    for (const double x : {0.5, 3.0, 5.5}) scene.model.point_supports.push_back({base, Vec2(x, -1.0), true, true, 1e9});
    scene.model.initial_velocities.push_back({low, Vec2(0.5, 0.0), 0.0});
    scene.model.initial_velocities.push_back({high, Vec2(1.5, 0.0), 0.0});
    const Stage& stage = scene.stage("nmm", Integrator::partitioned, 1.0, 1.0, 0.5);
    start = std::make_unique<test::ByHand>(scene.model, stage);
    start->state.explicit_side = {0, 1, 1};
    StepControl control;
    control.max_displacement = 0.01;
    Partitioned::Choice choice;
    choice.substeps = 1;
    choice.implicit.factor = factor;
    integrator = std::make_unique<Partitioned>(*start->setup, start->methods, start->state, control, 0.05, choice);
    (void)integrator->enter(start->state);
  }
  StepReport step(double h = 4e-5) { return integrator->step(start->state, ticks(h)); }
};

TEST(KeptTangent, moves_the_bodies_as_new_tangents_do) {
  Slide kept(OpenClose::Factor::chosen, 0.0), anew(OpenClose::Factor::anew, 0.0);
  const int steps = 1000;
  int made = 0, made_anew = 0, iterations = 0, iterations_anew = 0;
  for (int i = 0; i < steps; ++i) {
    const StepReport a = kept.step(), b = anew.step();
    ASSERT_EQ(a.status, StepReport::Status::ok) << a.cause;
    ASSERT_EQ(b.status, StepReport::Status::ok) << b.cause;
    made += a.factorisations;
    made_anew += b.factorisations;
    iterations += a.iterations;
    iterations_anew += b.iterations;
  }
  double apart = 0.0;
  for (std::size_t i = 0; i < kept.start->state.q.size(); ++i)
    apart = std::max(apart, std::abs(kept.start->state.q[i] - anew.start->state.q[i]));
  std::printf("%d and %d factors, %d and %d iterations, %.1e m apart\n", made, made_anew, iterations, iterations_anew,
              apart);
  EXPECT_LT(apart, 1e-9);  // each step balances to 1e-9 of the largest force; the blocks move by 0.06 m
  EXPECT_EQ(made_anew, steps);
  EXPECT_LT(made, steps / 4);
  EXPECT_LT(iterations, 1.2 * iterations_anew);
}

TEST(KeptTangent, that_does_not_fit_any_more_is_made_anew_within_the_step) {
  // The blocks fall on the base in the run: no spring of the first tangent belongs to a contact.
  Slide falls(OpenClose::Factor::chosen, 1e-4);
  int made = 0;
  bool touched = false;
  for (int i = 0; i < 400; ++i) {
    const StepReport report = falls.step();
    ASSERT_EQ(report.status, StepReport::Status::ok) << "step " << i << ": " << report.cause;
    made += report.factorisations;
    for (const ContactMemory& m : falls.start->state.contacts) touched = touched || m.status != ContactStatus::open;
  }
  EXPECT_TRUE(touched);
  EXPECT_GE(made, 2);
}

TEST(KeptTangent, belongs_to_one_length_of_step) {
  Slide slide(OpenClose::Factor::chosen, 0.0);
  for (int i = 0; i < 20; ++i) ASSERT_EQ(slide.step().status, StepReport::Status::ok);
  EXPECT_TRUE(slide.integrator->implicit_side().keeps_tangent(ticks(4e-5)));
  EXPECT_FALSE(slide.integrator->implicit_side().keeps_tangent(ticks(3e-5)));
  const StepReport shorter = slide.step(3e-5);
  ASSERT_EQ(shorter.status, StepReport::Status::ok);
  EXPECT_EQ(shorter.factorisations, 1);
}

TEST(KeptTangent, iterations_start_where_a_smooth_motion_goes) {
  // Without friction or other blocks the force on the base varies smoothly: one iteration is enough.
  Slide slide(OpenClose::Factor::chosen, 0.0);
  for (int i = 0; i < 500; ++i) ASSERT_EQ(slide.step(1e-5).status, StepReport::Status::ok);
  int iterations = 0;
  for (int i = 0; i < 200; ++i) iterations += slide.step(1e-5).iterations;
  std::printf("%.3f iterations\n", iterations / 200.0);
  EXPECT_LT(iterations, 300);
}

/// Forces on the nodes of ghosts, foreseen at two ends that differ by a small displacement of the base.
TEST(ForeseenContacts, again_are_those_of_a_new_search) {
  test::Scene scene(1e9, 0.2, 2600.0, 20.0);
  scene.add("base", rectangle(0.0, -1.0, 6.0, 0.0));
  scene.add("block", rectangle(1.0, 0.0, 3.0, 1.0));
  const Stage& stage = scene.stage("dda", Integrator::explicit_, 1.0, 1.0, 0.5);
  const test::ByHand hand(scene.model, stage);
  Ghosts ghosts;
  ghosts.ghost = {1, 0};
  const coupling::Setup setup(scene.model, hand.methods, hand.state.bodies, ghosts);
  State state = hand.state;  // with the nodes in the order of this setup
  const auto place = [&](std::size_t body, const AffineMotion& m, std::span<double> q) {
    std::vector<double> still(q.size(), 0.0);
    const auto p = static_cast<std::size_t>(setup.bodies()[body].pool);
    setup.pool_of(setup.bodies()[body])
        .place(setup.bodies()[body].index, m, setup.part(q, p), setup.part(std::span<double>(still), p));
  };
  for (std::size_t b = 0; b < 2; ++b) {
    AffineMotion at_rest;
    at_rest.c = setup.bodies()[b].centre;
    place(b, at_rest, state.q);
  }
  StepControl control;
  CentralDifference integrator(setup, control, 0.05, {});
  (void)integrator.enter(state);
  // The base, tilted and pressed against the block.
  const auto end_of = [&](double amount) {
    std::vector<double> end = state.q;
    AffineMotion m;
    m.c = setup.bodies()[0].centre + Vec2(2e-6, 1e-4) + amount * Vec2(1e-3, 2e-3);
    m.F = rotation(amount * 3e-3);
    place(0, m, end);
    return end;
  };
  const auto error = [&](double amount) {
    std::vector<double> first(state.q.size(), 0.0), again = first, anew = first;
    integrator.foresee(state, end_of(0.0), ticks(1e-3), false, first);
    integrator.foresee(state, end_of(amount), ticks(1e-3), true, again);
    integrator.foresee(state, end_of(amount), ticks(1e-3), false, anew);
    double changed = 0.0, wrong = 0.0;
    for (std::size_t i = 0; i < first.size(); ++i) {
      changed = std::max(changed, std::abs(anew[i] - first[i]));
      wrong = std::max(wrong, std::abs(anew[i] - again[i]));
    }
    EXPECT_GT(changed, 1e5 * amount);
    return wrong / changed;
  };
  // Dashpots of the points stay those of the first search.
  const double damped = error(1e-2);
  scene.model.joints[0].damping = 0.0;
  const double large = error(1e-2), small = error(1e-4);
  std::printf("with dashpots %.2e, without %.2e and %.2e of the change\n", damped, large, small);
  EXPECT_LT(damped, 1e-4);
  EXPECT_LT(large, 1e-8);
  EXPECT_LT(small, 1e-8);
}

}  // namespace
}  // namespace scree::coupling::newmark_interface_test
