#include "io/case/schema.h"

namespace scree::io {
namespace {

constexpr Range kAny{};
constexpr Range kPositive{.low = 0.0, .low_open = true};
constexpr Range kNotNegative{.low = 0.0};
constexpr Range kFraction{.low = 0.0, .high = 1.0};
constexpr Range kPoisson{.low = 0.0, .high = 0.5, .high_open = true};
constexpr Range kFriction{.low = 0.0, .high = 90.0, .high_open = true};
constexpr Range kTurn{.low = -360.0, .high = 360.0};
constexpr Range kSafety{.low = 0.0, .high = 1.0, .low_open = true};
constexpr Range kPasses{.low = 1.0, .high = 1000.0};
constexpr Range kFrameRate{.low = 0.0, .high = 1000.0, .low_open = true};
constexpr Range kThreads{.low = 0.0, .high = 1024.0};
constexpr Range kCoordinate{.low = -1e9, .high = 1e9};
constexpr Range kStart{.low = 0.0, .high = 1e6};
constexpr Range kTime{.low = 1e-12, .high = 1e6};  // one tick to 11 days: sums of stages stay within 64-bit ticks

// path, type, unit, range, fallback, required, choices, meaning
constexpr Key kKeys[] = {
    {"title", Type::text, "", kAny, "\"\"", false, "", "What the run is about; shown in results and pictures."},

    {"model", Type::table, "", kAny, "", false, "", "What holds for the whole model."},
    {"model.plane", Type::choice, "", kAny, "\"strain\"", false, "strain|stress", "Plane strain or plane stress."},
    {"model.gravity", Type::point, "m/s2", kAny, "[0.0, -9.81]", false, "", "Acceleration of gravity, x right, y up."},
    {"model.detection", Type::number_or_auto, "m", kPositive, "\"auto\"", false, "",
     "Distance below which corners and edges are watched for contact."},
    {"model.default_joint", Type::name, "", kAny, "(the only joint)", false, "",
     "Joint law of edges that name none. Needed where more than one joint is defined. Without any joint the law is "
     "\"smooth\": no friction, no cohesion."},
    {"model.cover_size", Type::number, "m", kPositive, "", false, "",
     "Size of the mathematical covers of the NMM, for stages that give none."},

    {"material", Type::named_tables, "", kAny, "", true, "", "A rock or soil; blocks refer to it by NAME."},
    {"material.NAME.density", Type::number, "kg/m3", kPositive, "", true, "", "Mass density."},
    {"material.NAME.young", Type::number, "Pa", kPositive, "", true, "", "Young's modulus."},
    {"material.NAME.poisson", Type::number, "", kPoisson, "", true, "", "Poisson's ratio."},

    {"joint", Type::named_tables, "", kAny, "", false, "", "A Coulomb law of block edges; blocks refer to it by NAME."},
    {"joint.NAME.friction_deg", Type::number, "deg", kFriction, "", true, "", "Friction angle."},
    {"joint.NAME.cohesion", Type::number, "Pa", kNotNegative, "0.0", false, "",
     "Cohesion; lost where the joint first opens or slips."},
    {"joint.NAME.contact_length", Type::number, "m", kPositive, "", false, "",
     "Length of joint that one contact point stands for; cohesion acts on it. Needed where cohesion is not zero."},
    {"joint.NAME.penalty", Type::number_or_auto, "N/m", kPositive, "\"auto\"", false, "",
     "Normal stiffness of a contact. \"auto\" is K + 4G/3 of the softer of the two blocks."},
    {"joint.NAME.shear_penalty", Type::number_or_auto, "N/m", kPositive, "\"auto\"", false, "",
     "Tangential stiffness of a contact. \"auto\" is the normal stiffness."},
    {"joint.NAME.damping", Type::number, "", kFraction, "0.2", false, "",
     "Damping of closed contacts in explicit steps, a fraction of critical."},

    {"motion", Type::named_tables, "", kAny, "", false, "", "A recorded ground motion; supports refer to it by NAME."},
    {"motion.NAME.file", Type::text, "", kAny, "", true, "",
     "A PEER record if it is called .AT2. Otherwise two columns, time [s] and acceleration, separated by comma, "
     "semicolon or space; # begins a comment; one line of headings may come first; the times follow at equal steps. "
     "Relative to the case file; a leading \"$SCREE_RECORDS/\" is replaced by that environment variable."},
    {"motion.NAME.unit", Type::choice, "", kAny, "(as the file says)", false, "m/s2|g|cm/s2",
     "Unit of the accelerations in the file; g is 9.80665 m/s2. Needed where the file does not say it, as .AT2 does."},
    {"motion.NAME.start", Type::number, "s", kStart, "0.0", false, "",
     "Simulated time at which the first sample that is kept acts. Before it the ground rests; after the last sample it "
     "moves on at its final velocity."},
    {"motion.NAME.from", Type::number, "s", kAny, "(first sample)", false, "",
     "Where the part of the record begins that is kept, in the time of the record (.AT2 counts from 0)."},
    {"motion.NAME.until", Type::number, "s", kAny, "(last sample)", false, "",
     "Where the part of the record ends that is kept, in the time of the record."},
    {"motion.NAME.resample", Type::number, "s", kPositive, "(as recorded)", false, "",
     "Step of new samples, read off the lines between the recorded ones and rounded down to a part of the duration. "
     "Also accepts records whose steps are not equal."},
    {"motion.NAME.baseline", Type::choice, "", kAny, "\"none\"", false, "none|constant|linear|quadratic",
     "Drift that is taken off: the polynomial in time, of degree 0, 1 or 2 in the acceleration, that leaves the ground "
     "at rest at the end and the mean square of its velocity least."},
    {"motion.NAME.taper", Type::number, "s", kNotNegative, "0.0", false, "",
     "Length at either end over which half a cosine bell leads the acceleration from and to zero. The baseline is "
     "corrected before and once more after it."},
    {"motion.NAME.pga", Type::number, "m/s2", kPositive, "", false, "",
     "Peak of the acceleration that the motion is scaled to, after all else. Either this or scale."},
    {"motion.NAME.scale", Type::number, "", kAny, "(1)", false, "", "Factor on the accelerations."},
    {"motion.NAME.integration", Type::choice, "", kAny, "\"linear\"", false, "linear|constant",
     "Acceleration between samples: straight from one to the next, or staying until the next. Either is integrated "
     "exactly at any time, whatever the time steps."},
    {"motion.NAME.direction", Type::point, "", kAny, "(along x)", false, "",
     "Direction of positive accelerations; only its direction counts. Either this or direction_deg."},
    {"motion.NAME.direction_deg", Type::number, "deg", kTurn, "(along x)", false, "",
     "Direction of positive accelerations, counter-clockwise from +x."},

    {"block", Type::table_list, "", kAny, "", true, "", "A block. Blocks may touch but not overlap."},
    {"block[].name", Type::name, "", kAny, "", true, "", "Name, given once only."},
    {"block[].polygon", Type::ring, "m", kCoordinate, "", true, "",
     "Corners in order around the block, either way round; the first is not repeated at the end."},
    {"block[].holes", Type::rings, "m", kCoordinate, "[]", false, "", "Holes in the block, each a list of corners."},
    {"block[].material", Type::name, "", kAny, "", true, "", "Name of a material."},
    {"block[].joint", Type::name, "", kAny, "(model.default_joint)", false, "", "Joint law of the edges of the block."},
    {"block[].edge_joints", Type::names, "", kAny, "[]", false, "",
     "Joint laws, one an edge: the first for the edge from the first corner of polygon to the second. \"\" stands for "
     "the joint of the block."},
    {"block[].velocity", Type::point, "m/s", kAny, "[0.0, 0.0]", false, "", "Initial velocity of the centroid."},
    {"block[].spin", Type::number, "rad/s", kAny, "0.0", false, "", "Initial angular velocity, counter-clockwise."},

    {"support", Type::table_list, "", kAny, "", false, "",
     "What holds blocks: whole blocks fixed or moving with the ground, or points on springs."},
    {"support[].block", Type::name, "", kAny, "", false, "", "Name of the block. Either this or blocks."},
    {"support[].blocks", Type::names, "", kAny, "", false, "", "Names of several blocks that are held whole."},
    {"support[].fix", Type::choice, "", kAny, "\"all\"", false, "all|x|y",
     "Directions that are held. A whole block is held in all."},
    {"support[].point", Type::point, "m", kCoordinate, "", false, "",
     "Point of the block, on its outline or inside, that a spring ties to its place. Without it the whole block is "
     "held."},
    {"support[].stiffness", Type::number_or_auto, "N/m", kPositive, "\"auto\"", false, "",
     "Stiffness of the spring at the point. \"auto\" is 10 (K + 4G/3) of the block."},
    {"support[].motion", Type::name, "", kAny, "", false, "", "Name of a ground motion that the whole block follows."},

    {"monitor", Type::table_list, "", kAny, "", false, "", "A point whose history is written."},
    {"monitor[].block", Type::name, "", kAny, "", true, "", "Name of the block."},
    {"monitor[].point", Type::point, "m", kCoordinate, "", true, "",
     "The point where the model starts, on the outline of the block or inside."},
    {"monitor[].name", Type::name, "", kAny, "(BLOCK#1, BLOCK#2, ...)", false, "",
     "Name in the results, given once only."},

    {"stage", Type::table_list, "", kAny, "", true, "", "A part of the run; stages follow one another."},
    {"stage[].name", Type::name, "", kAny, "", true, "", "Name, given once only."},
    {"stage[].method", Type::name, "", kAny, "", true, "", "Discretisation of the blocks: \"nmm\" or \"dda\"."},
    {"stage[].integrator", Type::choice, "", kAny, "", true, "explicit|implicit",
     "Time integration. The NMM is explicit."},
    {"stage[].dt", Type::number_or_auto, "s", kTime, "\"auto\"", false, "",
     "Time step. \"auto\", for explicit stages only, is safety times the certified stability bound."},
    {"stage[].duration", Type::number, "s", kTime, "", true, "", "Simulated time of the stage."},
    {"stage[].safety", Type::number, "", kSafety, "0.8", false, "",
     "Fraction of the stability bound that dt = \"auto\" takes."},
    {"stage[].cover_size", Type::number, "m", kPositive, "(model.cover_size)", false, "",
     "Size of the mathematical covers. Needed, here or in model, where a block of the stage uses the NMM."},
    {"stage[].damping", Type::number, "1/s", kNotNegative, "0.0", false, "",
     "Mass-proportional damping of explicit steps, on velocities less their affine part, so that sliding is not "
     "slowed."},
    {"stage[].max_passes", Type::integer, "", kPasses, "12", false, "",
     "Open-close passes of an implicit step before it is cut."},
    {"stage[].max_displacement", Type::number_or_auto, "m", kPositive, "\"auto\"", false, "",
     "Largest displacement in a step. \"auto\" is a hundredth of the width of the smallest block."},
    {"stage[].method_of", Type::table_list, "", kAny, "", false, "", "Blocks that use another method in this stage."},
    {"stage[].method_of[].blocks", Type::names, "", kAny, "", true, "", "Names of the blocks."},
    {"stage[].method_of[].method", Type::name, "", kAny, "", true, "", "Their method."},

    {"output", Type::table, "", kAny, "", false, "", "What is written and how often."},
    {"output.every", Type::number, "s", kTime, "(a hundredth of the run)", false, "", "Simulated time between frames."},
    {"output.history_every", Type::number, "s", kTime, "(output.every)", false, "",
     "Simulated time between samples of monitors and energies."},

    {"live", Type::table, "", kAny, "", false, "", "Streaming of the running model over LCM."},
    {"live.enabled", Type::boolean, "", kAny, "false", false, "", "Stream."},
    {"live.url", Type::text, "", kAny, "\"udpm://239.255.76.67:7667?ttl=0\"", false, "",
     "Where to: udpm:// multicast, memq:// within the process, file:// an LCM log."},
    {"live.rate", Type::number, "Hz", kFrameRate, "30.0", false, "", "Frames in a second of wall time, at most."},

    {"run", Type::table, "", kAny, "", false, "", "How the program runs."},
    {"run.threads", Type::integer, "", kThreads, "0", false, "",
     "Threads; 0 takes as many as the machine has. Results do not depend on it."},
};

}  // namespace

std::span<const Key> schema() { return kKeys; }

bool Range::holds(double value) const {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

const Key* find_key(std::string_view path) {
  for (const Key& k : kKeys)
    if (k.path == path) return &k;
  return nullptr;
}

std::string_view last_part(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? path : path.substr(dot + 1);
}

std::string_view parent_of(std::string_view path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string_view::npos ? std::string_view{} : path.substr(0, dot);
}

}  // namespace scree::io
