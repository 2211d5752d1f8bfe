// Choices of a stage for a block (cover size, onefold cover, mass, kinematics), and the quantities they conserve.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::choices_test {
namespace {

using namespace coupling;

TEST(Choices, cover_size_of_rule_block_and_stage_in_this_order) {
  Scene scene;
  for (const char* name : {"a", "b", "c", "d", "e"}) {
    const double x = 3.0 * static_cast<double>(scene.model.blocks.size());
    scene.add(name, rectangle(x, 0, x + 1, 1));
  }
  scene.model.blocks[1].cover_size = scene.model.blocks[3].cover_size = 0.3;
  Stage& s = scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.5);
  s.rules = {{{BlockId{2}, BlockId{3}}, "nmm", 0.2}, {{BlockId{4}}, "nmm", 0.0, true}};
  const std::vector<BodyRequest> request = body_requests(scene.model, s);
  EXPECT_EQ(request[0].form.cover_size, 0.5);
  EXPECT_EQ(request[1].form.cover_size, 0.3);
  EXPECT_EQ(request[2].form.cover_size, 0.2);
  EXPECT_EQ(request[3].form.cover_size, 0.2);
  EXPECT_TRUE(request[4].form.onefold);
  const coupling::Setup setup(scene.model, methods(), initial_records(scene.model, request));
  EXPECT_EQ(setup.bodies()[4].nodes, 3);
  EXPECT_LT(setup.bodies()[0].nodes, setup.bodies()[1].nodes);
  EXPECT_LT(setup.bodies()[1].nodes, setup.bodies()[2].nodes);
}

/// A free spinning block, with each mass, on a mesh and on one cover. The mass of one cover is exact for every choice:
/// row sums would be those of an arbitrary triangle.
TEST(Choices, spin_is_kept_and_its_momentum_is_the_blocks_but_for_row_sums) {
  const double spin = 3.0;
  for (const bool onefold : {false, true})
    for (const MassKind mass : {MassKind::affine_exact, MassKind::lumped, MassKind::consistent}) {
      SCOPED_TRACE(std::to_string(static_cast<int>(mass)) + (onefold ? " onefold" : " mesh"));
      Scene scene(1e8, 0.2, 2000.0);
      scene.model.gravity = {0.0, 0.0};
      const BlockId id = scene.add("block", {{{0, 0}, {2, 0.2}, {1.6, 1.1}, {0.1, 1.0}}, {}});
      scene.model.initial_velocities.push_back({id, {0.4, -0.1}, spin});
      const bool implicit = mass == MassKind::consistent;
      Stage& s = scene.stage("nmm", implicit ? Integrator::implicit : Integrator::explicit_, 0.05,
                             implicit ? std::optional<double>(1e-4) : std::nullopt, 0.4);
      if (implicit) s.newmark = NewmarkScheme::trapezoidal;
      s.mass = mass;
      s.rules = {{{id}, "nmm", 0.0, onefold}};
      s.control.max_displacement = 1.0;
      Driver run(scene.model, scene.plan, methods());
      const RunEnd end = run.run();
      ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
      const BodyTotals t = totals_of(run, id);
      const Moments m = moments(scene.model.blocks[0].polygon);
      const double inertia = 2000.0 * m.second.trace(), about_centre = t.angular_momentum - cross(t.centre, t.momentum);
      EXPECT_NEAR(t.mass, 2000.0 * m.area, 1e-9 * t.mass);
      EXPECT_NEAR((t.momentum - t.mass * Vec2(0.4, -0.1)).norm(), 0.0, 1e-9 * t.mass);
      EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
      if (mass == MassKind::lumped && !onefold) {
        EXPECT_GT(about_centre, 1.0001 * inertia * spin);  // row sums have a larger inertia
      } else {
        EXPECT_NEAR(about_centre, inertia * spin, (implicit ? 1e-4 : 1e-9) * inertia * spin);
      }
    }
}

TEST(Choices, linear_kinematics_after_a_turn_is_refused) {
  // A block turned by half a radian in an earlier stage has no strain, but linear kinematics would give it one.
  for (const char* before : {"dda", "nmm"}) {
    SCOPED_TRACE(before);
    Scene scene(1e8, 0.2, 2000.0);
    scene.model.gravity = {0.0, 0.0};
    const BlockId id = scene.add("block", rectangle(0, 0, 2, 1));
    scene.model.initial_velocities.push_back({id, {0.0, 0.0}, 1.0});
    scene.stage(before, Integrator::explicit_, 0.5, std::nullopt, 0.4).control.max_displacement = 1.0;
    Stage& s = scene.stage("nmm", Integrator::explicit_, 1e-4, std::nullopt, 0.4);
    s.kinematics = Kinematics::linear;
    s.control.max_displacement = 1.0;
    Driver run(scene.model, scene.plan, methods());
    try {
      (void)run.run();
      ADD_FAILURE() << "taken";
    } catch (const coupling::PlanError& e) {
      EXPECT_NE(std::string(e.what()).find("block 'block'"), std::string::npos) << e.what();
      EXPECT_NE(std::string(e.what()).find("0.5"), std::string::npos) << e.what();
    }
  }
}

}  // namespace
}  // namespace scree::test::choices_test
