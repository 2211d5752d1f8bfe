// A third method (rigid blocks) coupled with NMM and DDA: sums of forces, energies and results known by hand.
#include <gtest/gtest.h>

#include <filesystem>

#include "io/results/results_sink.h"
#include "io/results/run_reader.h"
#include "tests/support/scene.h"
#include "tests/third_method/rigid_pool.h"

namespace scree::test::third_method_test {
namespace {

using coupling::Integrator;

coupling::Methods with_rigid() {
  coupling::Methods methods = coupling::standard_methods();
  methods["rigid"] = [] { return std::make_unique<RigidPool>(); };
  return methods;
}

/// A rigid block lies on an NMM and a DDA block, side by side on a fixed base.
Scene bridge() {
  Scene scene(1e9, 0.2, 2500.0, 30.0);
  scene.add("base", rectangle(-1, -1, 5, 0), true);
  scene.add("left", rectangle(0, 0, 1.5, 1));
  scene.add("right", rectangle(2.5, 0, 4, 1));
  scene.add("beam", rectangle(0.5, 1, 3.5, 1.8));
  return scene;
}

double weight(const Scene& scene, double area) { return scene.model.materials[0].density * area * 9.81; }

double normal_force_on(const coupling::Driver& run, BlockId p, BlockId e) {
  double sum = 0.0;
  for (const coupling::ContactMemory& c : run.state().contacts)
    if ((c.key.block_p == p.value && c.key.block_e == e.value) ||
        (c.key.block_p == e.value && c.key.block_e == p.value))
      sum += c.fn;
  return sum;
}

TEST(ThirdMethod, rigid_block_on_nmm_and_dda_carries_its_weight_into_both) {
  Scene scene = bridge();
  coupling::Stage& stage = scene.stage("rigid", Integrator::explicit_, 0.6, std::nullopt);
  stage.damping = 500.0;
  stage.rules = {{{BlockId{0}, BlockId{2}}, "dda"}, {{BlockId{1}}, "nmm"}};
  for (JointLaw& law : scene.model.joints) law.damping = 0.8;
  const coupling::Methods methods = with_rigid();
  coupling::Driver run(scene.model, scene.plan, methods);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const double load = weight(scene, 3.0 * 0.8);
  // Four contact points: the shares of the load depend on the stiffness of the blocks below, their sum does not.
  const double left = normal_force_on(run, BlockId{3}, BlockId{1}),
               right = normal_force_on(run, BlockId{3}, BlockId{2});
  EXPECT_NEAR((left + right) / load, 1.0, 1e-3);
  EXPECT_GT(left, 0.4 * load);
  EXPECT_GT(right, 0.4 * load);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

TEST(ThirdMethod, staged_run_goes_from_explicit_to_implicit_and_is_written_to_results) {
  Scene scene = bridge();
  coupling::Stage& first = scene.stage("rigid", Integrator::explicit_, 0.05, std::nullopt);
  first.rules = {{{BlockId{0}, BlockId{2}}, "dda"}, {{BlockId{1}}, "nmm"}};
  coupling::Stage& second = scene.stage("dda", Integrator::implicit, 0.2, 1e-3);
  second.rules = {{{BlockId{3}}, "rigid"}};
  const coupling::Methods methods = with_rigid();
  coupling::Driver run(scene.model, scene.plan, methods);
  const std::filesystem::path out = std::filesystem::temp_directory_path() / "scree-third-method";
  std::filesystem::remove_all(out);
  {
    io::Provenance provenance;
    provenance.version = "test";
    io::ResultsSink results(io::RunFolder::create(out, false), provenance);
    run.add_sink(results);
    ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  }
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
  const double load = weight(scene, 3.0 * 0.8);
  EXPECT_NEAR((normal_force_on(run, BlockId{3}, BlockId{1}) + normal_force_on(run, BlockId{3}, BlockId{2})) / load, 1.0,
              0.01);
  EXPECT_TRUE(std::filesystem::exists(out / "run.vtkhdf"));
  EXPECT_GT(std::filesystem::file_size(out / "summary.json"), 100U);
  std::filesystem::remove_all(out);
}

/// Accelerates its first block by a force that is not booked in the ledger.
class HidesAForce final : public RigidPool {
 public:
  void mass_solve(std::span<const double> q, std::span<const double> f, std::span<double> a) const override {
    RigidPool::mass_solve(q, f, a);
    a[1] -= 0.1;  // m/s2
  }
};

TEST(ThirdMethod, run_ends_where_a_force_is_hidden_from_the_ledger) {
  const auto end_of = [](bool hidden, double allowed) {
    Scene scene = bridge();
    coupling::Stage& stage = scene.stage("rigid", Integrator::explicit_, 0.1, std::nullopt);
    stage.rules = {{{BlockId{0}, BlockId{2}}, "dda"}, {{BlockId{1}}, "nmm"}};
    scene.plan.max_closure = allowed;
    scene.plan.max_passed_closure = 0.0;
    scene.plan.max_gain = 0.0;
    coupling::Methods methods = with_rigid();
    if (hidden) methods["rigid"] = [] { return std::make_unique<HidesAForce>(); };
    coupling::Driver run(scene.model, scene.plan, methods);
    return run.run();
  };
  EXPECT_EQ(end_of(false, 1e-9).status, coupling::RunEnd::Status::done);
  const coupling::RunEnd open = end_of(true, 1e-9);
  EXPECT_EQ(open.status, coupling::RunEnd::Status::not_converged);
  EXPECT_NE(open.reason.find("the energy ledger is open by"), std::string::npos) << open.reason;
  EXPECT_NE(open.reason.find("run.max_closure"), std::string::npos) << open.reason;
  EXPECT_EQ(end_of(true, 0.0).status, coupling::RunEnd::Status::done);  // a limit of 0 switches the check off
}

TEST(ThirdMethod, rigid_spin_keeps_edges_and_rate) {
  Scene scene;
  scene.model.gravity = {0.0, 0.0};
  const BlockId id = scene.add("free", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({id, {0.0, 0.0}, 3.0});
  scene.stage("rigid", Integrator::implicit, 1.0, 1e-3);
  const coupling::Methods methods = with_rigid();
  coupling::Driver run(scene.model, scene.plan, methods);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const BodyTotals t = totals_of(run, id);
  EXPECT_NEAR(t.kinetic, 0.5 * 2600.0 * 2.0 * (4.0 + 1.0) / 12.0 * 9.0, 1e-8);  // 1e-12 relative
}

}  // namespace
}  // namespace scree::test::third_method_test
