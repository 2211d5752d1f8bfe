#include "io/case/schema.h"

#include <algorithm>
#include <deque>
#include <iterator>
#include <vector>

#include "coupling/bodies/methods.h"
#include "coupling/contact/law/friction_laws.h"

namespace scree::io {
namespace {

constexpr Range kAny{};
constexpr Range kPositive{.low = 0.0, .low_open = true};
constexpr Range kNotNegative{.low = 0.0};
constexpr Range kFraction{.low = 0.0, .high = 1.0};
constexpr Range kPoisson{.low = 0.0, .high = 0.5, .high_open = true};
constexpr Range kGsi{.low = 0.0, .high = 100.0, .low_open = true};
constexpr Range kDisturbance{.low = 0.0, .high = 1.0};
constexpr Range kFriction{.low = 0.0, .high = 90.0, .high_open = true};
constexpr Range kTurn{.low = -360.0, .high = 360.0};
constexpr Range kHalfTurn{.low = 0.0, .high = 180.0};
constexpr Range kDipDeviation{.low = 0.0, .high = 45.0};
constexpr Range kChords{.low = 1.0, .high = 10000.0};
constexpr Range kSeed{.low = 0.0, .high = 2147483647.0};
constexpr Range kSafety{.low = 0.0, .high = 1.0, .low_open = true};
constexpr Range kBelowOneOpen{.low = 0.0, .high = 1.0, .low_open = true, .high_open = true};
constexpr Range kBelowOne{.low = 0.0, .high = 1.0, .high_open = true};
constexpr Range kSleep{.low = 0.0, .high = 1e-3};
constexpr Range kCap{.low = 1.0, .high = 100.0};
constexpr Range kCount{.low = 1.0, .high = 2147483647.0};
constexpr Range kIndex{.low = 0.0, .high = 2147483647.0};
constexpr Range kShift{.low = -1e6, .high = 1e6};
constexpr Range kPasses{.low = 1.0, .high = 1000.0};
constexpr Range kFrameRate{.low = 0.0, .high = 1000.0, .low_open = true};
constexpr Range kThreads{.low = 0.0, .high = 1024.0};
constexpr Range kCoordinate{.low = -1e9, .high = 1e9};
constexpr Range kCoefficient{.low = -10.0, .high = 10.0};
constexpr Range kStart{.low = 0.0, .high = 1e6};
constexpr Range kTime{.low = 1e-12, .high = 1e6};  // one tick to 11 days: sums of stages stay within 64-bit ticks

// path, type, unit, range, fallback, required, choices, meaning
constexpr Key kKeys[] = {
    {"title", Type::text, "", kAny, "\"\"", false, "", "What the run is about; shown in results and pictures."},

    {"model", Type::table, "", kAny, "", false, "", "Settings of the whole model."},
    {"model.plane", Type::choice, "", kAny, "\"strain\"", false, "strain|stress", "Plane strain or plane stress."},
    {"model.gravity", Type::point, "m/s2", kAny, "[0.0, -9.81]", false, "", "Acceleration of gravity, x right, y up."},
    {"model.detection", Type::number_or_auto, "m", kPositive, "\"auto\"", false, "",
     "Distance below which corners and edges are tested for contact."},
    {"model.default_joint", Type::name, "", kAny, "(the only joint)", false, "",
     "Joint law of edges without one. Required if more than one joint is defined. Without any joint the law is "
     "\"smooth\": no friction, no cohesion."},
    {"model.cover_size", Type::number, "m", kPositive, "", false, "",
     "Size of the mathematical covers of the NMM, for stages without a cover_size."},

    {"function", Type::named_tables, "", kAny, "", false, "",
     "A number that depends on time; loads refer to it by NAME and are multiplied by it. It is zero before its start."},
    {"function.NAME.shape", Type::choice, "", kAny, "", true, "constant|ramp|sine|half_sine|sine_squared|table",
     "With s the time since start and T the duration: constant 1; ramp s/T, then 1; sine sin(2 pi frequency s), "
     "until T if that is given; half_sine sin(pi s/T), then 0; sine_squared sin^2(pi s/T), then 0; table straight "
     "lines through given points, zero before the first, the last value after the last."},
    {"function.NAME.amplitude", Type::number, "", kAny, "1.0", false, "", "Factor on the shape."},
    {"function.NAME.start", Type::number_or_stage, "s", kShift, "(0)", false, "",
     "Beginning of the shape: a simulated time, or the name of a stage, whose actual beginning counts."},
    {"function.NAME.offset", Type::number, "s", kStart, "(0)", false, "",
     "Time from the beginning of the stage to that of the shape. Requires the name of a stage in start."},
    {"function.NAME.duration", Type::number, "s", kTime, "", false, "",
     "T of the shape. Needed for ramp, half_sine and sine_squared; may be given for sine."},
    {"function.NAME.frequency", Type::number, "Hz", kPositive, "", false, "",
     "Frequency of a sine, which requires it."},
    {"function.NAME.file", Type::text, "", kAny, "", false, "",
     "Text file with the points of a table in two columns, time [s] and value; form and path as motion.NAME.file, but "
     "the steps may differ. A table needs either this or points."},
    {"function.NAME.points", Type::line, "", kAny, "", false, "",
     "Points [time, value] of a table, times in s from start on, increasing, none negative."},

    {"material", Type::named_tables, "", kAny, "", true, "", "A rock or soil; blocks refer to it by NAME."},
    {"material.NAME.density", Type::number, "kg/m3", kPositive, "", true, "", "Mass density."},
    {"material.NAME.young", Type::number, "Pa", kPositive, "", true, "", "Young's modulus."},
    {"material.NAME.poisson", Type::number, "", kPoisson, "", true, "", "Poisson's ratio."},
    {"material.NAME.initial_stress", Type::table, "", kAny, "", false, "",
     "In-situ stress of the material in the axes of the model, tension positive: constant, or growing with depth "
     "as stress + (level - y) gradient. It is present from the start with every method: as it varies in meshes of "
     "the NMM, as its mean over the block in blocks of the DDA or under a onefold cover."},
    {"material.NAME.initial_stress.xx", Type::number, "Pa", kAny, "", true, "", "Stress along x, at level."},
    {"material.NAME.initial_stress.yy", Type::number, "Pa", kAny, "", true, "", "Stress along y, at level."},
    {"material.NAME.initial_stress.xy", Type::number, "Pa", kAny, "0.0", false, "", "Shear stress, at level."},
    {"material.NAME.initial_stress.gradient_xx", Type::number, "Pa/m", kAny, "0.0", false, "",
     "Growth of xx with depth; negative where compression grows."},
    {"material.NAME.initial_stress.gradient_yy", Type::number, "Pa/m", kAny, "0.0", false, "",
     "Growth of yy with depth: -density g under the weight of the rock."},
    {"material.NAME.initial_stress.gradient_xy", Type::number, "Pa/m", kAny, "0.0", false, "",
     "Growth of xy with depth."},
    {"material.NAME.initial_stress.level", Type::number, "m", kCoordinate, "", false, "",
     "y from which depth is measured. Required with a gradient."},
    {"material.NAME.rock_strength", Type::table, "", kAny, "(none: not compared)", false, "",
     "Strength of the rock that the stress in its blocks is compared with: Mohr-Coulomb by cohesion and "
     "friction_deg, or Hoek and Brown (2002) by ucs, gsi and mi. Blocks stay elastic in any case; runs, `scree "
     "fos` and pictures show where the stress is above it."},
    {"material.NAME.rock_strength.cohesion", Type::number, "Pa", kPositive, "", false, "",
     "Mohr-Coulomb: cohesion. Requires friction_deg."},
    {"material.NAME.rock_strength.friction_deg", Type::number, "deg", kFriction, "", false, "",
     "Mohr-Coulomb: friction angle."},
    {"material.NAME.rock_strength.tension", Type::number, "Pa", kNotNegative, "(cohesion / tan(friction_deg))", false,
     "", "Mohr-Coulomb: tensile strength, at most that at which the envelope ends."},
    {"material.NAME.rock_strength.ucs", Type::number, "Pa", kPositive, "", false, "",
     "Hoek and Brown: uniaxial compressive strength of the intact rock. Requires gsi and mi."},
    {"material.NAME.rock_strength.gsi", Type::number, "", kGsi, "", false, "",
     "Hoek and Brown: geological strength index; 100: intact rock."},
    {"material.NAME.rock_strength.mi", Type::number, "", kPositive, "", false, "",
     "Hoek and Brown: constant of the intact rock, 4 (claystone) to 33 (granite)."},
    {"material.NAME.rock_strength.d", Type::number, "", kDisturbance, "0.0", false, "",
     "Hoek and Brown: disturbance by blasting and unloading, 0 to 1."},

    {"joint", Type::named_tables, "", kAny, "", false, "",
     "A Coulomb law of block edges; blocks refer to it by NAME. Where two edges touch that have different laws, "
     "the law with the smaller friction angle applies, with all of its stiffnesses and strengths; of two with the "
     "same angle the one whose NAME comes first in the case. An edge without a law takes that of the other edge."},
    {"joint.NAME.friction_deg", Type::number, "deg", kFriction, "", true, "", "Friction angle."},
    {"joint.NAME.residual_friction_deg", Type::number, "deg", kFriction, "(friction_deg)", false, "",
     "Friction angle that is left after failure, at most friction_deg."},
    {"joint.NAME.weakening_slip", Type::number, "m", kNotNegative, "0.0", false, "",
     "Slip over which the tangent of the friction angle falls, linearly, to that of residual_friction_deg. With 0 "
     "it falls at once when the joint first fails."},
    {"joint.NAME.cohesion", Type::number, "Pa", kNotNegative, "0.0", false, "",
     "Cohesion; lost when the joint first slips, or when its bond breaks."},
    {"joint.NAME.residual_cohesion", Type::number, "Pa", kNotNegative, "0.0", false, "",
     "Cohesion that is left after that, at most the value of cohesion."},
    {"joint.NAME.tensile_strength", Type::number_or_unlimited, "Pa", kNotNegative, "0.0", false, "",
     "Tension that a contact closed at the start carries until it first fails in tension or shear; then it can "
     "open. At most cohesion / tan(friction_deg), where Coulomb's line ends. \"unlimited\": such a contact never "
     "fails, not in shear either."},
    {"joint.NAME.dilation_deg", Type::number, "deg", kFriction, "0.0", false, "",
     "Dilation angle: slip in either direction opens the joint by its tangent. At most the least friction angle "
     "while it dilates."},
    {"joint.NAME.dilation_slip", Type::number, "m", kPositive, "(no end)", false, "",
     "Slip after which the joint opens no further. Requires dilation_deg."},
    {"joint.NAME.normal_stiffness", Type::number_or_auto, "Pa/m", kPositive, "\"auto\"", false, "",
     "Normal stiffness per area; a contact point carries its share of the overlap of two edges. \"auto\" is (K + "
     "4G/3)/d of the stiffer side, d the width of the block normal to the edge. Where a mesh of the NMM divides "
     "an edge, a hinge between two blocks rests on its outermost piece only and is softer than between blocks of "
     "the DDA, whose joints have two points, each with half of the length: the limit of an arch changes by about "
     "3 %. Ten times the automatic stiffness, or the DDA, is closer to rigid blocks; `scree check` warns about "
     "such arches, and about free-standing blocks on such a joint that rock or topple: they do so farther than rigid "
     "ones."},
    {"joint.NAME.shear_stiffness", Type::number_or_auto, "Pa/m", kPositive, "\"auto\"", false, "",
     "Shear stiffness per area. \"auto\" is the normal stiffness."},
    {"joint.NAME.contact_length", Type::number, "m", kPositive, "", false, "",
     "Length of joint that a contact of a corner with an edge represents. Without it, a tenth of the square root "
     "of the smaller block's area."},
    {"joint.NAME.penalty", Type::number, "N/m", kPositive, "", false, "",
     "Normal stiffness of every contact point, in place of a stiffness per area."},
    {"joint.NAME.shear_penalty", Type::number, "N/m", kPositive, "", false, "",
     "Tangential stiffness of every contact point. Without it, equal to penalty."},
    {"joint.NAME.damping", Type::number, "", kFraction, "0.5", false, "",
     "Dashpots of closed contacts, a fraction of critical for the mass at the corner. Their force is part of the "
     "normal force that friction depends on. In implicit steps they are normal to the joint only, and act if "
     "dynamics = 1."},

    {"motion", Type::named_tables, "", kAny, "", false, "", "A recorded ground motion; supports refer to it by NAME."},
    {"motion.NAME.file", Type::text, "", kAny, "", true, "",
     "A PEER record if its name ends in .AT2. Otherwise two columns, time [s] and acceleration, separated by "
     "comma, semicolon or space; # begins a comment; one line of headings may come first; the time steps are "
     "equal. Relative to the case file; a leading \"$SCREE_RECORDS/\" is replaced by that environment variable."},
    {"motion.NAME.unit", Type::choice, "", kAny, "(as stated in the file)", false, "m/s2|g|cm/s2",
     "Unit of the accelerations in the file; g is 9.80665 m/s2. Required unless the file states it, as .AT2 files "
     "do."},
    {"motion.NAME.start", Type::number_or_stage, "s", kStart, "(the first stage after the leading ones with rest)",
     false, "",
     "Time of the first sample that is kept: a simulated time, or the name of a stage, whose actual beginning "
     "counts (rest_force and end may end stages early). Before it the ground is at rest; after the last sample it "
     "moves on at its final velocity."},
    {"motion.NAME.offset", Type::number, "s", kStart, "(0)", false, "",
     "Time from the beginning of the stage to the first sample. Requires the name of a stage in start."},
    {"motion.NAME.from", Type::number, "s", kAny, "(first sample)", false, "",
     "Beginning of the part of the record that is kept, in the time of the record (from 0 for .AT2)."},
    {"motion.NAME.until", Type::number, "s", kAny, "(last sample)", false, "",
     "End of the part of the record that is kept, in the time of the record."},
    {"motion.NAME.resample", Type::number, "s", kPositive, "(as recorded)", false, "",
     "Time step of new samples, interpolated linearly between the recorded ones and rounded down to divide the "
     "duration. Also accepts records whose steps are not equal."},
    {"motion.NAME.baseline", Type::choice, "", kAny, "\"none\"", false, "none|constant|linear|quadratic",
     "Drift that is subtracted: the polynomial in time, of degree 0, 1 or 2 in the acceleration, that leaves the "
     "ground at rest at the end and makes the mean square of its velocity least."},
    {"motion.NAME.taper", Type::number, "s", kNotNegative, "0.0", false, "",
     "Time at either end over which half a cosine bell tapers the acceleration to zero. The baseline is corrected "
     "before the taper and again after it."},
    {"motion.NAME.pga", Type::number, "m/s2", kPositive, "", false, "",
     "Peak acceleration to which the motion is scaled, after all other processing. Either this or scale."},
    {"motion.NAME.scale", Type::number, "", kAny, "(1)", false, "", "Factor on the accelerations."},
    {"motion.NAME.integration", Type::choice, "", kAny, "\"linear\"", false, "linear|constant",
     "Acceleration between samples: linear from one to the next, or constant until the next. Either is integrated "
     "exactly at any time, whatever the time steps."},
    {"motion.NAME.direction", Type::point, "", kAny, "(along x)", false, "",
     "Direction of positive accelerations; its length does not matter. Either this or direction_deg."},
    {"motion.NAME.direction_deg", Type::number, "deg", kTurn, "(along x)", false, "",
     "Direction of positive accelerations, counter-clockwise from +x."},

    {"block", Type::table_list, "", kAny, "", false, "",
     "A block. Blocks may touch but not overlap. At least one, unless there is a domain."},
    {"block[].name", Type::name, "", kAny, "", true, "", "Name, given once only."},
    {"block[].polygon", Type::ring, "m", kCoordinate, "", true, "",
     "Corners in order around the block, either way round; the first is not repeated at the end."},
    {"block[].holes", Type::rings, "m", kCoordinate, "[]", false, "", "Holes in the block, each a list of corners."},
    {"block[].material", Type::name, "", kAny, "", true, "", "Name of a material."},
    {"block[].joint", Type::name, "", kAny, "(model.default_joint)", false, "", "Joint law of the edges of the block."},
    {"block[].edge_joints", Type::names, "", kAny, "[]", false, "",
     "Joint laws, one per edge: the first for the edge from the first corner of polygon to the second. \"\" "
     "stands for the joint of the block."},
    {"block[].cover_size", Type::number, "m", kPositive, "(that of the stage)", false, "",
     "Size of the mathematical covers of the NMM in this block."},
    {"block[].velocity", Type::point, "m/s", kAny, "[0.0, 0.0]", false, "", "Initial velocity of the centroid."},
    {"block[].spin", Type::number, "rad/s", kAny, "0.0", false, "", "Initial angular velocity, counter-clockwise."},

    {"drawing", Type::table, "", kAny, "", false, "",
     "A section drawing. Sections of the case take lines, rings and points from its layers: domain.outline_layer, "
     "domain.holes_layer, domain.region.layer, domain.trace.layer, water.layer, monitor.layer, bolt.layer. Names "
     "of layers are not case-sensitive; * in them stands for any characters. `scree check` prints what was read "
     "and what was left out."},
    {"drawing.file", Type::text, "", kAny, "", true, "",
     "ASCII DXF, R12 to 2018: LINE, LWPOLYLINE and POLYLINE with bulges, ARC, CIRCLE, ELLIPSE, SPLINE, POINT, and "
     "INSERT of blocks of these. Or, with the ending csv, txt or dat, columns x, y and the name of the layer, in "
     "the form of domain.trace.file. Relative to the case file."},
    {"drawing.unit", Type::choice, "", kAny, "\"auto\"", false, "auto|m|cm|mm|km|in|ft",
     "Unit of its coordinates. \"auto\" is the unit in the header of a DXF, which must then state one, and m for "
     "columns."},
    {"drawing.tolerance", Type::number_or_auto, "m", kPositive, "\"auto\"", false, "",
     "Largest distance of a curve from the chords that replace it. \"auto\" is 1e-4 of the extent of the drawing."},
    {"drawing.offset", Type::point, "m", kCoordinate, "[0.0, 0.0]", false, "",
     "Subtracted from all of its coordinates."},
    {"drawing.join", Type::number_or_auto, "m", kNotNegative, "\"auto\"", false, "",
     "Distance within which ends of lines are joined, where outlines, regions and piezometric lines consist of "
     "several lines. \"auto\" is 1e-6 of the extent of the drawing."},

    {"domain", Type::table, "", kAny, "", false, "",
     "A domain that is cut into blocks by joint sets, traces and arcs. Lines that end inside a block do not cut it; "
     "they "
     "are kept as cracks."},
    {"domain.outline", Type::ring, "m", kCoordinate, "", false, "",
     "Corners in order around the domain, either way round; the first is not repeated at the end. Either this or "
     "outline_file or outline_layer."},
    {"domain.outline_file", Type::text, "", kAny, "", false, "",
     "Text file with the outline as one line of points x, y; here the first point is repeated at the end. Form and "
     "path "
     "as domain.trace.file."},
    {"domain.outline_layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing that holds the outline: one closed line, or lines that meet end to end."},
    {"domain.holes_layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing with openings, in place of holes."},
    {"domain.holes", Type::rings, "m", kCoordinate, "[]", false, "",
     "Openings such as tunnels, each a list of corners."},
    {"domain.material", Type::name, "", kAny, "", true, "", "Name of the material outside regions."},
    {"domain.joint", Type::name, "", kAny, "(model.default_joint)", false, "",
     "Joint law of block edges that lie on no joint."},
    {"domain.prefix", Type::name, "", kAny, "\"block\"", false, "",
     "Blocks are named PREFIX-1, PREFIX-2, ..., in a region NAME-1, NAME-2, ..., from the lowest corner up, then from "
     "left to right."},
    {"domain.snap", Type::number_or_auto, "m", kPositive, "\"auto\"", false, "",
     "Grid on which lines are noded. \"auto\" is the power of ten at or above 1e-9 of the extent and the round-off "
     "of the coordinates."},
    {"domain.least_width", Type::number_or_auto, "m", kNotNegative, "\"auto\"", false, "",
     "Blocks with a smaller width (area over half the perimeter) join the neighbour with the longest shared edge, one "
     "of the same region if there is any; cracks that are shorter are trimmed away. \"auto\" is 1e-6 of the extent."},
    {"domain.least_area", Type::number, "m2", kNotNegative, "0.0", false, "",
     "Blocks with a smaller area join the neighbour with the longest shared edge."},
    {"domain.dead_ends", Type::choice, "", kAny, "\"keep\"", false, "keep|drop|extend",
     "Treatment of lines that end inside rock. keep: they are cracks, along which the NMM cuts its covers, and "
     "which the DDA ignores. drop: they are removed. extend: they are extended to the next line and cut through "
     "the rock bridges. `scree check` reports their number and length."},
    {"domain.region", Type::table_list, "", kAny, "", false, "",
     "A part of the domain with another material; its outline separates blocks. Regions may touch but not overlap."},
    {"domain.region[].name", Type::name, "", kAny, "", true, "", "Name, given once only; its blocks are NAME-k."},
    {"domain.region[].polygon", Type::ring, "m", kCoordinate, "", false, "",
     "Corners in order; what lies outside the domain is ignored. Either this or layer."},
    {"domain.region[].layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing with its outline. Each of several closed lines is a region, NAME_1, NAME_2, ..."},
    {"domain.region[].material", Type::name, "", kAny, "(domain.material)", false, "", "Name of a material."},
    {"domain.region[].joint", Type::name, "", kAny, "(domain.joint)", false, "",
     "Joint law of the region's outline, where no joint lies on it, and of edges of its blocks that lie on no joint."},
    {"domain.region[].cut", Type::boolean, "", kAny, "true", false, "",
     "If false, joints end at the region, which stays one block, a base for example."},
    {"domain.region[].cover_size", Type::number, "m", kPositive, "(that of the stage)", false, "",
     "Size of the mathematical covers of the NMM in its blocks."},
    {"domain.joint_set", Type::table_list, "", kAny, "", false, "",
     "A family of parallel joints. Random values come from a generator with a seed: the lines are the same on "
     "every machine. Deviations: the standard deviation of normal and lognormal, half the width of uniform, none "
     "for exponential. Draws that are not positive are repeated."},
    {"domain.joint_set[].joint", Type::name, "", kAny, "", true, "", "Joint law of the lines."},
    {"domain.joint_set[].dip_deg", Type::number, "deg", kHalfTurn, "", true, "",
     "Direction of the lines, counter-clockwise from +x."},
    {"domain.joint_set[].dip_deviation_deg", Type::number, "deg", kDipDeviation, "0.0", false, "", "Its deviation."},
    {"domain.joint_set[].dip_distribution", Type::choice, "", kAny, "\"normal\"", false, "normal|uniform",
     "Its distribution."},
    {"domain.joint_set[].dip_fisher_k", Type::number, "", kPositive, "", false, "",
     "Scatter of the poles in space by the Fisher distribution of this concentration K, as from a stereonet, "
     "about the mean pole, which lies in the section; the dips are apparent dips in the section. In place of "
     "dip_deviation_deg."},
    {"domain.joint_set[].spacing", Type::number, "m", kPositive, "", true, "",
     "Distance between lines, normal to the mean dip."},
    {"domain.joint_set[].spacing_deviation", Type::number, "m", kNotNegative, "0.0", false, "", "Its deviation."},
    {"domain.joint_set[].spacing_distribution", Type::choice, "", kAny, "\"normal\"", false,
     "normal|uniform|exponential|lognormal", "Its distribution."},
    {"domain.joint_set[].length", Type::number, "m", kPositive, "(lines run through)", false, "",
     "Length of the traces of a line."},
    {"domain.joint_set[].length_deviation", Type::number, "m", kNotNegative, "0.0", false, "", "Its deviation."},
    {"domain.joint_set[].length_distribution", Type::choice, "", kAny, "\"normal\"", false,
     "normal|uniform|exponential|lognormal", "Its distribution."},
    {"domain.joint_set[].gap", Type::number, "m", kNotNegative, "0.0", false, "",
     "Rock bridge between the traces of a line; requires length."},
    {"domain.joint_set[].persistence",
     Type::number,
     "",
     {0.0, 1.0, true, false},
     "",
     false,
     "",
     "Length over length + gap, in place of gap: 1 leaves no rock bridge."},
    {"domain.joint_set[].gap_deviation", Type::number, "m", kNotNegative, "0.0", false, "", "Its deviation."},
    {"domain.joint_set[].gap_distribution", Type::choice, "", kAny, "\"normal\"", false,
     "normal|uniform|exponential|lognormal", "Its distribution."},
    {"domain.joint_set[].stagger", Type::number, "", kFraction, "0.0", false, "",
     "Shift of the traces from line to line, a fraction of length + gap; 0.5 as in masonry. If length or gap "
     "varies, lines begin at random instead."},
    {"domain.joint_set[].origin", Type::point, "m", kCoordinate, "(lower left of the outline)", false, "",
     "A point on a line, where a trace begins."},
    {"domain.joint_set[].region", Type::ring, "m", kCoordinate, "(everywhere)", false, "",
     "Corners of a polygon in which the lines exist."},
    {"domain.joint_set[].seed", Type::integer, "", kSeed, "(number of the set, from 1)", false, "",
     "Seed of the generator."},
    {"domain.trace", Type::table_list, "", kAny, "", false, "", "A discontinuity as a line of points."},
    {"domain.trace[].points", Type::line, "m", kCoordinate, "", false, "",
     "Points in order. Either this or file or layer."},
    {"domain.trace[].layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing; each of its lines is a trace."},
    {"domain.trace[].file", Type::text, "", kAny, "", false, "",
     "Text file with columns x, y [m], separated by comma, semicolon or space; a blank line begins another trace, so "
     "does another name or number in a third column; # begins a comment; one line of headings may come first. Relative "
     "to the case file."},
    {"domain.trace[].joint", Type::name, "", kAny, "", true, "", "Joint law of the line."},
    {"domain.arc", Type::table_list, "", kAny, "", false, "", "A discontinuity as chords of a circular arc."},
    {"domain.arc[].centre", Type::point, "m", kCoordinate, "", true, "", "Centre of the circle."},
    {"domain.arc[].radius", Type::number, "m", kPositive, "", true, "", "Its radius."},
    {"domain.arc[].from_deg", Type::number, "deg", kTurn, "0.0", false, "",
     "Angle at which the arc begins, counter-clockwise from +x."},
    {"domain.arc[].to_deg", Type::number, "deg", kTurn, "360.0", false, "", "Angle at which it ends."},
    {"domain.arc[].chords", Type::integer, "", kChords, "36", false, "", "Number of chords."},
    {"domain.arc[].joint", Type::name, "", kAny, "", true, "", "Joint law of the line."},

    {"crack", Type::table_list, "", kAny, "", false, "",
     "A discontinuity inside a block, in addition to cracks of a domain. Stages of the NMM cut their covers along "
     "it unless cracks = false; the block stays one block even where the crack runs through it."},
    {"crack[].block", Type::name, "", kAny, "", true, "", "Name of the block."},
    {"crack[].points", Type::line, "m", kCoordinate, "", true, "",
     "Points of the line in order, inside the block or on its outline."},
    {"crack[].joint", Type::name, "", kAny, "(that of the block)", false, "", "Joint law of the crack."},

    {"support", Type::table_list, "", kAny, "", false, "",
     "A support: whole blocks fixed or moving with the ground, points on springs, or outlines along a line or in "
     "a box."},
    {"support[].block", Type::name, "", kAny, "", false, "", "Name of the block. Either this or blocks or at."},
    {"support[].blocks", Type::names, "", kAny, "", false, "",
     "Names of several blocks that are held whole; * stands for any characters: \"base-*\"."},
    {"support[].at", Type::point, "m", kCoordinate, "", false, "", "A point inside the block, in place of its name."},
    {"support[].on", Type::line, "m", kCoordinate, "", false, "",
     "Points of a line: all parts of outlines that lie on it, within 1e-6 of the extent of the model, and face no "
     "other block are held; with block or blocks only the parts of these blocks, also on joints. The edge is "
     "fixed along the directions of fix and slides freely along the others: blocks of the NMM by Nitsche's method "
     "on the elements that the line cuts, others by springs of 10 (K + 4G/3)/sqrt(area of the block)."},
    {"support[].box", Type::line, "m", kCoordinate, "", false, "",
     "Two opposite corners of a box: as on, for the parts of outlines in it."},
    {"support[].bedding", Type::number, "Pa/m", kPositive, "", false, "",
     "With on or box: stiffness of springs, as force per area and displacement, in place of an edge that cannot "
     "move."},
    {"support[].fix", Type::choice, "", kAny, "\"all\"", false, "all|both|x|y|normal",
     "Directions that are held; both is all. A whole block is held in all directions. normal, with on or box: at "
     "right angles to the edge (a roller)."},
    {"support[].point", Type::point, "m", kCoordinate, "", false, "",
     "Point of the block, on its outline or inside, that a spring holds in place. Without it the whole block is "
     "held."},
    {"support[].stiffness", Type::number_or_auto, "N/m", kPositive, "\"auto\"", false, "",
     "Stiffness of the spring at the point. \"auto\" is 10 (K + 4G/3) of the block."},
    {"support[].motion", Type::name, "", kAny, "", false, "", "Name of a ground motion that the whole block follows."},

    {"point_load", Type::table_list, "", kAny, "", false, "",
     "A force on a material point of a block, constant in direction."},
    {"point_load[].block", Type::name, "", kAny, "(the block that holds the point)", false, "", "Name of the block."},
    {"point_load[].point", Type::point, "m", kCoordinate, "", true, "",
     "The point in the initial model, on the outline of the block or inside."},
    {"point_load[].force", Type::point, "N", kAny, "", true, "", "Force per unit thickness."},
    {"point_load[].function", Type::name, "", kAny, "(constant)", false, "",
     "Name of the function that multiplies it."},
    {"point_load[].start", Type::number_or_stage, "s", kShift, "(always)", false, "",
     "Beginning of the load: a simulated time, or the name of a stage. It does not act before; the time of its "
     "function, which then has no start of its own, is counted from there."},
    {"point_load[].offset", Type::number, "s", kStart, "(0)", false, "",
     "Time from the beginning of the stage to that of the load. Requires the name of a stage in start."},

    {"traction", Type::table_list, "", kAny, "", false, "",
     "A force per length of the initial outline, constant in direction (a dead load)."},
    {"traction[].block", Type::name, "", kAny, "(all that lie on the line)", false, "", "Name of the block."},
    {"traction[].on", Type::line, "m", kCoordinate, "", false, "",
     "Ends of a straight line: the parts of the outline that lie on it, including holes, within 1e-6 of the "
     "extent of the block. Either this or edge. Without block it may have more points, and applies to the parts "
     "of all outlines that lie on it and face no other block; blocks that are held whole are skipped."},
    {"traction[].edge", Type::integer, "", kIndex, "", false, "",
     "Edge of a listed block, from 0: edge 0 runs from the first corner of polygon to the second."},
    {"traction[].traction", Type::point, "Pa", kAny, "", false, "",
     "Force per area in the axes of the model. Either this or pressure or surcharge."},
    {"traction[].pressure", Type::number, "Pa", kAny, "", false, "",
     "Force per area at right angles to the outline; positive pushes into the block."},
    {"traction[].surcharge", Type::number, "Pa", kAny, "", false, "",
     "Weight per horizontal area on the outline: it acts along -y; on a slope it is less per length of outline."},
    {"traction[].function", Type::name, "", kAny, "(constant)", false, "", "Name of the function that multiplies it."},
    {"traction[].start", Type::number_or_stage, "s", kShift, "(always)", false, "", "As point_load.start."},
    {"traction[].offset", Type::number, "s", kStart, "(0)", false, "", "As point_load.offset."},

    {"body_acceleration", Type::table_list, "", kAny, "", false, "",
     "A force per mass on blocks, in addition to gravity."},
    {"body_acceleration[].acceleration", Type::point, "m/s2", kAny, "", true, "", "Force per mass."},
    {"body_acceleration[].function", Type::name, "", kAny, "(constant)", false, "",
     "Name of the function that multiplies it."},
    {"body_acceleration[].start", Type::number_or_stage, "s", kShift, "(always)", false, "", "As point_load.start."},
    {"body_acceleration[].offset", Type::number, "s", kStart, "(0)", false, "", "As point_load.offset."},
    {"body_acceleration[].blocks", Type::names, "", kAny, "(all)", false, "",
     "Names of the blocks; * stands for any characters. Patterns skip blocks that are held whole."},

    {"viscous_edge", Type::table_list, "", kAny, "", false, "",
     "Outline that absorbs waves: dashpots of rho c_p and rho c_s per area, exact for waves at right angles to it."},
    {"viscous_edge[].block", Type::name, "", kAny, "", true, "", "Name of the block."},
    {"viscous_edge[].on", Type::line, "m", kCoordinate, "", false, "", "As traction.on. Either this or edge."},
    {"viscous_edge[].edge", Type::integer, "", kIndex, "", false, "", "As traction.edge."},
    {"viscous_edge[].motion", Type::name, "", kAny, "(none)", false, "",
     "Name of a ground motion that enters as a wave from the rock beyond the edge (a compliant base): it adds the "
     "tractions 2 rho c_s and 2 rho c_p times the velocity of the upgoing wave."},
    {"viscous_edge[].motion_is", Type::choice, "", kAny, "\"outcrop\"", false, "outcrop|upgoing",
     "What the motion was recorded on: an outcrop of that rock, where the upgoing wave has half of its velocity, "
     "or the upgoing wave itself. Requires motion."},

    {"free_field", Type::table_list, "", kAny, "", false, "",
     "A vertical side of the model beside level ground of its material, on the same kind of base and with the "
     "same motion: the stress and the dashpots of a free-field column act on it, so that waves from below travel "
     "up undistorted, and waves scattered by the model leave it. The base is the viscous edge with a motion (a "
     "compliant base), or the blocks held whole that follow one (a rigid base)."},
    {"free_field[].on", Type::line, "m", kCoordinate, "", false, "",
     "Ends of a vertical line: the parts of the outlines that lie on it and face no other block, or, for blocks "
     "that are named, also parts that face others. Either this or edge."},
    {"free_field[].block", Type::name, "", kAny, "(all that lie on the line)", false, "", "Name of the block."},
    {"free_field[].blocks", Type::names, "", kAny, "(all that lie on the line)", false, "",
     "Names of the blocks; * stands for any characters. All of one material."},
    {"free_field[].edge", Type::integer, "", kIndex, "", false, "", "As traction.edge; requires block."},
    {"free_field[].motion", Type::name, "", kAny, "(that of the base)", false, "",
     "Name of the ground motion that drives the base, where the model has several."},
    {"free_field[].bottom", Type::number, "m", kCoordinate, "(lower end of the side)", false, "",
     "Height of the base of the ground."},
    {"free_field[].top", Type::number, "m", kCoordinate, "(upper end of the side)", false, "",
     "Height of its free surface."},

    {"bolt", Type::table_list, "", kAny, "", false, "",
     "A bolt, cable or anchor through the blocks: a straight bar that is fastened to the rock by a plate at its "
     "head, and by an anchor or grout at its toe. Its numbers are those of one bolt; `spacing` is the distance "
     "between bolts."},
    {"bolt[].name", Type::name, "", kAny, "(bolt#1, bolt#2, ...)", false, "", "Name in results and messages."},
    {"bolt[].layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing; each of its lines, of two points, is a bolt from the head, its first point, to the "
     "toe. They are named NAME-1, NAME-2, ... where name is given."},
    {"bolt[].head", Type::point, "m", kCoordinate, "", false, "",
     "Beginning of the bar, on the outline of a block or inside one, in the initial model. Either head and toe, "
     "or layer."},
    {"bolt[].toe", Type::point, "m", kCoordinate, "", false, "", "End of the bar."},
    {"bolt[].stage", Type::name, "", kAny, "(the first)", false, "",
     "Name of the stage at whose beginning it is installed, in the blocks as they are then. It has its pretension "
     "at once, and no other force."},
    {"bolt[].spacing", Type::number, "m", kPositive, "1.0", false, "",
     "Distance between such bolts out of the plane. Forces and stiffnesses below are divided by it."},
    {"bolt[].axial_stiffness", Type::number, "N", kPositive, "", true, "",
     "Young's modulus times area of the bar: force per strain."},
    {"bolt[].yield", Type::number, "N", kPositive, "(never)", false, "",
     "Axial force at which the bar yields, in tension and, where it is grouted, also in compression."},
    {"bolt[].rupture_strain", Type::number, "", kPositive, "(never)", false, "",
     "Plastic strain of a piece of the bar at which it breaks. Requires yield."},
    {"bolt[].pretension", Type::number, "N", kNotNegative, "0.0", false, "",
     "Axial force that is applied on installation to the free length, or to the first piece of a bar that is "
     "bonded all along."},
    {"bolt[].plate", Type::boolean, "", kAny, "true", false, "",
     "The head is fastened to the rock. Without a plate the bar must be bonded all along."},
    {"bolt[].bond_length", Type::number, "m", kPositive, "(none: an anchor holds the toe)", false, "",
     "Length from the toe over which grout bonds the bar to the rock. The rest, up to the head, is free: it "
     "carries tension only, and goes slack in compression."},
    {"bolt[].bond_stiffness", Type::number, "N/m2", kPositive, "", false, "",
     "Force per length of the bar and per slip relative to the rock. Required with bond_length."},
    {"bolt[].bond_strength", Type::number, "N/m", kPositive, "(never slips)", false, "",
     "Force per length at which the bond slips."},
    {"bolt[].segment", Type::number, "m", kPositive, "(auto)", false, "",
     "Greatest length of the pieces that the bond is divided into. Auto: a tenth of the bond, and a third of "
     "sqrt(axial_stiffness/bond_stiffness), the length over which force passes from the bar into the rock."},
    {"bolt[].shear_stiffness", Type::number, "N/m", kPositive, "(none)", false, "",
     "Force across the bar per shear displacement, at every joint that it crosses."},
    {"bolt[].shear_strength", Type::number, "N", kPositive, "(never yields)", false, "",
     "Shear force at which the bar yields at a joint."},
    {"bolt[].rupture_shear", Type::number, "m", kPositive, "(never)", false, "",
     "Plastic shear displacement at which the bar breaks. Requires shear_strength."},

    {"liner", Type::table_list, "", kAny, "", false, "",
     "Shotcrete or another lining along the outlines of blocks: a beam without shear, as a chain of bars from "
     "node to node that resist stretching, with springs at the nodes that resist bending. Its nodes are glued to "
     "the blocks; it has no mass. It is installed without stress on the blocks as they are then."},
    {"liner[].name", Type::name, "", kAny, "(liner#1, liner#2, ...)", false, "", "Name in results and messages."},
    {"liner[].along", Type::line, "m", kCoordinate, "", true, "",
     "Points of a line along the outlines of the initial model. One that ends where it began is a closed ring."},
    {"liner[].spacing", Type::number, "m", kPositive, "", true, "",
     "Greatest distance between its nodes. The points of the line are nodes too. Where blocks meet at a node, the "
     "first one carries it."},
    {"liner[].tolerance", Type::number, "m", kPositive, "0.01", false, "",
     "Greatest distance of the line from the outlines at its nodes, which are moved to the nearest point of an "
     "outline."},
    {"liner[].stage", Type::name, "", kAny, "(the first)", false, "",
     "Name of the stage at whose beginning it is installed, after the blocks that the stage excavates are removed."},
    {"liner[].thickness", Type::number, "m", kPositive, "", true, "", "Thickness t of the lining."},
    {"liner[].young", Type::number, "Pa", kPositive, "", true, "",
     "Young's modulus E. Stiffnesses per unit length of the tunnel are EA = E' t and EI = E' t^3/12, with E' = "
     "E/(1 - poisson^2) in plane strain and E in plane stress."},
    {"liner[].poisson", Type::number, "", kPoisson, "0.2", false, "", "Poisson's ratio."},
    {"liner[].tensile_strength", Type::number, "Pa", kPositive, "(never yields)", false, "",
     "Mean tension at which a bar of the liner yields."},
    {"liner[].compressive_strength", Type::number, "Pa", kPositive, "(never yields)", false, "",
     "Mean compression at which a bar of the liner yields. Neither strength takes bending into account."},
    {"liner[].rupture_strain", Type::number, "", kPositive, "(never)", false, "",
     "Plastic strain in tension at which a bar breaks; the resistance to bending at its ends is then lost too. "
     "Requires tensile_strength."},

    {"water", Type::table_list, "", kAny, "", false, "",
     "Water that fills joints below a piezometric line. Its hydrostatic pressure pushes the faces of a joint "
     "apart where two edges face each other, also where they have opened within the detection distance; contact "
     "forces are then effective forces. The line does not move with the blocks."},
    {"water[].line", Type::line, "m", kCoordinate, "", false, "",
     "Points of the piezometric line, x increasing. Beyond its ends it is horizontal. Either this or layer."},
    {"water[].layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing with the piezometric line: one line, or lines that meet end to end."},
    {"water[].reservoir", Type::boolean, "", kAny, "false", false, "",
     "The water also stands in front of the slope: its pressure acts on the outlines below the line that face no "
     "other block and are open to the outside, not on the left, right and lower border of the model, nor on "
     "closed openings such as tunnels. It is a dead load, the pressure on the initial outline."},
    {"water[].level", Type::table_list, "", kAny, "", false, "",
     "Another line from a stage on: drawdown or filling, in the joints and in front of the slope."},
    {"water[].level[].stage", Type::name, "", kAny, "", true, "",
     "Name of the stage at whose beginning it takes effect."},
    {"water[].level[].line", Type::line, "m", kCoordinate, "", true, "", "As water.line."},
    {"water[].unit_weight", Type::number, "N/m3", kPositive, "9810.0", false, "", "Unit weight of the water."},
    {"water[].joints", Type::names, "", kAny, "(all)", false, "",
     "Names of the laws of the joints that it fills; * stands for any characters. A law has one line at most."},

    {"monitor", Type::table_list, "", kAny, "", false, "", "A point whose history is written."},
    {"monitor[].block", Type::name, "", kAny, "(the block that holds the point)", false, "", "Name of the block."},
    {"monitor[].point", Type::point, "m", kCoordinate, "", false, "",
     "The point in the initial model, on the outline of the block or inside. Either this or layer."},
    {"monitor[].layer", Type::name, "", kAny, "", false, "",
     "Layer of the drawing; each of its POINTs is a monitor, named NAME-1, NAME-2, ... where name is given."},
    {"monitor[].name", Type::name, "", kAny, "(BLOCK#1, BLOCK#2, ...)", false, "",
     "Name in the results, given once only."},

    {"stage", Type::table_list, "", kAny, "", true, "", "A part of the run; stages follow one another."},
    {"stage[].name", Type::name, "", kAny, "", true, "", "Name, given once only."},
    {"stage[].method", Type::name, "", kAny, "", true, "", "Discretisation of the blocks: \"nmm\" or \"dda\"."},
    {"stage[].integrator", Type::choice, "", kAny, "", true, "explicit|implicit|partitioned",
     "Time integration. partitioned: some blocks take explicit steps, the others implicit ones; the keys "
     "explicit_... and implicit_... select them."},
    {"stage[].dt", Type::number_or_auto, "s", kTime, "\"auto\"", false, "",
     "Time step. \"auto\", for explicit stages only, is safety times the certified stability bound. In "
     "partitioned stages the step of the other blocks (see slow_blocks), which substeps divide."},
    {"stage[].force_dt", Type::boolean, "", kAny, "false", false, "",
     "Accept an explicit dt, or substeps, above the certified bound, for studies of stability, and a dt above "
     "what slow_blocks = \"explicit\" allows; the run reports it."},
    {"stage[].duration", Type::number, "s", kTime, "", true, "", "Simulated time of the stage."},
    {"stage[].safety", Type::number, "", kSafety, "0.8", false, "",
     "Fraction of the stability bound that dt = \"auto\" and automatic substeps use."},
    {"stage[].cover_size", Type::number, "m", kPositive, "(model.cover_size)", false, "",
     "Size of the mathematical covers, for blocks without a cover_size of their own. Required, here or in model, "
     "if such a block uses the NMM."},
    {"stage[].kinematics", Type::choice, "", kAny, "\"corotational\"", false, "corotational|linear",
     "Kinematics of the NMM: small strain in a frame that turns with the rock, or small strain and small "
     "rotation, for comparisons with linear theory."},
    {"stage[].mass", Type::choice, "", kAny, "\"auto\"", false, "auto|affine-exact|lumped|consistent",
     "Mass of the NMM. lumped: row sums; affine-exact, explicit: row sums corrected so that mass, momenta and "
     "rotational "
     "inertia are exact; consistent, implicit: the full matrix. \"auto\" is affine-exact in explicit stages, "
     "consistent "
     "in implicit ones."},
    {"stage[].rotation", Type::choice, "", kAny, "(\"exact\", in implicit stages with the DDA)", false,
     "exact|affine|first-order",
     "Implicit steps of DDA blocks. exact: six unknowns relative to the block's position, then an exact rotation, "
     "which neither slows nor speeds up a free spin; affine: position and gradient by Newton's method, the steps "
     "of a onefold cover of the NMM, which have centrifugal terms and damp a spin w by w dt/2 per radian; "
     "first-order: the linear update of the original DDA, which lengthens the edges of a block by sqrt(1 + r0^2) "
     "in a step that turns it by r0, kept to reproduce this effect; only for integrator = \"implicit\"."},
    {"stage[].cracks", Type::boolean, "", kAny, "(true where a block uses the NMM)", false, "",
     "Cut the covers of the NMM along the cracks of its blocks. The two faces of a straight crack are in contact "
     "by its joint law. Stages of DDA, whose blocks deform as a whole, have no cracks."},
    {"stage[].damping", Type::number, "1/s", kNotNegative, "0.0", false, "",
     "Mass-proportional damping, on velocities minus their affine part, so that sliding is not slowed."},
    {"stage[].damp_rigid_motion", Type::boolean, "", kAny, "false", false, "",
     "Let damping act on the whole velocity. Requires damping."},
    {"stage[].stiffness_damping", Type::number, "s", kNotNegative, "0.0", false, "",
     "Rayleigh damping proportional to stiffness; rigid motion is not damped. It lowers the stable explicit step."},
    {"stage[].local_damping", Type::number, "", kBelowOne, "0.0", false, "",
     "Local damping of explicit steps: a force against the velocity, this fraction of the unbalanced force. For "
     "statics."},
    {"stage[].sliding_damping", Type::number, "", kFraction, "1.0", false, "",
     "Damping of the deformation of free blocks that slide, a fraction of critical for the lowest frequency of "
     "the block, in proportion to the share of its contact force that slips. It slows neither sliding nor spin; "
     "without it blocks on steep planes vibrate and lose friction. Stacked blocks that still lose friction are "
     "also damped along the normals of their contacts. It is not attenuation of rock; 0 turns it off."},
    {"stage[].newmark", Type::choice, "", kAny, "(\"damped\", in implicit stages)", false, "damped|trapezoidal",
     "Newmark's scheme of implicit steps. damped: beta 1/2, gamma 1; trapezoidal: beta 1/4, gamma 1/2, for studies "
     "without contacts."},
    {"stage[].transfer", Type::choice, "", kAny, "\"reservoir\"", false, "reservoir|strain-rate|rotational",
     "Treatment of the non-affine velocity of blocks that change method as the stage begins, or by switch. "
     "reservoir: stored with its energy, and returned when the block returns to its mesh; strain-rate: raises the "
     "strain rates of the block, up to transfer_cap, the rest goes to the reservoir; rotational: converted to "
     "spin as in the source, which conserves neither angular momentum nor energy. Not in the first stage, unless "
     "it has switch."},
    {"stage[].transfer_cap", Type::number, "", kCap, "1.1", false, "",
     "Largest factor of the strain rates. Requires transfer = \"strain-rate\"."},
    {"stage[].dynamics", Type::number, "", kFraction, "(1, in implicit stages without rest)", false, "",
     "Fraction of the velocity that an implicit step passes to the next: 1 dynamic, 0 static."},
    {"stage[].rest", Type::boolean, "", kAny, "false", false, "",
     "Bring the model to rest: explicit steps set all velocities to zero when the kinetic energy has passed a "
     "peak, implicit ones after every step (a static solution). Meant for gravity before a motion starts."},
    {"stage[].rest_force", Type::number, "", kSafety, "", false, "",
     "The stage ends once no unbalanced force is above this fraction of the largest force; if that is not reached "
     "within the duration, the run fails. Requires rest."},
    {"stage[].rest_steps", Type::integer, "", kCount, "(until the duration ends)", false, "",
     "Steps within which rest_force has to be reached. Requires rest_force."},
    {"stage[].max_passes", Type::integer, "", kPasses, "12", false, "",
     "Open-close passes of an implicit step before it is cut; passes that halve the number of contact points that "
     "change state are not counted."},
    {"stage[].max_displacement", Type::number_or_auto, "m", kPositive, "\"auto\"", false, "",
     "Largest displacement in a step. \"auto\" is a hundredth of the width of the smallest block."},
    {"stage[].sleep", Type::number, "", kSleep, "0.0", false, "",
     "Threshold of rest. Blocks whose motion is below this fraction of their elastic compression take no steps once "
     "all "
     "blocks near them are at rest too, until something acts on them: another block comes near, a load or the base "
     "below them changes, the next stage begins. Results agree to about this fraction; 0: all blocks take all steps."},
    {"stage[].explicit_blocks", Type::names, "", kAny, "", false, "",
     "Partitioned stages: names of the blocks that take explicit steps; * stands for any characters. Patterns "
     "skip blocks that are held whole. At least one key explicit_... is required."},
    {"stage[].implicit_blocks", Type::names, "", kAny, "", false, "",
     "Partitioned stages: names of blocks that take implicit steps whatever their area and motion; as "
     "explicit_blocks."},
    {"stage[].explicit_region", Type::ring, "m", kCoordinate, "", false, "",
     "Partitioned stages: blocks inside take explicit steps, unless they are named. A block across its border, "
     "which must use the NMM with a mesh, is divided: elements whose centroid was initially inside take explicit "
     "steps, the others implicit ones, and interface forces hold the covers of both together without work. Blocks "
     "that are held or driven take no steps and are not divided."},
    {"stage[].explicit_area", Type::number, "m2", kPositive, "", false, "",
     "Partitioned stages: blocks that are smaller take explicit steps, unless they are named."},
    {"stage[].explicit_speed", Type::number, "m/s", kPositive, "", false, "",
     "Partitioned stages: other blocks become explicit once a corner moves faster."},
    {"stage[].implicit_speed", Type::number, "m/s", kPositive, "(half of explicit_speed)", false, "",
     "They become implicit again once all corners move more slowly. Less than explicit_speed, which it requires."},
    {"stage[].explicit_strain_rate", Type::number, "1/s", kPositive, "", false, "",
     "Partitioned stages: other blocks become explicit once their largest principal strain rate, of the affine "
     "part of the motion, is above this. With explicit_speed as well, either is enough."},
    {"stage[].implicit_strain_rate", Type::number, "1/s", kPositive, "(half of explicit_strain_rate)", false, "",
     "They become implicit again once it is below this. Less than explicit_strain_rate, which it requires."},
    {"stage[].shared_contacts", Type::boolean, "", kAny, "false", false, "",
     "Partitioned stages: one contact algorithm, the explicit one, for all contacts. false: contacts between implicit "
     "blocks are those of the open-close iteration, the others explicit (thesis, figure 7.6)."},
    {"stage[].substeps", Type::integer, "", kCount, "(as many as the certified bound requires)", false, "",
     "Partitioned stages: explicit steps per dt of the other blocks."},
    {"stage[].slow_blocks", Type::choice, "", kAny, "(\"implicit\", in partitioned stages)", false, "implicit|explicit",
     "Partitioned stages: steps of the other blocks. explicit: the same as those of the explicit blocks, except "
     "that their internal force is evaluated once per dt, which may be 0.5/w at most, with w the bound of their "
     "own frequencies; implicit_... then selects these blocks. Contacts, loads and supports act in every step. A "
     "block cannot be divided."},
    {"stage[].excavate", Type::names, "", kAny, "", false, "",
     "Names of the blocks that are removed as the stage begins; * stands for any characters. The forces that they "
     "carried are released as set by release. Loads, supports and water that act on them are removed too. Not in "
     "the first stage."},
    {"stage[].excavate_in", Type::ring, "m", kCoordinate, "", false, "",
     "Blocks whose centroid is inside in the initial model are removed too."},
    {"stage[].fill", Type::names, "", kAny, "", false, "",
     "Names of the blocks that are added as the stage begins: backfill, embankments, stages of a dam; * stands "
     "for any characters. They are placed where the case defines them, at rest, without stress and without bonds. "
     "A block that a stage fills before any has excavated it is absent from the start. Not in the first stage."},
    {"stage[].fill_in", Type::ring, "m", kCoordinate, "", false, "",
     "Blocks whose centroid is inside, where the case defines them, are added too."},
    {"stage[].release", Type::number, "", kFraction, "(1, in stages that excavate)", false, "",
     "Fraction of the forces of excavated blocks on the remaining blocks that is released by the end of the "
     "stage; the rest continues to act, as the support of a nearby face does. It counts what this stage excavates "
     "and what earlier ones have not released; a later stage may release more."},
    {"stage[].release_time", Type::number, "s", kTime, "(at once)", false, "",
     "Time from the beginning of the stage over which they are released, linearly. Rules do not end a stage "
     "before that. Requires excavate, excavate_in or release."},
    {"stage[].end", Type::table, "", kAny, "", false, "",
     "Rules that end the stage before its duration is over, whichever is met first; later stages begin earlier."},
    {"stage[].end.kinetic_below", Type::number, "", kBelowOneOpen, "", false, "",
     "Kinetic energy, as a fraction of the largest of the stage so far."},
    {"stage[].end.force_below", Type::number, "", kSafety, "", false, "",
     "The largest unbalanced force, as a fraction of the largest force, as in rest_force."},
    {"stage[].end.hold", Type::number, "s", kTime, "", false, "",
     "Time for which the two rules above have to hold without a break; without it an instant is enough, such as a "
     "turning point."},
    {"stage[].end.slip", Type::number, "m", kPositive, "", false, "",
     "Slip of a joint: the largest between two blocks, minus its value as the stage began."},
    {"stage[].end.displacement", Type::number, "m", kPositive, "", false, "",
     "Displacement of the centre of mass of a block since the stage began."},
    {"stage[].strength", Type::table, "", kAny, "", false, "",
     "Joint laws lose strength during the stage, or have less throughout: weathering, reduction. Not in "
     "partitioned stages. The next stage has the strengths of the model again, unless it sets strength itself."},
    {"stage[].strength.factor", Type::number, "", kPositive, "", true, "",
     "tan phi, cohesion, tensile strength and tan psi, peak and residual, are divided by it at the end of the "
     "stage."},
    {"stage[].strength.from", Type::number, "", kPositive, "(factor)", false, "",
     "The factor at the beginning of the stage; in between it changes by equal ratios."},
    {"stage[].strength.joints", Type::names, "", kAny, "(all)", false, "",
     "Names of the joint laws; * stands for any characters."},
    {"stage[].switch", Type::table, "", kAny, "", false, "",
     "Blocks change between the NMM and the DDA during the stage, each according to its own motion; every change "
     "is an event. Excluded are held blocks, onefold covers, other methods and blocks with cracks (unless cracks "
     "= false)."},
    {"stage[].switch.blocks", Type::names, "", kAny, "(all that can)", false, "",
     "Names of the blocks that may change; * stands for any characters."},
    {"stage[].switch.kinetic", Type::number, "", kSafety, "", true, "",
     "dT over the energy of the block: a block changes to the DDA once the kinetic energy of its non-affine "
     "motion is not above this fraction of its kinetic and elastic energy. Requires elastic and hold."},
    {"stage[].switch.elastic", Type::number, "", kSafety, "", true, "",
     "dU over the same energy: the elastic energy in addition to that of its affine stress."},
    {"stage[].switch.inhomogeneity", Type::number, "", kSafety, "", false, "",
     "If given, the inhomogeneity of its strain, sqrt(dU/U), must not be above this either."},
    {"stage[].switch.hold", Type::number, "s", kTime, "", true, "",
     "Time for which all of this has to hold, evaluated at intervals of a tenth of it; then the block changes if "
     "that lowers the predicted cost of its steps."},
    {"stage[].switch.back", Type::table, "", kAny, "", false, "",
     "A block of the DDA changes to the NMM once one of these is above its bound. Without it blocks stay with the "
     "DDA."},
    {"stage[].switch.back.strain_rate", Type::number, "1/s", kPositive, "", false, "",
     "Largest principal strain rate of the affine part of its motion."},
    {"stage[].switch.back.stress", Type::number, "Pa", kPositive, "", false, "",
     "Largest principal stress of its affine part, tension or compression."},
    {"stage[].switch.back.acceleration", Type::number, "m/s2", kPositive, "", false, "",
     "Resultant of its contact forces over its mass: 9.81 for a block that lies at rest."},
    {"stage[].method_of", Type::table_list, "", kAny, "", false, "", "Blocks that use another method in this stage."},
    {"stage[].method_of[].blocks", Type::names, "", kAny, "", true, "",
     "Names of the blocks; * stands for any characters."},
    {"stage[].method_of[].method", Type::name, "", kAny, "", true, "", "Their method."},
    {"stage[].method_of[].cover_size", Type::number, "m", kPositive, "(that of the block or the stage)", false, "",
     "Size of the mathematical covers of the NMM in these blocks."},
    {"stage[].method_of[].onefold", Type::boolean, "", kAny, "false", false, "",
     "One cover around the whole block, in place of a mesh: six unknowns. NMM only."},
    {"stage[].method_of[].triangle", Type::choice, "", kAny, "\"own\"", false, "own|model",
     "Triangle of onefold covers: one around each block, or one around the whole model, whose stars are in the "
     "same places for all blocks (thesis 7.3.1). Motion and stress are the same except for round-off."},

    {"reduction", Type::table, "", kAny, "(no reduction)", false, "",
     "Reduction of the strength of joints: what `scree fos` sets in its runs. The leading stages with rest are "
     "kept, or one is added; the others are replaced by static steps in which the factor grows, static steps to "
     "balance, and a dynamic stage. Motions and loads of later stages are left out."},
    {"reduction.factor", Type::number, "", kPositive, "(the stages to rest alone)", false, "",
     "tan phi, cohesion, tensile strength and tan psi, peak and residual, are divided by it at the end."},
    {"reduction.start", Type::number, "", kPositive, "1.0", false, "", "The factor in the stages to rest."},
    {"reduction.joints", Type::names, "", kAny, "(all)", false, "",
     "Names of the joint laws that are reduced; * stands for any characters."},
    {"reduction.what", Type::choice, "", kAny, "\"all\"", false, "all|friction|cohesion",
     "Which strengths are divided; friction: tan phi and tan psi alone; cohesion: cohesion and tensile strength "
     "alone."},
    {"reduction.strength", Type::choice, "", kAny, "\"peak\"", false, "peak|as-is",
     "peak: residual strengths of these laws are set to their peaks, as limit equilibrium assumes, and friction "
     "does not change with motion; as-is: they weaken as defined."},
    {"reduction.method", Type::name, "", kAny, "(that of the last stage to rest)", false, "",
     "Method of the stages after the rest, for all blocks."},
    {"reduction.integrator", Type::choice, "", kAny, "(that of the last stage to rest)", false, "explicit|implicit",
     "Time integration of the stages after the rest."},
    {"reduction.rest_integrator", Type::choice, "", kAny, "(that of the stages to rest)", false, "explicit|implicit",
     "Time integration of the stages to rest, in place of theirs."},
    {"reduction.dt", Type::number, "s", kTime, "(two traverses of a pressure wave through the free blocks)", false, "",
     "Static step, implicit."},
    {"reduction.hold", Type::number, "s", kTime, "5.0", false, "", "Duration of the dynamic stage, at most."},
    {"reduction.limit", Type::number, "m", kPositive, "(5e-3 of the root of the smallest free block's area)", false, "",
     "Displacement of a block that ends a stage: the block has failed if it accelerates."},
    {"reduction.rest_force", Type::number, "", kSafety, "1e-5", false, "",
     "As stage.rest_force, for a last stage to rest that has none."},
    {"reduction.k_h", Type::number, "", kCoefficient, "0.0", false, "",
     "Pseudo-static coefficient: gravity has a component of k_h times its size along x, from the start."},

    {"output", Type::table, "", kAny, "", false, "",
     "What is written and how often. These keys do not change the steps: output is written at the first step at "
     "or after its time."},
    {"output.every", Type::number, "s", kTime, "(a hundredth of the run)", false, "", "Simulated time between frames."},
    {"output.history_every", Type::number, "s", kTime, "(output.every)", false, "",
     "Simulated time between samples of monitors and energies."},
    {"output.contacts", Type::boolean, "", kAny, "false", false, "",
     "Write the contact points of every frame: place, state, forces, gap and slip."},
    {"output.checkpoint_every", Type::number, "s", kNotNegative, "60.0", false, "",
     "Wall-clock time between checkpoints, from which `scree resume` continues; 0: none by the clock. One is "
     "written in any case when the run begins, when a stage ends and when the run is stopped. Results do not "
     "depend on it."},
    {"output.checkpoint_steps", Type::integer, "", kIndex, "0", false, "",
     "Steps between checkpoints, in addition to checkpoint_every; 0: none by steps. For tests and for runs that "
     "must write the same files each time."},

    {"live", Type::table, "", kAny, "", false, "", "Streaming of the running model over LCM."},
    {"live.enabled", Type::boolean, "", kAny, "false", false, "", "Stream the run."},
    {"live.url", Type::text, "", kAny, "\"udpm://239.255.76.67:7667?ttl=0\"", false, "",
     "Address: udpm:// multicast, memq:// within the process, file:// an LCM log."},
    {"live.rate", Type::number, "Hz", kFrameRate, "30.0", false, "", "Frames per second of wall-clock time, at most."},
    {"live.field", Type::choice, "", kAny, "\"speed\"", false,
     "speed|mean_stress|s1|s3|shear|sxx|syy|sxy|joint|integrator",
     "The scalar of each cell that is sent with the displacements (live.md explains them); `scree control RUN "
     "field NAME` and the page of `scree view --live --control` change it during the run."},

    {"run", Type::table, "", kAny, "", false, "", "How the program runs."},
    {"run.threads", Type::integer, "", kThreads, "0", false, "",
     "Threads; 0: as many as the machine has. Results do not depend on it."},
    {"run.max_closure", Type::number, "", kNotNegative, "0.0", false, "",
     "A run ends as not converged once its energy ledger is open by more than this fraction of the energy moved, "
     "checked every 100 steps of a stage and at its end; 0: never. Scree guarantees 1e-9."},
    {"run.max_passed_closure", Type::number, "", kNotNegative, "1e-3", false, "",
     "The same, as a fraction of the energy passed: the largest so far of the energy at the start and the work "
     "done, or the energy held now. A blow-up inflates the energy moved, not this. 0: never."},
    {"run.max_gain", Type::number, "", kNotNegative, "1.0", false, "",
     "A run ends as not converged once the blocks hold more energy than they were given, by more than this "
     "fraction of the energy passed, as by steps that are too long or a wrong force. 0: never."},
    {"run.max_slowdown", Type::number, "", kNotNegative, "20.0", false, "",
     "A run ends as not converged once a partitioned stage has taken more than so many times the effort that "
     "implicit steps of its dt would have taken, counted in operations, with an allowance of 20 steps at its "
     "beginning. 0: never."},
};

}  // namespace

namespace {

/// Appends a table and its numbers. Keys refer to the texts of registered methods and laws in place; the paths made
/// here are stored in `paths`.
void append(std::vector<Key>& keys, const std::string& path, std::string_view meaning,
            std::span<const NumberKey> numbers) {
  static std::deque<std::string> paths;
  const std::string& table = paths.emplace_back(path);
  keys.push_back({table, Type::table, "", kAny, "", false, "", meaning});
  for (const NumberKey& key : numbers)
    keys.push_back({paths.emplace_back(table + "." + key.name), Type::number, key.unit,
                    Range{key.low, key.high, key.low_open, key.high_open}, key.fallback, key.fallback.empty(), "",
                    key.meaning});
}

void insert_after(std::vector<Key>& keys, std::string_view section, const std::vector<Key>& added) {
  const auto last = std::find_if(keys.rbegin(), keys.rend(), [&](const Key& k) { return k.path.starts_with(section); });
  keys.insert(last.base(), added.begin(), added.end());
}

/// The keys of friction laws follow those of the joints that they belong to; those of methods follow those of stages.
std::vector<Key> with_registered() {
  std::vector<Key> keys(std::begin(kKeys), std::end(kKeys));
  std::vector<Key> laws, methods;
  methods.push_back({"method", Type::table, "", kAny, "", false, "", "Constants of methods of libraries (--load)."});
  for (const FrictionLaw& law : coupling::friction_laws())
    append(laws, "joint.NAME." + law.name, law.meaning, law.keys);
  for (const coupling::Method& m : coupling::registered_methods()) {
    if (m.keys.empty()) continue;
    append(methods, "method." + m.name, m.meaning, m.keys);
  }
  insert_after(keys, "joint.", laws);
  insert_after(keys, "stage", methods);
  return keys;
}

}  // namespace

std::span<const Key> schema() {
  static const std::vector<Key> kAll = with_registered();
  return kAll;
}

}  // namespace scree::io
