// Loads, time functions, cracks, in-situ stress and stage options read from a case.
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_loads_test {
namespace {

const Model& full_model() {
  static const Case kCase = read("full_case.toml");
  return kCase.model;
}

TEST(Functions, have_their_shape_and_numbers) {
  const std::vector<TimeFunction>& f = full_model().functions;
  ASSERT_EQ(f.size(), 6u);
  EXPECT_EQ(f[0].name, "steady");
  EXPECT_EQ(f[0].value(7.0), 0.5);
  EXPECT_EQ(f[1].shape, TimeFunction::Shape::ramp);
  EXPECT_EQ(f[1].duration, 0.01);
  EXPECT_EQ(f[1].start, 0.05);
  EXPECT_EQ(f[2].frequency, 20.0);
  EXPECT_EQ(f[2].duration, 0.5);
  EXPECT_EQ(f[3].shape, TimeFunction::Shape::sine_squared);
  EXPECT_EQ(f[4].value(0.1), 1.0);
  EXPECT_EQ(f[4].value(1e3), 0.5);
  EXPECT_EQ(f[5].time.size(), f[5].table.size());
}

TEST(Functions, file_gives_what_a_motion_of_the_same_file_gives) {
  const Model& m = full_model();
  const Case raw = read("full_case.toml", {"motion.pulse={file=\"pulse.csv\", unit=\"m/s2\"}"});
  ASSERT_EQ(m.functions[5].time.size(), raw.model.motions[0].times().size());
  for (std::size_t i = 0; i < m.functions[5].time.size(); ++i) {
    EXPECT_EQ(m.functions[5].time[i], raw.model.motions[0].times()[i]);
    EXPECT_EQ(m.functions[5].table[i], raw.model.motions[0].accelerations()[i]);
  }
}

TEST(Loads, point_load_names_its_block_or_finds_it) {
  const Model& m = full_model();
  ASSERT_EQ(m.point_loads.size(), 2u);
  EXPECT_EQ(m.point_loads[0].block, BlockId{1});
  EXPECT_EQ(m.point_loads[0].force, Vec2(1000.0, -500.0));
  EXPECT_EQ(m.point_loads[0].function, FunctionId{3});
  EXPECT_TRUE(m.blocks[m.point_loads[1].block.index()].name.starts_with("cut-"));
  EXPECT_FALSE(m.point_loads[1].function.valid());
  EXPECT_EQ(m.factor(m.point_loads[1].function, 3.0), 1.0);
}

TEST(Loads, load_with_a_start_has_a_function_of_its_own) {
  const Model m = read_case(kFaults + "time_offset_late.toml", {"point_load.0.offset=0.05"}, kMethods).model;
  ASSERT_EQ(m.functions.size(), 1u);
  EXPECT_TRUE(m.functions[0].of_load);
  EXPECT_EQ(m.functions[0].stage, StageId{0});
  EXPECT_EQ(m.functions[0].start, 0.05);
  EXPECT_EQ(m.functions[0].shape, TimeFunction::Shape::constant);
  EXPECT_EQ(m.point_loads[0].function, FunctionId{0});
}

TEST(Motions, begin_with_the_first_stage_after_the_leading_rest) {
  const std::string file = std::string(SCREE_SOURCE_DIR) + "/tests/e2e/looks/shaken.toml";
  const Case c = read_case(file, {}, kMethods);
  EXPECT_EQ(c.model.motions[0].setting().stage, StageId{1});
  EXPECT_EQ(c.model.motions[0].setting().start, 0.0);
  EXPECT_NE(c.resolved.find("start = \"shaking\""), std::string::npos) << c.resolved;
  const Case later = read_case(file, {"motion.quake.start=\"after\"", "motion.quake.offset=\"20 ms\""}, kMethods);
  EXPECT_EQ(later.model.motions[0].setting().stage, StageId{2});
  EXPECT_EQ(later.model.motions[0].setting().start, 0.02);
  const Case by_clock = read_case(file, {"motion.quake.start=\"2.01 s\""}, kMethods);
  EXPECT_FALSE(by_clock.model.motions[0].setting().stage.valid());
  EXPECT_EQ(by_clock.model.motions[0].setting().start, 2.01);
}

TEST(Loads, pressure_pushes_into_the_block_and_traction_is_as_given) {
  const Model& m = full_model();
  ASSERT_GE(m.tractions.size(), 2u);
  EXPECT_EQ(m.tractions[0].span.edge, (OutlineEdge{0, 2}));  // the top of the slider, from (2, 2) to (1, 2)
  EXPECT_NEAR(m.tractions[0].span.s0, 0.25, 1e-15);
  EXPECT_NEAR(m.tractions[0].span.s1, 0.75, 1e-15);
  EXPECT_EQ(m.tractions[0].traction, Vec2(0.0, -1000.0));
  EXPECT_EQ(m.tractions[0].function, FunctionId{1});
  EXPECT_EQ(m.tractions[1].span.edge, (OutlineEdge{0, 1}));
  EXPECT_EQ(m.tractions[1].traction, Vec2(-10.0, 2.0));
}

TEST(Loads, pressure_in_a_hole_pushes_outwards_from_it) {
  const Case c = read("full_case.toml", {"traction.0={block=\"slider\", on=[[1.25, 1.75], [1.75, 1.75]], pressure=2}"});
  EXPECT_EQ(c.model.tractions[0].span.edge.ring, 1);
  EXPECT_EQ(c.model.tractions[0].traction, Vec2(0.0, 2.0));  // into the rock above the hole
}

TEST(Loads, edge_counts_as_the_polygon_was_written) {
  // The polygon is written clockwise: left, top, right, bottom.
  const std::string text = replaced(bytes_of(kFolder + "full_case.toml"), "[[2, 2], [3, 2], [3, 3], [2, 3]]",
                                    "[[2, 2], [2, 3], [3, 3], [3, 2]]");
  const Vec2 middles[] = {{2.0, 2.5}, {2.5, 3.0}, {3.0, 2.5}, {2.5, 2.0}};
  for (int edge = 0; edge < 4; ++edge) {
    const Case c = read_text(text, {fmt::format("traction.1={{block=\"ledge\", edge={}, pressure=1}}", edge)});
    const EdgeSpan span = c.model.tractions[1].span;
    const Ring& ring = c.model.blocks[4].polygon.outer;
    const auto i = static_cast<std::size_t>(span.edge.edge);
    EXPECT_GT(signed_area(ring), 0.0);
    EXPECT_EQ(Vec2(0.5 * (ring[i] + ring[(i + 1) % 4])), middles[edge]) << edge;
    EXPECT_EQ(c.model.tractions[1].traction, Vec2(Vec2(2.5, 2.5) - middles[edge]) * 2.0) << edge;
  }
}

TEST(Loads, acceleration_takes_patterns_without_those_held) {
  const Model& m = full_model();
  ASSERT_EQ(m.body_accelerations.size(), 1u);
  EXPECT_EQ(m.body_accelerations[0].blocks, (std::vector<BlockId>{BlockId{1}, BlockId{4}}));
  EXPECT_EQ(m.body_accelerations[0].acceleration, Vec2(0.5, 0.25));
  const Case some = read("full_case.toml", {"body_acceleration.0.blocks=[\"*wall\", \"led*\", \"ledge\"]"});
  EXPECT_EQ(some.model.body_accelerations[0].blocks, std::vector<BlockId>{BlockId{4}});  // held walls are left out
  const Case all = read("full_case.toml", {"body_acceleration.0={acceleration=[1, 0]}"});
  EXPECT_TRUE(all.model.body_accelerations[0].blocks.empty());
}

TEST(Loads, viscous_edges_lie_on_outline_and_hole) {
  const Model& m = full_model();
  ASSERT_EQ(m.viscous_edges.size(), 2u);
  EXPECT_EQ(m.viscous_edges[0].span.edge, (OutlineEdge{0, 3}));
  EXPECT_EQ(m.viscous_edges[1].span.edge.ring, 1);
  EXPECT_EQ(m.viscous_edges[1].span.s1 - m.viscous_edges[1].span.s0, 1.0);
}

TEST(Loads, viscous_stretches_that_touch_are_not_an_overlap) {
  EXPECT_NO_THROW((void)read("full_case.toml", {"viscous_edge.0={block=\"ledge\", on=[[2, 3], [2.3, 3]]}",
                                                "viscous_edge.1={block=\"ledge\", on=[[2.3, 3], [3, 3]]}"}));
}

TEST(Cracks, straight_pieces_follow_those_of_the_domain) {
  const Model& m = full_model();
  ASSERT_GE(m.cracks.size(), 2u);
  const Crack &a = m.cracks[m.cracks.size() - 2], &b = m.cracks.back();
  EXPECT_EQ(a.from, Vec2(1.0, 1.1));
  EXPECT_EQ(a.to, b.from);
  EXPECT_EQ(b.to, Vec2(1.2, 1.9));
  EXPECT_EQ(b.block, BlockId{1});
  EXPECT_EQ(b.joint, JointId{1});
  const std::size_t of_domain = read("full_case.toml", {"crack=[]"}).model.cracks.size();
  EXPECT_EQ(m.cracks.size(), of_domain + 2);
}

TEST(Cracks, one_may_run_through_its_block_and_takes_its_joint) {
  const Case c = read("full_case.toml", {"crack.0={block=\"ledge\", points=[[2, 2], [3, 3]]}"});
  EXPECT_EQ(c.model.cracks.back().to, Vec2(3.0, 3.0));
  EXPECT_EQ(c.model.cracks.back().joint, c.model.default_joint);
}

TEST(InitialStress, grows_with_depth_below_its_level) {
  const Model& m = full_model();
  EXPECT_FALSE(m.materials[0].initial_stress);
  ASSERT_TRUE(m.materials[1].initial_stress);
  const Mat2 s = m.materials[1].initial_stress->at({3.0, -1.0});  // 2 m below the level
  EXPECT_EQ(s(0, 0), -20e3 - 2.0 * 10e3);
  EXPECT_EQ(s(1, 1), -10e3 - 2.0 * 18639.0);
  EXPECT_EQ(s(0, 1), 520.0);
  EXPECT_EQ(s(1, 0), 520.0);
}

TEST(InitialStress, held_blocks_may_begin_with_any_method) {
  EXPECT_NO_THROW((void)read("full_case.toml", {"stage.0.method_of.2={blocks=[\"base\"], method=\"dda\"}"}));
}

TEST(CoverSizes, come_from_block_region_rule_and_stage) {
  const Case c = read("full_case.toml");
  EXPECT_EQ(c.model.blocks[0].cover_size, 0.0);
  EXPECT_EQ(c.model.blocks[1].cover_size, 0.25);
  for (std::size_t b = 5; b < c.model.blocks.size(); ++b)
    EXPECT_EQ(c.model.blocks[b].cover_size, c.model.blocks[b].name.starts_with("ground-") ? 0.5 : 0.0);
  ASSERT_EQ(c.plan.stages[0].rules.size(), 3u);
  EXPECT_EQ(c.plan.stages[0].rules[1].cover_size, 0.75);
  EXPECT_FALSE(c.plan.stages[0].rules[1].onefold);
  EXPECT_TRUE(c.plan.stages[0].rules[2].onefold);
  EXPECT_FALSE(c.plan.stages[0].rules[1].model_triangle);
  EXPECT_TRUE(c.plan.stages[0].rules[2].model_triangle);
}

TEST(StageOptions, are_read) {
  const std::vector<coupling::Stage> s = read("full_case.toml").plan.stages;
  EXPECT_EQ(s[0].kinematics, Kinematics::linear);
  EXPECT_EQ(s[0].mass, MassKind::lumped);
  EXPECT_TRUE(s[0].cracks);
  EXPECT_TRUE(s[0].damp_rigid_motion);
  EXPECT_EQ(s[0].stiffness_damping, 1e-6);
  EXPECT_EQ(s[0].local_damping, 0.1);
  EXPECT_EQ(s[1].newmark, coupling::NewmarkScheme::trapezoidal);
  EXPECT_EQ(s[1].dynamics, 0.9);
  EXPECT_EQ(s[1].rotation, BlockRotation::affine);
  EXPECT_EQ(s[2].rotation, BlockRotation::exact);
  EXPECT_EQ(read("full_case.toml", {"stage.1.rotation=\"first-order\""}).plan.stages[1].rotation,
            BlockRotation::first_order);
  EXPECT_EQ(s[0].transfer, coupling::TransferMode::reservoir);
  EXPECT_EQ(s[1].transfer, coupling::TransferMode::strain_rate);
  EXPECT_EQ(s[1].transfer_cap, 1.5);
  EXPECT_EQ(s[2].transfer, coupling::TransferMode::rotational);
  EXPECT_EQ(s[2].newmark, coupling::NewmarkScheme::damped);
  EXPECT_EQ(s[2].rest_force, 1e-4);
  EXPECT_EQ(s[2].rest_steps, 50);
  EXPECT_TRUE(s[2].rest);
}

TEST(StageOptions, absent_ones_take_the_defaults_of_a_stage) {
  const coupling::Stage s = read("good_case.toml").plan.stages[0], fresh;
  EXPECT_EQ(s.kinematics, fresh.kinematics);
  EXPECT_EQ(s.mass, fresh.mass);
  EXPECT_EQ(s.cracks, fresh.cracks);
  EXPECT_EQ(s.damp_rigid_motion, fresh.damp_rigid_motion);
  EXPECT_EQ(s.stiffness_damping, fresh.stiffness_damping);
  EXPECT_EQ(s.local_damping, fresh.local_damping);
  EXPECT_EQ(s.newmark, fresh.newmark);
  EXPECT_EQ(s.rotation, fresh.rotation);
  EXPECT_EQ(s.transfer, fresh.transfer);
  EXPECT_EQ(s.transfer_cap, fresh.transfer_cap);
  EXPECT_EQ(s.dynamics, fresh.dynamics);
  EXPECT_EQ(s.rest_force, fresh.rest_force);
  EXPECT_EQ(s.rest_steps, fresh.rest_steps);
}

TEST(StageOptions, mass_is_that_of_the_choice) {
  const auto mass = [](const char* name) {
    return read("full_case.toml", {fmt::format("stage.0.mass=\"{}\"", name)}).plan.stages[0].mass;
  };
  EXPECT_EQ(mass("auto"), std::nullopt);
  EXPECT_EQ(mass("affine-exact"), MassKind::affine_exact);
  EXPECT_EQ(mass("lumped"), MassKind::lumped);
}

TEST(StageOptions, of_implicit_steps_are_settled_in_the_resolved_case) {
  const Case c = read("good_case.toml");
  EXPECT_TRUE(holds(c.resolved, "newmark = \"damped\"")) << c.resolved;
  EXPECT_TRUE(holds(c.resolved, "dynamics = 1.0")) << c.resolved;
  EXPECT_FALSE(holds(c.resolved, "function"));
  const Case again = read_text(c.resolved);
  EXPECT_EQ(dump(again), dump(c));
}

TEST(Partitions, are_read) {
  const Case c = read("full_case.toml");
  const coupling::Stage& s = c.plan.stages[3];
  const coupling::Partition& p = s.partition;
  EXPECT_EQ(s.integrator, coupling::Integrator::partitioned);
  EXPECT_EQ(p.explicit_blocks, (std::vector<BlockId>{BlockId{4}}));
  EXPECT_EQ(p.implicit_blocks, (std::vector<BlockId>{BlockId{1}}));
  EXPECT_EQ(p.explicit_region, (Ring{{2.0, 1.9}, {3.1, 1.9}, {3.1, 3.1}, {2.0, 3.1}}));
  EXPECT_TRUE(p.shared_contacts);
  EXPECT_FALSE(p.slow_explicit);
  EXPECT_TRUE(read("full_case.toml", {"stage.3.shared_contacts=false", "stage.3.slow_blocks=\"explicit\""})
                  .plan.stages[3]
                  .subcycled());
  EXPECT_DOUBLE_EQ(p.explicit_area, 0.2);
  EXPECT_EQ(p.speed.up, 0.5);
  EXPECT_EQ(p.speed.down, 0.1);
  EXPECT_EQ(p.strain_rate.up, 0.5);
  EXPECT_EQ(p.strain_rate.down, 0.25);
  EXPECT_EQ(p.substeps, 20);
}

TEST(StageRules, are_read) {
  const Case c = read("full_case.toml");
  const coupling::EndRules& end = c.plan.stages[3].end;
  EXPECT_EQ(end.kinetic_below, 1e-3);
  EXPECT_EQ(end.force_below, 1e-2);
  EXPECT_EQ(end.hold, ticks(0.02));
  EXPECT_DOUBLE_EQ(end.slip, 0.05);
  EXPECT_EQ(end.displacement, 0.5);
  EXPECT_FALSE(c.plan.stages[0].end.used());
  const coupling::SwitchRules& change = c.plan.stages[3].change;
  EXPECT_TRUE(change.used);
  EXPECT_TRUE(std::binary_search(change.blocks.begin(), change.blocks.end(), BlockId{4}));
  for (const BlockId b : change.blocks) {
    EXPECT_EQ(c.model.support_of(b), nullptr);
    EXPECT_NE(c.model.blocks[b.index()].name, "slider");
  }
  EXPECT_EQ(change.kinetic, 1e-4);
  EXPECT_EQ(change.elastic, 1e-3);
  EXPECT_EQ(change.inhomogeneity, 0.25);
  EXPECT_EQ(change.hold, ticks(0.05));
  EXPECT_EQ(change.back.strain_rate, 0.5);
  EXPECT_EQ(change.back.stress, 1e6);
  EXPECT_EQ(change.back.acceleration, 50.0);
  EXPECT_FALSE(c.plan.stages[0].change.used);
  EXPECT_EQ(dump(read_text(c.resolved)), dump(c));
}

TEST(StageRules, without_names_all_blocks_that_can_may_change) {
  const Case c = read("good_case.toml", {"stage.0.switch={kinetic=1e-3, elastic=1e-3, hold=0.01}",
                                         "stage.0.method=\"nmm\"", "stage.0.cover_size=0.5"});
  const coupling::SwitchRules& change = c.plan.stages[0].change;
  EXPECT_FALSE(change.back.used());
  ASSERT_FALSE(change.blocks.empty());
  for (const BlockId b : change.blocks) EXPECT_EQ(c.model.support_of(b), nullptr);
}

TEST(Partitions, lower_limits_are_half_of_the_upper_ones_unless_given) {
  const Case c = read("good_case.toml", {"stage.0.integrator=\"partitioned\"", "stage.0.explicit_speed=0.5",
                                         "stage.0.explicit_strain_rate=3"});
  const coupling::Partition& p = c.plan.stages[0].partition;
  EXPECT_EQ(p.speed.down, 0.25);
  EXPECT_EQ(p.strain_rate.down, 1.5);
  EXPECT_EQ(p.explicit_area, 0.0);
  EXPECT_EQ(p.substeps, 0);
  EXPECT_TRUE(p.explicit_blocks.empty());
  EXPECT_TRUE(holds(c.resolved, "implicit_speed = 0.25")) << c.resolved;
  EXPECT_EQ(dump(read_text(c.resolved)), dump(c));
}

TEST(Partitions, patterns_pass_over_held_blocks) {
  const Case c = read("full_case.toml", {"stage.3.implicit_blocks=[\"*wall\", \"slid*\", \"cut-*\", \"*1\"]"});
  const std::vector<BlockId>& blocks = c.plan.stages[3].partition.implicit_blocks;
  EXPECT_TRUE(std::is_sorted(blocks.begin(), blocks.end()));
  EXPECT_EQ(std::adjacent_find(blocks.begin(), blocks.end()), blocks.end()) << "a block that two patterns mean";
  ASSERT_GE(blocks.size(), 2U);
  EXPECT_EQ(blocks[0], BlockId{1});
  for (const BlockId b : blocks) EXPECT_FALSE(c.model.support_of(b)) << c.model.blocks[b.index()].name;
}

TEST(StageOptions, dynamics_of_zero_goes_with_rest) {
  const Case c = read("full_case.toml", {"stage.2.dynamics=0"});
  EXPECT_EQ(c.plan.stages[2].dynamics, 0.0);
}

}  // namespace
}  // namespace scree::io::test::case_loads_test
