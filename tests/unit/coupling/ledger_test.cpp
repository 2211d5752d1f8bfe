#include <gtest/gtest.h>

#include "coupling/integrate/central_difference.h"
#include "tests/support/by_hand.h"
#include "tests/support/scene.h"

namespace scree::test::ledger_test {
namespace {

using namespace coupling;

Scene falling_block() {
  Scene scene(1e7, 0.2, 2000.0, 20.0);
  scene.add("base", rectangle(-2, -1, 4, 0), true);
  scene.add("block", rectangle(0, 0.01, 1, 1.01));
  scene.stage("nmm", Integrator::explicit_, 0.2, std::nullopt, 0.5);
  return scene;
}

TEST(Ledger, unknown_work_shows_as_closure) {
  Ledger ledger;
  ledger.open(std::array{10.0});
  ledger.set(Column::kinetic, 12.0);
  ledger.book(Column::gravity, 3.0);
  ledger.book(Column::friction, 1.0);
  EXPECT_EQ(ledger.closure(), 0.0);
  ledger.set(Column::kinetic, 12.5);
  EXPECT_EQ(ledger.closure(), 0.5);
}

TEST(Ledger, several_increments_are_booked_as_one_after_another) {
  Ledger single, several;
  for (int k = 1; k < 100; ++k) {
    const double a = 1.0 / k, b = -0.3 / (k * k);
    single.book(Column::friction, a);
    single.book(Column::contact_geometry, b);
    single.book(Column::friction, b);
    Ledger::Booking booking(several);
    booking.book(Column::friction, a);
    booking.book(Column::contact_geometry, b);
    booking.book(Column::friction, b);
  }
  for (const Column c : {Column::friction, Column::contact_geometry, Column::dilation})
    EXPECT_EQ(several[c], single[c]);
  EXPECT_EQ(several.moved(), single.moved());
  EXPECT_GT(several.moved(), 0.0);
}

/// A force that acts on the bodies but is not in the ledger.
class Hidden final : public ForceTerm {
 public:
  void add(const Instant&, std::span<double> f) override {
    for (std::size_t i = 0; i < f.size(); i += 2) f[i] += 1.0;
  }
  void leave(double, std::span<const double>) override {}
  void arrive(double, std::span<const double>, coupling::Ledger&) override {}
};

/// Runs the falling block by hand, with or without a hidden force.
double closure_of_fall(bool hide) {
  Scene scene = falling_block();
  const Methods methods = standard_methods();
  ByHand hand(scene.model, scene.plan.stages[0]);
  State& state = hand.state;
  const coupling::Setup& setup = *hand.setup;
  StepControl control;
  control.max_displacement = 0.01;
  CentralDifference integrator(setup, control, 0.05);
  if (hide) integrator.add_term(std::make_unique<Hidden>());
  integrator.enter(state);
  const Tick h = ticks(0.5 * integrator.stable_step(state, nullptr));
  for (int i = 0; i < 500; ++i) EXPECT_EQ(integrator.step(state, h).status, StepReport::Status::ok);
  integrator.update_ledger(state);
  return state.ledger.relative_closure();
}

TEST(Ledger, closes_and_a_force_hidden_from_it_is_found) {
  EXPECT_LT(closure_of_fall(false), 1e-12);
  EXPECT_GT(closure_of_fall(true), 1e-6);
}

TEST(Ledger, closes_through_a_driven_base_and_both_schemes) {
  for (const bool implicit : {false, true}) {
    Scene scene(1e8, 0.2, 2000.0, 25.0);
    scene.add("base", rectangle(-2, -1, 6, 0));
    scene.model.block_supports.push_back({BlockId{0}, MotionId{0}});
    std::vector<double> t, a;
    for (int i = 0; i <= 200; ++i) {
      t.push_back(0.005 * i);
      a.push_back(4.0 * std::sin(2.0 * std::numbers::pi * 3.0 * t.back()));
    }
    scene.model.motions.emplace_back(t, a, Vec2(1.0, 0.0));
    scene.add("block", rectangle(0, 0, 1, 1));
    scene.add("upper", rectangle(0.2, 1, 0.8, 1.5));
    scene.stage("dda", implicit ? Integrator::implicit : Integrator::explicit_, 0.8,
                implicit ? std::optional<double>(1e-3) : std::nullopt);
    const Methods methods = standard_methods();
    Driver run(scene.model, scene.plan, methods);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    EXPECT_GT(std::abs(run.state().ledger[Column::prescribed_motion]), 1.0);
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
  }
}

TEST(PointSupports, hanging_block_stretches_its_springs_by_its_weight) {
  for (const bool implicit : {false, true}) {
    Scene scene(1e9, 0.2, 2000.0, 25.0);
    const BlockId id = scene.add("block", rectangle(0, 0, 1, 1));
    for (double x : {0.0, 1.0}) {
      PointSupport s;
      s.block = id;
      s.point = {x, 1.0};
      s.stiffness = 1e6;
      scene.model.point_supports.push_back(s);
    }
    scene.stage("dda", implicit ? Integrator::implicit : Integrator::explicit_, 0.5,
                implicit ? std::optional<double>(5e-3) : std::nullopt);
    const Methods methods = standard_methods();
    Driver run(scene.model, scene.plan, methods);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    // Undamped, the block swings between 0 and 2 m g / (2 k): the energy checks it at any phase.
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
    const double drop = 0.5 - centre_of(run, id).y();
    EXPECT_GT(drop, 0.0);
    EXPECT_LT(drop, 2.05 * 2000.0 * 9.81 / 2e6);
  }
}

}  // namespace
}  // namespace scree::test::ledger_test
