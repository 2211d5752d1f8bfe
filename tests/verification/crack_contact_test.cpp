// The faces of a crack are in contact under the law of its joint, as two blocks are. References: uniform stress across
// a crack (within twice the strain), Coulomb's law on a slope, conservation of momentum and energy.
#include <gtest/gtest.h>

#include <Eigen/LU>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"

namespace scree::test::crack_contact_test {
namespace {

using coupling::Integrator;

constexpr double kYoung = 1e9, kNormal = 2e10, kShear = 1e10, kTraction = 1e3;
constexpr double kStrain = kTraction / kYoung;  // relative change of lengths, and of the forces on them

/// A polygon with cracks. Their law has given stiffnesses and a given friction angle.
struct Cracked {
  Scene scene;
  Cracked(double friction_deg, const Polygon& polygon, const std::vector<std::pair<Vec2, Vec2>>& cracks)
      : scene(kYoung, 0.25, 2000.0, friction_deg) {
    scene.model.gravity = {0.0, 0.0};
    scene.model.joints[0].normal_stiffness = kNormal;
    scene.model.joints[0].shear_stiffness = kShear;
    scene.add("block", polygon);
    for (const auto& [from, to] : cracks) scene.model.cracks.push_back({from, to, JointId{0}, BlockId{0}});
  }
  coupling::Stage& stage(Integrator integrator, double duration, std::optional<double> dt, double cover_size) {
    coupling::Stage& s = scene.stage("nmm", integrator, duration, dt, cover_size);
    s.cracks = true;
    return s;
  }
};

/// Largest difference of the stress of any element from a uniaxial compression along y [Pa].
double stress_error(const coupling::Setup& setup, const coupling::State& state) {
  MeshPart mesh;
  setup.pool(0).topology(mesh);
  std::vector<double> cells(3 * mesh.body.size());
  setup.pool(0).stress(state.q, cells);
  double worst = 0.0;
  for (std::size_t c = 0; c < mesh.body.size(); ++c)
    worst =
        std::max({worst, std::abs(cells[3 * c]), std::abs(cells[3 * c + 1] + kTraction), std::abs(cells[3 * c + 2])});
  return worst;
}

class CrackPatch : public testing::TestWithParam<double> {};

/// Compression across a crack that cuts through the block at any slope: the stress stays uniform and the relative
/// displacements of the faces are sigma_n/k_n and tau/k_s for any mesh.
TEST_P(CrackPatch, uniform_stress_passes_through) {
  const double slope = GetParam();
  const Vec2 t(std::cos(slope), std::sin(slope)), n(-t.y(), t.x());
  Cracked cracked(80.0, rectangle(-0.5, -0.5, 0.5, 0.5), {{-2.0 * t, 2.0 * t}});
  coupling::Stage& stage = cracked.stage(Integrator::implicit, 2.0, 0.02, 0.23);
  stage.kinematics = Kinematics::linear;
  stage.dynamics = 0.0;
  for (const auto& [edge, sign] : {std::pair(0, 1.0), std::pair(2, -1.0)})
    cracked.scene.model.tractions.push_back({{BlockId{0}, {0, edge}, 0.0, 1.0}, {0.0, sign * kTraction}, {}});
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(cracked.scene.model, cracked.scene.plan, methods);
  const coupling::RunEnd end = run.run();
  ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  EXPECT_LT(stress_error(run.setup(), run.state()), 2.0 * kStrain * kTraction);
  // The force on the upper face is the traction of a stress of -sigma along y on a plane with the normal n.
  const double pressure = kTraction * n.y() * n.y(), shear = kTraction * n.y() * t.y();
  std::size_t closed = 0;
  for (const coupling::ContactMemory& m : run.state().contacts) {
    if (m.status == coupling::ContactStatus::open) continue;
    ++closed;
    EXPECT_NEAR(m.gap, -pressure / kNormal, 2.0 * kStrain * kTraction / kNormal);
    EXPECT_NEAR(std::abs(m.stretch), shear / kShear, 2.0 * kStrain * kTraction / kShear);
  }
  EXPECT_GT(closed, 8U);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Slopes, CrackPatch, testing::Values(0.0, 0.2, 0.61));

/// A block cut through along a slope: its upper part slides as a block on an incline does.
class CrackSliding : public testing::TestWithParam<Integrator> {};

TEST_P(CrackSliding, upper_part_follows_coulomb) {
  const bool implicit = GetParam() == Integrator::implicit;
  const double phi = 10.0, slope = 25.0 * kDegree, g = 9.81;
  // Drawn along the slope: a base, fixed from below, and on it, cut off by the crack along its whole length, the part
  // that slides.
  const Mat2 R = rotation(-slope);
  Cracked cracked(phi, transformed(rectangle(0.0, -0.5, 2.0, 0.5), Vec2(0, 0), R), {});
  cracked.scene.model.gravity = {0.0, -g};
  const double y = 0.1;
  cracked.scene.model.cracks.push_back({R * Vec2(-0.1, y), R * Vec2(2.1, y), JointId{0}, BlockId{0}});
  for (const double x : {0.1, 0.7, 1.3, 1.9}) {
    PointSupport s;
    s.block = BlockId{0};
    s.point = R * Vec2(x, -0.4);
    s.stiffness = 1e10;
    cracked.scene.model.point_supports.push_back(s);
  }
  for (const double x : {0.5, 1.0})
    cracked.scene.model.monitors.push_back({"m" + std::to_string(x), BlockId{0}, R * Vec2(x, 0.3)});
  cracked.stage(GetParam(), 0.3, implicit ? std::optional<double>(2e-4) : std::nullopt, 0.25);
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(cracked.scene.model, cracked.scene.plan, methods);
  const coupling::RunEnd end = run.run();
  ASSERT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  const double expected = 0.5 * g * (std::sin(slope) - std::cos(slope) * std::tan(phi * kDegree)) * 0.3 * 0.3;
  const coupling::Body& body = run.setup().bodies()[0];
  const AffineMotion origin = affine_fit(run.state().bodies[0].shape.outline, run.state().bodies[0].shape.origin);
  const Vec2 X = origin.F.inverse() * (R * Vec2(1.0, 0.3) - origin.c);
  const Row row = run.setup().global(body, run.setup().pool_of(body).row_at(0, X));
  const Vec2 moved = coupling::position(row, run.state().q) - R * Vec2(1.0, 0.3);
  std::printf("slid %.6f m, expected %.6f m, error %.2e, closure %.1e\n", moved.dot(R * Vec2(1, 0)), expected,
              moved.dot(R * Vec2(1, 0)) / expected - 1.0, run.state().ledger.relative_closure());
  EXPECT_NEAR(moved.dot(R * Vec2(1.0, 0.0)) / expected, 1.0, 5e-3);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Schemes, CrackSliding, testing::Values(Integrator::explicit_, Integrator::implicit),
                         [](const auto& p) { return p.param == Integrator::implicit ? "implicit" : "explicit"; });

/// A crack that a blow closes and opens again: the momentum of the free block is conserved and the ledger closes.
TEST(CrackContact, clapping_faces_keep_momentum_and_energy) {
  for (const Integrator kind : {Integrator::explicit_, Integrator::implicit}) {
    Cracked cracked(30.0, rectangle(-0.5, -0.5, 0.5, 0.5), {{Vec2(-0.3, 0.05), Vec2(0.35, -0.02)}});
    coupling::Stage& stage =
        cracked.stage(kind, 4e-3, kind == Integrator::implicit ? std::optional<double>(1e-5) : std::nullopt, 0.12);
    ByHand hand(cracked.scene.model, stage);
    // The upper half moves against the lower one, and the whole block spins.
    for (std::int32_t k = 0; k < hand.setup->nodes(); ++k) {
      const auto i = 2 * static_cast<std::size_t>(k);
      hand.state.v[i] = -2.0 * hand.state.q[i + 1];
      hand.state.v[i + 1] = 2.0 * hand.state.q[i] - (hand.state.q[i + 1] > 0.0 ? 1.0 : 0.0);
    }
    hand.state.ledger.open(std::array{hand.kinetic()});
    const BodyTotals before = hand.totals(hand.setup->bodies()[0]);
    coupling::StepControl control;
    control.max_displacement = 0.01;
    std::unique_ptr<coupling::TimeIntegrator> integrator;
    if (kind == Integrator::implicit)
      integrator = std::make_unique<coupling::Newmark>(*hand.setup, control, 0.02);
    else
      integrator =
          std::make_unique<coupling::CentralDifference>(*hand.setup, control, 0.02, coupling::ExplicitDamping{}, false);
    (void)integrator->enter(hand.state);
    const double h = kind == Integrator::implicit ? 1e-5 : 0.5 * integrator->stable_step(hand.state, nullptr);
    double most = 0.0;
    bool was_open = false, closed = false;
    for (int i = 0; i < 300; ++i) {
      const coupling::StepReport report = integrator->step(hand.state, ticks(h));
      ASSERT_EQ(report.status, coupling::StepReport::Status::ok) << report.cause;
      for (const coupling::ContactMemory& m : hand.state.contacts) {
        was_open = was_open || m.gap > 1e-6;
        closed = closed || m.fn > 1e3;
        most = std::max(most, -m.gap);
      }
    }
    integrator->leave(hand.state);
    EXPECT_TRUE(was_open && closed);
    EXPECT_LT(most, 1e-3);
    const BodyTotals after = hand.totals(hand.setup->bodies()[0]);
    const double size = before.mass;  // times 1 m/s
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-9 * size);
    EXPECT_LT(std::abs(after.angular_momentum - before.angular_momentum),
              (kind == Integrator::explicit_ ? 1e-9 : 1e-4) * size);
    EXPECT_LT(hand.state.ledger.relative_closure(), 1e-9);
  }
}

/// The memory of a crack's contacts is kept in a change to a finer mesh: the forces of a compressed and sheared crack
/// do not change.
TEST(CrackContact, tractions_outlive_a_new_mesh) {
  Cracked cracked(80.0, rectangle(-0.5, -0.5, 0.5, 0.5), {{Vec2(-1.0, -0.4), Vec2(1.0, 0.4)}});
  for (const double size : {0.3, 0.17}) {
    coupling::Stage& stage = cracked.stage(Integrator::implicit, 1.0, 0.02, size);
    stage.kinematics = Kinematics::linear;
    stage.dynamics = 0.0;
  }
  for (const auto& [edge, sign] : {std::pair(0, 1.0), std::pair(2, -1.0)})
    cracked.scene.model.tractions.push_back({{BlockId{0}, {0, edge}, 0.0, 1.0}, {0.0, sign * kTraction}, {}});
  const coupling::Methods methods = coupling::standard_methods();
  std::vector<double> normal, shear;  // sums over the points after either stage
  for (const double until : {1.0, 1.02}) {
    coupling::Driver run(cracked.scene.model, cracked.scene.plan, methods);
    ASSERT_EQ(run.run(until).status, coupling::RunEnd::Status::done);
    double fn = 0.0, ft = 0.0;
    for (const coupling::ContactMemory& m : run.state().contacts) {
      fn += m.fn;
      ft += std::abs(m.ft);
    }
    normal.push_back(fn);
    shear.push_back(ft);
  }
  EXPECT_NEAR(normal[1] / normal[0], 1.0, 1e-6);
  EXPECT_NEAR(shear[1] / shear[0], 1.0, 1e-6);
  EXPECT_GT(shear[0], 0.1 * kTraction);
}

}  // namespace
}  // namespace scree::test::crack_contact_test
