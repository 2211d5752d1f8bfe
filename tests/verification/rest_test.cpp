// Stages that run to rest against the static solution, and the forces of contacts when stages change.
#include <gtest/gtest.h>

#include <functional>
#include <map>

#include "tests/support/schemes.h"

namespace scree::test::rest_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2600.0, kYoung = 1e9;

class Rest : public testing::TestWithParam<Scheme> {};

/// Three blocks of 1.2 x 1 m on a fixed base, without Poisson's effect: a column in one dimension.
TEST_P(Rest, stack_comes_to_its_static_state_and_stays) {
  const Scheme scheme = GetParam();
  Scene scene(kYoung, 0.0, kDensity, 30.0);
  scene.add("base", rectangle(-1, -1, 2.2, 0), true);
  for (int i = 0; i < 3; ++i) scene.add("b" + std::to_string(i), rectangle(0, i, 1.2, i + 1));
  const std::optional<double> dt = scheme.implicit() ? std::optional<double>(1e-2) : std::nullopt;
  const double rest = scheme.implicit() ? 1.0 : 2.0;
  scene.stage(scheme.method, scheme.integrator, rest, dt, 0.5).rest = true;
  scene.stage(scheme.method, scheme.integrator, 0.5, dt, 0.5);
  scene.plan.output.every = ticks(0.5);
  Driver run(scene.model, scene.plan, methods());
  std::vector<Vec2> rested;
  double reaction = 0.0, rest_damping = 0.0, sunk = 0.0, kinetic = 1.0, closure = 1.0, gravity = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.state->stage != 1 || !rested.empty()) return;
    const Ledger& ledger = view.state->ledger;
    for (const ContactMemory& m : view.state->contacts)
      if (m.key.block_p == 0 || m.key.block_e == 0) reaction += m.fn;
    for (std::int32_t i = 1; i <= 3; ++i) {
      rested.push_back(centre_of(run, BlockId{i}));
      sunk += i - 0.5 - rested.back().y();
    }
    rest_damping = ledger[Column::rest_damping];
    gravity = ledger[Column::gravity];
    kinetic = ledger[Column::kinetic];
    closure = ledger.relative_closure();
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(rested.size(), 3U);

  const double weight = 1.2 * kDensity * kGravity;  // of a block
  double drift = 0.0;
  for (std::int32_t i = 1; i <= 3; ++i)
    drift = std::max(drift, (centre_of(run, BlockId{i}) - rested[static_cast<std::size_t>(i) - 1]).norm());
  // The topmost centroid sinks by three joints, of stiffness E over the height of 1 m, by the two blocks below, each
  // under the mean of the stress at its ends, and by its own lower half: its mean stress in DDA, which has one strain
  // per block, p/4; p/3 in truth, the mean of p (y - y^2/2).
  const double p = kDensity * kGravity;  // of one block's weight
  const double joints = (3.0 + 2.0 + 1.0) * p / kYoung, below = (2.5 + 1.5) * p / kYoung;
  const double half = (std::string(scheme.method) == "dda" ? 0.25 : 1.0 / 3.0) * p / kYoung;
  const double expected = joints + below + half, settled = 2.5 - rested[2].y();
  std::printf("%s: reaction off by %.1e, settlement by %.1e, drift %.1e m, rest damping %.3g of %.3g J, closure %.1e\n",
              scheme.name, reaction / (3.0 * weight) - 1.0, settled / expected - 1.0, drift, rest_damping, gravity,
              closure);
  EXPECT_NEAR(reaction / (3.0 * weight), 1.0, 1e-8);
  EXPECT_NEAR(settled / expected, 1.0, scheme.implicit() ? 2e-4 : 2e-3);  // strains of 1e-4; the mesh
  EXPECT_LT(drift, 1e-9);
  EXPECT_LT(kinetic, 1e-12 * gravity);
  EXPECT_GT(rest_damping, 0.1 * gravity);
  EXPECT_NEAR(gravity / (weight * sunk), 1.0, 1e-8);  // positions are rounded at each of 4e4 steps
  EXPECT_LT(closure, 1e-10);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-10);
}
INSTANTIATE_TEST_SUITE_P(schemes, Rest,
                         testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

/// Two blocks on a slope below their friction angle: closed, sheared contacts of a column and of its foot.
class HandOverOfContacts : public testing::Test {
 protected:
  HandOverOfContacts() {
    const Mat2 R = rotation(-20.0 * kDegree);
    const Vec2 origin(0.0, 0.0);
    scene_.add("plane", transformed(rectangle(-3, -1, 6, 0), origin, R), true);
    scene_.add("lower", transformed(rectangle(0, 0, 1.5, 1), origin, R));
    scene_.add("upper", transformed(rectangle(0.2, 1, 1.3, 1.8), origin, R));
  }
  Scene scene_{kYoung, 0.2, kDensity, 40.0};
};

TEST_F(HandOverOfContacts, corners_keep_their_traction_when_a_mesh_adds_vertices) {
  scene_.stage("dda", Integrator::implicit, 0.4, 1e-2).rest = true;
  scene_.stage("nmm", Integrator::explicit_, 0.05, std::nullopt, 0.4).damping = 50.0;
  scene_.plan.output.every = ticks(0.05);
  Driver run(scene_.model, scene_.plan, methods());
  std::int32_t stage = 0;
  int compared = 0;
  double gap = 0.0, stretch = 0.0, scale_gap = 0.0, scale_stretch = 0.0;
  std::map<ContactKey, ContactMemory> before;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    EXPECT_LT(view.state->ledger.relative_closure(), 1e-9) << "t = " << view.time;
    if (view.state->stage != stage) {
      stage = view.state->stage;
      for (const ContactMemory& m : view.state->contacts) {
        const auto old = before.find(m.key);
        if (m.key.part > 0 || old == before.end() || old->second.status == ContactStatus::open) continue;
        ++compared;
        gap = std::max(gap, std::abs(m.gap - old->second.gap));
        stretch = std::max(stretch, std::abs(m.stretch - old->second.stretch));
        scale_gap = std::max(scale_gap, std::abs(m.gap));
        scale_stretch = std::max(scale_stretch, std::abs(m.stretch));
      }
    }
    before.clear();
    for (const ContactMemory& m : view.state->contacts) before[m.key] = m;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  std::printf("%d corners: gap %.1e of %.1e m, stretch %.1e of %.1e m\n", compared, gap, scale_gap, stretch,
              scale_stretch);
  EXPECT_GE(compared, 4);
  EXPECT_GT(scale_stretch, 1e-6);  // the contacts are sheared
  EXPECT_LT(gap, 1e-12);
  EXPECT_LT(stretch, 1e-12);
}

/// The forces right after a hand-over balance the weight as they did before. On the way back, forces of mesh vertices
/// that are removed pass to the corners by the lever rule.
TEST_F(HandOverOfContacts, resultants_stay) {
  scene_.stage("dda", Integrator::implicit, 0.4, 1e-2).rest = true;
  scene_.stage("nmm", Integrator::explicit_, 0.05, std::nullopt, 0.4).damping = 50.0;
  scene_.stage("dda", Integrator::implicit, 0.1, 2e-3);
  scene_.plan.output.every = ticks(0.05);
  Driver run(scene_.model, scene_.plan, methods());
  struct Sums {
    double normal = 0.0, tangential = 0.0, moment = 0.0;  // of the springs on the plane; moment about its origin
  };
  std::map<std::pair<int, std::int32_t>, Sums> seen;  // by multiple of 0.05 s and stage
  const Mat2 R = rotation(-20.0 * kDegree);
  Watch watch;
  watch.see = [&](const FrameView& view) {
    Sums sums;
    const Outlines& o = run.setup().outlines();
    for (const ContactMemory& m : view.state->contacts) {
      if ((m.key.block_p != 0 && m.key.block_e != 0) || m.status == ContactStatus::open) continue;
      const double fn = -m.kn * m.gap, ft = -m.kt * m.stretch;
      const EdgeIndex edge = run.setup().edge_of(m.key.block_p, m.key.ring_p, m.key.vertex);
      const VertexIndex v = o.edges[edge].first_vertex() + m.key.part;
      const Vec2 x = position(o.nodes[o.vertices[v].node], view.state->q);
      sums.normal += fn;
      sums.tangential += ft;
      sums.moment += fn * R.col(0).dot(x);
    }
    seen[{static_cast<int>(std::lround(view.time / 0.05)), view.state->stage}] = sums;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Sums &rested = seen.at({8, 0}), &meshed = seen.at({8, 1}), &held = seen.at({9, 1}), &back = seen.at({9, 2});
  const double weight = kDensity * kGravity * (1.5 + 1.1 * 0.8);
  EXPECT_NEAR(rested.normal / (weight * std::cos(20.0 * kDegree)), 1.0, 1e-6);
  EXPECT_NEAR(std::abs(rested.tangential) / (weight * std::sin(20.0 * kDegree)), 1.0, 1e-6);
  EXPECT_NEAR(meshed.normal / rested.normal, 1.0, 1e-3);  // other tributary lengths, slightly bent edges
  EXPECT_NEAR(meshed.tangential / rested.tangential, 1.0, 1e-3);
  EXPECT_NEAR(back.normal / held.normal, 1.0, 1e-9);
  EXPECT_NEAR(back.tangential / held.tangential, 1.0, 1e-9);
  EXPECT_NEAR(back.moment / held.moment, 1.0,
              1e-4);  // corners of affine and meshed block differ by the bending
}

/// From one mesh to another: the force of the vertices that are removed passes to the remaining points.
TEST(TransferReport, force_passes_from_mesh_to_mesh) {
  Scene scene(1e10, 0.0, kDensity, 30.0);
  scene.model.joints[0].normal_stiffness = scene.model.joints[0].shear_stiffness = 2e7;
  scene.add("base", rectangle(-1, -1, 2.5, 0), true);
  scene.add("block", rectangle(0, 0, 1.5, 1));
  scene.stage("nmm", Integrator::implicit, 0.4, 1e-2, 0.5).rest = true;
  scene.stage("nmm", Integrator::implicit, 0.1, 1e-2, 0.3).rest = true;  // finer
  scene.stage("nmm", Integrator::explicit_, 0.1, std::nullopt, 0.6);     // coarser
  scene.plan.output.every = ticks(0.1);
  Driver run(scene.model, scene.plan, methods());
  const double weight = 1.5 * kDensity * kGravity;
  std::map<std::int32_t, std::size_t> points;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.state->stage == 0) return;  // the stage ends with a frame
    double force = 0.0;
    for (const ContactMemory& m : view.state->contacts) {
      if (m.status == ContactStatus::open) continue;
      force += -m.kn * m.gap;
      ++points[view.state->stage];
    }
    EXPECT_NEAR(force / weight, 1.0, 1e-3) << "stage " << view.state->stage << ", t = " << view.time;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_NE(points[1], points[2]);
  const Ledger& ledger = run.state().ledger;
  EXPECT_LT(std::abs(ledger[Column::contact_edges]), 1e-3 * ledger[Column::contact_springs]);
  EXPECT_LT(ledger.relative_closure(), 1e-10);
}

/// Blocks slide through changes of scheme in both directions: no energy of one scheme stays in the ledger of the other.
TEST_F(HandOverOfContacts, moving_blocks_close_the_books_through_every_change) {
  scene_.model.joints[0].friction = 10.0 * kDegree;
  for (const auto& [method, integrator] :
       {std::pair("nmm", Integrator::explicit_), std::pair("dda", Integrator::implicit),
        std::pair("nmm", Integrator::explicit_), std::pair("dda", Integrator::explicit_),
        std::pair("dda", Integrator::implicit), std::pair("nmm", Integrator::explicit_)})
    scene_.stage(method, integrator, 0.05,
                 integrator == Integrator::implicit ? std::optional<double>(1e-3) : std::nullopt, 0.4);
  scene_.plan.output.every = ticks(0.01);
  Driver run(scene_.model, scene_.plan, methods());
  double worst = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) { worst = std::max(worst, view.state->ledger.relative_closure()); };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  std::printf("closure %.1e\n", worst);
  EXPECT_LT(worst, 1e-9);
}

}  // namespace
}  // namespace scree::test::rest_test
