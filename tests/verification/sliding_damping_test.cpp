// Blocks that slide on steep planes: rigid sliding with the standard settings, flutter without, no drag on slide or
// spin, and site response where little of a block slips.
#include <gtest/gtest.h>

#include "tests/support/scene.h"

namespace scree::test {
namespace {

using namespace coupling;

constexpr double kSlope = 40.0 * kDegree, kGravity = 9.81;

/// A block of 2 x 1 m with friction 2 degrees above the slope, thrown down it at a speed; gravity from the start, the
/// springs pressed by its weight.
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

const Methods& methods() {
  static const Methods kAll = standard_methods();
  return kAll;
}

class SteepSlide : public testing::TestWithParam<std::tuple<std::string, Integrator>> {
 protected:
  [[nodiscard]] std::string method() const { return std::get<0>(GetParam()); }
  [[nodiscard]] Integrator integrator() const { return std::get<1>(GetParam()); }
  [[nodiscard]] std::optional<double> dt() const {
    return integrator() == Integrator::implicit ? std::optional<double>(2e-4) : std::nullopt;
  }
};

TEST_P(SteepSlide, a_thrown_block_is_slowed_as_a_rigid_one_and_stays_where_it_stops) {
  // v' = g (sin a - cos a tan phi) < 0: it stops after v/|v'|.
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
  // A frictionless slide has no loss; momenta change by the contact alone.
  Scene scene(1e9, 0.2, 2600.0, 0.0);
  scene.model.gravity = Vec2(0.0, -kGravity);
  scene.add("plane", rectangle(-5, -2, 15, 0), true);
  const BlockId block = scene.add("block", rectangle(0, 0, 2, 1));
  scene.model.initial_velocities.push_back({block, Vec2(3.0, 0.0), 0.0});
  scene.stage("nmm", Integrator::explicit_, 1.0, std::nullopt, 0.4);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  const BodyTotals end = totals_of(run, block);
  EXPECT_NEAR(end.momentum.x() / end.mass, 3.0, 3e-6);  // corners of a block that rocks push a little along
  EXPECT_GT(run.state().ledger[Column::deformation_damping], 0.0);
}

}  // namespace
}  // namespace scree::test
