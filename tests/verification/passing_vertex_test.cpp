// A corner under load that slides from one edge to the next: over a vertex in the middle of a side, over the joint of
// two blocks, over a convex corner. Forces, energy and slip must change continuously.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tests/support/schemes.h"

namespace scree::test::passing_vertex_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2600.0, kWeight = kDensity * kGravity;
constexpr double kStiffness = 1e9, kLength = 0.1;  // [Pa/m], [m]: a corner has 1e8 N/m
constexpr double kFriction = 6.0;                  // [degrees]
constexpr double kSpeed = 0.4;                     // [m/s]

enum class Ground { vertex_in_a_side, two_blocks, unlike_blocks, three_slivers, ridge };

const char* name(Ground ground) {
  switch (ground) {
    case Ground::vertex_in_a_side:
      return "vertex_in_a_side";
    case Ground::two_blocks:
      return "two_blocks";
    case Ground::unlike_blocks:
      return "unlike_blocks";
    case Ground::three_slivers:
      return "three_slivers";
    case Ground::ridge:
      return "ridge";
  }
  return "";
}

struct Step final : Sink {
  std::function<void(double)> see;
  void step(double time, const RunStats&, const Ledger&) override { see(time); }
};

/// Largest changes in a step while a corner passes.
struct Passage {
  double normal = 0.0, tangential = 0.0;  // sums over the contacts, over the weight
  double energy = 0.0;                    // of the slider and its springs [J]
  double lost_slip = 0.0;                 // way that the slip does not contain [m]
  double farthest_normal = 0.0;           // largest difference to the weight, over the weight
  double closure = 0.0;
};

/// A 1 x 1 m block on its tip, in equilibrium with its spring. Gravity is inclined so that it balances friction, which
/// keeps the speed constant, and acts through the tip. The block crosses x = 0 after 0.05 s.
Passage pass(const Scheme& scheme, Ground ground, double dt) {
  Scene scene(1e10, 0.2, kDensity, kFriction);
  JointLaw& law = scene.model.joints[0];
  law.normal_stiffness = kStiffness;
  law.contact_length = kLength;
  if (ground == Ground::ridge) law.damping = 0.0;  // the rate of the gap is discontinuous there
  scene.model.gravity = Vec2(std::tan(kFriction * kDegree), -1.0) * kGravity;
  switch (ground) {
    case Ground::vertex_in_a_side:
      scene.add("base", {{{-2, -1}, {2, -1}, {2, 0}, {0, 0}, {-2, 0}}, {}}, true);
      break;
    case Ground::two_blocks:
      scene.add("left", rectangle(-2, -1, 0, 0), true);
      scene.add("right", rectangle(0, -1, 2, 0), true);
      break;
    case Ground::unlike_blocks:  // the right one four times as stiff
      law.normal_stiffness.reset();
      scene.add("left", rectangle(-2, -1, 0, 0), true);
      scene.add("right", rectangle(0, -0.25, 2, 0), true);
      break;
    case Ground::three_slivers:
      scene.add("left", rectangle(-2, -1, 0, 0), true);
      for (int i = 0; i < 3; ++i) scene.add("sliver", rectangle(1e-5 * i, -1, 1e-5 * (i + 1), 0), true);
      scene.add("right", rectangle(3e-5, -1, 2, 0), true);
      break;
    case Ground::ridge:
      scene.add("base", {{{-2, -1}, {2, -1}, {2, -2 * std::tan(2.0 * kDegree)}, {0, 0}, {-2, 0}}, {}}, true);
      break;
  }
  const double depth =
      kWeight / (kLength * law.normal_stiffness.value_or(scene.model.elasticity_of(BlockId{0}).p_modulus()));
  const Mat2 R = rotation((45.0 + kFriction) * kDegree);  // the centre lies above the tip along the line of gravity
  const Vec2 tip(-0.05 * kSpeed, -depth);
  const BlockId slider = scene.add("slider", transformed(rectangle(0, 0, 1, 1), tip, R));
  scene.model.initial_velocities.push_back({slider, Vec2(kSpeed, 0.0), 0.0});
  Stage& stage = scene.stage(scheme.method, scheme.integrator, 0.1, dt, 0.6);
  stage.rules.push_back({{slider}, scheme.method, 0.0, std::string(scheme.method) == "nmm"});
  scene.plan.detection = 0.02;
  const double start = moments(scene.model.blocks[slider.index()].polygon).centroid.x();
  Driver run(scene.model, scene.plan, methods());
  Passage most;
  double normal = 0.0, tangential = 0.0, energy = 0.0, travelled = 0.0, slip = 0.0;
  bool before = false;
  Step watch;
  watch.see = [&](double time) {
    const State& state = run.state();
    double n = 0.0, t = 0.0, s = 0.0;
    for (const ContactMemory& m : state.contacts) {
      if (m.status == ContactStatus::open) continue;
      n += (m.fn - m.fd) / kWeight;
      t += (m.ft - m.fdt) / kWeight;
      s = std::max(s, m.slip);
    }
    const BodyTotals b = totals_of(run, slider);
    const double held = b.kinetic + b.elastic - kDensity * scene.model.gravity.dot(b.centre) +
                        state.ledger[Column::contact_springs] - state.ledger[Column::contact_tributary];
    if (before && time > 0.03) {  // the tangential spring has been stretched by then
      most.normal = std::max(most.normal, std::abs(n - normal));
      most.tangential = std::max(most.tangential, std::abs(t - tangential));
      most.energy = std::max(most.energy, std::abs(held - energy));
      most.farthest_normal = std::max(most.farthest_normal, std::abs(n - 1.0));
      most.lost_slip = std::max(most.lost_slip, std::abs((s - slip) - (b.centre.x() - travelled)));
    }
    before = true;
    normal = n;
    tangential = t;
    energy = held;
    travelled = b.centre.x();
    slip = s;
  };
  run.add_sink(watch);
  const RunEnd end = run.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  most.closure = run.state().ledger.relative_closure();
  EXPECT_NEAR(centre_of(run, slider).x() - start, 0.1 * kSpeed, 0.2 * 0.1 * kSpeed);
  return most;
}

class PassingVertex : public testing::TestWithParam<std::tuple<Scheme, Ground>> {};

TEST_P(PassingVertex, forces_energy_and_slip_go_on) {
  const auto& [scheme, ground] = GetParam();
  Passage before;
  for (const double h : {4e-5, 2e-5, 1e-5}) {
    const Passage p = pass(scheme, ground, h);
    std::printf(
        "%s h %.0e: normal %.1e, tangential %.1e a step, energy %.1e J, slip %.1e m; normal off by %.1e; "
        "closure %.1e\n",
        scheme.name, h, p.normal, p.tangential, p.energy, p.lost_slip, p.farthest_normal, p.closure);
    // The change of a force per step is proportional to the step: no jumps.
    EXPECT_LT(p.normal, 300.0 * h);
    EXPECT_LT(p.tangential, 30.0 * h);
    if (before.normal > 0.0) {
      EXPECT_LT(p.normal, std::max(0.8 * before.normal, 1e-4));
      EXPECT_LT(p.tangential, std::max(0.8 * before.tangential, 1e-4));
    }
    // Beyond the ridge the normal force changes by v sin(2 degrees) sqrt(k m)/W = 0.3. Elsewhere the oscillation by the
    // block's own compression at the start remains, and a stiffer joint increases it.
    EXPECT_LT(p.farthest_normal, ground == Ground::ridge ? 0.35 : (ground == Ground::unlike_blocks ? 0.1 : 0.01));
    // Friction alone reduces the energy, by this amount per step.
    EXPECT_LT(p.energy, 1.1 * (1.0 + p.farthest_normal) * kWeight * std::tan(kFriction * kDegree) * kSpeed * h);
    EXPECT_LT(p.lost_slip, 0.2 * kSpeed * h);
    EXPECT_LT(p.closure, 1e-9);
    before = p;
  }
}

INSTANTIATE_TEST_SUITE_P(all, PassingVertex,
                         testing::Combine(testing::Values(Scheme{"dda", "dda", Integrator::explicit_},
                                                          Scheme{"dda_implicit", "dda", Integrator::implicit},
                                                          Scheme{"nmm", "nmm", Integrator::explicit_},
                                                          Scheme{"nmm_implicit", "nmm", Integrator::implicit}),
                                          testing::Values(Ground::vertex_in_a_side, Ground::two_blocks,
                                                          Ground::unlike_blocks, Ground::three_slivers, Ground::ridge)),
                         [](const auto& of) {
                           return std::string(std::get<0>(of.param).name) + "_over_" + name(std::get<1>(of.param));
                         });

}  // namespace
}  // namespace scree::test::passing_vertex_test
