// The table of keys: it is complete and documented, and every key has an effect.
#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>

#include "io/case/document.h"
#include "io/case/schema.h"
#include "io/case/suggest.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_schema_test {
namespace {

bool is_section(const Key& key) {
  return key.type == Type::table || key.type == Type::named_tables || key.type == Type::table_list;
}

TEST(Schema, every_key_is_declared_once_with_a_meaning_and_a_parent) {
  std::set<std::string_view> seen;
  for (const Key& key : schema()) {
    EXPECT_TRUE(seen.insert(key.path).second) << key.path;
    EXPECT_TRUE(key.meaning.ends_with('.')) << key.path;
    EXPECT_FALSE(key.required && !key.fallback.empty()) << key.path;
    EXPECT_EQ(key.type == Type::choice, !key.choices.empty()) << key.path;
    std::string_view parent = parent_of(key.path);
    if (parent.empty()) continue;
    if (parent.ends_with(".NAME")) parent.remove_suffix(5);
    if (parent.ends_with("[]")) parent.remove_suffix(2);
    const Key* above = find_key(parent);
    ASSERT_NE(above, nullptr) << key.path;
    EXPECT_TRUE(is_section(*above)) << key.path;
  }
}

// Another value for every key, with the other settings that the value requires.
const std::map<std::string, std::string> kChange = {
    {"title", "title=\"another\""},
    {"model.plane", "model.plane=\"strain\""},
    {"model.gravity", "model.gravity=[0, 0]"},
    {"model.detection", "model.detection=0.1"},
    {"model.default_joint", "model.default_joint=\"rough\""},
    {"model.cover_size", "model.cover_size=0.75"},
    {"material.NAME.density", "material.rock.density=1"},
    {"material.NAME.young", "material.rock.young=1"},
    {"material.NAME.poisson", "material.rock.poisson=0.1"},
    {"material.NAME.initial_stress.xx", "material.soil.initial_stress.xx=-1"},
    {"material.NAME.initial_stress.yy", "material.soil.initial_stress.yy=-1"},
    {"material.NAME.initial_stress.xy", "material.soil.initial_stress.xy=-1"},
    {"material.NAME.initial_stress.gradient_xx", "material.soil.initial_stress.gradient_xx=-1"},
    {"material.NAME.initial_stress.gradient_yy", "material.soil.initial_stress.gradient_yy=-1"},
    {"material.NAME.initial_stress.gradient_xy", "material.soil.initial_stress.gradient_xy=-1"},
    {"material.NAME.initial_stress.level", "material.soil.initial_stress.level=2"},
    {"function.NAME.shape", "function.hit.shape=\"half_sine\""},
    {"function.NAME.amplitude", "function.hit.amplitude=3"},
    {"function.NAME.start", "function.rise.start=0.06"},
    {"function.NAME.duration", "function.hum.duration=0.25"},
    {"function.NAME.frequency", "function.hum.frequency=30"},
    {"function.NAME.file", "function.filed.file=\"other_pulse.csv\""},
    {"function.NAME.points", "function.listed.points=[[0, 0], [1, 1]]"},
    {"joint.NAME.friction_deg", "joint.plane.friction_deg=1"},
    {"joint.NAME.cohesion", "joint.plane.cohesion=1"},
    {"joint.NAME.residual_friction_deg", "joint.rough.residual_friction_deg=25"},
    {"joint.NAME.weakening_slip", "joint.rough.weakening_slip=0"},
    {"joint.NAME.residual_cohesion", "joint.rough.residual_cohesion=0"},
    {"joint.NAME.tensile_strength", "joint.rough.tensile_strength=\"unlimited\""},
    {"joint.NAME.contact_length", "joint.plane.contact_length=1"},
    {"joint.NAME.normal_stiffness", "joint.rough.normal_stiffness=1e9"},
    {"joint.NAME.shear_stiffness", "joint.rough.shear_stiffness=1e9"},
    {"joint.NAME.penalty", "joint.plane.penalty=2e9"},
    {"joint.NAME.shear_penalty", "joint.plane.shear_penalty=3e8"},
    {"joint.NAME.dilation_deg", "joint.rough.dilation_deg=4"},
    {"joint.NAME.dilation_slip", "joint.rough.dilation_slip=0.5"},
    {"joint.NAME.damping", "joint.plane.damping=0.4"},
    {"joint.NAME.velocity_weakening.fast_friction_deg", "joint.plane.velocity_weakening.fast_friction_deg=0.1"},
    {"joint.NAME.velocity_weakening.velocity", "joint.plane.velocity_weakening.velocity=2"},
    {"joint.NAME.velocity_weakening.slip", "joint.plane.velocity_weakening.slip=3"},
    {"motion.NAME.file", "motion.pulse.file=\"./other_pulse.csv\""},
    {"motion.NAME.unit", "motion.pulse.unit=\"m/s2\""},
    {"motion.NAME.start", "motion.pulse.start=2.1"},
    {"motion.NAME.from", "motion.upward.from=0.05"},
    {"motion.NAME.until", "motion.upward.until=0.25"},
    {"motion.NAME.resample", "motion.pulse.resample=0.05"},
    {"motion.NAME.taper", "motion.pulse.taper=0.15"},
    {"motion.NAME.pga", "motion.upward.pga=3"},
    {"motion.NAME.integration", "motion.pulse.integration=\"constant\""},
    {"motion.NAME.scale", "motion.pulse.scale=-1"},
    {"motion.NAME.direction", "motion.pulse.direction=[0, 1]"},
    {"motion.NAME.direction_deg", "motion.upward.direction_deg=45"},
    {"motion.NAME.baseline", "motion.pulse.baseline=\"none\""},
    {"block[].name", "block.3.name=\"ground\""},
    {"block[].polygon", "block.0.polygon=[[0, 0], [4, 0], [4, 1], [0.5, 1]]"},
    {"block[].holes", "block.1.holes=[]"},
    {"block[].material", "block.1.material=\"soil\""},
    {"block[].joint", "block.0.joint=\"plane\""},
    {"block[].edge_joints", "block.0.edge_joints=[]"},
    {"block[].cover_size", "block.1.cover_size=0.125"},
    {"block[].velocity", "block.1.velocity=[0, 0]"},
    {"block[].spin", "block.1.spin=0"},
    {"drawing.file", "drawing.file=\"other_drawn.dxf\""},
    {"drawing.unit", "drawing.unit=\"ft\""},
    {"drawing.tolerance", "drawing.tolerance=0.2"},
    {"drawing.offset", "drawing.offset=[0, 0.25]"},
    {"drawing.join", "drawing.join=0.01"},
    {"domain.outline", "domain.outline=[[20, 0], [30, 0], [30, 7], [20, 6]]"},
    {"domain.outline_file", "domain={outline_file = \"outline.csv\", material = \"rock\"}"},
    {"domain.outline_layer", "domain={outline_layer = \"edge\", material = \"rock\"}"},
    {"domain.holes_layer", "domain.holes_layer=\"pit\""},
    {"domain.dead_ends", "domain.dead_ends=\"drop\""},
    {"domain.holes", "domain.holes=[]"},
    {"domain.material", "domain.material=\"soil\""},
    {"domain.joint", "domain.joint=\"rough\""},
    {"domain.prefix", "domain.prefix=\"piece\""},
    {"domain.snap", "domain.snap=\"auto\""},
    {"domain.least_width", "domain.least_width=\"auto\""},
    {"domain.least_area", "domain.least_area=0.5"},
    {"domain.region[].name", "domain.region.0.name=\"soil\""},
    {"domain.region[].polygon", "domain.region.0.polygon=[[19, -1], [27, -1], [27, 1.5], [19, 2]]"},
    {"domain.region[].layer", "domain.region.0={name = \"ground\", layer = \"SOIL\"}"},
    {"domain.region[].material", "domain.region.0.material=\"rock\""},
    {"domain.region[].joint", "domain.region.0.joint=\"plane\""},
    {"domain.region[].cut", "domain.region.0.cut=true"},
    {"domain.region[].cover_size", "domain.region.0.cover_size=0.25"},
    {"domain.joint_set[].joint", "domain.joint_set.0.joint=\"rough\""},
    {"domain.joint_set[].dip_deg", "domain.joint_set.0.dip_deg=25"},
    {"domain.joint_set[].dip_deviation_deg", "domain.joint_set.0.dip_deviation_deg=2"},
    {"domain.joint_set[].dip_distribution", "domain.joint_set.0.dip_distribution=\"uniform\""},
    {"domain.joint_set[].dip_fisher_k", "domain.joint_set.1.dip_fisher_k=50"},
    {"domain.joint_set[].persistence",
     "domain.joint_set.1={joint = \"rough\", dip_deg = 90, spacing = 2, length = 3, persistence = 0.6}"},
    {"domain.joint_set[].spacing", "domain.joint_set.0.spacing=1.6"},
    {"domain.joint_set[].spacing_deviation", "domain.joint_set.0.spacing_deviation=0.1"},
    {"domain.joint_set[].spacing_distribution", "domain.joint_set.0.spacing_distribution=\"lognormal\""},
    {"domain.joint_set[].length", "domain.joint_set.0.length=4"},
    {"domain.joint_set[].length_deviation", "domain.joint_set.0.length_deviation=0.1"},
    {"domain.joint_set[].length_distribution", "domain.joint_set.0.length_distribution=\"uniform\""},
    {"domain.joint_set[].gap", "domain.joint_set.0.gap=0.75"},
    {"domain.joint_set[].gap_deviation", "domain.joint_set.0.gap_deviation=0.2"},
    {"domain.joint_set[].gap_distribution", "domain.joint_set.0.gap_distribution=\"lognormal\""},
    {"domain.joint_set[].stagger", "domain.joint_set.1.stagger=0.25"},
    {"domain.joint_set[].origin", "domain.joint_set.0.origin=[21, 3.5]"},
    {"domain.joint_set[].region", "domain.joint_set.0.region=[[20, 3], [30, 3], [30, 6], [20, 6]]"},
    {"domain.joint_set[].seed", "domain.joint_set.0.seed=8"},
    {"domain.trace[].points", "domain.trace.0.points=[[20, 5], [24, 4.5], [30, 5.5]]"},
    {"domain.trace[].file", "domain.trace.1.file=\"other_traces.csv\""},
    {"domain.trace[].layer", "domain.trace.2.layer=\"table\""},
    {"domain.trace[].joint", "domain.trace.0.joint=\"plane\""},
    {"domain.arc[].centre", "domain.arc.0.centre=[25.5, 8]"},
    {"domain.arc[].radius", "domain.arc.0.radius=3.5"},
    {"domain.arc[].from_deg", "domain.arc.0.from_deg=200"},
    {"domain.arc[].to_deg", "domain.arc.0.to_deg=300"},
    {"domain.arc[].chords", "domain.arc.0.chords=9"},
    {"domain.arc[].joint", "domain.arc.0.joint=\"plane\""},
    {"support[].at", "support.3.at=[29.5, 0.5]"},
    {"support[].block", "support.2.block=\"base\""},
    {"support[].blocks", "support.1.blocks=[\"wall\"]"},
    {"support[].fix", "support.2.fix=\"y\""},
    {"support[].point", "support.2.point=[2, 1]"},
    {"support[].stiffness", "support.2.stiffness=\"auto\""},
    {"support[].on", "support.4.on=[[2, 3], [2.5, 3]]"},
    {"support[].box", "support.5.box=[[2.9, 1.9], [3.1, 2.5]]"},
    {"support[].bedding", "support.5.bedding=2e9"},
    {"support[].motion", "support.0.motion=\"upward\""},
    {"crack[].block", "crack.0={block=\"ledge\", points=[[2.1, 2.1], [2.9, 2.9]]}"},
    {"crack[].points", "crack.0.points=[[1.0, 1.1], [1.2, 1.9]]"},
    {"crack[].joint", "crack.0.joint=\"plane\""},
    {"point_load[].block", "point_load.0.block=\"ledge\""},
    {"point_load[].point", "point_load.0.point=[1, 1]"},
    {"point_load[].force", "point_load.0.force=[1, 0]"},
    {"point_load[].function", "point_load.0.function=\"hum\""},
    {"traction[].block", "traction.1.block=\"ledge\""},
    {"traction[].on", "traction.0.on=[[1.25, 2.0], [1.5, 2.0]]"},
    {"traction[].edge", "traction.1.edge=0"},
    {"traction[].traction", "traction.1.traction=[-10, 3]"},
    {"traction[].pressure", "traction.0.pressure=2"},
    {"traction[].surcharge", "traction.2.surcharge=4e3"},
    {"traction[].function", "traction.0.function=\"hum\""},
    {"body_acceleration[].acceleration", "body_acceleration.0.acceleration=[1, 1]"},
    {"body_acceleration[].function", "body_acceleration.0.function=\"hit\""},
    {"body_acceleration[].blocks", "body_acceleration.0.blocks=[\"slider\"]"},
    {"viscous_edge[].block", "viscous_edge.0.block=\"ledge\""},
    {"viscous_edge[].on", "viscous_edge.1.on=[[1.25, 1.25], [1.25, 1.75]]"},
    {"bolt[].name", "bolt.0.name=\"other\""},
    {"bolt[].head", "bolt.0.head=[1.15, 1.9]"},
    {"bolt[].toe", "bolt.0.toe=[1.12, 0.4]"},
    {"bolt[].stage", "bolt.0.stage=\"settling\""},
    {"bolt[].spacing", "bolt.0.spacing=2"},
    {"bolt[].axial_stiffness", "bolt.0.axial_stiffness=2e7"},
    {"bolt[].yield", "bolt.0.yield=2e5"},
    {"bolt[].rupture_strain", "bolt.0.rupture_strain=0.2"},
    {"bolt[].pretension", "bolt.0.pretension=\"10 kN\""},
    {"bolt[].plate", "bolt.0.plate=false"},
    {"bolt[].bond_length", "bolt.0.bond_length=1.2"},
    {"bolt[].bond_stiffness", "bolt.0.bond_stiffness=2e8"},
    {"bolt[].bond_strength", "bolt.0.bond_strength=2e5"},
    {"bolt[].segment", "bolt.0.segment=0.05"},
    {"bolt[].shear_stiffness", "bolt.0.shear_stiffness=2e7"},
    {"bolt[].shear_strength", "bolt.0.shear_strength=2e5"},
    {"bolt[].rupture_shear", "bolt.0.rupture_shear=0.2"},
    {"viscous_edge[].motion", "viscous_edge.0.motion=\"pulse\""},
    {"viscous_edge[].motion_is", "viscous_edge.0.motion_is=\"upgoing\""},
    {"viscous_edge[].edge", "viscous_edge.0.edge=2"},
    {"free_field[].on", "free_field.0.on=[[2, 1], [2, 2.5]]"},
    {"free_field[].block", "free_field.0.block=\"ledge\""},
    {"free_field[].blocks", "free_field.0.blocks=[\"slider\"]"},
    {"free_field[].edge", "free_field.0.edge=3"},
    {"free_field[].motion", "free_field.0.motion=\"upward\""},
    {"free_field[].bottom", "free_field.0.bottom=-2"},
    {"free_field[].top", "free_field.0.top=5"},
    {"monitor[].block", "monitor.0.block=\"base\""},
    {"monitor[].point", "monitor.0.point=[1.1, 1.1]"},
    {"monitor[].layer", "monitor.1={layer = \"spots\"}"},
    {"monitor[].name", "monitor.1.name=\"top\""},
    {"stage[].name", "stage.0.name=\"a\""},
    {"stage[].method", "stage.0.method=\"dda\""},
    {"stage[].method_of[].blocks", "stage.0.method_of.0.blocks=[\"slider\"]"},
    {"stage[].method_of[].cover_size", "stage.0.method_of.1.cover_size=0.5"},
    {"stage[].method_of[].onefold", "stage.0.method_of.2={blocks=[\"base\"], method=\"nmm\"}"},
    {"stage[].method_of[].triangle", "stage.0.method_of.2.triangle=\"own\""},
    {"stage[].method_of[].method", "stage.0.method_of.0.method=\"nmm\""},
    {"stage[].integrator", "stage.2.integrator=\"explicit\""},
    {"stage[].dt", "stage.1.dt=0.002"},
    {"stage[].duration", "stage.0.duration=1"},
    {"stage[].safety", "stage.0.safety=1"},
    {"stage[].force_dt", "stage.0.force_dt=true"},
    {"stage[].rest", "stage.1.rest=true"},
    {"stage[].damping", "stage.0.damping=3"},
    {"stage[].cover_size", "stage.0.cover_size=1"},
    {"stage[].kinematics", "stage.0.kinematics=\"corotational\""},
    {"stage[].mass", "stage.0.mass=\"auto\""},
    {"stage[].rotation", "stage.1.rotation=\"exact\""},
    {"stage[].cracks", "stage.0.cracks=false"},
    {"stage[].damp_rigid_motion", "stage.0.damp_rigid_motion=false"},
    {"stage[].stiffness_damping", "stage.0.stiffness_damping=1e-5"},
    {"stage[].local_damping", "stage.0.local_damping=0.8"},
    {"stage[].sleep", "stage.0.sleep=1e-5"},
    {"stage[].newmark", "stage.1.newmark=\"damped\""},
    {"stage[].dynamics", "stage.1.dynamics=0.5"},
    {"stage[].transfer", "stage.2.transfer=\"reservoir\""},
    {"stage[].transfer_cap", "stage.1.transfer_cap=2"},
    {"stage[].rest_force", "stage.2.rest_force=1e-3"},
    {"stage[].rest_steps", "stage.2.rest_steps=60"},
    {"stage[].max_passes", "stage.1.max_passes=7"},
    {"stage[].max_displacement", "stage.1.max_displacement=\"auto\""},
    {"stage[].explicit_blocks", "stage.3.explicit_blocks=[\"cut-*\"]"},
    {"stage[].implicit_blocks", "stage.3.implicit_blocks=[\"cut-*\"]"},
    {"stage[].explicit_region", "stage.3.explicit_region.1=[4, 1.9]"},
    {"stage[].shared_contacts", "stage.3.shared_contacts=false"},
    {"stage[].explicit_area", "stage.3.explicit_area=3"},
    {"stage[].explicit_speed", "stage.3.explicit_speed=0.75"},
    {"stage[].implicit_speed", "stage.3.implicit_speed=0.2"},
    {"stage[].explicit_strain_rate", "stage.3.explicit_strain_rate=0.75"},
    {"stage[].implicit_strain_rate", "stage.3.implicit_strain_rate=0.125"},
    {"stage[].substeps", "stage.3.substeps=21"},
    {"stage[].slow_blocks", "stage.3.slow_blocks=\"explicit\""},
    {"stage[].end.kinetic_below", "stage.3.end.kinetic_below=2e-3"},
    {"stage[].end.force_below", "stage.3.end.force_below=2e-3"},
    {"stage[].end.hold", "stage.3.end.hold=0.01"},
    {"stage[].end.slip", "stage.3.end.slip=0.06"},
    {"stage[].end.displacement", "stage.3.end.displacement=0.25"},
    {"stage[].switch.blocks", "stage.3.switch.blocks=[\"ledge\"]"},
    {"stage[].switch.kinetic", "stage.3.switch.kinetic=2e-4"},
    {"stage[].switch.elastic", "stage.3.switch.elastic=2e-4"},
    {"stage[].switch.inhomogeneity", "stage.3.switch.inhomogeneity=0.125"},
    {"stage[].switch.hold", "stage.3.switch.hold=0.01"},
    {"stage[].switch.back.strain_rate", "stage.3.switch.back.strain_rate=0.25"},
    {"stage[].switch.back.stress", "stage.3.switch.back.stress=2e6"},
    {"stage[].switch.back.acceleration", "stage.3.switch.back.acceleration=40"},
    {"stage[].strength.factor", "stage.2.strength.factor=2"},
    {"stage[].strength.from", "stage.2.strength.from=1.0"},
    {"stage[].strength.joints", "stage.2.strength.joints=[\"rough\"]"},
    {"reduction.factor", "reduction.factor=1.3"},
    {"reduction.start", "reduction.start=0.5"},
    {"reduction.joints", "reduction.joints=[\"rough\"]"},
    {"reduction.what", "reduction.what=\"cohesion\""},
    {"reduction.strength", "reduction.strength=\"as-is\""},
    {"reduction.method", "reduction.method=\"dda\""},
    {"reduction.integrator", "reduction.integrator=\"implicit\""},
    {"reduction.rest_integrator", "reduction.rest_integrator=\"explicit\""},
    {"reduction.dt", "reduction.dt=0.5"},
    {"reduction.hold", "reduction.hold=1.0"},
    {"reduction.limit", "reduction.limit=0.25"},
    {"reduction.rest_force", "reduction.rest_force=1e-3"},
    {"reduction.k_h", "reduction.k_h=0.25"},
    {"liner[].name", "liner.0.name=\"other\""},
    {"liner[].along", "liner.0.along=[[1.2, 2], [1.8, 2]]"},
    {"liner[].spacing", "liner.0.spacing=0.1"},
    {"liner[].tolerance", "liner.0.tolerance=0.02"},
    {"liner[].stage", "liner.0.stage=\"settling\""},
    {"liner[].thickness", "liner.0.thickness=0.2"},
    {"liner[].young", "liner.0.young=2e10"},
    {"liner[].poisson", "liner.0.poisson=0.3"},
    {"liner[].tensile_strength", "liner.0.tensile_strength=2e6"},
    {"liner[].compressive_strength", "liner.0.compressive_strength=2e7"},
    {"liner[].rupture_strain", "liner.0.rupture_strain=0.02"},
    {"bolt[].layer", "bolt=[{layer=\"BAR\", axial_stiffness=1e7}]"},
    {"material.NAME.rock_strength.cohesion", "material.rock.rock_strength.cohesion=2e6"},
    {"material.NAME.rock_strength.friction_deg", "material.rock.rock_strength.friction_deg=20"},
    {"material.NAME.rock_strength.tension", "material.rock.rock_strength.tension=1e5"},
    {"material.NAME.rock_strength.ucs", "material.rock.rock_strength.ucs=5e7"},
    {"material.NAME.rock_strength.gsi", "material.rock.rock_strength.gsi=50"},
    {"material.NAME.rock_strength.mi", "material.rock.rock_strength.mi=12"},
    {"material.NAME.rock_strength.d", "material.rock.rock_strength.d=0.5"},
    {"water[].line", "water.0.line.1=[9, 0.25]"},
    {"water[].layer", "water.0={layer = \"table\", joints = [\"rou*\"]}"},
    {"water[].reservoir", "water.0.reservoir=true"},
    {"water[].level[].stage", "water.0.level.0.stage=\"settling\""},
    {"water[].level[].line", "water.0.level.0.line.1=[9, 0.1]"},
    {"water[].unit_weight", "water.0.unit_weight=\"10 kN/m3\""},
    {"water[].joints", "water.0.joints=[\"plane\"]"},
    {"output.contacts", "output.contacts=true"},
    {"output.checkpoint_every", "output.checkpoint_every=6.0"},
    {"output.checkpoint_steps", "output.checkpoint_steps=101"},
    {"output.every", "output.every=0.5"},
    {"output.history_every", "output.history_every=0.5"},
    {"live.enabled", "live.enabled=false"},
    {"live.url", "live.url=\"file:///tmp/log\""},
    {"live.rate", "live.rate=1"},
    {"live.field", "live.field=\"s1\""},
    {"run.threads", "run.threads=1"},
    {"run.max_closure", "run.max_closure=1e-5"},
    {"run.max_passed_closure", "run.max_passed_closure=1e-5"},
    {"run.max_gain", "run.max_gain=0.5"},
    {"run.max_slowdown", "run.max_slowdown=5"},
    {"function.NAME.offset", "function.rise.offset=0.01"},
    {"motion.NAME.offset", "motion.pulse.offset=0.01"},
    {"point_load[].start", "point_load.1.start=\"runout\""},
    {"point_load[].offset", "point_load.1.offset=0.01"},
    {"traction[].start", "traction.1.start=\"runout\""},
    {"traction[].offset", "traction.1.offset=0.01"},
    {"body_acceleration[].start", "body_acceleration.0.start=\"runout\""},
    {"body_acceleration[].offset", "body_acceleration.0.offset=0.01"},
    {"stage[].excavate", "stage.2.excavate=[\"far wall\"]"},
    {"stage[].excavate_in", "stage.2.excavate_in=[[21, 1], [30, 1], [30, 6], [21, 6]]"},
    {"stage[].fill", "stage.2.fill=[\"wall\"]"},
    {"stage[].fill_in", "stage.2.fill_in=[[21, 1], [30, 1], [30, 6], [21, 6]]"},
    {"stage[].release", "stage.2.release=0.5"},
    {"stage[].release_time", "stage.2.release_time=0.5"},
    {"stage[].sliding_damping", "stage.0.sliding_damping=0.5"}};
// Settings that some changes require.
const char* const kWeakening = "joint.plane.velocity_weakening={fast_friction_deg=0, velocity=1, slip=0.1}";
const char* const kBolt =
    "bolt=[{name=\"bar\", head=[1.1, 1.9], toe=[1.1, 0.4], axial_stiffness=1e7, yield=1e5, rupture_strain=0.1, "
    "bond_length=1.5, bond_stiffness=1e8, bond_strength=1e5, shear_stiffness=1e7, shear_strength=1e5, "
    "rupture_shear=0.1}]";
const char* const kLiner =
    "liner=[{name=\"skin\", along=[[1.1, 2], [1.9, 2]], spacing=0.25, thickness=0.1, young=3e10, "
    "tensile_strength=1e6, compressive_strength=1e7, rupture_strain=0.01}]";
const char* const kMohr = "material.rock.rock_strength={cohesion=1e6, friction_deg=30}";
const char* const kHoek = "material.rock.rock_strength={ucs=6e7, gsi=45, mi=10}";
// Two bases, a shaken block and a compliant one; meshes in both stages during which the motions act.
const char *const kBases = "viscous_edge=[{block=\"ledge\", edge=2, motion=\"upward\"}]",
                  *const kMeshes = "stage.1.method_of=[{blocks=[\"slider\", \"ledge\"], method=\"nmm\"}]",
                  *const kSide = "free_field=[{block=\"slider\", edge=1, motion=\"pulse\", bottom=-1, top=4}]",
                  *const kSides =
                      "free_field=[{blocks=[\"slider\", \"ledge\"], on=[[2, 1], [2, 3]], motion=\"pulse\"}]";
const char* const kReduction = "reduction={factor=1.1}";
const std::string kOnLedge =
    "traction.2={block=\"ledge\", edge=1, surcharge=1}";  // independent of the position of the domain
const std::map<std::string, std::vector<std::string>> kBeside = {
    {"joint.NAME.velocity_weakening.fast_friction_deg", {kWeakening}},
    {"joint.NAME.velocity_weakening.velocity", {kWeakening}},
    {"joint.NAME.velocity_weakening.slip", {kWeakening}},
    {"block[].name", {"support.1.blocks=[\"wall\"]"}},
    {"bolt[].name", {kBolt}},
    {"material.NAME.rock_strength.cohesion", {kMohr}},
    {"material.NAME.rock_strength.friction_deg", {kMohr}},
    {"material.NAME.rock_strength.tension", {kMohr}},
    {"material.NAME.rock_strength.ucs", {kHoek}},
    {"material.NAME.rock_strength.gsi", {kHoek}},
    {"material.NAME.rock_strength.mi", {kHoek}},
    {"material.NAME.rock_strength.d", {kHoek}},
    {"bolt[].head", {kBolt}},
    {"bolt[].toe", {kBolt}},
    {"bolt[].stage", {kBolt}},
    {"bolt[].spacing", {kBolt}},
    {"bolt[].axial_stiffness", {kBolt}},
    {"bolt[].yield", {kBolt}},
    {"bolt[].rupture_strain", {kBolt}},
    {"bolt[].pretension", {kBolt}},
    {"bolt[].plate", {kBolt}},
    {"bolt[].bond_length", {kBolt}},
    {"bolt[].bond_stiffness", {kBolt}},
    {"bolt[].bond_strength", {kBolt}},
    {"bolt[].segment", {kBolt}},
    {"bolt[].shear_stiffness", {kBolt}},
    {"bolt[].shear_strength", {kBolt}},
    {"bolt[].rupture_shear", {kBolt}},
    {"liner[].name", {kLiner}},
    {"liner[].along", {kLiner}},
    {"liner[].spacing", {kLiner}},
    {"liner[].tolerance", {kLiner}},
    {"liner[].stage", {kLiner}},
    {"liner[].thickness", {kLiner}},
    {"liner[].young", {kLiner}},
    {"liner[].poisson", {kLiner, "model.plane=\"strain\""}},
    {"liner[].tensile_strength", {kLiner}},
    {"liner[].compressive_strength", {kLiner}},
    {"liner[].rupture_strain", {kLiner}},
    {"viscous_edge[].motion_is", {"viscous_edge.0.motion=\"pulse\""}},
    {"free_field[].on", {kBases, kMeshes, kSides}},
    {"free_field[].block", {kBases, kMeshes, kSide}},
    {"free_field[].blocks", {kBases, kMeshes, kSides}},
    {"free_field[].edge", {kBases, kMeshes, kSide}},
    {"free_field[].motion", {kBases, kMeshes, kSide}},
    {"free_field[].bottom", {kBases, kMeshes, kSide}},
    {"free_field[].top", {kBases, kMeshes, kSide}},
    {"block[].holes", {"viscous_edge.1={block=\"slider\", edge=0}"}},
    {"domain.outline_file", {"point_load.1={block=\"ledge\", point=[3, 3], force=[0, -1]}", kOnLedge}},
    {"domain.outline_layer", {"point_load.1={block=\"ledge\", point=[3, 3], force=[0, -1]}", kOnLedge}},
    {"domain.outline", {kOnLedge}},
    {"domain.holes_layer", {"domain.holes=[]"}},
    {"monitor[].block", {"monitor.0.point=[1.5, 1]"}},
    {"reduction.factor", {kReduction}},
    {"reduction.start", {kReduction}},
    {"reduction.joints", {kReduction}},
    {"reduction.what", {kReduction}},
    {"reduction.strength", {kReduction}},
    {"reduction.method", {kReduction}},
    {"reduction.integrator", {kReduction}},
    {"reduction.dt", {kReduction, "reduction.integrator=\"implicit\""}},
    {"reduction.hold", {kReduction}},
    {"reduction.limit", {kReduction}},
    {"reduction.rest_force", {kReduction}},
    {"reduction.k_h", {kReduction}},
    {"stage[].fill", {"stage.1.newmark=\"damped\""}},
    {"stage[].fill_in", {"stage.1.newmark=\"damped\""}},
    {"stage[].release", {"stage.2.excavate=[\"far wall\"]"}},
    {"stage[].release_time", {"stage.2.excavate=[\"far wall\"]"}},
    {"stage[].force_dt", {"stage.0.dt=1e-6"}},
    {"function.NAME.offset", {"function.rise.start=\"runout\""}},
    {"motion.NAME.offset", {"motion.pulse.start=\"runout\""}},
    {"point_load[].offset", {"point_load.1.start=\"runout\""}},
    {"traction[].offset", {"traction.1.start=\"runout\""}},
    {"body_acceleration[].offset", {"body_acceleration.0.start=\"runout\""}},
    {"stage[].slow_blocks", {"stage.3.shared_contacts=false"}},
    {"stage[].rest", {"motion.pulse.start=2.1", "stage.1.dynamics=0"}}};

// The model or the plan must change: a key that is read and then ignored fails the test.
TEST(Schema, every_key_changes_the_case) {
  std::size_t keys = 0;
  for (const Key& key : schema()) {
    if (is_section(key)) continue;
    ++keys;
    const auto found = kChange.find(std::string(key.path));
    ASSERT_NE(found, kChange.end()) << "give another value for " << key.path;
    std::vector<std::string> set;
    if (const auto more = kBeside.find(found->first); more != kBeside.end()) set = more->second;
    const std::string before = dump(read("full_case.toml", set));
    set.push_back(found->second);
    EXPECT_NE(dump(read("full_case.toml", set)), before) << key.path;
  }
  EXPECT_EQ(keys, kChange.size());
}

TEST(Schema, every_default_reads_back) {
  for (const Key& key : schema()) {
    if (key.fallback.empty() || key.fallback.starts_with('(')) continue;
    EXPECT_NO_THROW((void)parse_document(fmt::format("x = {}", key.fallback), "")) << key.path;
  }
}

TEST(Schema, both_texts_name_every_key) {
  const std::string text = schema_text(), markdown = schema_markdown();
  for (const Key& key : schema()) {
    EXPECT_NE(text.find(key.meaning), std::string::npos) << key.path;
    EXPECT_NE(markdown.find(is_section(key) ? fmt::format("`{}`", header_text(key))
                                            : fmt::format("| `{}` |", last_part(key.path))),
              std::string::npos)
        << key.path;
  }
}

TEST(Schema, documentation_holds_the_table) {
  const std::string path = SCREE_SOURCE_DIR "/docs/case-file.md";
  const std::string begin = "<!-- keys: written by the test Schema.documentation_holds_the_table -->\n",
                    end = "\n<!-- end of keys -->";
  const std::string text = bytes_of(path);
  const std::size_t from = text.find(begin), to = text.find(end);
  ASSERT_NE(from, std::string::npos);
  ASSERT_NE(to, std::string::npos);
  const std::string now = text.substr(0, from + begin.size()) + schema_markdown() + text.substr(to);
  if (std::getenv("SCREE_WRITE_DOCS")) std::ofstream(path, std::ios::binary) << now;
  EXPECT_TRUE(text == now) << "run this test with SCREE_WRITE_DOCS=1 to write the table into docs/case-file.md";
}

TEST(Suggest, nearest_name_is_found_or_none) {
  EXPECT_EQ(nearest("densty", {"density", "young"}), "density");
  EXPECT_EQ(nearest("Young", {"density", "young"}), "young");
  EXPECT_EQ(nearest("durtaion", {"dt", "duration"}), "duration");
  EXPECT_EQ(nearest("colour", {"density", "young"}), "");
  EXPECT_EQ(nearest("", {"a"}), "");
}

TEST(Suggest, parts_of_names_are_understood) {
  const std::vector<std::string> keys = {"friction_deg",     "residual_friction_deg", "cohesion",
                                         "normal_stiffness", "shear_stiffness",       "damping"};
  EXPECT_EQ(nearest("fric_deg", keys), "friction_deg");
  EXPECT_EQ(nearest("friction", keys), "friction_deg");
  EXPECT_EQ(nearest("coh", keys), "cohesion");
  EXPECT_EQ(nearest("norm_stiff", keys), "normal_stiffness");
  EXPECT_EQ(nearest("res_fric_deg", keys), "residual_friction_deg");
  EXPECT_EQ(nearest("stiffness", {"stiffness_left", "stiffness_down"}), "") << "two would do";
  EXPECT_EQ(nearest("no", keys), "") << "too short to say";
  EXPECT_EQ(nearest("deg_fric", keys), "") << "another order";
}

TEST(Suggest, symbols_of_the_trade_are_understood) {
  for (const auto& [symbol, key] : {std::pair{"phi", "friction_deg"}, std::pair{"c", "cohesion"}}) {
    const std::string option = fmt::format("joint.plane.{}=20", symbol);
    const CaseError e = error_in([&] { (void)read("good_case.toml", {option}); });
    EXPECT_NE(std::string(e.what()).find(fmt::format("did you mean \"{}\"?", key)), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace scree::io::test::case_schema_test
