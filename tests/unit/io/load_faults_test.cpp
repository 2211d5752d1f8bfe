// Cases with wrong loads, time functions, cracks and stage options: one error each, with place, value, allowed values
// and remedy.
#include <gtest/gtest.h>

#include <filesystem>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::load_faults_test {
namespace {

/// The case is CASE.toml; the error lies in it or in the table beside it.
struct WrongLoad {
  const char *name, *kind;
  int line, column;
  const char *key, *value, *problem, *allowed, *hint;  // the key is compared whole, the others in part
};

std::ostream& operator<<(std::ostream& out, const WrongLoad& wrong) { return out << wrong.name; }
class WrongLoadFile : public testing::TestWithParam<WrongLoad> {};

TEST_P(WrongLoadFile, gives_place_value_allowed_and_hint) {
  const WrongLoad& w = GetParam();
  const CaseError e = error_of_file(kFaults + w.name + ".toml");
  EXPECT_EQ(e.file, kFaults + w.name + w.kind) << e.what();
  expect_told(e, w);
}

const WrongLoad kWrong[] = {
    {"load_ramp_without_duration", ".toml", 21, 1, "function.push.duration", "", "ramp needs a duration",
     "number [s], > 0", "add duration"},
    {"load_pulse_with_frequency", ".toml", 24, 13, "function.push.frequency", "50.0", "half_sine has no frequency",
     "\"duration\"", "remove it"},
    {"load_table_backwards", ".toml", 23, 36, "function.push.points.2", "[0.01, 0.0]", "0.01 s comes after 0.02 s",
     "> 0.02 s", "sort the points"},
    {"load_table_before_zero", ".toml", 23, 11, "function.push.points.0", "[-0.01, 0.0]", "time is negative", ">= 0 s",
     "start"},
    {"load_table_number", ".csv", 3, 7, "", "0.5O", "not a number", "time [s], value", "decimals have a point"},
    {"load_table_missing", ".toml", 23, 8, "function.push.file", "nowhere.csv", "does not exist", "two columns",
     "folder of the case"},
    {"load_table_empty", ".toml", 21, 1, "function.push.file", "", "no points", "either file or points", "points = [["},
    {"load_unknown_function", ".toml", 28, 12, "point_load.0.function", "psuh", "no function of that name", "\"push\"",
     "did you mean"},
    {"load_point_off", ".toml", 23, 9, "point_load.0.point", "[1.5, 2.1]", "not on block \"slider\"",
     "inside the block or on its outline", "[1, 1] to [2, 2]"},
    {"load_unit", ".toml", 24, 10, "point_load.0.force.0", "1 kPa", "does not fit the quantity", "[N]",
     "plain number [N]"},
    {"load_held_block", ".toml", 22, 9, "point_load.0.point", "[0.5, 0.5]", "\"base\" is held whole", "that is free",
     "the support of the block"},
    {"load_line_off", ".toml", 23, 6, "traction.0.on", "[[1.0, 2.1]", "no edge of block \"slider\"", "within 1e-06 m",
     "from (2, 2) to (1, 2); the line is up to 0.1 m away"},
    {"load_line_bent", ".toml", 23, 6, "traction.0.on", "[[1.0, 1.0]", "two ends, not 3", "[[x, y], [x, y]]",
     "one section for each"},
    {"load_edge_number", ".toml", 23, 8, "traction.0.edge", "7", "4 edges", "0 to 3", "first corner"},
    {"load_edge_of_domain", ".toml", 14, 8, "traction.0.edge", "0", "cut from the domain", "on = ", "with on"},
    {"load_twice", ".toml", 25, 12, "traction.0.pressure", "1000.0", "both given", "one of traction, pressure",
     "pushes"},
    {"load_nowhere", ".toml", 21, 1, "traction.0.on", "", "the part of the outline", "either on or edge", "on = [["},
    {"load_acceleration_held", ".toml", 23, 21, "body_acceleration.0.blocks.1", "base", "held whole", "free",
     "remove the name"},
    {"load_viscous_twice", ".toml", 27, 6, "viscous_edge.1.on", "[[2.0, 1.5]", "viscous already", "do not overlap",
     "absorbed twice"},
    {"load_crack_outside", ".toml", 23, 35, "crack.0.points.2", "[2.2, 1.9]", "leaves block \"slider\"",
     "end on its outline", "[1, 1] to [2, 2]"},
    {"load_crack_on_edge", ".toml", 23, 23, "crack.0.points.1", "[1.8, 2.0]", "along the outline", "inside the block",
     "edge_joints"},
    {"load_stress_without_level", ".toml", 8, 1, "material.rock.initial_stress.level", "", "grows with depth",
     "number [m]", "add level"},
    {"time_function_late", ".toml", 23, 9, "function.push.start", "0.1",
     "begins at 0.1 s, but the run is over at 0.1 s", "a time before 0.1 s", "start = \"only\""},
    {"time_function_over", ".toml", 23, 9, "function.push.start", "-0.2", "over at -0.1 s, before the run begins",
     "the name of a stage", "start = \"only\""},
    {"time_stage_unknown", ".toml", 23, 9, "function.push.start", "olny", "no stage of that name", "\"only\"",
     "did you mean"},
    {"time_offset_late", ".toml", 25, 9, "point_load.0.start", "only", "the load 'point_load.0' begins at 0.5 s",
     "the name of a stage", "last longer"},
    {"time_offset_alone", ".toml", 24, 10, "function.push.offset", "0.02", "start names none", "start = \"STAGE\"",
     "name the stage in start"},
    {"time_two_starts", ".toml", 30, 9, "point_load.0.start", "0.02", "\"push\" has a start too", "start of the load",
     "remove one of the two"},
    {"stage_local_implicit", ".toml", 27, 17, "stage.0.local_damping", "0.8", "explicit steps", "0 in implicit",
     "rest = true"},
    {"stage_local_whole", ".toml", 27, 17, "stage.0.local_damping", "1.0", "out of range", "0 <= value < 1", "smaller"},
    {"stage_sleep_partitioned", ".toml", 27, 9, "stage.0.sleep", "1e-06", "partitioned", "0 in partitioned",
     "integrator = \"implicit\""},
    {"stage_sleep_rest", ".toml", 27, 9, "stage.0.sleep", "1e-06", "runs to rest", "0 in stages with rest",
     "remove one of the two"},
    {"stage_sleep_trapezoidal", ".toml", 27, 9, "stage.0.sleep", "1e-06", "nothing comes to rest", "0",
     "remove the key"},
    {"stage_sleep_switch", ".toml", 27, 9, "stage.0.sleep", "1e-06", "blocks that take steps", "0", "remove sleep"},
    {"stage_consistent_explicit", ".toml", 27, 8, "stage.0.mass", "consistent", "explicit steps do not solve",
     "\"lumped\"", "leave mass out"},
    {"stage_affine_implicit", ".toml", 27, 8, "stage.0.mass", "affine-exact", "sparse", "\"consistent\"",
     "leave mass out"},
    {"stage_newmark_explicit", ".toml", 27, 11, "stage.0.newmark", "trapezoidal", "implicit steps", "implicit stages",
     "integrator = \"implicit\""},
    {"stage_transfer_first", ".toml", 27, 12, "stage.0.transfer", "rotational", "no block changes method",
     "later stages", "remove it"},
    {"stage_transfer_cap_alone", ".toml", 34, 16, "stage.1.transfer_cap", "1.2", "no strain rates are raised",
     "strain-rate", "remove transfer_cap"},
    {"stage_dynamics_with_rest", ".toml", 28, 12, "stage.0.dynamics", "0.5", "sets all velocities to zero",
     "0, or no dynamics", "remove one"},
    {"stage_rest_force_alone", ".toml", 27, 14, "stage.0.rest_force", "0.0001", "not brought to rest", "rest = true",
     "remove rest_force"},
    {"stage_rest_steps_alone", ".toml", 28, 14, "stage.0.rest_steps", "100", "when the model is at rest",
     "beside rest_force", "add rest_force"},
    {"stage_damps_nothing", ".toml", 27, 21, "stage.0.damp_rigid_motion", "true", "no damping", "beside damping",
     "give damping"},
    {"stage_linear_dda", ".toml", 27, 14, "stage.0.kinematics", "linear", "no block uses the NMM", "\"corotational\"",
     "method = \"nmm\""},
    {"stage_onefold_dda", ".toml", 31, 11, "stage.0.method_of.0.onefold", "true", "\"dda\" has no covers", "\"nmm\"",
     "method = \"nmm\""},
    {"stage_onefold_sized", ".toml", 32, 14, "stage.0.method_of.0.cover_size", "0.25", "no size to choose",
     "onefold = true or cover_size", "remove one"},
    {"stage_partition_elsewhere", ".toml", 27, 18, "stage.0.explicit_speed", "0.5", "steps of one kind",
     "in partitioned stages", "integrator = \"partitioned\""},
    {"stage_partition_no_dt", ".toml", 21, 1, "stage.0.dt", "", "a partitioned stage needs a time step",
     "number [s], > 0", "write dt = 1e-3"},
    {"stage_partition_no_rule", ".toml", 21, 1, "stage.0.explicit_blocks", "", "no key selects the blocks",
     "explicit_strain_rate", "add explicit_blocks"},
    {"stage_partition_both_lists", ".toml", 28, 20, "stage.0.implicit_blocks.0", "sli*", "\"slider\" is among explicit",
     "one of the two lists", "remove it"},
    {"stage_partition_held", ".toml", 27, 30, "stage.0.explicit_blocks.1", "base", "\"base\" is held whole", "free",
     "remove the name"},
    {"stage_region_crossed", ".toml", 27, 19, "stage.0.explicit_region", "", "not a polygon", "not cross itself",
     "in their order"},
    {"stage_region_empty", ".toml", 27, 19, "stage.0.explicit_region", "", "no free block lies in the region",
     "a region with blocks", "same coordinates"},
    {"stage_region_no_mesh", ".toml", 27, 19, "stage.0.explicit_region", "", "\"slider\" lies across its border",
     "the NMM with a mesh", "explicit_blocks or implicit_blocks"},
    {"stage_slow_blocks_divided", ".toml", 29, 19, "stage.0.explicit_region", "", "\"slider\" lies across its border",
     "a border between blocks", "explicit_blocks or implicit_blocks"},
    {"stage_slow_blocks_shared", ".toml", 29, 19, "stage.0.shared_contacts", "true", "all contacts are explicit",
     "false", "remove the key"},
    {"stage_slow_blocks_local", ".toml", 29, 17, "stage.0.local_damping", "0.1", "unbalanced force", "0",
     "use damping"},
    {"stage_partition_rest", ".toml", 28, 8, "stage.0.rest", "true", "in different ways", "false", "in a stage before"},
    {"stage_partition_trapezoidal", ".toml", 28, 11, "stage.0.newmark", "trapezoidal", "has no contacts", "\"damped\"",
     "remove the key"},
    {"stage_partition_dynamics", ".toml", 28, 12, "stage.0.dynamics", "0.5", "keep all of their velocity",
     "1, or no dynamics", "remove the key"},
    {"stage_partition_consistent", ".toml", 29, 8, "stage.0.mass", "consistent", "implicit steps only", "\"lumped\"",
     "leave mass out"},
    {"stage_partition_forced", ".toml", 28, 12, "stage.0.force_dt", "true", "nothing to force", "beside substeps",
     "give substeps"},
    {"stage_partition_speeds", ".toml", 28, 18, "stage.0.implicit_speed", "0.6", "would change back",
     "below explicit_speed = 0.5", "leave the key out"},
    {"stage_partition_speed_alone", ".toml", 28, 18, "stage.0.implicit_speed", "0.25", "above which",
     "beside explicit_speed", "add explicit_speed"},
    {"stage_end_of_rest", ".toml", 28, 25, "stage.0.end.kinetic_below", "0.001", "removes the motion",
     "slip or displacement", "give rest_force"},
    {"stage_switch_crack", ".toml", 36, 18, "stage.0.switch.blocks.1", "slider", "has a crack", "free blocks",
     "remove the name"},
    {"stage_triangle_of_mesh", ".toml", 31, 12, "stage.0.method_of.0.triangle", "model", "many triangles",
     "onefold = true", "add onefold"}};

INSTANTIATE_TEST_SUITE_P(Files, WrongLoadFile, testing::ValuesIn(kWrong),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(WrongLoads, folder_holds_no_case_without_a_test) {
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kFaults)) {
    const std::string name = entry.path().filename().string();
    count += entry.path().extension() == ".toml" &&
             (name.starts_with("load_") || name.starts_with("stage_") || name.starts_with("time_"));
  }
  EXPECT_EQ(count, std::size(kWrong));
}

/// Changes of a key of the full case, and the error expected for each.
struct WrongSet {
  std::vector<std::string> set;
  const char *key, *problem;  // the key is compared whole, the problem in part
};
std::ostream& operator<<(std::ostream& out, const WrongSet& wrong) { return out << wrong.set.front(); }
class WrongLoadSet : public testing::TestWithParam<WrongSet> {};

TEST_P(WrongLoadSet, is_refused_at_the_key) {
  const CaseError e = error_of_file(kFolder + "full_case.toml", GetParam().set);
  EXPECT_EQ(e.key, GetParam().key) << e.what();
  EXPECT_TRUE(holds(e.problem, GetParam().problem)) << e.what();
  EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
}

INSTANTIATE_TEST_SUITE_P(
    Case, WrongLoadSet,
    testing::Values(
        WrongSet{{"function.rise={shape=\"sine\"}"}, "function.rise.frequency", "needs a frequency"},
        WrongSet{{"function.rise={shape=\"sine_squared\"}"}, "function.rise.duration", "needs a duration"},
        WrongSet{{"function.rise={shape=\"half_sine\"}"}, "function.rise.duration", "needs a duration"},
        WrongSet{{"function.steady.duration=1"}, "function.steady.duration", "constant has no duration"},
        WrongSet{{"function.listed.duration=1"}, "function.listed.duration", "table has no duration"},
        WrongSet{{"function.hit.points=[[0, 0], [1, 1]]"}, "function.hit.points", "sine_squared has no points"},
        WrongSet{{"function.hit.file=\"pulse.csv\""}, "function.hit.file", "sine_squared has no file"},
        WrongSet{{"function.listed.file=\"pulse.csv\""}, "function.listed.points", "both given"},
        WrongSet{{"function.listed.points=[[0, 0]]"}, "function.listed.points", "1 points has no length"},
        WrongSet{{"function.filed.file=\"pulse.AT2\""}, "function.filed.file", "ground motion is no table"},
        WrongSet{{"function.filed.file=\"$HOME/pulse.csv\""}, "function.filed.file", "only the variable"},
        WrongSet{{"function.filed.file=\"\""}, "function.filed.file", "empty"},
        WrongSet{{"function.hit.duration=0"}, "function.hit.duration", "out of range"},
        WrongSet{{"function.hit.shape=\"sinus\""}, "function.hit.shape", "not one of the choices"},
        WrongSet{{"traction.0.on=[[1, 1], [1, 1.0000001]]"}, "traction.0.on", "no length"},
        WrongSet{{"traction.1.on=[[1, 1], [2, 1]]"}, "traction.1.edge", "both given"},
        WrongSet{{"traction.1.edge=-1"}, "traction.1.edge", "out of range"},
        WrongSet{{"traction.0.block=\"base\""}, "traction.0.block", "held whole"},
        WrongSet{{"traction.0={block=\"slider\", edge=0}"}, "traction.0.traction", "no size"},
        WrongSet{{"viscous_edge.0.block=\"wall\""}, "viscous_edge.0.block", "held whole"},
        WrongSet{{"body_acceleration.0.blocks=[]"}, "body_acceleration.0.blocks", "empty"},
        WrongSet{{"body_acceleration.0.blocks=[\"*wall\"]"}, "body_acceleration.0.blocks", "all of these blocks"},
        WrongSet{{"body_acceleration.0.blocks=[\"nobody*\"]"}, "body_acceleration.0.blocks.0", "fits the pattern"},
        WrongSet{{"point_load.1.point=[5.5, 0.5]"}, "point_load.1.point", "held whole"},
        WrongSet{{"point_load.1.point=[50, 50]"}, "point_load.1.point", "in no block"},
        WrongSet{{"crack.0.points=[[1.1, 1.1], [1.1, 1.1]]"}, "crack.0.points.1", "no length"},
        WrongSet{{"crack.0.points=[[1.1, 1.5], [1.9, 1.5]]"}, "crack.0.points.1", "leaves block"},  // crosses the hole
        WrongSet{{"crack.0.joint=\"plain\""}, "crack.0.joint", "no joint of that name"},
        WrongSet{{"material.soil.initial_stress={xx=0, yy=0, level=1}"},
                 "material.soil.initial_stress.level",
                 "is constant"},
        WrongSet{{"material.soil.initial_stress={xx=0}"}, "material.soil.initial_stress.yy", "missing"},
        WrongSet{{"block.1.cover_size=0"}, "block.1.cover_size", "out of range"},
        WrongSet{{"stage.1.dynamics=1.5"}, "stage.1.dynamics", "out of range"},
        WrongSet{{"stage.0.dynamics=0"}, "stage.0.dynamics", "implicit steps"},
        WrongSet{{"stage.1.cracks=true"}, "stage.1.cracks", "no block uses the NMM"},
        WrongSet{{"stage.1.mass=\"lumped\""}, "stage.1.mass", "no block uses the NMM"},
        WrongSet{{"stage.0.rotation=\"affine\""}, "stage.0.rotation", "explicit steps"},
        WrongSet{{"stage.0.rotation=\"first-order\""}, "stage.0.rotation", "explicit steps"},
        WrongSet{{"stage.3.rotation=\"first-order\""}, "stage.3.rotation", "no first-order rotation"},
        WrongSet{{"stage.1.method=\"nmm\"", "stage.1.cover_size=0.5"}, "stage.1.rotation", "no block uses the DDA"},
        WrongSet{{"stage.2.rest_steps=0"}, "stage.2.rest_steps", "out of range"},
        WrongSet{{"stage.2.rest_force=0"}, "stage.2.rest_force", "out of range"},
        WrongSet{{"stage.3.mass=\"affine-exact\"", "stage.3.method=\"nmm\""}, "stage.3.mass", "explicit steps only"},
        WrongSet{{"stage.3.explicit_blocks=[]"}, "stage.3.explicit_blocks", "empty"},
        WrongSet{{"stage.3.implicit_blocks=[\"*wall\"]"}, "stage.3.implicit_blocks", "all of these blocks"},
        WrongSet{{"stage.3.implicit_blocks=[\"base\"]"}, "stage.3.implicit_blocks.0", "takes no steps"},
        WrongSet{{"stage.3.explicit_blocks=[\"ledgy\"]"}, "stage.3.explicit_blocks.0", "no block of that name"},
        WrongSet{{"stage.3.explicit_area=0"}, "stage.3.explicit_area", "out of range"},
        WrongSet{{"stage.3.implicit_speed=0.5"}, "stage.3.implicit_speed", "would change back"},
        WrongSet{{"stage.3.explicit_strain_rate=0.25"}, "stage.3.implicit_strain_rate", "would change back"},
        WrongSet{{"stage.3.substeps=0"}, "stage.3.substeps", "out of range"},
        WrongSet{{"stage.1.substeps=2"}, "stage.1.substeps", "steps of one kind"},
        WrongSet{{"stage.3.end={}"}, "stage.3.end.slip", "no rule to end the stage"},
        WrongSet{{"stage.0.end={hold=1}"}, "stage.0.end.slip", "no rule to end the stage"},
        WrongSet{{"stage.0.end={hold=1, slip=1}"}, "stage.0.end.hold", "as they are reached"},
        WrongSet{{"stage.2.end={kinetic_below=0.1}"}, "stage.2.end.kinetic_below", "removes the motion"},
        WrongSet{{"stage.2.end={force_below=0.1}"}, "stage.2.end.force_below", "removes the motion"},
        WrongSet{{"stage.1.dynamics=0", "stage.1.newmark=\"damped\"", "stage.1.end={kinetic_below=0.1}"},
                 "stage.1.end.kinetic_below",
                 "leaves no kinetic energy"},
        WrongSet{{"stage.3.end.kinetic_below=1"}, "stage.3.end.kinetic_below", "out of range"},
        WrongSet{{"stage.3.end.slip=0"}, "stage.3.end.slip", "out of range"},
        WrongSet{{"stage.3.end.strain=0"}, "stage.3.end.strain", "unknown key"},
        WrongSet{{"stage.2.strength.factor=0"}, "stage.2.strength.factor", "out of range"},
        WrongSet{{"stage.2.strength.joints=[\"clay\"]"}, "stage.2.strength.joints.0", "no joint of that name"},
        WrongSet{{"stage.2.strength={from=1}"}, "stage.2.strength.factor", "missing"},
        WrongSet{{"stage.3.strength={factor=2}"}, "stage.3.strength", "partitioned stages"},
        WrongSet{{"reduction.factor=-1"}, "reduction.factor", "out of range"},
        WrongSet{{"reduction={factor=2, joints=[\"clay\"]}"}, "reduction.joints.0", "no joint of that name"},
        WrongSet{{"reduction={factor=2, method=\"fem\"}"}, "reduction.method", "no method of that name"},
        WrongSet{{"reduction={factor=2, joints=[]}"}, "reduction.joints", "empty"},
        WrongSet{{"stage.0.switch={kinetic=1e-3, elastic=1e-3, hold=0.01}"}, "stage.0.switch", "linear kinematics"},
        WrongSet{{"stage.1.switch={kinetic=1e-3, elastic=1e-3, hold=0.01}"}, "stage.1.switch", "trapezoidal"},
        WrongSet{{"stage.2.switch={kinetic=1e-3, elastic=1e-3, hold=0.01}"}, "stage.2.switch", "removes the motion"},
        WrongSet{{"stage.3.switch={elastic=1e-3, hold=0.01}"}, "stage.3.switch.kinetic", "missing"},
        WrongSet{{"stage.3.switch.blocks=[\"base\"]"}, "stage.3.switch.blocks.0", "held whole"},
        WrongSet{{"stage.3.switch.blocks=[\"*wall\"]"}, "stage.3.switch.blocks", "no block can change"},
        WrongSet{{"stage.3.switch.blocks=[]"}, "stage.3.switch.blocks", "no block can change"},
        WrongSet{{"stage.3.switch.back={}"}, "stage.3.switch.back.strain_rate", "no rule for a block"},
        WrongSet{{"stage.3.switch.elastic=0"}, "stage.3.switch.elastic", "out of range"},
        WrongSet{{"stage.0.method_of.0.cover_size=0.5"}, "stage.0.method_of.0.cover_size", "has no covers"}));

}  // namespace
}  // namespace scree::io::test::load_faults_test
