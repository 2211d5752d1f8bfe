// Warnings of plans: each with a case that raises it and with similar cases that do not.
#include "coupling/stages/plan_warnings.h"

#include <gtest/gtest.h>

#include "tests/support/scene.h"

namespace scree::test::plan_warnings_test {
namespace {

using coupling::Integrator;

std::vector<std::string> warned(const Scene& scene) { return coupling::plan_warnings(scene.model, scene.plan); }

/// Expects exactly one warning, which contains `part`.
void expect_one(const Scene& scene, const std::string& part) {
  const auto found = warned(scene);
  ASSERT_EQ(found.size(), 1U) << (found.empty() ? "" : found[0]);
  EXPECT_NE(found[0].find(part), std::string::npos) << found[0];
}

Scene box_on_base(double gap = 0.0, bool held = true) {
  Scene scene;
  scene.add("base", rectangle(0, 0, 4, 1), held);
  scene.add("box", rectangle(1, 1 + gap, 2, 2 + gap));
  scene.stage("dda", Integrator::implicit, 0.1, 1e-3);
  return scene;
}

TEST(Warnings, none_for_a_box_on_its_base) { EXPECT_TRUE(warned(box_on_base()).empty()); }

TEST(Warnings, nothing_holds_the_model) {
  expect_one(box_on_base(0.0, false), "nothing holds the model");
  expect_one(box_on_base(0.1, false), "nothing holds the model");
  Scene still = box_on_base(0.0, false);
  still.model.gravity.setZero();
  EXPECT_TRUE(warned(still).empty());
  Scene pushed = still;  // a constant force on an unsupported model
  pushed.model.point_loads.push_back({BlockId{1}, {1.0, 1.5}, {1e3, 0.0}, {}});
  expect_one(pushed, "nothing holds the model");
  Scene pulled = pushed;  // two forces that cancel
  pulled.model.point_loads.push_back({BlockId{0}, {0.0, 0.5}, {-1e3, 0.0}, {}});
  EXPECT_TRUE(warned(pulled).empty());
  Scene struck = pushed;  // a pulse
  TimeFunction pulse;
  pulse.shape = TimeFunction::Shape::half_sine, pulse.duration = 0.1;
  struck.model.functions.push_back(pulse);
  struck.model.point_loads[0].function = FunctionId{0};
  EXPECT_TRUE(warned(struck).empty());
}

TEST(Warnings, dashpots_alone_let_a_model_sink) {
  Scene scene = box_on_base(0.0, false);
  scene.model.viscous_edges.push_back({{BlockId{0}, {0, 0}, 0.0, 1.0}});
  expect_one(scene, "sinks");
}

TEST(Warnings, supports_that_hold_the_other_direction_only) {
  Scene scene = box_on_base(0.0, false);
  scene.model.point_supports.push_back({BlockId{0}, {0.0, 0.0}, true, false, {}});
  expect_one(scene, "along y");
  scene.model.point_supports.push_back({BlockId{0}, {2.0, 0.0}, false, true, {}});
  EXPECT_TRUE(warned(scene).empty());
}

TEST(Warnings, a_block_touches_nothing) {
  expect_one(box_on_base(0.01), "block 'box' touches nothing; the nearest other one, 'base', is 0.01 m away");
  EXPECT_TRUE(warned(box_on_base(1e-5)).empty());  // a gap of the order of drawing errors
  Scene thrown = box_on_base(0.5);
  thrown.model.initial_velocities.push_back({BlockId{1}, {1.0, 0.0}, 0.0});
  EXPECT_TRUE(warned(thrown).empty());
  Scene hung = box_on_base(0.5);
  hung.model.point_supports.push_back({BlockId{1}, {1.5, 2.4}, true, true, {}});
  EXPECT_TRUE(warned(hung).empty());
}

TEST(Warnings, gravity_as_a_body_acceleration_counts) {
  Scene scene = box_on_base(0.01);
  scene.model.gravity.setZero();
  EXPECT_TRUE(warned(scene).empty());
  TimeFunction ramp;
  ramp.shape = TimeFunction::Shape::ramp, ramp.duration = 0.5;
  scene.model.functions.push_back(ramp);
  scene.model.body_accelerations.push_back({{}, {0.0, -9.81}, FunctionId{0}});
  expect_one(scene, "touches nothing");
}

TEST(Warnings, blocks_that_touch_each_other_and_nothing_held) {
  Scene scene = box_on_base(0.2);
  scene.add("second", rectangle(2, 1.2, 3, 2.2));
  expect_one(scene, "blocks 'box' and 'second' touch each other, but nothing that is held");
}

TEST(Warnings, many_loose_blocks_are_counted) {
  Scene scene = box_on_base();
  for (int i = 0; i < 20; ++i) scene.add("loose-" + std::to_string(i), rectangle(2.0 * i, 5, 2.0 * i + 1, 6));
  const auto found = warned(scene);
  ASSERT_EQ(found.size(), 6U);
  EXPECT_NE(found.back().find("15 more blocks"), std::string::npos) << found.back();
}

TEST(Warnings, damping_that_acts_on_nothing) {
  for (const bool onefold : {false, true}) {
    Scene scene = box_on_base();
    coupling::Stage& stage = scene.plan.stages[0];
    if (onefold) stage.rules.push_back({{BlockId{0}, BlockId{1}}, "nmm", 0.0, true, false});
    stage.damping = 5.0;
    expect_one(scene, "damping = 5 acts on nothing");
    stage.damp_rigid_motion = true;
    EXPECT_TRUE(warned(scene).empty());
    stage.damp_rigid_motion = false;
    stage.damping = 0.0, stage.stiffness_damping = 1e-4;
    EXPECT_TRUE(warned(scene).empty());
  }
  Scene meshed = box_on_base();
  meshed.plan.stages[0].method = "nmm";
  meshed.plan.stages[0].damping = 5.0;
  EXPECT_TRUE(warned(meshed).empty());
  meshed.plan.stages[0].rules.push_back({{BlockId{1}}, "dda", 0.0, false, false});  // the base is held: no block left
  expect_one(meshed, "acts on nothing");
  Scene held = box_on_base();
  held.model.block_supports.push_back({BlockId{1}, {}});
  held.plan.stages[0].stiffness_damping = 1e-4;
  expect_one(held, "all blocks are held");
}

/// A block of 2 x 1 m on a slope.
Scene on_slope(double degrees, double friction_deg, double damping) {
  Scene scene(1e9, 0.2, 2600.0, friction_deg);
  const double a = degrees * kDegree;
  const Vec2 t(std::cos(a), std::sin(a)), n(-std::sin(a), std::cos(a));
  scene.add("slope", {{Vec2(0, 0) - 2 * t, Vec2(0, 0) - 2 * t - 3 * n, 6 * t - 3 * n, 6 * t}, {}}, true);
  scene.add("slider", {{Vec2(0, 0), 2 * t, 2 * t + n, n}, {}});
  scene.model.joints[0].damping = damping;
  scene.stage("dda", Integrator::explicit_, 0.1, {});
  return scene;
}

TEST(Warnings, sliding_with_less_damping_than_it_asks_for) {
  const double usual = JointLaw{}.damping;
  expect_one(on_slope(35, 34, 0.5 * usual), "less than sliding requires");
  expect_one(on_slope(35, 37, 0.0), "less than sliding requires");
  EXPECT_TRUE(warned(on_slope(35, 34, usual)).empty());
  EXPECT_TRUE(warned(on_slope(35, 34, 1.0)).empty());
  EXPECT_TRUE(warned(on_slope(15, 34, 0.0)).empty());  // not steep
  EXPECT_TRUE(warned(on_slope(35, 5, 0.0)).empty());   // hardly any friction
  Scene bare = on_slope(35, 34, usual);
  bare.plan.stages[0].sliding_damping = 0.0;
  expect_one(bare, "sliding_damping = 0 is less than sliding requires, 1");
  bare.plan.stages[0].sliding_damping = 1.0;
  EXPECT_TRUE(warned(bare).empty());
  bare.plan.stages[0].sliding_damping = 0.0, bare.plan.stages[0].rest = true;
  EXPECT_TRUE(warned(bare).empty());
  Scene statics = on_slope(35, 37, 0.0);
  statics.plan.stages[0].rest = true;
  EXPECT_TRUE(warned(statics).empty());
  Scene pushed = on_slope(5, 37, 0.0);  // a push on one block is no slope
  pushed.model.body_accelerations.push_back({{BlockId{1}}, {50.0, 0.0}, {}});
  EXPECT_TRUE(warned(pushed).empty());
  Scene grown = on_slope(35, 37, 0.0);  // gravity as a body acceleration counts
  grown.model.body_accelerations.push_back({{}, grown.model.gravity, {}});
  grown.model.gravity.setZero();
  expect_one(grown, "less than sliding requires");
  Scene weightless = on_slope(35, 37, 0.0);
  weightless.model.gravity.setZero();
  EXPECT_TRUE(warned(weightless).empty());
}

TEST(Warnings, an_area_or_a_region_that_holds_no_block) {
  Scene scene = box_on_base();
  coupling::Stage& stage = scene.plan.stages[0];
  stage.method = "nmm", stage.integrator = Integrator::partitioned;
  stage.partition.explicit_area = 0.5;
  expect_one(scene, "explicit_area");
  stage.partition.explicit_area = 2.0;
  EXPECT_TRUE(warned(scene).empty());
  stage.partition.explicit_area = 0.0;
  stage.partition.explicit_region = rectangle(2.5, 0, 4, 4).outer;
  expect_one(scene, "explicit_region");
  stage.partition.explicit_region = rectangle(0.5, 0.5, 3, 3).outer;
  EXPECT_TRUE(warned(scene).empty());
}

/// A semicircular arch of stones between two held abutments.
Scene arch(int stones, const std::string& method) {
  Scene scene(5e9, 0.2, 2500.0, 35.0);
  const double inner = 4.0, outer = 5.0;
  const auto at = [](double r, double angle) { return Vec2(r * std::cos(angle), r * std::sin(angle)); };
  scene.add("left", rectangle(-outer, -1, -inner, 0), true);
  scene.add("right", rectangle(inner, -1, outer, 0), true);
  for (int i = 0; i < stones; ++i) {
    const double a = std::numbers::pi * i / stones, b = std::numbers::pi * (i + 1) / stones;
    scene.add("stone-" + std::to_string(i + 1), {{at(inner, a), at(outer, a), at(outer, b), at(inner, b)}, {}});
  }
  scene.stage(method, Integrator::implicit, 0.1, 1e-3, 0.4);
  return scene;
}

TEST(Warnings, stones_of_an_arch_on_soft_joints_of_the_nmm) {
  for (const int stones : {5, 8, 15}) {
    expect_one(arch(stones, "nmm"), "as a stone of an arch");
    EXPECT_TRUE(warned(arch(stones, "dda")).empty());
    Scene stiff = arch(stones, "nmm");
    stiff.model.joints[0].normal_stiffness = 1e11;
    EXPECT_TRUE(warned(stiff).empty());
    Scene coarse = arch(stones, "nmm");
    coarse.plan.stages[0].cover_size = 3.0;  // one cover spans a joint of 1 m
    EXPECT_TRUE(warned(coarse).empty());
  }
}

/// A column on a shaken base.
Scene shaken_column(double width, const std::string& method) {
  Scene scene(5e9, 0.2, 2500.0, 35.0);
  scene.model.motions.push_back(
      {{0.0, 0.01, 0.03, 0.04}, {0.0, 1.0, -1.0, 0.0}, {1.0, 0.0}, {0.0, Between::linear, "shake", StageId{}}});
  scene.add("base", rectangle(-5, -1, 5, 0));
  scene.model.block_supports.push_back({BlockId{0}, MotionId{0}});
  scene.add("column", rectangle(0, 0, width, 2));
  scene.stage(method, Integrator::explicit_, 0.1, std::nullopt, 0.2);
  return scene;
}

TEST(Warnings, slender_blocks_that_may_rock_on_soft_joints_of_the_nmm) {
  expect_one(shaken_column(0.5, "nmm"), "rock on a joint");
  EXPECT_TRUE(warned(shaken_column(0.5, "dda")).empty());
  EXPECT_TRUE(warned(shaken_column(1.6, "nmm")).empty());  // the column slides before it rocks
  Scene stiff = shaken_column(0.5, "nmm");
  stiff.model.joints[0].normal_stiffness = 1e12;
  EXPECT_TRUE(warned(stiff).empty());
  Scene coarse = shaken_column(0.5, "nmm");
  coarse.plan.stages[0].cover_size = 0.6;
  EXPECT_TRUE(warned(coarse).empty());
  Scene between = shaken_column(0.5, "nmm");  // neighbours on either side
  between.add("left", rectangle(-2, 0, 0, 2));
  between.add("right", rectangle(0.5, 0, 2.5, 2));
  EXPECT_TRUE(warned(between).empty());
  Scene still = shaken_column(0.5, "nmm");
  still.model.block_supports[0].motion = {};
  EXPECT_TRUE(warned(still).empty());
  Scene pushed = still;
  TimeFunction pulse;
  pulse.shape = TimeFunction::Shape::half_sine, pulse.duration = 0.1;
  pushed.model.functions.push_back(pulse);
  pushed.model.body_accelerations.push_back({{}, Vec2(5.0, 0.0), FunctionId{0}});
  expect_one(pushed, "rock on a joint");
}

TEST(Warnings, blocks_that_topple_on_soft_joints_of_the_nmm) {
  // A column of 1 x 2 m topples from 26.6 degrees on, if its friction is larger. At 28 degrees it is 0.155 m away after
  // a second as a rigid block, 0.165 m by the DDA, and 0.20 m by the NMM with covers of 0.5 m.
  const auto column = [](double slope_deg, double friction_deg, const std::string& method) {
    Scene scene(1e10, 0.2, 2500.0, friction_deg);
    const double a = -slope_deg * std::numbers::pi / 180.0;
    scene.add("base", transformed(rectangle(-6, -1, 6, 0), Vec2(0, 0), rotation(a)), true);
    scene.add("column", transformed(rectangle(0, 0, 1, 2), Vec2(0, 0), rotation(a)));
    scene.stage(method, Integrator::implicit, 1.0, 1e-3, 0.5);
    return scene;
  };
  expect_one(column(28.0, 45.0, "nmm"), "rock on a joint");
  expect_one(column(26.0, 45.0, "nmm"), "rock on a joint");
  EXPECT_TRUE(warned(column(28.0, 45.0, "dda")).empty());
  EXPECT_TRUE(warned(column(20.0, 45.0, "nmm")).empty());  // it stands
  EXPECT_TRUE(warned(column(28.0, 20.0, "nmm")).empty());  // it slides
}

TEST(Warnings, affine_blocks_that_become_meshes_under_load) {
  Scene scene(1e9, 0.2, 2600.0, 30.0);
  scene.add("ground", rectangle(-1, -1, 3, 0), true);
  scene.add("block", rectangle(0, 0, 2, 1));
  scene.stage("dda", Integrator::implicit, 0.1, 1e-3).rest = true;
  scene.stage("nmm", Integrator::explicit_, 0.1, {});
  expect_one(scene, "stage 'nmm1': 'block' passes from one cover or the DDA to a mesh of the NMM under load");
  Scene rested = scene, back = scene, onefold = scene, meshed = scene;
  rested.plan.stages[1].rest = true;
  rested.plan.stages.push_back(scene.plan.stages[1]);  // the mesh has come to rest before
  std::swap(back.plan.stages[0].method, back.plan.stages[1].method);
  onefold.plan.stages[1].rules.push_back({{BlockId{1}}, "nmm", 0.0, true, false});
  meshed.plan.stages[0].method = "nmm";
  for (const Scene& fine : {rested, back, onefold, meshed}) EXPECT_TRUE(warned(fine).empty());
}

TEST(Warnings, no_arch_in_a_notch) {
  Scene notch(5e9, 0.2, 2500.0, 10.0);
  notch.add("left", {{{-2, -1}, {0, 0}, {-1, 2}, {-2, 2}}, {}}, true);
  notch.add("right", {{{0, 0}, {2, -1}, {4, 2}, {2, 1}}, {}}, true);
  notch.add("block", {{{0, 0}, {2, 1}, {1, 3}, {-1, 2}}, {}});
  notch.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.4);
  EXPECT_TRUE(warned(notch).empty());
}

TEST(Warnings, no_arch_in_a_wall_a_pile_or_a_row_that_slides) {
  Scene wall(1e9, 0.2, 2600.0, 30.0);
  wall.add("ground", rectangle(-1, -1, 9, 0), true);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const double x = 2.0 * i + (j % 2);
      wall.add("brick-" + std::to_string(4 * i + j), rectangle(x, j, x + 2, j + 1));
    }
  wall.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.3);
  EXPECT_TRUE(warned(wall).empty());
  Scene row = on_slope(35, 10, JointLaw{}.damping);
  const double a = 35 * kDegree;
  const Vec2 t(std::cos(a), std::sin(a)), n(-std::sin(a), std::cos(a));
  row.add("next", {{2 * t, 4 * t, 4 * t + n, 2 * t + n}, {}});
  row.add("last", {{4 * t, 6 * t, 6 * t + n, 4 * t + n}, {}});
  row.plan.stages[0].method = "nmm";
  row.plan.stages[0].cover_size = 0.3;
  EXPECT_TRUE(warned(row).empty());
  // The lowest block stands by its friction, and holds those above it, which slide.
  Scene held = row;
  held.model.joints.push_back(held.model.joints[0]);
  held.model.joints[1].name = "rough";
  held.model.joints[1].friction = 40.0 * kDegree;
  held.model.blocks[0].joint = JointId{1};  // between two laws, that with less friction acts
  held.model.blocks[1].edges = {{JointId{1}, {}, {}, {}}};
  EXPECT_TRUE(warned(held).empty());
}

}  // namespace
}  // namespace scree::test::plan_warnings_test
