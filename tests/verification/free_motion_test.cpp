// Free fall and free spin of both methods against theory; transfers from the NMM to the DDA; stress in situ.
#include <gtest/gtest.h>

#include "tests/support/scene.h"

namespace scree::test::free_motion_test {
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
  EXPECT_NEAR(std::sqrt(totals_of(run, id).kinetic / before), 1.0, 1e-12);  // round-off adds about 4e-16 per step
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

TEST(TransferReport, explicit_nmm_to_dda_keeps_mass_momenta_and_energy) {
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

/// Mean of the stress over the cells of a block, xx, yy, xy [Pa].
Eigen::Vector3d mean_stress(const coupling::Driver& run, BlockId id) {
  const coupling::Body& b = run.setup().bodies()[id.index()];
  const auto p = static_cast<std::size_t>(b.pool);
  MeshPart mesh;
  run.setup().pool(p).topology(mesh);
  std::vector<double> cells(3 * mesh.body.size());
  run.setup().pool(p).stress(run.setup().part(std::span<const double>(run.state().q), p), cells);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double count = 0.0;
  for (std::size_t c = 0; c < mesh.body.size(); ++c)
    if (mesh.body[c] == b.index) {
      sum += Eigen::Vector3d(cells[3 * c], cells[3 * c + 1], cells[3 * c + 2]);
      count += 1.0;
    }
  return sum / count;
}

TEST(TransferReport, in_situ_stress_goes_along_both_ways) {
  // A spinning block that expands from its in-situ stress: it is affine as a whole (onefold), so that nothing may jump.
  Scene scene(1e7, 0.2, 2000.0);
  InitialStress s;
  s.stress << -2e5, 4e4, 4e4, -5e5;
  scene.model.materials[0].initial_stress = s;
  scene.model.gravity.setZero();
  const BlockId id = scene.add("block", {{{0, 0}, {2, 0.3}, {1.5, 1.2}, {0.2, 1}}, {}});
  scene.model.initial_velocities.push_back({id, {0.5, 0.0}, 3.0});
  for (const char* method : {"nmm", "dda", "nmm"}) {
    scene.stage(method, Integrator::explicit_, 0.05, 1e-5, 0.4);
    scene.plan.stages.back().rules.push_back({{id}, method, 0.4, true});
  }
  const coupling::Methods methods = coupling::standard_methods();
  Scene unbroken = scene;
  unbroken.plan.stages.resize(1);
  unbroken.plan.stages[0].duration = ticks(0.15);
  coupling::Driver run(scene.model, scene.plan, methods), whole(unbroken.model, unbroken.plan, methods);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  ASSERT_EQ(whole.run().status, coupling::RunEnd::Status::done);
  EXPECT_GT(mean_stress(whole, id).norm(), 1e4);
  EXPECT_LT((mean_stress(run, id) - mean_stress(whole, id)).norm(), 1e-6 * 5e5);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-11);
  for (const coupling::TransferRow& row : run.transfers()) EXPECT_LT(row.energy_error, 1e-10);
}

}  // namespace
}  // namespace scree::test::free_motion_test
