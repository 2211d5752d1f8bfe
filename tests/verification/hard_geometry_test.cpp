// Vertices on vertices, collinear edges, slivers and minute gaps: the results are compared with those of the same scene
// moved, turned and scaled, and must agree within 1e-6 of the largest displacement and of a block's weight.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "coupling/contact/table/contact_point.h"
#include "model/local_origin.h"
#include "tests/support/schemes.h"

namespace scree::test::hard_geometry_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2600.0, kYoung = 1e9;
constexpr double kStiffness = 1e9;  // of joints [Pa/m]

/// A scene in metres, its blocks about 1 m wide.
struct Geometry {
  std::string name;
  std::function<void(Scene&)> build;
  double explicit_step, implicit_step;  // [s]
  bool explicit_too = true;
};

/// x -> R s x + shift. Gravity turns and grows by s, moduli by s^2 and stiffness per area by s: times, angles and
/// strains stay, velocities and lengths grow by s, forces by s^3.
struct Place {
  std::string name;
  double scale = 1.0, turn = 0.0;
  Vec2 shift{0.0, 0.0};
};

Scene placed(Scene scene, const Place& place) {
  const Mat2 R = rotation(place.turn);
  const double s = place.scale;
  Model& model = scene.model;
  for (Block& b : model.blocks) b.polygon = transformed(b.polygon, place.shift, s * R);
  model.gravity = s * (R * model.gravity);
  for (Material& m : model.materials) m.young *= s * s;
  for (JointLaw& law : model.joints)
    if (law.normal_stiffness) *law.normal_stiffness *= s;
  for (InitialVelocity& v : model.initial_velocities) v.velocity = s * (R * v.velocity);
  for (Stage& stage : scene.plan.stages) stage.cover_size *= s;
  move_to_local_origin(model);  // as the reader of cases does
  return scene;
}

/// Forces between pairs of blocks and displacements of the blocks, in the units and axes of the original scene.
struct Frame {
  std::vector<Vec2> displacement;
  std::map<std::pair<std::int32_t, std::int32_t>, Vec2> force;  // on the first block of the pair [N]
};

Frame frame_of(const Driver& run, const Model& model, const Place& place) {
  const Mat2 back = rotation(-place.turn);
  const State& state = run.state();
  const Outlines& o = run.setup().outlines();
  Frame frame;
  for (const Body& b : run.setup().bodies())
    frame.displacement.push_back(
        back * (totals_of(run.setup(), state, b).centre - moments(model.blocks[b.block.index()].polygon).centroid) /
        place.scale);
  for (const ContactMemory& m : state.contacts) {
    if (m.status == ContactStatus::open) continue;
    const auto x = [&](OutlineNode node) { return position(o.nodes[node], state.q); };
    const EdgeIndex edge_p = run.setup().edge_of(m.key.block_p, m.key.ring_p, m.key.vertex),
                    edge_e = run.setup().edge_of(m.key.block_e, m.key.ring_e, m.key.edge);
    const VertexIndex vertex = o.edges[edge_p].first_vertex() + m.key.part;
    const SegmentIndex segment = o.edges[edge_e].first_segment + m.segment;
    const ContactGeometry g =
        contact_geometry(x(o.vertices[vertex].node), x(o.segments[segment].a), x(o.segments[segment].b));
    const Vec2 on_p = back * (m.fn * g.n + m.ft * g.t) / std::pow(place.scale, 3);
    Vec2& sum = frame.force.try_emplace(std::minmax(m.key.block_p, m.key.block_e), Vec2(0.0, 0.0)).first->second;
    sum += m.key.block_p < m.key.block_e ? on_p : Vec2(-on_p);
  }
  return frame;
}

constexpr int kFrames = 6, kSteps = 240;

struct Outcome {
  std::vector<Frame> frames;
  double closure = 0.0;
};

Outcome run_at(const Scene& original, const Place& place) {
  const Scene scene = placed(original, place);
  Driver run(scene.model, scene.plan, methods());
  Outcome out;
  Watch watch;
  watch.see = [&](const FrameView&) { out.frames.push_back(frame_of(run, scene.model, place)); };
  run.add_sink(watch);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << place.name << ": " << end.reason;
  out.closure = run.state().ledger.relative_closure();
  return out;
}

struct Difference {
  double displacement = 0.0, largest_displacement = 0.0;  // [m]
  double force = 0.0;                                     // of the weight of a block of 1 m2
};
Difference compare(const std::vector<Frame>& a, const std::vector<Frame>& b) {
  Difference d;
  EXPECT_EQ(a.size(), b.size());
  for (std::size_t f = 0; f < std::min(a.size(), b.size()); ++f) {
    for (std::size_t i = 0; i < a[f].displacement.size(); ++i) {
      d.displacement = std::max(d.displacement, (a[f].displacement[i] - b[f].displacement[i]).norm());
      d.largest_displacement = std::max(d.largest_displacement, a[f].displacement[i].norm());
    }
    auto forces = b[f].force;
    for (const auto& [pair, force] : a[f].force) {
      Vec2& other = forces.try_emplace(pair, Vec2(0.0, 0.0)).first->second;
      other -= force;
    }
    for (const auto& [pair, difference] : forces)
      d.force = std::max(d.force, difference.norm() / (kDensity * kGravity));
  }
  return d;
}

// ---- Scenes -----------------------------------------------------------------------------------------------------

std::vector<Geometry> geometries() {
  std::vector<Geometry> all;
  // Four blocks at a corner, over the corners of two more.
  all.push_back({"four_corners",
                 [](Scene& s) {
                   s.model.joints[0].damping = 0.0;  // round-off decides which of the touching corners is damped first
                   s.add("left", rectangle(-1, -1, 1, 0), true);
                   s.add("right", rectangle(1, -1, 3, 0), true);
                   for (const int row : {0, 1})
                     for (const int column : {0, 1}) s.add("b", rectangle(column, row, column + 1, row + 1));
                 },
                 4e-5, 5e-4});
  // Every vertex on a vertex of the next block, sides flush.
  all.push_back({"tower",
                 [](Scene& s) {
                   s.add("base", rectangle(0, -1, 1, 0), true);
                   for (int i = 0; i < 3; ++i) s.add("b", rectangle(0, i, 1, i + 1));
                 },
                 4e-5, 5e-4});
  // Straight joints through many blocks, with vertices on vertices in some places and within edges in others.
  all.push_back({"long_joints",
                 [](Scene& s) {
                   for (int i = 0; i < 7; ++i) s.add("base", rectangle(0.7 * i, -1, 0.7 * (i + 1), 0), true);
                   for (int i = 0; i < 5; ++i) s.add("b", rectangle(0.98 * i, 0, 0.98 * (i + 1), 0.8));
                   for (int i = 0; i < 2; ++i) s.add("t", rectangle(0.7 + 1.5 * i, 0.8, 2.1 + 1.5 * i, 1.7));
                 },
                 4e-5, 5e-4});
  // A block slides over slivers a micrometre wide, and over steps a micrometre high.
  all.push_back({"slivers",
                 [](Scene& s) {
                   const double x[] = {-2.0, 0.500001, 0.500002, 0.500003, 0.50005, 0.50005 + 1e-6, 3.0};
                   for (std::size_t i = 0; i + 1 < std::size(x); ++i)
                     s.add("base", rectangle(x[i], -1, x[i + 1], i == 4 ? -1e-6 : 0.0), true);
                   const BlockId block = s.add("b", rectangle(-0.5, 0, 0.5, 1));
                   s.model.initial_velocities.push_back({block, Vec2(0.01, 0.0), 0.0});
                 },
                 4e-5, 2e-4});
  // Minute gaps and overlaps on all sides.
  all.push_back({"gaps",
                 [](Scene& s) {
                   s.add("base", rectangle(-1, -1, 4, 0), true);
                   s.add("b", rectangle(0, 1e-12, 1, 1));
                   s.add("b", rectangle(1 + 1e-12, 0, 2, 1));
                   s.add("b", rectangle(2 - 1e-12, -1e-12, 3, 1 - 1e-12));
                   s.add("t", rectangle(0.5, 1 + 1e-12, 2.5, 1.8));
                 },
                 4e-5, 5e-4});
  // A corner exactly where two collinear edges meet; in the next scene, exactly on the corner that ends an edge.
  all.push_back({"corner_on_joint",
                 [](Scene& s) {
                   s.add("left", rectangle(-2, -1, 0, 0), true);
                   s.add("right", rectangle(0, -1, 3, 0), true);
                   s.add("b", transformed(rectangle(0, 0, 1, 1), Vec2(0.0, 0.0), rotation(20.0 * kDegree)));
                 },
                 4e-5, 5e-4});
  all.push_back({"corner_on_corner",
                 [](Scene& s) {
                   s.add("base", rectangle(-2, -1, 0, 0), true);
                   s.add("b", transformed(rectangle(-1, 0, 0, 1), Vec2(0.0, 0.0), rotation(-20.0 * kDegree)));
                 },
                 4e-5, 5e-4});
  return all;
}

std::vector<Place> places(bool turned) {
  std::vector<Place> all{{"as it is"}, {"moved", 1.0, 0.0, Vec2(1e6, -1e6)}, {"small", 1e-3}, {"large", 1e3}};
  if (turned) all.push_back({"turned", 1.0, 37.0 * kDegree});
  return all;
}

struct HardScheme {
  Scheme scheme;
  bool onefold = false;
};

class HardGeometry : public testing::TestWithParam<std::tuple<HardScheme, std::size_t>> {};

TEST_P(HardGeometry, physics_is_the_same_wherever_and_however_large) {
  const auto& [hard, index] = GetParam();
  const Geometry geometry = geometries()[index];
  const Scheme scheme = hard.scheme;
  Scene scene(kYoung, 0.2, kDensity, 30.0);
  scene.model.joints[0].normal_stiffness = kStiffness;
  geometry.build(scene);
  const double dt = scheme.implicit() ? geometry.implicit_step : geometry.explicit_step;
  Stage& stage = scene.stage(scheme.method, scheme.integrator, kSteps * dt, dt, 0.45);
  stage.sliding_damping = 0.0;  // sliding is decided by a threshold: round-off may change it one period later
  if (hard.onefold)
    for (std::int32_t i = 0; i < static_cast<std::int32_t>(scene.model.blocks.size()); ++i)
      stage.rules.push_back({{BlockId{i}}, "nmm", 0.0, true});
  scene.plan.output.every = ticks(kSteps * dt / kFrames);
  std::vector<Frame> base;
  // The lattice of a mesh does not turn with a block, so that a turned block has another mesh. Affine covers turn.
  for (const Place& place : places(scheme.method == std::string("dda") || hard.onefold)) {
    const Outcome now = run_at(scene, place);
    if (base.empty()) base = now.frames;
    const Difference d = compare(base, now.frames);
    std::printf("%s: displacement off by %.1e of %.1e m, force %.1e of a weight, closure %.1e\n", place.name.c_str(),
                d.displacement, d.largest_displacement, d.force, now.closure);
    EXPECT_LT(d.displacement, 1e-6 * d.largest_displacement) << place.name;
    EXPECT_LT(d.force, 1e-6) << place.name;
    EXPECT_LT(now.closure, 1e-9) << place.name;
  }
}

INSTANTIATE_TEST_SUITE_P(
    scenes, HardGeometry,
    testing::Combine(testing::Values(HardScheme{{"dda", "dda", Integrator::explicit_}},
                                     HardScheme{{"dda_implicit", "dda", Integrator::implicit}},
                                     HardScheme{{"nmm", "nmm", Integrator::explicit_}},
                                     HardScheme{{"nmm_implicit", "nmm", Integrator::implicit}},
                                     HardScheme{{"onefold", "nmm", Integrator::explicit_}, true},
                                     HardScheme{{"onefold_implicit", "nmm", Integrator::implicit}, true}),
                     testing::Range<std::size_t>(0, 7)),
    [](const auto& of) {
      return std::string(std::get<0>(of.param).scheme.name) + "_" + geometries()[std::get<1>(of.param)].name;
    });

// Corners nearer to each other than 1e-9 of the model's extent cannot be resolved: the model is refused before the run.
TEST(HardGeometryRefused, sliver_that_the_extent_swallows) {
  for (const auto& [width, far] : {std::pair(1e-6, 0.0), std::pair(1e-12, 0.0), std::pair(1e-6, 1e4)}) {
    Scene scene;
    scene.add("base", rectangle(-1, -1, 1, 0), true);
    const BlockId sliver = scene.add("sliver", rectangle(0, 0, width, 1));
    if (far > 0.0) scene.add("far", rectangle(far, 0, far + 1, 1));
    const std::vector<GeometryFault> faults = check_geometry(scene.model);
    if (width > 1e-9 && far == 0.0) {
      EXPECT_TRUE(faults.empty()) << faults[0].what;
      continue;
    }
    ASSERT_EQ(faults.size(), 1U);
    EXPECT_EQ(faults[0].block, sliver);
    EXPECT_NE(faults[0].what.find("corner (0, 0) is given twice"), std::string::npos) << faults[0].what;
    EXPECT_FALSE(faults[0].hint.empty());
  }
}

}  // namespace
}  // namespace scree::test::hard_geometry_test
