// Joints that open as they slip (dilation): lift, friction and acceleration compared with closed formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/support/schemes.h"

namespace scree::test::dilation_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2000.0, kYoung = 1e10, kStiffness = 1e9;
constexpr double kLength = 2.0, kHeight = 0.2;

class Dilation : public testing::TestWithParam<Scheme> {
 protected:
  Dilation() {
    JointLaw& law = scene_.model.joints[0];
    law.normal_stiffness = law.shear_stiffness = kStiffness;
    law.dilation = 10.0 * kDegree;
    scene_.model.gravity = {0.0, -kGravity};
    scene_.add("base", rectangle(-1, -1, 4, 0), true);
    block_ = scene_.add("block", rectangle(0, 0, kLength, kHeight));
  }
  Stage& stage(double duration, double dt) {
    return scene_.stage(GetParam().method, GetParam().integrator, duration,
                        GetParam().implicit() ? std::optional<double>(dt) : std::nullopt, kHeight);
  }
  /// A push along the joint, a fraction of gravity, that grows over `rise` from `start` on and is taken away again
  /// later.
  void push(double part, double start, double rise) {
    TimeFunction f;
    f.shape = TimeFunction::Shape::table;
    f.time = {0.0, start, start + rise, start + 0.3, start + 0.3 + rise};
    f.table = {0.0, 0.0, 1.0, 1.0, 0.0};
    scene_.model.functions.push_back(f);
    scene_.model.body_accelerations.push_back({{}, {part * kGravity, 0.0}, FunctionId{0}});
  }
  Scene scene_{kYoung, 0.0, kDensity, 30.0};
  BlockId block_;
};

/// Mean slip of the closed points, weighted by tributary length.
double mean_slip(const State& state) {
  double slip = 0.0, length = 0.0;
  for (const ContactMemory& m : state.contacts) {
    if (m.status == ContactStatus::open) continue;
    slip += m.slip * m.tributary;
    length += m.tributary;
  }
  return slip / length;
}

/// A block is pushed along, released and brought to rest. The force between the faces keeps the direction of the joint,
/// so friction is T = N tan phi and dilation only lifts: with y'' = x'' tan psi, N = m (g + x'' tan psi) and
/// m x'' = H - T,
///   x'' = (H/m - g tan phi)/(1 + tan phi tan psi)
/// Of the friction force's work the part tan psi/tan phi lifts the block.
TEST_P(Dilation, lifts_a_sliding_block_by_its_angle) {
  const double seated = 0.5, pushed = 0.9, tan_phi = std::tan(30.0 * kDegree), tan_psi = std::tan(10.0 * kDegree);
  push(pushed, seated, 0.02);
  stage(seated, 0.05).rest = true;
  stage(0.7, 5e-4);
  stage(1.0, 0.05).rest = true;
  Driver run(scene_.model, scene_.plan, methods());
  const double mass = kLength * kHeight * kDensity;
  double height = 0.0, from = 0.0, to = 0.0, begin = 0.0, end = 0.0, apparent = 0.0;
  EveryStep watch;
  watch.see = [&](double t) {
    if (t <= seated + 1e-9) height = centre_of(run, block_).y();
    if (t < seated + 0.1 || t > seated + 0.29) return;
    const double v = totals_of(run, block_).momentum.x() / mass;
    if (begin == 0.0) from = v, begin = t;
    to = v, end = t;
    double normal = 0.0, shear = 0.0;
    for (const ContactMemory& m : run.state().contacts) normal += m.fn, shear += std::abs(m.ft);
    apparent = shear / normal;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double slip = mean_slip(run.state()), lift = centre_of(run, block_).y() - height;
  const double wanted = (pushed - tan_phi) * kGravity / (1.0 + tan_phi * tan_psi), found = (to - from) / (end - begin);
  const Ledger& ledger = run.state().ledger;
  std::printf(
      "%s: slip %.4f m, lift %.8f of slip tan(psi), T/N %.8f tan(phi), acceleration %.6f of the formula, "
      "dilation %.6f of friction, closure %.1e\n",
      GetParam().name, slip, lift / (slip * tan_psi), apparent / tan_phi, found / wanted,
      -ledger[Column::dilation] / ledger[Column::friction] * tan_phi / tan_psi, ledger.relative_closure());
  EXPECT_GT(slip, 0.1);
  EXPECT_NEAR(lift, slip * tan_psi, 1e-6 * slip);
  EXPECT_NEAR(apparent, tan_phi, 1e-6);
  EXPECT_NEAR(found, wanted, 1e-4 * wanted);  // the contact springs oscillate a little
  EXPECT_NEAR(-ledger[Column::dilation], ledger[Column::friction] * tan_psi / tan_phi, 1e-5 * ledger[Column::friction]);
  EXPECT_LT(ledger.relative_closure(), 1e-9);
}

TEST_P(Dilation, ends_after_its_slip) {
  const double seated = 0.5;
  scene_.model.joints[0].dilation_slip = 0.03;
  push(0.9, seated, 0.02);
  stage(seated, 0.05).rest = true;
  stage(0.7, 5e-4);
  stage(1.0, 0.05).rest = true;
  Driver run(scene_.model, scene_.plan, methods());
  double height = 0.0;
  EveryStep watch;
  watch.see = [&](double t) {
    if (t <= seated + 1e-9) height = centre_of(run, block_).y();
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_GT(mean_slip(run.state()), 0.1);
  EXPECT_NEAR(centre_of(run, block_).y() - height, 0.03 * std::tan(10.0 * kDegree), 3e-8);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

/// Under a spring on top instead of a weight, the normal force grows with the slip: N = N_0 + K tan psi s.
TEST_P(Dilation, raises_the_normal_force_under_confinement) {
  const double seated = 0.5, tan_psi = std::tan(10.0 * kDegree), k = 1e7;
  for (const double x : {0.0, kLength}) scene_.model.point_supports.push_back({block_, {x, kHeight}, false, true, k});
  push(3.0, seated, 0.1);
  stage(seated, 0.05).rest = true;
  stage(0.3, 5e-4);
  Driver run(scene_.model, scene_.plan, methods());
  const double weight = kLength * kHeight * kDensity * kGravity;
  double off = 0.0, most = 0.0, cone = 0.0;
  EveryStep watch;
  watch.see = [&](double t) {
    if (t < seated + 0.05) return;
    double normal = 0.0, shear = 0.0;
    bool slips = true;
    for (const ContactMemory& m : run.state().contacts) {
      normal += m.fn, shear += std::abs(m.ft);
      slips = slips && (m.status == ContactStatus::slip || m.tributary < 1e-3);
    }
    const double lift = centre_of(run, block_).y() - 0.5 * kHeight;
    // Inertia is small compared with the springs: their force follows from the lift, and the lift from the slip.
    if (slips) {
      off = std::max(off, std::abs(lift - tan_psi * mean_slip(run.state())));
      cone = std::max(cone, std::abs(shear - normal * std::tan(30.0 * kDegree)));
    }
    most = std::max(most, normal);
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double slip = mean_slip(run.state());
  std::printf("%s: slip %.4f m, normal force %.2f of the weight, lift off by %.1e m, cone by %.1e N, closure %.1e\n",
              GetParam().name, slip, most / weight, off, cone, run.state().ledger.relative_closure());
  EXPECT_GT(most, 2.0 * weight);
  EXPECT_NEAR(most, weight + 2.0 * k * tan_psi * slip, 0.1 * most);
  EXPECT_LT(cone, 1e-6 * most);
  EXPECT_LT(off, 0.02 * tan_psi * slip + most / (kStiffness * kLength));
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

/// A mesh slides over a mesh, from vertex to vertex, in steps in which the joint opens by twenty times what its springs
/// are pressed: an open point does not dilate, and would be left behind by the joint that rides up.
TEST(DilationOfMeshes, keeps_all_points_closed_while_the_joint_rides_up) {
  Scene scene(5e9, 0.25, 2500.0, 35.0);
  scene.model.joints[0].dilation = 10.0 * kDegree;
  scene.model.gravity = {0.0, -kGravity};
  scene.add("base", rectangle(-1.0, -1.0, 6.0, 0.0), true);
  const BlockId block = scene.add("block", rectangle(0.0, 0.0, 3.0, 0.6));
  constexpr double kSeated = 2.0;
  scene.stage("nmm", Integrator::implicit, kSeated, 0.01, 0.3).rest = true;
  scene.stage("nmm", Integrator::implicit, 0.5, 1e-3, 0.3);
  TimeFunction go;
  go.shape = TimeFunction::Shape::table;
  go.time = {0.0, kSeated - 1e-9, kSeated};
  go.table = {0.0, 0.0, 1.0};
  scene.model.functions.push_back(go);
  scene.model.body_accelerations.push_back({{}, {0.9 * kGravity, 0.0}, FunctionId{0}});
  scene.plan.audit = true;
  const Methods methods = standard_methods();
  Driver run(scene.model, scene.plan, methods);
  Vec2 from(0.0, 0.0);
  int open = 0;
  EveryStep watch;
  watch.see = [&](double t) {
    if (t <= kSeated + 1e-9) from = centre_of(run, block);
    if (t < kSeated + 0.1) return;
    for (const ContactMemory& m : run.state().contacts) open += m.status == ContactStatus::open && m.tributary > 0.01;
  };
  run.add_sink(watch);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const double tan_phi = std::tan(35.0 * kDegree), tan_psi = std::tan(10.0 * kDegree),
               wanted = 0.125 * (0.9 - tan_phi) * kGravity / (1.0 + tan_phi * tan_psi);
  const Vec2 way = centre_of(run, block) - from;
  std::printf("slip %.6f m, formula %.6f m, lift %.6f of slip tan(psi), %d open points\n", way.x(), wanted,
              way.y() / (way.x() * tan_psi), open);
  EXPECT_NEAR(way.x(), wanted, 5e-3 * wanted);  // it starts against springs that are not stretched yet
  EXPECT_NEAR(way.y(), way.x() * tan_psi, 2e-3 * way.x() * tan_psi);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(schemes, Dilation, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::test::dilation_test
