// Free fall, free spin and the patch of both methods against theory.
#include <gtest/gtest.h>

#include "tests/support/scene.h"

namespace scree::test {
namespace {

using coupling::Integrator;

class FreeFall : public testing::TestWithParam<std::string> {};

TEST_P(FreeFall, follows_the_parabola_to_round_off) {
  const bool implicit = GetParam().ends_with("-implicit");
  Scene scene;
  const BlockId id = scene.add("block", {{{0, 0}, {2, 0.3}, {1.5, 1.2}, {0.2, 1}}, {}});
  scene.model.initial_velocities.push_back({id, {3.0, 4.0}, 0.0});
  scene.stage(GetParam().substr(0, 3), implicit ? Integrator::implicit : Integrator::explicit_, 0.5,
              implicit ? std::optional<double>(1e-3) : std::nullopt, 0.4);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  const Vec2 start = moments(scene.model.blocks[0].polygon).centroid;
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  EXPECT_NEAR((centre_of(run, id) - start - Vec2(1.5, 2.0 - 0.5 * 9.81 * 0.25)).norm(), 0.0, 1e-11);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}
INSTANTIATE_TEST_SUITE_P(all, FreeFall,
                         testing::Values("nmm-explicit", "nmm-implicit", "dda-explicit", "dda-implicit"));

TEST(FreeSpin, implicit_dda_keeps_edges_and_spin_to_1e_12) {
  Scene scene;
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("block", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({id, {0.0, 0.0}, 1.0});
  scene.stage("dda", Integrator::implicit, 2.0 * std::numbers::pi * 2.0, 1e-2).control.max_displacement = 0.1;
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  const double before = 0.5 * 2600.0 * 2.0 * 5.0 / 12.0;
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const std::vector<double>& q = run.state().q;
  EXPECT_NEAR(std::hypot(q[2], q[3]), 1.0, 1e-12);
  EXPECT_NEAR(std::hypot(q[4], q[5]), 1.0, 1e-12);
  EXPECT_NEAR(std::sqrt(totals_of(run, id).kinetic / before), 1.0, 1e-12);  // round-off adds some 4e-16 a step
}

TEST(FreeSpin, explicit_nmm_keeps_angular_momentum) {
  Scene scene(1e7, 0.2, 2000.0);
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("block", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({id, {0.0, 0.0}, 2.0});
  scene.stage("nmm", Integrator::explicit_, 2.0, std::nullopt, 0.5);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const double J = 2000.0 * 2.0 * 5.0 / 12.0;
  const BodyTotals t = totals_of(run, id);
  EXPECT_NEAR((t.angular_momentum - cross(t.centre, t.momentum)) / (2.0 * J), 1.0, 1e-12);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-11);
}

TEST(HandOver, explicit_nmm_to_dda_keeps_mass_momenta_and_energy) {
  Scene scene(1e7, 0.2, 2000.0);
  const BlockId id = scene.add("block", {{{0, 0}, {2, 0.3}, {1.5, 1.2}, {0.2, 1}}, {}});
  scene.add("base", rectangle(-2, -2, 5, -0.02), true);
  scene.model.initial_velocities.push_back({id, {0.5, 0.0}, 1.5});
  scene.stage("nmm", Integrator::explicit_, 0.2, std::nullopt, 0.4);
  scene.stage("dda", Integrator::implicit, 0.01, 1e-3);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  ASSERT_EQ(run.transfers().size(), 1U);
  const coupling::TransferRow& row = run.transfers()[0];
  EXPECT_GT(row.before.kinetic, 1.0);
  EXPECT_GT(row.reservoir_kinetic, 0.0);
  EXPECT_LT(row.mass_error, 1e-12);
  EXPECT_LT(row.momentum_error, 1e-12);
  EXPECT_LT(row.angular_error, 1e-12);
  EXPECT_LT(row.energy_error, 1e-10);
}

}  // namespace
}  // namespace scree::test
