// Bonded joints that are pulled and sheared to failure, and friction that slip weakens, against formulas.
#include "coupling/contact/law/joint_strength.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

#include "tests/support/schemes.h"

namespace scree::test::joint_strength_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2000.0, kYoung = 1e10, kStiffness = 1e9;

const Scheme kSchemes[] = {{"nmm", "nmm", Integrator::explicit_},
                           {"dda", "dda", Integrator::explicit_},
                           {"nmm_implicit", "nmm", Integrator::implicit},
                           {"dda_implicit", "dda", Integrator::implicit}};
const auto kNames = [](const auto& of) { return std::string(of.param.name); };

/// Sums over the closed contact points of a state.
struct Joint {
  double normal = 0.0, shear = 0.0, length = 0.0;  // forces [N], tributary length [m]
  double bonded = 0.0, gap = 0.0;                  // bonded length [m]; largest gap [m]
  std::size_t points = 0;
  explicit Joint(const State& state) {
    for (const ContactMemory& m : state.contacts) {
      if (m.status == ContactStatus::open) {
        EXPECT_EQ(m.bonded, 0);
        continue;
      }
      ++points;
      normal += m.fn;
      shear += m.ft;
      length += m.tributary;
      bonded += m.bonded != 0 ? m.tributary : 0.0;
      gap = std::max(gap, m.gap);
    }
  }
};

/// Newton's method leaves 1e-11 of the largest force.
double closure_of(const Scheme& s) { return s.implicit() && std::string(s.method) == "nmm" ? 1e-10 : 1e-12; }

FunctionId ramp(Scene& scene, double amplitude, double start, double duration) {
  TimeFunction f;
  f.shape = TimeFunction::Shape::ramp;
  f.amplitude = amplitude;
  f.start = start;
  f.duration = duration;
  scene.model.functions.push_back(f);
  return FunctionId{static_cast<std::int32_t>(scene.model.functions.size()) - 1};
}

class Strength : public testing::TestWithParam<Scheme> {
 protected:
  Strength() {
    JointLaw& law = scene_.model.joints[0];
    law.normal_stiffness = law.shear_stiffness = kStiffness;
    scene_.model.gravity = {0.0, 0.0};
  }
  Stage& stage(double duration, double dt) {
    return scene_.stage(GetParam().method, GetParam().integrator, duration,
                        GetParam().implicit() ? std::optional<double>(dt) : std::nullopt, 0.5);
  }
  JointLaw& law() { return scene_.model.joints[0]; }
  Scene scene_{kYoung, 0.0, kDensity, 30.0};
};

// ---- Tension ----------------------------------------------------------------------------------------------------

TEST_P(Strength, pulled_block_follows_its_springs_and_breaks_off_at_the_strength) {
  const double strength = 1e5, length = 1.5, most = 1.25 * strength, time = GetParam().implicit() ? 1.0 : 0.2;
  law().tensile_strength = strength;
  law().cohesion = 2.0 * strength;
  scene_.add("base", rectangle(-1, -1, 2.5, 0), true);
  const BlockId block = scene_.add("block", rectangle(0, 0, length, 1));
  scene_.model.tractions.push_back({{block, {0, 2}, 0.0, 1.0}, {0.0, 1.0}, ramp(scene_, most, 0.0, time)});
  const double dt = 0.01;
  stage(0.9 * time, dt).dynamics = 0.0;  // implicit steps: static, no oscillation about equilibrium
  Driver run(scene_.model, scene_.plan, methods());
  EveryStep watch;
  // Static steps lag behind the ramp by a part of an increment: the inertia 2 M/h^2 over the springs' stiffness.
  // Explicit steps oscillate about the ramp with the amplitude (rate/frequency), and the pull reaches the joint after
  // the travel time of a wave through the block.
  const double increment = most * dt / time, off = GetParam().implicit() ? 0.05 * increment : 0.015 * strength;
  double held = 0.0, broken = 0.0, worst = 0.0;
  watch.see = [&](double t) {
    const Joint joint(run.state());
    const double pull = most * t / time;
    if (joint.points == 0) {
      if (broken == 0.0) broken = pull;
      return;
    }
    ASSERT_EQ(broken, 0.0) << "it closed again";
    for (const ContactMemory& m : run.state().contacts) {
      if (m.status == ContactStatus::open) continue;
      ASSERT_EQ(m.bonded, 1);
      ASSERT_NEAR(m.fn - m.fd, -kStiffness * m.tributary * m.gap, 1e-9 * strength);
      // Round-off of the geometry update after an implicit step.
      ASSERT_LE(-m.fn, strength * m.tributary * (1.0 + 1e-12));
    }
    if (joint.bonded < length * (1.0 - 1e-9)) return;  // the bond is breaking, one point after another
    held = pull;
    worst = std::max(worst, std::abs(joint.normal + pull * length));
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Ledger& ledger = run.state().ledger;
  const double energy = 0.5 * strength * strength / kStiffness * length, dropped = ledger[Column::bonds_broken];
  std::printf(
      "%s: held to %.4f, open at %.4f of the strength, force off by %.1e, energy %.4f of T^2 L/2k, closure %.1e\n",
      GetParam().name, held / strength, broken / strength, worst / (strength * length), dropped / energy,
      ledger.relative_closure());
  EXPECT_LT(worst, off * length);
  EXPECT_NEAR(held, strength, off + increment * (GetParam().implicit() ? 1.0 : 0.0));
  EXPECT_NEAR(broken, strength, 2.0 * (off + increment * (GetParam().implicit() ? 1.0 : 0.0)));
  // An implicit step books the spring energy at its start, an increment of load below the strength.
  EXPECT_NEAR(dropped, energy, 0.04 * energy);
  EXPECT_LT(ledger.relative_closure(), closure_of(GetParam()));
}

TEST_P(Strength, hanging_block_stays_or_falls) {
  const double weight = kDensity * kGravity, length = 1.5;  // per square metre of joint: the block is 1 m high
  for (const double part : {2.5, 0.3}) {                    // a sudden weight doubles the static elongation
    Scene scene(kYoung, 0.0, kDensity, 30.0);
    JointLaw& law = scene.model.joints[0];
    law.normal_stiffness = law.shear_stiffness = 2e7;
    law.tensile_strength = part * weight;
    law.cohesion = 5.0 * weight;
    scene.add("ceiling", rectangle(-1, 0, 2.5, 1), true);
    const BlockId block = scene.add("block", rectangle(0, -1, length, 0));
    const double time = 0.3;
    scene
        .stage(GetParam().method, GetParam().integrator, time,
               GetParam().implicit() ? std::optional<double>(part > 1.0 ? 1e-2 : 2e-3) : std::nullopt, 0.5)
        .rest = part > 1.0;
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const Joint joint(run.state());
    const double sunk = -0.5 - centre_of(run, block).y(), fall = 0.5 * kGravity * time * time;
    std::printf("%s, strength %.1f of the weight: sinks %.5f m (w/k %.5f, free fall %.5f), closure %.1e\n",
                GetParam().name, part, sunk, weight / 2e7, fall, run.state().ledger.relative_closure());
    if (part > 1.0) {
      EXPECT_NEAR(joint.bonded, length, 1e-4);               // the block strains by 1e-6
      EXPECT_NEAR(sunk, weight / 2e7, 0.01 * weight / 2e7);  // the block's own strain adds a thousandth
    } else {
      EXPECT_EQ(joint.points, 0U);
      EXPECT_LT(sunk, fall);
      EXPECT_GT(sunk, 0.95 * fall);  // the springs took 0.3 g off the fall for less than 10 ms
      EXPECT_GT(run.state().ledger[Column::bonds_broken], 0.0);
    }
    EXPECT_LT(run.state().ledger.relative_closure(), closure_of(GetParam()));
  }
}

TEST_P(Strength, contact_that_came_later_is_never_bonded) {
  law().tensile_strength = std::numeric_limits<double>::infinity();
  scene_.add("base", rectangle(-1, -1, 2.5, 0), true);
  const BlockId block = scene_.add("block", rectangle(0, 0.01, 1.5, 1.01));
  scene_.model.initial_velocities.push_back({block, Vec2(0.0, -1.0), 0.0});
  stage(0.08, 5e-4);
  Driver run(scene_.model, scene_.plan, methods());
  EveryStep watch;
  double pressed = 0.0, pulled = 0.0;
  watch.see = [&](double) {
    const Joint joint(run.state());
    EXPECT_EQ(joint.bonded, 0.0);
    pressed = std::max(pressed, joint.normal);
    for (const ContactMemory& m : run.state().contacts) pulled = std::min(pulled, m.fn);
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_GT(pressed, 1e5);
  EXPECT_EQ(pulled, 0.0);
  EXPECT_GT(totals_of(run, block).momentum.y(), 0.0);  // and the block moves up again
}

// ---- Shear ------------------------------------------------------------------------------------------------------

/// A block astride a ridge 4 m wide, with its centre of mass in the joint: a push along the joint does not tilt it.
struct Saddle {
  static constexpr double kLength = 4.0, kWeight = 12.0 * kDensity * kGravity;
  static BlockId add_to(Scene& scene) {
    scene.model.gravity = {0.0, -kGravity};
    scene.add("ridge", rectangle(0, -4, kLength, 0), true);
    return scene.add("saddle", {{{-2, -2}, {-1, -2}, {-1, 0}, {5, 0}, {5, -2}, {6, -2}, {6, 1}, {-2, 1}}, {}});
  }
};

const Scheme kBlocks[] = {{"dda", "dda", Integrator::explicit_}, {"dda_implicit", "dda", Integrator::implicit}};
class Shear : public Strength {};

TEST_P(Shear, bonded_joint_fails_at_its_peak_and_keeps_its_residual) {
  law().friction = 30.0 * kDegree;
  law().residual_friction = 20.0 * kDegree;
  law().cohesion = 5e4;
  law().residual_cohesion = 1e4;
  law().tensile_strength = 1e4;
  Saddle::add_to(scene_);
  const double seated = 0.5, mass = Saddle::kWeight / kGravity;
  const double peak = law().cohesion * Saddle::kLength + Saddle::kWeight * std::tan(law().friction);
  scene_.model.body_accelerations.push_back({{}, {1.0, 0.0}, ramp(scene_, 1.25 * peak / mass, seated, 0.5)});
  stage(seated, 1e-2).rest = true;
  stage(0.45, 1e-3);
  Driver run(scene_.model, scene_.plan, methods());
  EveryStep watch;
  double most = 0.0, off = 0.0;
  watch.see = [&](double t) {
    if (t <= seated) return;
    const Joint joint(run.state());
    most = std::max(most, std::abs(joint.shear));
    for (const ContactMemory& m : run.state().contacts) {
      if (m.status == ContactStatus::open) continue;
      EXPECT_NE(m.bonded, m.failed);
      const double c = m.failed != 0 ? law().residual_cohesion : law().cohesion;
      const double phi = m.failed != 0 ? *law().residual_friction : law().friction;
      // The step of failure ends at the peak strength if implicit, at the residual strength if explicit.
      if (m.slip > 0.01) off = std::max(off, std::abs(std::abs(m.ft) - c * m.tributary - m.fn * std::tan(phi)));
    }
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Joint joint(run.state());
  const double residual =
      law().residual_cohesion * Saddle::kLength + Saddle::kWeight * std::tan(*law().residual_friction);
  std::printf("%s: peak %.5f, residual %.5f of c L + N tan(phi), law off by %.1e N, closure %.1e\n", GetParam().name,
              most / peak, std::abs(joint.shear) / residual, off, run.state().ledger.relative_closure());
  EXPECT_NEAR(most, peak, 5e-3 * peak);  // a step raises the load by 0.25 %
  EXPECT_NEAR(std::abs(joint.shear), residual, 1e-3 * residual);
  EXPECT_EQ(joint.bonded, 0.0);
  EXPECT_LT(off, 1e-8 * peak);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

/// The block hangs under the ridge: the pull reduces the shear strength of the bond by W tan(phi).
TEST_P(Shear, pulled_joint_shears_through_and_opens) {
  law().cohesion = 1e5;
  law().tensile_strength = 1.5e5;
  Saddle::add_to(scene_);
  scene_.model.gravity = {0.0, kGravity};
  const double seated = 0.5, mass = Saddle::kWeight / kGravity;
  const double peak = law().cohesion * Saddle::kLength - Saddle::kWeight * std::tan(law().friction);
  scene_.model.body_accelerations.push_back({{}, {1.0, 0.0}, ramp(scene_, 1.25 * peak / mass, seated, 0.5)});
  stage(seated, 1e-2).rest = true;
  stage(0.42, 1e-3);
  Driver run(scene_.model, scene_.plan, methods());
  EveryStep watch;
  double most = 0.0, pull = 0.0, held = 0.0;
  watch.see = [&](double t) {
    const Joint joint(run.state());
    if (t <= seated || joint.points == 0) return;
    EXPECT_NEAR(joint.bonded, joint.length, 1e-12);
    held = t;
    pull = -joint.normal;
    most = std::max(most, std::abs(joint.shear));
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Ledger& ledger = run.state().ledger;
  const double energy = 0.5 * (pull * pull + most * most) / (kStiffness * Saddle::kLength);
  std::printf("%s: peak %.5f of c L - W tan(phi) at t = %.3f s under %.5f of the weight, energy %.4f, closure %.1e\n",
              GetParam().name, most / peak, held, pull / Saddle::kWeight, ledger[Column::bonds_broken] / energy,
              ledger.relative_closure());
  EXPECT_NEAR(most, peak, 5e-3 * peak);  // a step raises the load by 0.25 %
  EXPECT_NEAR(pull, Saddle::kWeight, 1e-3 * Saddle::kWeight);
  EXPECT_EQ(Joint(run.state()).points, 0U);
  EXPECT_NEAR(ledger[Column::bonds_broken], energy, 0.01 * energy);
  EXPECT_EQ(ledger[Column::friction], 0.0);
  EXPECT_LT(ledger.relative_closure(), 1e-12);
}

TEST_P(Shear, friction_falls_with_slip_along_its_line) {
  const double peak = std::tan(35.0 * kDegree), residual = std::tan(15.0 * kDegree), over = 0.02;
  law().friction = 35.0 * kDegree;
  law().residual_friction = 15.0 * kDegree;
  law().weakening_slip = over;
  const BlockId block = Saddle::add_to(scene_);
  const double seated = 0.5;
  scene_.model.body_accelerations.push_back({{}, {0.75 * kGravity, 0.0}, ramp(scene_, 1.0, seated, 0.05)});
  stage(seated, 1e-2).rest = true;
  stage(0.3, 1e-3);
  Driver run(scene_.model, scene_.plan, methods());
  EveryStep watch;
  std::map<ContactKey, double> before;
  double off = 0.0, way_off = 0.0;
  int at_peak = 0, between = 0, at_residual = 0;
  watch.see = [&](double t) {
    for (const ContactMemory& m : run.state().contacts) {
      // The friction limit is that for the slip at the start of the step.
      const double s = std::exchange(before[m.key], m.slip);
      if (t <= seated || m.status != ContactStatus::slip) continue;
      const double mu = peak + (residual - peak) * std::min(1.0, s / over);
      off = std::max(off, std::abs(std::abs(m.ft) - m.fn * mu));
      const double moved = centre_of(run, block).x() - 2.0;
      way_off = std::max(way_off, std::abs(moved - m.slip - std::abs(m.ft) / (kStiffness * m.tributary)));
      ++(s == 0.0 ? at_peak : (s < over ? between : at_residual));
    }
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  std::printf("%s: %d points at peak, %d between, %d at residual; law off by %.1e N, slip by %.1e m, closure %.1e\n",
              GetParam().name, at_peak, between, at_residual, off, way_off, run.state().ledger.relative_closure());
  EXPECT_GT(at_peak, 0);
  EXPECT_GT(between, 50);
  EXPECT_GT(at_residual, 50);
  EXPECT_LT(off, 1e-9 * Saddle::kWeight);
  EXPECT_LT(way_off, 5e-5);  // elastic shear of the block
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

// ---- Changes that a bond survives --------------------------------------------------------------------------------

TEST(Bonds, outlive_hand_over_and_new_meshes) {
  const double weight = kDensity * kGravity, length = 1.5, k = 2e7;
  Scene scene(kYoung, 0.0, kDensity, 30.0);
  JointLaw& law = scene.model.joints[0];
  law.normal_stiffness = law.shear_stiffness = k;
  law.tensile_strength = 3.0 * weight;
  law.cohesion = 5.0 * weight;
  scene.add("ceiling", rectangle(-1, 0, 2.5, 1), true);
  const BlockId block = scene.add("block", rectangle(0, -1, length, 0));
  scene.stage("nmm", Integrator::explicit_, 0.3, std::nullopt, 0.5).rest = true;
  scene.stage("dda", Integrator::implicit, 0.1, 1e-3);
  scene.stage("nmm", Integrator::implicit, 0.1, 1e-3, 0.3);
  scene.stage("nmm", Integrator::explicit_, 0.1, std::nullopt, 0.4);
  Driver run(scene.model, scene.plan, methods());
  std::map<std::size_t, int> counts;
  EveryStep watch;
  watch.see = [&](double) {
    const Joint joint(run.state());
    ++counts[joint.points];
    EXPECT_NEAR(joint.bonded, length, 1e-4);  // the block strains by 1e-6
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  EXPECT_GE(counts.size(), 3U);  // three meshes and an affine block, each with other contact points
  EXPECT_NEAR(-0.5 - centre_of(run, block).y(), weight / k, 0.02 * weight / k);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-10);
}

/// Gravity is tilted until the joint is torn open at one end, and then turned back.
TEST(Bonds, torn_end_stays_torn_in_a_new_mesh) {
  Scene scene(kYoung, 0.0, kDensity, 30.0);
  JointLaw& law = scene.model.joints[0];
  law.normal_stiffness = law.shear_stiffness = 1e8;
  law.tensile_strength = 3e3;
  law.cohesion = 1e5;
  scene.add("base", rectangle(-1, -1, 3, 0), true);
  scene.add("block", rectangle(0, 0, 2, 1));
  TimeFunction tilt;
  tilt.shape = TimeFunction::Shape::table;
  tilt.time = {0.0, 0.3, 0.6};
  tilt.table = {0.0, 1.0, 0.0};
  scene.model.functions.push_back(tilt);
  // The weight acts 0.6 m beside the middle: without strength only 3 (1 - 0.6) m of the joint would stay closed.
  scene.model.body_accelerations.push_back({{}, {1.2 * kGravity, 0.0}, FunctionId{0}});
  for (const double cover : {0.35, 0.22}) {
    Stage& stage = scene.stage("nmm", Integrator::implicit, cover == 0.35 ? 0.7 : 0.1, 0.01, cover);
    stage.dynamics = 0.0;
  }
  Driver run(scene.model, scene.plan, methods());
  double first = 0.0, second = -1.0, closed = 0.0, torn = 0.0;
  Watch watch;  // the first stage ends with a frame, and the second begins with one
  watch.see = [&](const FrameView& view) {
    const Joint joint(*view.state);
    if (view.state->stage == 0) {
      first = joint.bonded;
      closed = joint.length;
      torn = std::max(torn, 2.0 - joint.length);
    } else if (second < 0.0) {
      second = joint.bonded;
    }
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Joint last(run.state());
  std::printf(
      "torn open %.3f m; closed %.3f m, bonded %.3f m, %.3f m in the new mesh, %.3f m at the end, closure %.1e\n", torn,
      closed, first, second, last.bonded, run.state().ledger.relative_closure());
  EXPECT_GT(torn, 0.3);
  EXPECT_NEAR(closed, 2.0, 1e-3);
  EXPECT_LT(first, 2.0 - torn + 1e-3);
  EXPECT_GT(first, 0.5);
  EXPECT_NEAR(second, 1.0, 0.22);  // a corner's bond reaches to the middle: within half a segment of a mesh
  EXPECT_NEAR(last.bonded, second, 1e-3);
  EXPECT_NEAR(last.normal, 2.0 * kDensity * kGravity, 1e-3 * kDensity * kGravity);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-10);
}

/// The block is dragged on soft springs; its corner passes from one edge of the base to the next collinear one.
TEST(Bonds, pass_with_a_corner_to_the_next_edge_in_line) {
  for (const Scheme& scheme : kBlocks) {
    Scene scene(kYoung, 0.0, kDensity, 30.0);
    JointLaw& law = scene.model.joints[0];
    law.normal_stiffness = 1e8;
    law.shear_stiffness = 1e6;
    law.tensile_strength = std::numeric_limits<double>::infinity();
    scene.model.gravity = {0.3 * kGravity, 0.2 * kGravity};  // up, and along
    scene.add("base", {{{-1, -1}, {3, -1}, {3, 0}, {1.0005, 0}, {-1, 0}}, {}}, true);
    const BlockId block = scene.add("block", rectangle(0, 0, 1, 0.2));
    scene.stage(scheme.method, scheme.integrator, 0.5, scheme.implicit() ? std::optional<double>(5e-3) : std::nullopt)
        .damping = 30.0;
    scene.plan.stages[0].damp_rigid_motion = true;
    Driver run(scene.model, scene.plan, methods());
    double least = 1.0, farthest = 0.0;
    bool passed = false;
    EveryStep watch;
    watch.see = [&](double) {
      const State& state = run.state();
      least = std::min(least, Joint(state).bonded);
      farthest = std::max(farthest, centre_of(run, block).x() - 0.5);
      for (const ContactMemory& m : state.contacts)
        passed =
            passed || (m.status != ContactStatus::open && m.key.block_p == 1 && m.key.block_e == 0 && m.key.edge == 2);
    };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const double weight = 0.2 * kDensity * kGravity;
    std::printf("%s: goes %.4f m, %.3f m bonded at least, pull %.4f of the load, closure %.1e\n", scheme.name, farthest,
                least, -Joint(run.state()).normal / (0.2 * weight), run.state().ledger.relative_closure());
    EXPECT_TRUE(passed);
    EXPECT_NEAR(least, 1.0, 1e-4);
    EXPECT_NEAR(-Joint(run.state()).normal, 0.2 * weight, 0.02 * weight);
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(schemes, Strength, testing::ValuesIn(kSchemes), kNames);
INSTANTIATE_TEST_SUITE_P(schemes, Shear, testing::ValuesIn(kBlocks), kNames);

}  // namespace
}  // namespace scree::test::joint_strength_test
