// Contacts of blocks that rest, slide, stand in a column and collide. References: no creep, Coulomb's acceleration on a
// slope, the elastic compression of a column, the penetration at which one contact point stores all kinetic energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "model/random.h"
#include "tests/support/outlines.h"
#include "tests/support/schemes.h"

namespace scree::test::contact_claims_test {
namespace {

using namespace coupling;

constexpr double kGravity = 9.81, kDensity = 2600.0;

const auto kSchemes =
    testing::Values(Scheme{"nmm", "nmm", Integrator::explicit_}, Scheme{"nmm_implicit", "nmm", Integrator::implicit},
                    Scheme{"dda", "dda", Integrator::explicit_}, Scheme{"dda_implicit", "dda", Integrator::implicit});
std::string scheme_name(const testing::TestParamInfo<Scheme>& of) { return of.param.name; }

// ---- Slopes -----------------------------------------------------------------------------------------------------

/// A flat block on a slope of 25 degrees, brought to rest without sliding; then its friction acts.
struct Slope {
  static constexpr double kAngle = 25.0;
  Scene scene;
  BlockId slider;
  Mat2 R = rotation(-kAngle * kDegree);

  Slope(const Scheme& scheme, double friction_deg, double young, double rest, double time)
      : scene(young, 0.2, kDensity, friction_deg) {
    scene.add("plane", transformed(rectangle(-5, -1, 20, 0), Vec2(0, 0), R), true);
    slider = scene.add("slider", transformed(rectangle(0, 0, 1, 0.5), Vec2(0, 0), R));
    const std::optional<double> dt = scheme.implicit() ? std::optional<double>(2e-3) : std::nullopt;
    if (rest > 0.0) scene.stage(scheme.method, scheme.integrator, rest, dt, 0.6).rest = true;
    scene.stage(scheme.method, scheme.integrator, time, dt, 0.6);
    scene.plan.output.every = scene.plan.output.history_every = ticks(time / 10);
  }
};

class Claims : public testing::TestWithParam<Scheme> {};

TEST_P(Claims, block_on_a_slope_does_not_creep) {
  Slope slope(GetParam(), 35.0, 2e7, 1.0, 9.0);  // soft, so that the explicit steps are long
  Driver run(slope.scene.model, slope.scene.plan, methods());
  Vec2 at_rest(0.0, 0.0);
  double creep = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    const Vec2 centre = centre_of(run, slope.slider);
    if (view.time < 1.0 || view.state->stage == 0) return;
    if (at_rest.isZero()) at_rest = centre;
    creep = std::max(creep, (centre - at_rest).norm());
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  std::printf("%s: creeps %.1e m from t = 1 to 10 s, closure %.1e\n", GetParam().name, creep,
              run.state().ledger.relative_closure());
  EXPECT_FALSE(at_rest.isZero());
  EXPECT_LT(creep, 1e-6 * 0.5);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

TEST_P(Claims, slope_holds_a_tenth_of_a_degree_below_friction_and_slides_above) {
  for (const double more : {0.1, -0.1}) {
    const double phi = Slope::kAngle + more, time = 2.0;
    Slope slope(GetParam(), phi, 1e8, 0.5, time);
    Driver run(slope.scene.model, slope.scene.plan, methods());
    struct {
      double x, v, t;
    } first{}, last{};
    const Vec2 down = slope.R * Vec2(1.0, 0.0);
    Watch watch;
    watch.see = [&](const FrameView& view) {
      if (view.state->stage == 0 || view.time < 1.2) return;  // the friction springs are stretched by then
      const BodyTotals t = totals_of(run, slope.slider);
      last = {down.dot(t.centre), down.dot(t.momentum) / t.mass, view.time};
      if (first.t == 0.0) first = last;
    };
    run.add_sink(watch);
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const double a = Slope::kAngle * kDegree, duration = last.t - first.t, moved = last.x - first.x,
                 acceleration = (last.v - first.v) / duration,
                 coulomb = kGravity * (std::sin(a) - std::cos(a) * std::tan(phi * kDegree));
    ASSERT_GT(duration, 1.0);
    std::printf("%s phi %.1f: moves %.2e m, acceleration %.5f of %.5f m/s2, closure %.1e\n", GetParam().name, phi,
                moved, acceleration, coulomb, run.state().ledger.relative_closure());
    if (more > 0.0)
      EXPECT_LT(std::abs(moved), 1e-6);
    else
      EXPECT_NEAR(acceleration, coulomb, kGravity * 0.005 * kDegree);  // strains of 1e-4 turn edges by about this angle
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  }
}

TEST_P(Claims, bouncing_and_sliding_block_closes_its_ledger) {
  Scene scene(1e8, 0.2, kDensity, 20.0);
  const Mat2 R = rotation(-20.0 * kDegree);
  scene.add("plane", transformed(rectangle(-5, -1, 20, 0), Vec2(0, 0), R), true);
  const BlockId block = scene.add(
      "block", transformed(transformed(rectangle(0, 0, 1, 0.6), Vec2(0, 0), rotation(0.3)), R * Vec2(0, 0.5), R));
  scene.model.initial_velocities.push_back({block, R * Vec2(3.0, -1.0), -1.0});
  const Scheme scheme = GetParam();
  scene.stage(scheme.method, scheme.integrator, 2.0, scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt,
              0.6);
  scene.plan.output.every = ticks(0.02);
  Driver run(scene.model, scene.plan, methods());
  double worst = 0.0;
  int lifts = 0;
  bool closed = false;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    worst = std::max(worst, view.state->ledger.relative_closure());
    const bool now = std::any_of(view.state->contacts.begin(), view.state->contacts.end(),
                                 [](const ContactMemory& m) { return m.status != ContactStatus::open; });
    lifts += closed && !now ? 1 : 0;
    closed = now;
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const Ledger& ledger = run.state().ledger;
  std::printf("%s: lifts off %d times, friction took %.3g J, closure %.1e\n", scheme.name, lifts,
              ledger[Column::friction], worst);
  EXPECT_GE(lifts, 1);
  EXPECT_GT(ledger[Column::friction], 100.0);
  EXPECT_LT(worst, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(schemes, Claims, kSchemes, scheme_name);

// ---- A column ---------------------------------------------------------------------------------------------------

// All schemes except implicit steps of the NMM.
const Scheme kQuick[] = {{"nmm", "nmm", Integrator::explicit_},
                         {"dda", "dda", Integrator::explicit_},
                         {"dda_implicit", "dda", Integrator::implicit}};

class Column20 : public testing::TestWithParam<Scheme> {};

/// Gravity is applied at once: the column oscillates to at most twice the elastic compression and stands.
TEST_P(Column20, stands) {
  const Scheme scheme = GetParam();
  constexpr int kBlocks = 20;
  const double young = 1e9, side = 1.0;
  Scene scene(young, 0.2, kDensity, 30.0);
  scene.add("base", rectangle(-2, -1, 3, 0), true);
  for (int i = 0; i < kBlocks; ++i) scene.add("b", rectangle(0, i, side, i + 1));
  const double time = scheme.name == std::string("nmm") ? 0.4 : 2.0;  // two oscillations and more
  scene.stage(scheme.method, scheme.integrator, time, scheme.implicit() ? std::optional<double>(5e-3) : std::nullopt,
              0.8);
  if (std::string(scheme.method) == "nmm")
    for (std::int32_t i = 1; i <= kBlocks; ++i) scene.plan.stages[0].rules.push_back({{BlockId{i}}, "nmm", 0.0, true});
  scene.plan.output.every = ticks(0.02);
  // Sum over blocks and joints of the weight above, divided by the stiffness: E' of a block, E'/1 m of a joint.
  const double modulus = scene.model.elasticity_of(BlockId{1}).p_modulus(), soft = young;  // unconfined: below E'
  const double static_top = kDensity * kGravity * 0.5 * kBlocks * (kBlocks + 1.0) * (1.0 / soft + 1.0 / modulus);
  Driver run(scene.model, scene.plan, methods());
  double down = 0.0, sideways = 0.0;
  Watch watch;
  watch.see = [&](const FrameView&) {
    for (std::int32_t i = 1; i <= kBlocks; ++i) {
      const Vec2 moved = centre_of(run, BlockId{i}) - Vec2(0.5, i - 0.5);
      down = std::max(down, -moved.y());
      sideways = std::max(sideways, std::abs(moved.x()));
    }
  };
  run.add_sink(watch);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  std::printf("%s: sinks %.3e m of %.3e, sideways %.1e m, closure %.1e\n", scheme.name, down, 2.0 * static_top,
              sideways, run.state().ledger.relative_closure());
  EXPECT_LT(down, 2.0 * static_top);
  EXPECT_LT(sideways, 0.01 * static_top);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, Column20, testing::ValuesIn(kQuick), scheme_name);

// ---- Blocks thrown together -------------------------------------------------------------------------------------

class Thrown : public testing::TestWithParam<Scheme> {};

TEST_P(Thrown, never_deeper_than_the_penalty_allows) {
  const Scheme scheme = GetParam();
  double deepest_part = 0.0;
  for (const double speed : {5.0, 20.0}) {
    Scene scene(1e9, 0.2, kDensity, 20.0);
    scene.model.joints[0].penalty = 1e9;
    scene.model.gravity.setZero();
    Random random(11);
    std::vector<BlockId> ids;
    for (int i = 0; i < 10; ++i) {
      const double angle = 2.0 * M_PI * i / 10.0;
      const Vec2 centre = 3.0 * Vec2(std::cos(angle), std::sin(angle));
      ids.push_back(
          scene.add("b", transformed(rectangle(-0.5, -0.4, 0.5, 0.4), centre, rotation(random.uniform() * 6.0))));
      scene.model.initial_velocities.push_back(
          {ids.back(), -speed * (0.8 + 0.2 * random.uniform()) * centre.normalized(), random.uniform() * 4.0 - 2.0});
    }
    scene.stage(scheme.method, scheme.integrator, 5.0 / speed,
                scheme.implicit() ? std::optional<double>(2e-3 / speed) : std::nullopt, 0.6);
    scene.plan.output.every = scene.plan.stages[0].duration / 400;
    Driver run(scene.model, scene.plan, methods());
    // Upper bound: one contact point that stores all kinetic energy, k d^2/2 = E.
    const double energy = 10 * 0.5 * kDensity * 0.8 * speed * speed * 1.01, limit = std::sqrt(2.0 * energy / 1e9);
    double deepest = 0.0;
    Watch watch;
    watch.see = [&](const FrameView&) {
      std::vector<Ring> rings;
      rings.reserve(ids.size());
      for (const BlockId id : ids) rings.push_back(outline_of(run, id));
      for (std::size_t a = 0; a < rings.size(); ++a)
        for (std::size_t b = 0; b < rings.size(); ++b)
          if (a != b) deepest = std::max(deepest, depth_in(rings[a], rings[b]));
    };
    run.add_sink(watch);
    const RunEnd end = run.run();
    ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
    std::printf("%s %g m/s: %.3e m deep of %.3e, closure %.1e\n", scheme.name, speed, deepest, limit,
                run.state().ledger.relative_closure());
    EXPECT_GT(deepest, 0.01 * limit);  // they met
    EXPECT_LT(deepest, limit);
    EXPECT_LT(limit, 0.4);  // half a block's width: at less depth nothing has passed through
    EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
    deepest_part = std::max(deepest_part, deepest / limit);
  }
}

/// A fast block does not pass through a plate of a hundredth of its thickness.
TEST_P(Thrown, thin_plate_is_not_passed) {
  const Scheme scheme = GetParam();
  Scene scene(1e9, 0.2, kDensity, 20.0);
  scene.model.gravity.setZero();
  const BlockId plate = scene.add("plate", rectangle(0.0, -0.5, 0.01, 0.5), true),
                block =
                    scene.add("block", transformed(rectangle(-0.5, -0.5, 0.5, 0.5), Vec2(-0.8, 0.1), rotation(0.6)));
  scene.model.initial_velocities.push_back({block, Vec2(20.0, 0.0), 0.0});
  scene.stage(scheme.method, scheme.integrator, 0.1, scheme.implicit() ? std::optional<double>(1e-3) : std::nullopt,
              0.6);
  scene.plan.output.every = ticks(1e-3);
  Driver run(scene.model, scene.plan, methods());
  double farthest = -1.0;
  Watch watch;
  watch.see = [&](const FrameView&) { farthest = std::max(farthest, centre_of(run, block).x()); };
  run.add_sink(watch);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  std::printf("%s: centre to x = %.4f m, leaves with %.2f m/s, %lld cuts, closure %.1e\n", scheme.name, farthest,
              totals_of(run, block).momentum.x() / kDensity, static_cast<long long>(run.stats().cuts),
              run.state().ledger.relative_closure());
  EXPECT_TRUE(plate.valid());
  EXPECT_LT(farthest, -0.4);
  EXPECT_LT(totals_of(run, block).momentum.x(), 0.0);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, Thrown, testing::ValuesIn(kQuick), scheme_name);

}  // namespace
}  // namespace scree::test::contact_claims_test
