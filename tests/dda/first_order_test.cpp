// Shi's first-order rotation: edges and energy of a free spin against the analytic growth, stress at rest against the
// exact rotation, and changes between the forms of rotation.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::first_order_test {
namespace {

using namespace coupling;

constexpr double kSpin = 2.0, kStep = 1e-2;

/// A block free of stress that spins about its centre, and moves.
Scene spinning(BlockRotation rotation, int steps) {
  Scene scene(1e12, 0.25, 2500.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("block", {{{0, 0}, {1.2, 0.1}, {1.0, 0.7}, {0.2, 0.9}}, {}});
  scene.model.initial_velocities.push_back({id, Vec2(0.3, -0.2), kSpin});
  Stage& stage = scene.stage("dda", Integrator::implicit, steps * kStep, kStep);
  stage.rotation = rotation;
  stage.control.max_displacement = 0.1;
  return scene;
}

void run_to_end(Driver& run) {
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
}

std::vector<Vec2> corners(const Driver& run) {
  std::vector<Vec2> out;
  for (const Row& row : run.setup().outlines().nodes) out.push_back(position(row, run.state().q));
  return out;
}

/// Largest relative error of the ratio of an edge's length to its initial length against the expected ratio.
double edge_error(const Driver& run, const Model& model, double expected) {
  const std::vector<Vec2> now = corners(run);
  const Ring& ring = model.blocks[0].polygon.ring(0);
  double worst = 0.0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const std::size_t next = (k + 1) % ring.size();
    worst = std::max(worst, std::abs((now[next] - now[k]).norm() / (ring[next] - ring[k]).norm() / expected - 1.0));
  }
  return worst;
}

double stress_energy(const Driver& run) { return run.state().ledger[Column::elastic]; }

void expect_closed(const Driver& run) {
  const Ledger& ledger = run.state().ledger;
  EXPECT_LT(std::abs(ledger.closure()), 1e-11 * ledger.moved() + ledger.last_places()) << ledger.moved();
}

// Growth stated in the keynote: sqrt(1 + r0^2) per step, here r0 = w dt; `exact` keeps the lengths of the edges.
TEST(FirstOrderRotation, edges_of_a_free_spin_grow_by_the_secant_and_those_of_exact_stay) {
  for (const int steps : {50, 200}) {
    const Scene scene = spinning(BlockRotation::first_order, steps);
    Driver run(scene.model, scene.plan, methods());
    run_to_end(run);
    const double r0 = kSpin * kStep, growth = std::pow(1.0 + r0 * r0, 0.5 * steps),
                 error = edge_error(run, scene.model, growth);
    std::printf("first order, %d steps: edges longer by %.6f, expected %.6f\n", steps, growth * (1.0 + error), growth);
    EXPECT_LT(error, 1e-12) << steps;

    const Scene still = spinning(BlockRotation::exact, steps);
    Driver exact(still.model, still.plan, methods());
    run_to_end(exact);
    EXPECT_LT(edge_error(exact, still.model, 1.0), 1e-12) << steps;
  }
}

// The inertia tr S grows by 1 + r0^2 per step while the spin stays: the kinetic energy of the spin and the angular
// momentum grow by the same factor. The ledger books this in the column of the geometry update, and closes; the growth
// causes no stress.
TEST(FirstOrderRotation, what_it_adds_to_a_spin_is_kinetic_energy_of_the_update) {
  const int steps = 100;
  const Scene scene = spinning(BlockRotation::first_order, steps);
  Driver run(scene.model, scene.plan, methods());
  const ByHand begin(scene.model, scene.plan.stages[0]);
  const BodyTotals before = begin.totals(begin.setup->bodies()[0]);
  run_to_end(run);
  const BodyTotals after = totals_of(run, BlockId{0});
  const double r0 = kSpin * kStep, growth = std::pow(1.0 + r0 * r0, steps);
  const auto spin = [](const BodyTotals& t) { return t.angular_momentum - cross(t.centre, t.momentum); };
  const double linear = 0.5 * before.momentum.squaredNorm() / before.mass;
  EXPECT_NEAR(spin(after) / spin(before), growth, 1e-12 * growth);
  EXPECT_NEAR((after.kinetic - linear) / (before.kinetic - linear), growth, 1e-12 * growth);
  EXPECT_LT((after.momentum - before.momentum).norm(), 1e-12 * before.momentum.norm());
  EXPECT_NEAR(run.state().ledger[Column::update_kinetic], after.kinetic - before.kinetic, 1e-12 * before.kinetic);
  EXPECT_LT(std::abs(stress_energy(run)), 1e-12 * before.kinetic);
  EXPECT_LT(std::abs(run.state().ledger[Column::update_elastic]), 1e-15 * before.kinetic);
  expect_closed(run);
}

/// A soft block with in-situ stress on a floor, loaded from above.
Scene pressed(std::initializer_list<BlockRotation> rotations) {
  Scene scene(5e7, 0.25, 2500.0);
  scene.model.materials[0].initial_stress = InitialStress{};
  scene.model.materials[0].initial_stress->stress = (Mat2() << -2e4, 3e3, 3e3, -4e4).finished();
  scene.add("floor", rectangle(-1, -1, 2, 0), true);
  const BlockId id = scene.add("block", rectangle(0.0, 0.0, 1.0, 1.0));
  scene.model.point_loads.push_back({id, Vec2(0.5, 1.0), Vec2(0.0, -5e4), {}});
  for (const BlockRotation rotation : rotations) {
    Stage& stage = scene.stage("dda", Integrator::implicit, 0.5, 5e-3);
    stage.rotation = rotation;
    stage.control.max_displacement = 0.1;
    stage.dynamics = 0.0;
  }
  return scene;
}

std::vector<double> stress_at_end(const Driver& run) {
  const Body& b = run.setup().bodies()[1];
  std::vector<double> cells(3 * 16, 0.0);
  run.setup().pool_of(b).stress(run.setup().part(std::span<const double>(run.state().q), std::size_t(b.pool)), cells);
  cells.resize(6);
  return cells;
}

// Without rotation the two updates differ only by products of strains.
TEST(FirstOrderRotation, a_block_at_rest_has_the_stress_of_exact_but_for_products_of_strains) {
  const Scene one = pressed({BlockRotation::first_order}), other = pressed({BlockRotation::exact});
  Driver run(one.model, one.plan, methods()), exact(other.model, other.plan, methods());
  run_to_end(run);
  run_to_end(exact);
  const std::vector<double> a = stress_at_end(run), b = stress_at_end(exact);
  const double strain = 1e5 / 5e7;  // upper bound of the strain by load and in-situ stress
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 2.0 * strain * 1e5) << k;
  EXPECT_LT((centre_of(run, BlockId{1}) - centre_of(exact, BlockId{1})).norm(), 2.0 * strain * strain);
  expect_closed(run);
}

// Changes into and out of the first-order form keep outline, momenta and energies, with stress and growth present.
TEST(FirstOrderRotation, a_change_of_rotation_keeps_shape_momenta_and_energies) {
  Scene scene = spinning(BlockRotation::exact, 40);
  scene.model.materials[0].young = 5e6;
  scene.model.materials[0].initial_stress = InitialStress{};
  scene.model.materials[0].initial_stress->stress = (Mat2() << -2e4, 5e3, 5e3, -1e4).finished();
  for (const BlockRotation rotation : {BlockRotation::first_order, BlockRotation::affine}) {
    Stage next = scene.plan.stages.back();
    next.rotation = rotation;
    scene.plan.stages.push_back(next);
  }
  Driver run(scene.model, scene.plan, methods());
  run_to_end(run);
  const TransferRow* seen = nullptr;
  ASSERT_EQ(run.transfers().size(), 2U);
  for (const TransferRow& row : run.transfers()) {
    EXPECT_LT(row.momentum_error, 1e-12);
    EXPECT_LT(row.angular_error, 1e-12);
    EXPECT_LT(row.energy_error, 1e-12);
    EXPECT_LT((row.after.centre - row.before.centre).norm(), 1e-12);
    seen = &row;
  }
  ASSERT_NE(seen, nullptr);
  EXPECT_GT(std::abs(seen->before.elastic), 1.0);
  expect_closed(run);
}

TEST(FirstOrderRotation, goes_on_from_a_checkpoint_to_the_same_bits) {
  Scene scene = spinning(BlockRotation::first_order, 40);
  scene.model.materials[0].young = 5e6;
  scene.model.gravity = {0.0, -9.81};
  scene.add("floor", rectangle(-2, -2, 3, -0.4), true);
  KeepOne keeper(17);
  Driver whole(scene.model, scene.plan, methods());
  whole.set_keeper(keeper);
  run_to_end(whole);
  ASSERT_EQ(keeper.kept.size(), 1U);
  Driver rest(scene.model, scene.plan, methods());
  rest.continue_from(keeper.kept[0]);
  run_to_end(rest);
  EXPECT_NE(state_hash(keeper.kept[0].state), state_hash(whole.state()));
  EXPECT_EQ(state_hash(rest.state()), state_hash(whole.state()));
}

TEST(FirstOrderRotation, steps_of_two_kinds_refuse_it) {
  Scene scene = spinning(BlockRotation::first_order, 10);
  scene.plan.stages[0].integrator = Integrator::partitioned;
  try {
    Driver run(scene.model, scene.plan, methods());
    (void)run.run();
    FAIL() << "it ran";
  } catch (const PlanError& e) {
    EXPECT_NE(std::string(e.what()).find("rotation of first order"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace scree::test::first_order_test
