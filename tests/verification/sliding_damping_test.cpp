// Blocks that slide on steep planes: rigid sliding with the standard damping, flutter without it, no damping of sliding
// or spin, and site response if little of a block slips.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::sliding_damping_test {
namespace {

using namespace coupling;

constexpr double kSlope = 40.0 * kDegree, kGravity = 9.81;

/// A block of 2 x 1 m with friction 2 degrees above the slope, thrown down it at a speed; gravity from the start, the
/// springs without load at first.
struct Thrown {
  Scene scene{5e10, 0.2, 2600.0, 42.0};
  BlockId block;
  explicit Thrown(const std::string& method, Integrator integrator, std::optional<double> dt, double speed,
                  double duration) {
    scene.model.gravity = kGravity * Vec2(-std::sin(kSlope), -std::cos(kSlope));
    scene.add("plane", rectangle(-8, -2, 6, 0), true);
    block = scene.add("block", rectangle(0, 0, 2, 1));
    scene.model.initial_velocities.push_back({block, Vec2(-speed, 0.0), 0.0});
    scene.stage(method, integrator, duration, dt, 0.5);
  }
};

class SteepSlide : public testing::TestWithParam<std::tuple<std::string, Integrator>> {
 protected:
  [[nodiscard]] std::string method() const { return std::get<0>(GetParam()); }
  [[nodiscard]] Integrator integrator() const { return std::get<1>(GetParam()); }
  [[nodiscard]] std::optional<double> dt() const {
    return integrator() == Integrator::implicit ? std::optional<double>(2e-4) : std::nullopt;
  }
};

TEST_P(SteepSlide, a_thrown_block_is_slowed_as_a_rigid_one_and_stays_where_it_stops) {
  // v' = g (sin a - cos a tan phi) < 0: the block stops after v/|v'|.
  const double slows = kGravity * (std::cos(kSlope) * std::tan(42.0 * kDegree) - std::sin(kSlope)), speed = 0.3;
  Thrown thrown(method(), integrator(), dt(), speed, speed / slows + 0.3);
  Driver run(thrown.scene.model, thrown.scene.plan, methods());
  const Vec2 start = moments(thrown.scene.model.blocks[thrown.block.index()].polygon).centroid;
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const double way = start.x() - centre_of(run, thrown.block).x(), rigid = 0.5 * speed * speed / slows;
  const BodyTotals end = totals_of(run, thrown.block);
  std::printf("%s: %.5f m, rigid %.5f m, speed at the end %.1e m/s, closure %.1e, deformation damping %.2e J\n",
              method().c_str(), way, rigid, end.momentum.norm() / end.mass, run.state().ledger.relative_closure(),
              run.state().ledger[Column::deformation_damping]);
  EXPECT_NEAR(way / rigid, 1.0, 0.02);
  EXPECT_LT(end.momentum.norm() / end.mass, 1e-3 * speed);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  EXPECT_GT(run.state().ledger[Column::deformation_damping], 0.0);
}

INSTANTIATE_TEST_SUITE_P(all, SteepSlide,
                         testing::Combine(testing::Values("dda", "nmm"),
                                          testing::Values(Integrator::explicit_, Integrator::implicit)));

TEST(SlidingFlutter, comes_with_the_bare_equations_and_goes_with_the_standard_settings) {
  double way[2];
  for (const bool bare : {true, false}) {
    Scene scene(5e10, 0.2, 2600.0, std::atan((std::sin(kSlope) - 0.01) / std::cos(kSlope)) / kDegree);
    scene.model.gravity = kGravity * Vec2(-std::sin(kSlope), -std::cos(kSlope));
    scene.add("plane", rectangle(-30, -3, 15, 0), true);
    const BlockId block = scene.add("block", rectangle(0, 0, 10, 5));
    Stage& stage = scene.stage("dda", Integrator::explicit_, 3.0, std::nullopt);
    if (bare) {
      scene.model.joints[0].damping = 0.2;
      stage.sliding_damping = 0.0;
    }
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    way[bare ? 0 : 1] = 5.0 - centre_of(run, block).x();
  }
  const double rigid = 0.5 * 0.01 * kGravity * 9.0;
  std::printf("bare %.3f m, standard %.4f m, rigid %.4f m\n", way[0], way[1], rigid);
  EXPECT_GT(way[0], 1.5 * rigid);
  EXPECT_NEAR(way[1] / rigid, 1.0, 0.1);  // gravity at once: the block bounces before it slides
}

TEST(SlidingDamping, slows_neither_slide_nor_spin) {
  // A frictionless slide is not slowed: only its deformation is damped, and momenta change by the contact alone.
  Scene scene(1e9, 0.2, 2600.0, 0.0);
  scene.model.gravity = Vec2(0.0, -kGravity);
  scene.add("plane", rectangle(-5, -2, 15, 0), true);
  const BlockId block = scene.add("block", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({block, Vec2(3.0, 0.0), 0.0});
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.4);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const BodyTotals end = totals_of(run, block);
  EXPECT_NEAR(end.momentum.x() / end.mass, 3.0, 3e-6);  // the corners of a rocking block push slightly sideways
  EXPECT_GT(run.state().ledger[Column::deformation_damping], 0.0);
}

/// A stack of five blocks of 10 x 2 m, thrown up a plane of 25 degrees; friction of 30 degrees in every joint.
class ThrownStack : public testing::TestWithParam<Integrator> {
 protected:
  static constexpr double kDip = 25.0 * kDegree, kSpeed = 2.0;
  ThrownStack() {
    scene_.model.gravity = kGravity * Vec2(-std::sin(kDip), -std::cos(kDip));
    scene_.add("plane", rectangle(-20, -5, 30, 0), true);
    for (int i = 0; i < 5; ++i) {
      blocks_.push_back(scene_.add("block-" + std::to_string(i), rectangle(0, 2 * i, 10, 2 * i + 2)));
      scene_.model.initial_velocities.push_back({blocks_.back(), Vec2(kSpeed, 0.0), 0.0});
    }
    scene_.stage("nmm", GetParam(), 2.2, GetParam() == Integrator::implicit ? std::optional(1e-3) : std::nullopt, 2.0);
  }
  [[nodiscard]] std::vector<double> ways(const Driver& run) const {
    std::vector<double> out;
    for (const BlockId b : blocks_) out.push_back(centre_of(run, b).x() - 5.0);
    return out;
  }
  Scene scene_{5e9, 0.2, 2600.0, 30.0};
  std::vector<BlockId> blocks_;
};

TEST_P(ThrownStack, of_meshed_blocks_stops_and_stays_where_it_is) {
  // Without StackDamping the stack keeps bouncing and loses friction: its top moves down by 0.17 m in the last second.
  Driver run(scene_.model, scene_.plan, methods());
  (void)run.run(1.2);
  const std::vector<double> then = ways(run);
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const std::vector<double> now = ways(run);
  const double rigid =
      0.5 * kSpeed * kSpeed / (kGravity * (std::sin(kDip) + std::cos(kDip) * std::tan(30.0 * kDegree)));
  double mean = 0.0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    std::printf("block %zu: %.4f m at 1.2 s, %.4f m at 2.2 s, rigid %.4f m\n", i, then[i], now[i], rigid);
    EXPECT_NEAR(now[i], then[i], 5e-4) << i;
    mean += now[i] / 5.0;
  }
  EXPECT_NEAR(mean / rigid, 1.0, 0.1);  // gravity at once: the stack bounces as it slides
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Steps, ThrownStack, testing::Values(Integrator::explicit_, Integrator::implicit),
                         [](const auto& of) { return of.param == Integrator::implicit ? "implicit" : "explicit"; });

}  // namespace
}  // namespace scree::test::sliding_damping_test
