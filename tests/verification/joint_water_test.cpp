// Water in joints against formulas: resultants, effective forces, friction, uplift, the ledger.
#include "model/joint_water.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/support/schemes.h"

namespace scree::test::joint_water_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2000.0, kYoung = 1e10, kStiffness = 1e9, kWater = 9810.0;

class Water : public testing::TestWithParam<Scheme> {
 protected:
  Water() {
    law().normal_stiffness = law().shear_stiffness = kStiffness;
    scene_.model.gravity = {0.0, -kGravity};
  }
  Stage& stage(double duration, double dt) {
    return scene_.stage(GetParam().method, GetParam().integrator, duration,
                        GetParam().implicit() ? std::optional<double>(dt) : std::nullopt, 0.5);
  }
  /// A level piezometric line at a height.
  void fill_to(double y) { scene_.model.waters = {{{{-1.0, y}, {1.0, y}}, kWater}}; }
  JointLaw& law() { return scene_.model.joints[0]; }
  Scene scene_{kYoung, 0.0, kDensity, 30.0};
};

// ---- Resultants -------------------------------------------------------------------------------------------------

/// Force along x and moment about y = 0 of the water on the block, from the first frame.
struct Resultant {
  double force = 0.0, moment = 0.0;
  int points = 0;
};
Resultant crack_of(const char* method, double cover, const JointWater& water) {
  Scene scene(kYoung, 0.0, kDensity, 30.0);
  scene.model.gravity = {0.0, 0.0};
  scene.add("wall", rectangle(-1, -1, 0, 5), true);
  scene.add("block", rectangle(0, 0, 2, 4));
  scene.stage(method, Integrator::explicit_, 1e-6, std::nullopt, cover);
  scene.model.waters = {water};
  scene.plan.output.contacts = true;
  Driver run(scene.model, scene.plan, methods());
  Resultant out;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    if (view.time > 0.0) return;
    for (std::size_t i = 0; i < view.contacts->memory.size(); ++i) {
      const ContactMemory& m = view.contacts->memory[i];
      // Force on the block: on its own corner, or as the reaction on its edge, at the same height.
      const double on_block = (m.key.block_p == 1 ? 1.0 : -1.0) * m.water * view.contacts->normal[2 * i];
      out.force += on_block;
      out.moment += on_block * view.contacts->position[2 * i + 1];
      out.points += m.water > 0.0 ? 1 : 0;
    }
  };
  run.add_sink(watch);
  EXPECT_EQ(run.run().status, RunEnd::Status::done);
  return out;
}

TEST(WaterResultant, is_that_of_the_pressure_whatever_the_mesh) {
  struct {
    double level, slope;  // of the piezometric line; level at x = 0
  } const lines[] = {{6.0, 0.0}, {2.5, 0.0}, {3.0, 0.2}};
  for (const auto& line : lines) {
    const JointWater water{{{-1.0, line.level - line.slope}, {1.0, line.level + line.slope}}, kWater};
    // u = w (level - y) over the height H of the joint, or up to the level.
    const double top = std::min(4.0, line.level);
    const double force = kWater * (line.level * top - top * top / 2.0),
                 moment = kWater * (line.level * top * top / 2.0 - top * top * top / 3.0);
    for (const auto& [method, cover] : {std::pair("dda", 1.0), {"nmm", 1.3}, {"nmm", 0.7}, {"nmm", 0.31}}) {
      const Resultant found = crack_of(method, cover, water);
      EXPECT_NEAR(found.force, force, 1e-12 * force) << method << ' ' << cover;
      EXPECT_NEAR(found.moment, moment, 1e-12 * moment) << method << ' ' << cover;
      EXPECT_GT(found.points, 0);
    }
  }
}

TEST(WaterResultant, is_nothing_in_joints_that_it_does_not_fill) {
  JointWater water{{{-1.0, 6.0}, {1.0, 6.0}}, kWater};
  water.joints = {JointId{1}};
  EXPECT_EQ(crack_of("dda", 1.0, water).force, 0.0);
}

// ---- Blocks on a wet joint --------------------------------------------------------------------------------------

TEST_P(Water, leaves_the_weight_less_its_uplift_to_the_contact) {
  scene_.add("base", rectangle(-1, -1, 3, 0), true);
  scene_.add("block", rectangle(0, 0, 2, 1));
  fill_to(1.2);
  stage(2.0, 0.05).rest = true;
  Driver run(scene_.model, scene_.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  double effective = 0.0, water = 0.0;
  for (const ContactMemory& m : run.state().contacts) {
    effective += m.fn;
    water += m.water;
  }
  const double weight = 2.0 * kDensity * kGravity, uplift = 2.0 * kWater * 1.2;
  std::printf("%s: effective %.8f of W - U, closure %.1e\n", GetParam().name, effective / (weight - uplift),
              run.state().ledger.relative_closure());
  EXPECT_NEAR(effective + water, weight, 1e-4 * weight);
  EXPECT_NEAR(water, uplift, 2e-5 * uplift);  // the joint opens by 2e-5 m
  EXPECT_NEAR(effective, weight - uplift, 2e-4 * weight);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

/// A block pushed along its joint by H slides with the acceleration (H - (W - U) tan phi)/m if that is positive.
TEST_P(Water, takes_friction_away) {
  const double level = 0.6, uplift = 2.0 * kWater * level, weight = 2.0 * 0.4 * kDensity * kGravity;
  const double mass = weight / kGravity, cap = (weight - uplift) * std::tan(30.0 * kDegree);
  for (const double part : {0.998, 1.002, 1.5}) {
    Scene scene(kYoung, 0.0, kDensity, 30.0);
    scene.model.joints[0].normal_stiffness = scene.model.joints[0].shear_stiffness = kStiffness;
    scene.model.gravity = {0.0, -kGravity};
    scene.add("base", rectangle(-1, -1, 4, 0), true);
    const BlockId block = scene.add("block", rectangle(0, 0, 2, 0.4));
    scene.model.waters = {{{{-1.0, level}, {1.0, level}}, kWater}};
    TimeFunction push;
    push.shape = TimeFunction::Shape::ramp;
    push.start = 0.5;
    push.duration = 0.1;
    scene.model.functions.push_back(push);
    scene.model.body_accelerations.push_back({{}, {part * cap / mass, 0.0}, FunctionId{0}});
    const auto dt = [&](double h) { return GetParam().implicit() ? std::optional<double>(h) : std::nullopt; };
    scene.stage(GetParam().method, GetParam().integrator, 0.5, dt(0.05), 0.4).rest = true;
    scene.stage(GetParam().method, GetParam().integrator, 0.4, dt(1e-3), 0.4);
    Driver run(scene.model, scene.plan, methods());
    double from = 0.0, to = 0.0, begin = 0.0, end = 0.0;
    EveryStep watch;
    watch.see = [&](double t) {
      if (t < 0.65) return;
      const double v = totals_of(run, block).momentum.x() / mass;
      if (begin == 0.0) from = v, begin = t;
      to = v, end = t;
    };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const double found = (to - from) / (end - begin), wanted = std::max(0.0, part - 1.0) * cap / mass;
    std::printf("%s: %.3f of (W - U) tan(phi): acceleration %.6f m/s2, formula %.6f, closure %.1e\n", GetParam().name,
                part, found, wanted, run.state().ledger.relative_closure());
    EXPECT_NEAR(found, wanted, 1e-3 * cap / mass * (part > 1.1 ? part - 1.0 : 1.0));
    EXPECT_EQ(to > 1e-3 * cap / mass * 0.1, part > 1.0) << to;
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  }
}

TEST_P(Water, lifts_a_block_that_is_lighter) {
  const double level = 3.0, weight = 2.0 * kDensity * kGravity, mass = weight / kGravity;
  const double uplift = 2.0 * kWater * level;
  scene_.add("base", rectangle(-1, -1, 3, 0), true);
  const BlockId block = scene_.add("block", rectangle(0, 0, 2, 1));
  fill_to(level);
  const double time = 0.1;
  stage(time, 2e-4);
  Driver run(scene_.model, scene_.plan, methods());
  double pressed = 0.0;
  EveryStep watch;
  watch.see = [&](double) {
    for (const ContactMemory& m : run.state().contacts) pressed = std::max(pressed, m.fn);
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  // The pressure is evaluated in the middle of the gap: m y'' = U - W - w L y/2.
  const double k = kWater, omega = std::sqrt(k / mass), rise = (uplift - weight) / k * (1.0 - std::cos(omega * time));
  const double found = centre_of(run, block).y() - 0.5;
  const Ledger& ledger = run.state().ledger;
  const double work = uplift * rise - 0.5 * k * rise * rise;
  std::printf("%s: rises %.6f of the formula, work of water %.6f, closure %.1e\n", GetParam().name, found / rise,
              ledger[Column::water] / work, ledger.relative_closure());
  // The tolerances cover waves of the sudden pressure in a meshed block, and the pressure of an implicit step, which is
  // that at the start of the step.
  EXPECT_NEAR(found, rise, 5e-5 * rise);
  EXPECT_NEAR(ledger[Column::water], work, 2e-4 * work);
  EXPECT_LT(pressed, 1e-3 * weight);
  EXPECT_LT(ledger.relative_closure(), 1e-9);
}

/// Water between two free blocks pushes both apart: the sum of their momenta stays zero, and the water does work.
TEST_P(Water, parts_two_free_blocks_without_momentum) {
  scene_.model.gravity = {0.0, 0.0};
  const BlockId left = scene_.add("left", rectangle(0, 0, 1, 1)), right = scene_.add("right", rectangle(1, 0, 3, 1));
  fill_to(20.0);
  stage(0.02, 1e-4);
  Driver run(scene_.model, scene_.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const BodyTotals a = totals_of(run, left), b = totals_of(run, right);
  EXPECT_LT(a.momentum.x(), -100.0);
  EXPECT_NEAR(a.momentum.x() + b.momentum.x(), 0.0, 1e-9 * b.momentum.x());
  EXPECT_NEAR(a.momentum.y() + b.momentum.y(), 0.0, 1e-9 * b.momentum.x());
  // Implicit steps rotate the blocks after equilibrium is found, hence the larger tolerance.
  EXPECT_NEAR(a.angular_momentum + b.angular_momentum, 0.0, (GetParam().implicit() ? 2e-6 : 1e-9) * b.momentum.x());
  EXPECT_GT(run.state().ledger[Column::water], 0.0);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

TEST(WaterAndTrapezoid, is_refused) {
  Scene scene;
  scene.add("block", rectangle(0, 0, 1, 1));
  scene.model.waters = {{{{-1.0, 1.0}, {1.0, 1.0}}, kWater}};
  scene.stage("nmm", Integrator::implicit, 1e-3, 1e-4).newmark = NewmarkScheme::trapezoidal;
  Driver run(scene.model, scene.plan, methods());
  EXPECT_THROW((void)run.run(), PlanError);
}

INSTANTIATE_TEST_SUITE_P(schemes, Water, testing::ValuesIn(kAllSchemes),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::test::joint_water_test
