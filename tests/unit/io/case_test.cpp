// Model and plan read from a case file: numbers, defaults, names, orientation, overrides, the resolved case.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <optional>

#include "io/case/suggest.h"
#include "io/case/unit.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_test {
namespace {

TEST(Case, good_file_gives_the_numbers_written) {
  const Case c = read("good_case.toml");
  EXPECT_EQ(c.model.title, "One block on a base");
  ASSERT_EQ(c.model.materials.size(), 1u);
  EXPECT_EQ(c.model.materials[0].name, "rock");
  EXPECT_EQ(c.model.materials[0].density, 2600.0);
  EXPECT_EQ(c.model.materials[0].young, 1e9);
  EXPECT_EQ(c.model.materials[0].poisson, 0.2);
  ASSERT_EQ(c.model.blocks.size(), 2u);
  EXPECT_EQ(c.model.blocks[1].name, "slider");
  EXPECT_EQ(c.model.blocks[1].polygon.outer[2], Vec2(2.0, 2.0));
  ASSERT_EQ(c.model.block_supports.size(), 1u);
  EXPECT_EQ(c.model.block_supports[0].block, BlockId{0});
  EXPECT_FALSE(c.model.block_supports[0].motion.valid());
  ASSERT_EQ(c.plan.stages.size(), 1u);
  EXPECT_EQ(c.plan.stages[0].method, "dda");
  EXPECT_EQ(c.plan.stages[0].integrator, coupling::Integrator::implicit);
  EXPECT_EQ(c.plan.stages[0].dt, 1e-3);
  EXPECT_EQ(c.plan.stages[0].duration, ticks(0.1));
  EXPECT_EQ(c.text, bytes_of(kFolder + "good_case.toml"));
}

TEST(Case, absent_keys_take_their_defaults) {
  const Case c = read("good_case.toml");
  EXPECT_EQ(c.model.plane, Plane::strain);
  EXPECT_EQ(c.model.gravity, Vec2(0.0, -9.81));
  EXPECT_EQ(c.plan.detection, 0.0);
  EXPECT_EQ(c.plan.stages[0].safety, 0.8);
  EXPECT_EQ(c.plan.stages[0].control.max_passes, 12);
  EXPECT_EQ(c.plan.stages[0].control.max_displacement, 0.0);
  EXPECT_EQ(c.plan.output.every, ticks(0.001));  // a hundredth of 0.1 s
  EXPECT_EQ(c.plan.output.history_every, ticks(0.001));
  EXPECT_FALSE(c.plan.live.enabled);
  EXPECT_EQ(c.plan.live.url, coupling::LivePlan{}.url);
  EXPECT_EQ(c.plan.live.rate, 30.0);
  EXPECT_EQ(c.plan.threads, 0);
}

TEST(Case, no_joint_gives_a_smooth_one) {
  const Case c = read("good_case.toml");
  ASSERT_EQ(c.model.joints.size(), 1u);
  EXPECT_EQ(c.model.joints[0].name, "smooth");
  EXPECT_EQ(c.model.joints[0].friction, 0.0);
  EXPECT_EQ(c.model.joints[0].cohesion, 0.0);
  EXPECT_FALSE(c.model.joints[0].penalty);
  EXPECT_EQ(c.model.default_joint, JointId{0});
}

TEST(Case, only_joint_is_the_default) {
  const Case c = read("good_case.toml", {"joint.plane.friction_deg=30"});
  ASSERT_EQ(c.model.joints.size(), 1u);
  EXPECT_EQ(c.model.joints[0].name, "plane");
  EXPECT_EQ(c.model.default_joint, JointId{0});
  EXPECT_NEAR(c.model.joints[0].friction, std::numbers::pi / 6.0, 1e-15);  // one rounding of pi/6
}

TEST(Case, joint_without_strength_keys_is_as_it_was) {
  const Case c = read("good_case.toml", {"joint.plane.friction_deg=30"});
  EXPECT_EQ(c.model.joints[0].tensile_strength, 0.0);
  EXPECT_EQ(c.model.joints[0].residual_cohesion, 0.0);
  EXPECT_FALSE(c.model.joints[0].residual_friction);
  EXPECT_EQ(c.model.joints[0].weakening_slip, 0.0);
}

TEST(Case, unlimited_tension_needs_no_cohesion) {
  const Case c = read("good_case.toml", {"joint.plane.friction_deg=30", "joint.plane.tensile_strength=\"unlimited\""});
  EXPECT_TRUE(std::isinf(c.model.joints[0].tensile_strength));
}

TEST(Case, several_joints_without_default_ask_for_one) {
  const CaseError e = error_of_text(bytes_of(kFolder + "good_case.toml"),
                                    {"joint.plane.friction_deg=30", "joint.rough.friction_deg=40"});
  EXPECT_EQ(e.key, "model.default_joint");
  EXPECT_EQ(e.allowed, "\"plane\", \"rough\"");
}

TEST(Case, units_are_converted) {
  const Case c = read("full_case.toml");
  EXPECT_EQ(c.model.materials[0].density, 2600.0);
  EXPECT_EQ(c.model.materials[0].young, 1e9);
  EXPECT_EQ(c.model.materials[1].young, 30e6);
  EXPECT_EQ(c.model.materials[1].density, 1900.0);  // a whole number
  EXPECT_EQ(c.model.joints[0].friction, 12.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(c.model.joints[0].cohesion, 5000.0);
  EXPECT_EQ(c.model.joints[1].tensile_strength, 2e4);
  EXPECT_EQ(c.model.joints[1].residual_cohesion, 1e3);
  EXPECT_EQ(c.model.joints[1].residual_friction, 28.0 * std::numbers::pi / 180.0);
  EXPECT_EQ(c.model.joints[1].weakening_slip, 0.02);
  EXPECT_EQ(c.model.joints[0].penalty, 1e9);
  EXPECT_EQ(c.model.joints[0].shear_penalty, 5e8);
  EXPECT_EQ(c.plan.detection, 0.02);
  EXPECT_EQ(c.plan.stages[1].dt, 1e-3);
  ASSERT_EQ(c.model.initial_velocities.size(), 1u);
  EXPECT_EQ(c.model.initial_velocities[0].velocity, Vec2(0.1, 0.0));
  EXPECT_NEAR(c.model.initial_velocities[0].spin, std::numbers::pi / 2.0, 1e-15);  // roundings of pi/180
}

TEST(Case, edge_joints_keep_their_edges_when_the_ring_is_turned) {
  // Written clockwise: left (rough), top (plane), right (block's own), bottom (plane).
  const Case c = read("full_case.toml");
  const Block& base = c.model.blocks[0];
  EXPECT_GT(signed_area(base.polygon.outer), 0.0);
  const auto law_at = [&](const Vec2& middle) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Vec2 m = 0.5 * (base.polygon.outer[i] + base.polygon.outer[(i + 1) % 4]);
      if ((m - middle).norm() < 1e-12) return base.edges[0][i].value;  // coordinates are small binary fractions
    }
    return -2;
  };
  EXPECT_EQ(law_at({0.0, 0.5}), 1);
  EXPECT_EQ(law_at({2.0, 1.0}), 0);
  EXPECT_EQ(law_at({4.0, 0.5}), -1);
  EXPECT_EQ(law_at({2.0, 0.0}), 0);
  EXPECT_EQ(base.joint, JointId{1});
}

TEST(Case, edge_joints_of_both_ways_round_are_the_same) {
  const std::string text = bytes_of(kFolder + "full_case.toml");
  const std::string other =
      replaced(replaced(text, "[[0, 0], [0, 1], [4, 1], [4, 0]]", "[[4, 0], [4, 1], [0, 1], [0, 0]]"),
               R"(["rough", "plane", "", "plane"])", R"(["", "plane", "rough", "plane"])");
  const Model a = read_text(text).model, b = read_text(other).model;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const Ring &p = a.blocks[0].polygon.outer, &q = b.blocks[0].polygon.outer;
      if (p[i] == q[j] && p[(i + 1) % 4] == q[(j + 1) % 4]) {
        EXPECT_EQ(a.blocks[0].edges[0][i], b.blocks[0].edges[0][j]) << i << ' ' << j;
      }
    }
}

TEST(Case, holes_run_clockwise_and_have_edges) {
  const Block slider = read("full_case.toml").model.blocks[1];
  ASSERT_EQ(slider.polygon.holes.size(), 1u);
  EXPECT_LT(signed_area(slider.polygon.holes[0]), 0.0);
  ASSERT_EQ(slider.edges.size(), 2u);
  EXPECT_EQ(slider.edges[1].size(), 4u);
}

TEST(Case, supports_hold_blocks_points_and_motions) {
  const Model m = read("full_case.toml").model;
  ASSERT_EQ(m.block_supports.size(), 4u);
  EXPECT_EQ(m.block_supports[0].motion, MotionId{0});
  EXPECT_EQ(m.block_supports[2].block, BlockId{3});
  EXPECT_FALSE(m.block_supports[2].motion.valid());
  EXPECT_EQ(m.blocks[m.block_supports[3].block.index()].name, "ground-1");  // the block that contains the point `at`
  ASSERT_EQ(m.point_supports.size(), 1u);
  EXPECT_TRUE(m.point_supports[0].fix_x);
  EXPECT_FALSE(m.point_supports[0].fix_y);
  EXPECT_EQ(m.point_supports[0].stiffness, 2e6);
}

TEST(Case, monitors_without_name_are_numbered_by_block) {
  const Model m = read("full_case.toml").model;
  ASSERT_EQ(m.monitors.size(), 3u);
  EXPECT_EQ(m.monitors[0].name, "slider#1");
  EXPECT_EQ(m.monitors[1].name, "ground-1#1");  // no block is named: the block that contains the point
  EXPECT_EQ(m.monitors[2].name, "corner");
}

TEST(Case, motion_is_scaled_directed_and_corrected) {
  const Model m = read("full_case.toml").model;
  ASSERT_EQ(m.motions.size(), 2u);
  EXPECT_NEAR((m.motions[0].direction() - Vec2(0.6, 0.8)).norm(), 0.0, 1e-15);  // one rounding of 3/5 and 4/5
  EXPECT_EQ(m.motions[1].direction(), Vec2(0.0, 1.0));
  // Corrected to end at rest: v_end = sum of trapezia = 0, up to roundings of 4 terms of order 1 m/s.
  EXPECT_NEAR(m.motions[0].facts().final_velocity, 0.0, 1e-14);
  // 0.2 g at 0.1 s, less the mean (0.01 g s / 0.3 s), twice; 0.2 cm/s2 unscaled in the second.
  EXPECT_NEAR(m.motions[0].accelerations()[1], 2.0 * 9.80665 * (0.2 - 0.01 / 0.3), 1e-12);
  EXPECT_NEAR(m.motions[1].accelerations()[1], 0.002, 1e-18);
}

/// Restores the environment variable for the tests that read shared records.
struct RecordsVariable {
  RecordsVariable() {
    if (const char* value = std::getenv("SCREE_RECORDS")) before = value;
  }
  RecordsVariable(const RecordsVariable&) = delete;
  RecordsVariable& operator=(const RecordsVariable&) = delete;
  ~RecordsVariable() {
    if (before) setenv("SCREE_RECORDS", before->c_str(), 1);
  }
  std::optional<std::string> before{};
};

TEST(Case, motion_file_is_found_through_the_variable) {
  const RecordsVariable kept;
  ASSERT_EQ(setenv("SCREE_RECORDS", kFolder.c_str(), 1), 0);
  const std::vector<std::string> set = {"motion.pulse.file=\"$SCREE_RECORDS/pulse.csv\""};
  EXPECT_EQ(dump(read("full_case.toml", set)), dump(read("full_case.toml")));
  ASSERT_EQ(unsetenv("SCREE_RECORDS"), 0);
  const CaseError e = error_of_file(kFolder + "full_case.toml", set);
  EXPECT_EQ(e.key, "motion.pulse.file");
  EXPECT_NE(e.problem.find("SCREE_RECORDS is not set"), std::string::npos) << e.what();
}

TEST(Case, plan_holds_rules_and_controls) {
  const coupling::Plan p = read("full_case.toml").plan;
  ASSERT_EQ(p.stages.size(), 4u);
  EXPECT_FALSE(p.stages[0].dt);
  EXPECT_EQ(p.stages[0].cover_size, 0.2);
  ASSERT_EQ(p.stages[0].rules.size(), 3u);
  EXPECT_EQ(p.stages[0].rules[0].blocks, std::vector<BlockId>{BlockId{2}});
  EXPECT_EQ(p.stages[0].rules[0].method, "dda");
  EXPECT_EQ(p.stages[1].control.max_passes, 6);
  EXPECT_EQ(p.stages[1].control.max_displacement, 1e-3);
  EXPECT_EQ(p.output.history_every, ticks(1e-3));
  EXPECT_TRUE(p.live.enabled);
  EXPECT_EQ(p.threads, 2);
}

TEST(Case, cover_size_of_the_model_serves_stages_without) {
  const std::string text = replaced(bytes_of(kFolder + "full_case.toml"), "cover_size = \"20 cm\"", "");
  EXPECT_EQ(read_text(text).plan.stages[0].cover_size, 0.5);
}

TEST(Case, resolved_case_says_the_same) {
  for (const char* name : {"good_case.toml", "full_case.toml"}) {
    const Case once = read(name, {"stage.0.duration=\"70 ms\""});
    const Case again = read_text(once.resolved);
    EXPECT_EQ(dump(again), dump(once)) << once.resolved;
    EXPECT_EQ(again.resolved, once.resolved);
  }
}

constexpr const char* kSurvey = R"(
[material.rock]
density = 2600.0
young = 1.0e9
poisson = 0.2
[material.rock.initial_stress]
xx = 0
yy = 0
gradient_yy = -2.5e4
level = 4000002.5
[[block]]
name = "base"
polygon = [[500000, 4000000], [500004, 4000000], [500004, 4000001.25], [500000, 4000001.25]]
material = "rock"
[[block]]
name = "slider"
polygon = [[500001.1, 4000001.25], [500002, 4000001.25], [500002, 4000002.5]]
material = "rock"
[[support]]
block = "base"
[[water]]
line = [[499900, 4000000.5], [500100, 4000000.75]]
[[monitor]]
point = [500002, 4000002.5]
[[stage]]
name = "only"
method = "dda"
integrator = "implicit"
dt = 1.0e-3
duration = 0.1
)";

TEST(Case, model_in_survey_coordinates_counts_from_a_point_nearby) {
  const Case c = read_text(kSurvey);
  const Model& m = c.model;
  const Vec2 origin = m.origin;
  EXPECT_LT((origin - Vec2(500002.0, 4000001.0)).norm(), 4.0);
  EXPECT_EQ(m.blocks[1].polygon.outer[0] + origin, Vec2(500001.1, 4000001.25));
  EXPECT_EQ(m.monitors[0].point + origin, Vec2(500002.0, 4000002.5));
  EXPECT_EQ(m.waters[0].line[0] + origin, Vec2(499900.0, 4000000.5));
  EXPECT_EQ(m.materials[0].initial_stress->level + origin.y(), 4000002.5);
  EXPECT_EQ(dump(read_text(c.resolved)), dump(c)) << "the resolved case is in the coordinates of the file";
  EXPECT_EQ(read("full_case.toml").model.origin, Vec2(0.0, 0.0));
}

TEST(CaseErrors, coordinates_of_a_survey_are_those_of_the_file_in_full) {
  const std::string twice = replaced(kSurvey, "[500002, 4000002.5]]", "[500002, 4000002.5], [500002, 4000002.5]]");
  EXPECT_TRUE(holds(error_of_text(twice).problem, "corner (500002, 4000002.5) is given twice"))
      << error_of_text(twice).what();
  const std::string off = replaced(kSurvey, "point = [500002, 4000002.5]", "block = \"slider\"\npoint = [2, 2.5]");
  EXPECT_TRUE(holds(error_of_text(off).hint, "[500001.1, 4000001.25] to [500002, 4000002.5]"))
      << error_of_text(off).what();
}

TEST(Case, run_longer_than_its_clock_is_refused_at_the_stage_that_exceeds_it) {
  std::string text = bytes_of(kFolder + "good_case.toml");
  for (int i = 1; i <= 8; ++i)  // with the 0.1 s of the case, the eighth stage exceeds 8e6 s
    text += fmt::format("[[stage]]\nname = \"{}\"\nmethod = \"dda\"\nintegrator = \"explicit\"\nduration = 1e6\n", i);
  const CaseError e = error_of_text(text);
  EXPECT_EQ(e.key, "stage.8.duration") << e.what();
  EXPECT_EQ(e.allowed, "at most 8e+06 s in all") << e.what();
}

TEST(Case, long_flat_list_of_decimals_is_not_deep) {
  std::string list = "0.5";
  for (int i = 0; i < 200; ++i) list += ", 0.5";
  const CaseError e = error_of_text("block = [" + list + "]\n");
  EXPECT_EQ(e.key, "block.0") << e.what();  // the error is the type, not the depth
}

TEST(Case, unit_of_the_key_may_have_a_prefix) { EXPECT_EQ(std::get<double>(in_unit("30 kPa", "MPa")), 0.03); }

TEST(Case, long_names_may_differ_by_a_third_of_their_letters) {
  EXPECT_EQ(nearest("hanging_bloc_wal", {"hanging_block_wall", "base"}), "hanging_block_wall");  // two edits
  EXPECT_EQ(nearest("wal", {"ball"}), "");  // two edits of three letters: not similar
}

TEST(CaseErrors, coordinate_out_of_place_asks_for_a_number_not_for_a_ring) {
  const std::string text = bytes_of(kFolder + "good_case.toml");
  for (const char* x : {"nan", "-inf", "2e9", "\"4\""}) {
    const CaseError e = error_of_text(replaced(text, "[[0, 0], [4, 0]", fmt::format("[[0, 0], [{}, 0]", x)));
    EXPECT_EQ(e.key, "block.0.polygon.1.0") << e.what();
    EXPECT_EQ(e.allowed, "number [m], -1e+09 <= value <= 1e+09") << e.what();
  }
}

TEST(CaseErrors, range_hint_says_which_way_and_what_the_key_holds) {
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"material.rock.density=-1", "give a larger value, or check that it is in kg/m3. density: Mass density."},
      {"material.rock.density=0", "give a larger value, or check that it is in kg/m3. density: Mass density."},
      {"material.rock.poisson=0.5", "give a smaller value. poisson: Poisson's ratio."},
      {"material.rock.poisson=-0.1", "give a larger value. poisson: Poisson's ratio."},
      {"run.threads=5000",
       "give a smaller value. threads: Threads; 0: as many as the machine has. Results do not depend on it."}};
  for (const auto& [option, hint] : wrong)
    EXPECT_EQ(error_of_file(kFolder + "good_case.toml", {option}).hint, hint) << option;
}

TEST(CaseErrors, overlap_names_each_block_once) {
  const CaseError e = error_of_file(kFaults + "overlap.toml");
  EXPECT_EQ(e.problem, "block 'slider' overlaps block 'base' by 0.5 m2");
}

TEST(CaseErrors, wrong_type_and_unknown_table_read_as_sentences) {
  const std::string file = kFolder + "good_case.toml";
  EXPECT_EQ(error_of_file(kFaults + "wrong_type.toml").hint,
            "true or false was given here. duration: Simulated time of the stage.");
  EXPECT_EQ(error_of_file(file, {"materials.rock.young=1"}).problem,
            "unknown key \"materials\" at the top of the case file");
  EXPECT_EQ(error_of_file(file, {"block=[]"}).hint,
            "add [[block]] with a polygon, or [domain] with an outline that joints cut into blocks");
}

TEST(Override, number_and_name_enter_lists) {
  EXPECT_EQ(read("full_case.toml", {"stage.1.duration=0.25"}).plan.stages[1].duration, ticks(0.25));
  EXPECT_EQ(read("full_case.toml", {"stage.runout.duration = 0.25"}).plan.stages[1].duration, ticks(0.25));
  EXPECT_EQ(read("full_case.toml", {"block.\"far wall\".material=\"soil\""}).model.blocks[3].material, MaterialId{1});
  EXPECT_EQ(read("full_case.toml", {"block.0.polygon.2=[3.5, 1]"}).model.blocks[0].polygon.outer[1], Vec2(3.5, 1.0));
}

TEST(Override, later_option_wins_and_units_hold) {
  const Case c = read("good_case.toml", {"material.rock.young=\"2 GPa\"", "material.rock.young=\"3 GPa\""});
  EXPECT_EQ(c.model.materials[0].young, 3e9);
}

TEST(Override, missing_table_is_made) { EXPECT_TRUE(read("good_case.toml", {"live.enabled=true"}).plan.live.enabled); }

}  // namespace
}  // namespace scree::io::test::case_test
