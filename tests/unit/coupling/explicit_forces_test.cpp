// Loads in explicit steps against the theory of one free block.
#include <gtest/gtest.h>

#include "coupling/integrate/edge_stretch.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::explicit_forces_test {
namespace {

using namespace coupling;

class Loads : public testing::TestWithParam<const char*> {
 protected:
  Loads() { scene_.model.gravity = {0.0, 0.0}; }
  Stage& stage(double duration) { return scene_.stage(GetParam(), Integrator::explicit_, duration, std::nullopt, 0.3); }
  FunctionId function(TimeFunction f) {
    scene_.model.functions.push_back(std::move(f));
    return FunctionId{static_cast<std::int32_t>(scene_.model.functions.size()) - 1};
  }
  static EdgeSpan edge(BlockId block, std::int32_t edge, double s0 = 0.0, double s1 = 1.0) {
    return {block, {0, edge}, s0, s1};
  }
  Scene scene_{1e8, 0.2, 2000.0};
};

TEST_P(Loads, point_load_accelerates_the_centre_by_force_over_mass) {
  const BlockId id = scene_.add("block", {{{0, 0}, {2, 0.3}, {1.5, 1.2}, {0.2, 1}}, {}});
  scene_.model.point_loads.push_back({id, {0.4, 0.3}, {3000.0, -2000.0}, {}});
  stage(0.2);
  Driver run(scene_.model, scene_.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Moments m = moments(scene_.model.blocks[0].polygon);
  const Vec2 moved = centre_of(run, id) - m.centroid, force(3000.0, -2000.0);
  // Deformation does not affect the mean motion: central difference is exact for a constant force.
  EXPECT_NEAR((moved - 0.5 * 0.04 * force / (2000.0 * m.area)).norm(), 0.0, 1e-12);
  const BodyTotals t = totals_of(run, id);
  EXPECT_NEAR((t.momentum - 0.2 * force).norm(), 0.0, 1e-9);
  EXPECT_GT(std::abs(t.angular_momentum - cross(t.centre, t.momentum)), 1.0);  // the load is eccentric
  EXPECT_GT(run.state().ledger[Column::loads], 1.0);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

TEST_P(Loads, tractions_on_opposite_edges_end_in_uniform_stress) {
  const BlockId id = scene_.add("block", rectangle(0, 0, 1.3, 0.9));
  const Vec2 pull(2e5, 5e4);
  scene_.model.tractions.push_back({edge(id, 1), pull, {}});
  scene_.model.tractions.push_back({edge(id, 3), -pull, {}});
  const Vec2 shear(5e4, 0.0);  // balances the moment
  scene_.model.tractions.push_back({edge(id, 2), shear, {}});
  scene_.model.tractions.push_back({edge(id, 0), -shear, {}});
  Stage& s = stage(2.0);
  s.damping = 60.0;  // of the whole velocity: otherwise the uniform strain of the balanced block would not be damped
  s.damp_rigid_motion = true;
  std::vector<double> stress;
  Watch watch;
  watch.see = [&](const FrameView& f) { stress.assign(f.stress.begin(), f.stress.end()); };
  Driver run(scene_.model, scene_.plan, methods());
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_GE(stress.size(), 3U);
  for (std::size_t i = 0; i < stress.size(); i += 3) {
    // Dead loads: with strains of 0.2 % the Cauchy stress differs from them by about as much.
    EXPECT_NEAR(stress[i], 2e5, 2e3);
    EXPECT_NEAR(stress[i + 1], 0.0, 2e3);
    EXPECT_NEAR(stress[i + 2], 5e4, 2e3);
    EXPECT_NEAR(stress[i], stress[0], 1e-4);  // uniform
  }
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

TEST_P(Loads, traction_on_part_of_an_edge_has_its_resultant_and_its_lever) {
  const BlockId id = scene_.add("block", rectangle(0, 0, 2, 1));
  scene_.model.tractions.push_back({edge(id, 0, 0.13, 0.41), {0.0, 1000.0}, {}});
  const Stage& s = stage(0.1);
  ByHand hand(scene_.model, s);
  double length = 0.0, lever = 0.0;
  for (const EdgeStretch& e : edge_stretches(*hand.setup, hand.state, scene_.model.tractions[0].span)) {
    length += e.length;
    lever += e.length * (e.at(0.5 * (e.from + e.to), hand.state.q).x() - 1.0);
  }
  EXPECT_NEAR(length, 0.28 * 2.0, 1e-13);
  EXPECT_NEAR(lever, 0.28 * 2.0 * (0.27 * 2.0 - 1.0), 1e-13);
  CentralDifference integrator(*hand.setup, {.max_displacement = 0.01}, 0.05);
  integrator.enter(hand.state);
  const Tick h = ticks(1e-5);
  for (int i = 0; i < 20; ++i) ASSERT_EQ(integrator.step(hand.state, h).status, StepReport::Status::ok);
  const BodyTotals t = hand.totals(hand.setup->bodies()[0]);
  EXPECT_NEAR(t.momentum.y(), 560.0 * 2e-4, 1e-12);
  EXPECT_NEAR(t.angular_momentum - cross(t.centre, t.momentum), 560.0 * -0.46 * 2e-4, 1e-9);
}

TEST_P(Loads, body_acceleration_is_inclined_gravity) {
  std::vector<double> end[2];
  for (const bool as_gravity : {true, false}) {
    Scene scene(1e8, 0.2, 2000.0);
    scene.add("block", rectangle(0, 0, 1.3, 0.9));
    const Vec2 g(3.0, -8.0);
    scene.model.gravity = as_gravity ? g : Vec2(0.0, 0.0);
    if (!as_gravity) scene.model.body_accelerations.push_back({{BlockId{0}}, g, {}});
    scene.stage(GetParam(), Integrator::explicit_, 0.2, std::nullopt, 0.3);
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    end[as_gravity ? 0 : 1] = run.state().q;
    const Ledger& ledger = run.state().ledger;
    EXPECT_GT(ledger[as_gravity ? Column::gravity : Column::loads], 1.0);
    EXPECT_EQ(ledger[as_gravity ? Column::loads : Column::gravity], 0.0);
    EXPECT_LT(ledger.relative_closure(), 1e-12);
  }
  EXPECT_EQ(end[0], end[1]);
}

TEST_P(Loads, body_acceleration_leaves_the_other_blocks_alone) {
  scene_.add("one", rectangle(0, 0, 1, 1));
  const BlockId two = scene_.add("two", rectangle(5, 0, 6, 1));
  scene_.model.body_accelerations.push_back({{two}, {0.0, 2.0}, {}});
  stage(0.1);
  Driver run(scene_.model, scene_.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_LT(totals_of(run, BlockId{0}).kinetic, 1e-18);  // round-off of its stress
  EXPECT_NEAR(totals_of(run, two).momentum.y(), 2000.0 * 0.2, 1e-9);
}

TEST_P(Loads, time_functions_are_taken_at_the_instant_of_the_force) {
  const BlockId id = scene_.add("block", rectangle(0, 0, 1, 1));
  TimeFunction pulse;
  pulse.shape = TimeFunction::Shape::half_sine;
  pulse.amplitude = 4000.0;
  pulse.start = 0.02;
  pulse.duration = 0.06;
  scene_.model.point_loads.push_back({id, {0.5, 0.5}, {1.0, 0.0}, function(pulse)});
  scene_.model.tractions.push_back({edge(id, 0), {0.0, 0.5}, function(pulse)});
  scene_.model.body_accelerations.push_back({{}, {0.0, -1.0 / 4000.0}, function(pulse)});
  stage(0.1).dt = 1e-4;
  Driver run(scene_.model, scene_.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Vec2 p = totals_of(run, id).momentum;
  const double impulse = 4000.0 * 0.06 * 2.0 / std::numbers::pi;  // of the half sine
  EXPECT_NEAR(p.x() / impulse, 1.0, 1e-5);                        // the trapezoid rule errs by (pi h/T)^2/12 = 2.3e-6
  EXPECT_NEAR(p.y(), 0.0, 1e-9);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

TEST_P(Loads, on_a_fixed_block_do_nothing) {
  const BlockId id = scene_.add("base", rectangle(0, 0, 1, 1), true);
  scene_.add("other", rectangle(3, 0, 4, 1));
  scene_.model.point_loads.push_back({id, {0.5, 0.5}, {1e5, 0.0}, {}});
  scene_.model.tractions.push_back({edge(id, 0), {0.0, 1e5}, {}});
  scene_.model.body_accelerations.push_back({{id}, {0.0, 7.0}, {}});
  scene_.model.viscous_edges.push_back({edge(id, 1)});
  stage(0.05);
  Driver run(scene_.model, scene_.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_LT(run.state().ledger.moved(), 1e-15);  // round-off of stress
}
INSTANTIATE_TEST_SUITE_P(methods, Loads, testing::Values("nmm", "dda"));

/// Every kind of damping, all together and one by one, with loads, contact and a driven base: the ledger closes.
struct Kind {
  const char* name;
  ExplicitDamping damping;
  bool viscous = false, rest = false;
};
std::ostream& operator<<(std::ostream& out, const Kind& k) { return out << k.name; }

class DampingBooks : public testing::TestWithParam<std::tuple<const char*, Kind>> {};

TEST_P(DampingBooks, close_to_round_off) {
  const auto& [method, kind] = GetParam();
  Scene scene(1e7, 0.2, 2000.0, 20.0);
  scene.add("base", rectangle(-2, -1, 4, 0));
  std::vector<double> t, a;
  for (int i = 0; i <= 100; ++i) {
    t.push_back(0.005 * i);
    a.push_back(6.0 * std::sin(2.0 * std::numbers::pi * 5.0 * t.back()));
  }
  scene.model.motions.emplace_back(t, a, Vec2(1.0, 0.0));
  scene.model.block_supports.push_back({BlockId{0}, MotionId{0}});
  const BlockId id = scene.add("block", rectangle(0, 0.005, 1, 1.005));
  TimeFunction wave;
  wave.shape = TimeFunction::Shape::sine;
  wave.frequency = 7.0;
  scene.model.functions.push_back(wave);
  scene.model.point_loads.push_back({id, {0.8, 0.9}, {2000.0, 500.0}, FunctionId{0}});
  scene.model.tractions.push_back({{id, {0, 2}, 0.2, 0.9}, {3000.0, -4000.0}, FunctionId{0}});
  scene.model.body_accelerations.push_back({{id}, {1.0, 0.5}, FunctionId{0}});
  if (kind.viscous) scene.model.viscous_edges.push_back({{id, {0, 1}, 0.1, 0.8}});
  Stage& stage = scene.stage(method, Integrator::explicit_, 0.3, std::nullopt, 0.4);
  stage.damping = kind.damping.mass;
  stage.damp_rigid_motion = kind.damping.rigid;
  stage.stiffness_damping = kind.damping.stiffness;
  stage.local_damping = kind.damping.local;
  stage.rest = kind.rest;
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Ledger& ledger = run.state().ledger;
  EXPECT_LT(ledger.relative_closure(), 1e-12);
  const auto taken = [&](Column c, bool expected) {
    if (!expected)
      EXPECT_EQ(ledger[c], 0.0) << info(c).name;
    else
      EXPECT_GT(ledger[c], 0.0) << info(c).name;
  };
  const bool nmm = std::string(method) == "nmm";
  taken(Column::mass_damping, kind.damping.mass > 0.0 && (nmm || kind.damping.rigid));
  if (!nmm) taken(Column::stiffness_damping, kind.damping.stiffness > 0.0);
  taken(Column::local_damping, kind.damping.local > 0.0);
  taken(Column::viscous_edges, kind.viscous);
}
INSTANTIATE_TEST_SUITE_P(all, DampingBooks,
                         testing::Combine(testing::Values("nmm", "dda"),
                                          testing::Values(Kind{"none", {}}, Kind{"mass", {.mass = 20.0}},
                                                          Kind{"rigid", {.mass = 20.0, .rigid = true}},
                                                          Kind{"stiffness", {.stiffness = 1e-4}},
                                                          Kind{"local", {.local = 0.3}}, Kind{"viscous", {}, true},
                                                          Kind{"all", {20.0, false, 1e-4, 0.2}, true},
                                                          Kind{"all_rigid", {20.0, true, 1e-4, 0.2}, true},
                                                          Kind{"all_to_rest", {20.0, false, 1e-4, 0.2}, true, true},
                                                          Kind{"rigid_to_rest", {20.0, true, 0.0, 0.0}, false, true})));

}  // namespace
}  // namespace scree::test::explicit_forces_test
