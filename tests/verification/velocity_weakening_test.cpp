// A block that slides while its friction decreases with its speed, against the same law on a rigid block.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "coupling/contact/law/friction_laws.h"
#include "tests/support/scene.h"

namespace scree::test::velocity_weakening_test {
namespace {

using coupling::Integrator;

constexpr double kSlope = 25.0, kPeak = 20.0, kFast = 5.0;  // [deg]
constexpr double kVelocity = 0.5, kSlip = 0.05;             // [m/s], [m]
constexpr double kTime = 0.8;                               // [s]

/// x'' = g (sin a - tan phi cos a), tan phi' = -x' (tan phi - tan phi_v(x'))/D from rest, by the classical Runge-Kutta
/// method: way [m].
double rigid_way() {
  const double peak = std::tan(kPeak * kDegree), fast = std::tan(kFast * kDegree);
  using Vector = std::array<double, 3>;  // way, speed, tan phi
  const auto rate = [&](const Vector& y) -> Vector {
    const double steady = fast + (peak - fast) / (1.0 + y[1] / kVelocity);
    return {y[1], 9.81 * (std::sin(kSlope * kDegree) - y[2] * std::cos(kSlope * kDegree)),
            -y[1] * (y[2] - steady) / kSlip};
  };
  const auto moved = [](const Vector& y, const Vector& k, double h) {
    return Vector{y[0] + h * k[0], y[1] + h * k[1], y[2] + h * k[2]};
  };
  Vector y = {0.0, 0.0, peak};
  const int steps = 8000;
  const double h = kTime / steps;
  for (int i = 0; i < steps; ++i) {
    const Vector a = rate(y), b = rate(moved(y, a, 0.5 * h)), c = rate(moved(y, b, 0.5 * h)), d = rate(moved(y, c, h));
    for (std::size_t k = 0; k < y.size(); ++k) y[k] += h / 6.0 * (a[k] + 2.0 * b[k] + 2.0 * c[k] + d[k]);
  }
  return y[0];
}

/// A block on a level plane under inclined gravity.
Scene slide(bool weakens) {
  Scene scene(5e9, 0.2, 2600.0, kPeak);
  scene.model.gravity = 9.81 * Vec2(-std::sin(kSlope * kDegree), -std::cos(kSlope * kDegree));
  scene.add("plane", rectangle(-6, -1, 3, 0), true);
  scene.add("block", rectangle(0, 0, 2, 0.5));
  static const FrictionLaw kLaw = coupling::velocity_weakening();
  if (weakens) {
    scene.model.joints[0].friction_law = &kLaw;
    scene.model.joints[0].friction_constants = {kFast, kVelocity, kSlip};
  }
  return scene;
}

double way(const Scene& scene) {
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  EXPECT_EQ(run.run().status, coupling::RunEnd::Status::done);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  EXPECT_TRUE(run.warnings().empty()) << run.warnings().front().text;
  return 1.0 - centre_of(run, BlockId{1}).x();
}

TEST(VelocityWeakeningSlide, a_slide_speeds_up_as_a_rigid_block_does_by_every_scheme) {
  const double rigid = rigid_way();
  ASSERT_GT(rigid, 1.2 * 0.5 * 9.81 * kTime * kTime *
                       (std::sin(kSlope * kDegree) - std::tan(kPeak * kDegree) * std::cos(kSlope * kDegree)));
  for (const auto& [method, integrator, dt] :
       {std::tuple("dda", Integrator::explicit_, 0.0), std::tuple("dda", Integrator::implicit, 5e-4),
        std::tuple("nmm", Integrator::explicit_, 0.0), std::tuple("nmm", Integrator::implicit, 5e-4)}) {
    Scene scene = slide(true);
    scene.stage(method, integrator, kTime, dt > 0.0 ? std::optional(dt) : std::nullopt);
    EXPECT_NEAR(way(scene) / rigid, 1.0, 5e-3) << method << (dt > 0.0 ? " implicit" : " explicit");
  }
}

TEST(VelocityWeakeningSlide, implicit_steps_converge_with_their_length) {
  const auto by_step = [](double dt) {
    Scene scene = slide(true);
    scene.stage("dda", Integrator::implicit, kTime, dt);
    return way(scene);
  };
  const double coarse = by_step(4e-3), middle = by_step(2e-3), fine = by_step(1e-3);
  // First order: the friction of a step is evaluated at its start.
  EXPECT_NEAR((coarse - middle) / (middle - fine), 2.0, 0.4);
}

TEST(VelocityWeakeningSlide, an_unbroken_slide_without_the_law_keeps_its_friction) {
  Scene scene = slide(false);
  scene.stage("dda", Integrator::implicit, kTime, 5e-4);
  const double a = 9.81 * (std::sin(kSlope * kDegree) - std::tan(kPeak * kDegree) * std::cos(kSlope * kDegree));
  EXPECT_NEAR(way(scene) / (0.5 * a * kTime * kTime), 1.0, 5e-3);
}

TEST(VelocityWeakeningSlide, stages_to_rest_leave_friction_as_it_is) {
  Scene scene = slide(true);
  scene.model.gravity = {0.0, -9.81};
  coupling::Stage& stage = scene.stage("dda", Integrator::implicit, 0.05, 1e-3);
  stage.rest = true;
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  for (const coupling::ContactMemory& m : run.state().contacts) EXPECT_EQ(m.friction_change, 0.0);
}

/// Position of the block along the slope at the end [m].
double end_of(const Scene& scene) {
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  EXPECT_EQ(run.run().status, coupling::RunEnd::Status::done);
  return centre_of(run, BlockId{1}).x();
}

TEST(VelocityWeakeningSlide, slip_in_a_stage_to_rest_is_no_speed_of_the_stage_after_it) {
  // Static steps on a slope steeper than friction slip by some millimetres each second, 18 in all. The stage after them
  // begins without speed, hence with the friction of a block at rest: its slide is that of a rigid block from rest.
  const double rigid = rigid_way();
  for (const auto& [method, integrator, dt] :
       {std::tuple("dda", Integrator::explicit_, 0.0), std::tuple("dda", Integrator::implicit, 5e-4),
        std::tuple("nmm", Integrator::explicit_, 0.0), std::tuple("nmm", Integrator::implicit, 5e-4)}) {
    Scene scene = slide(true);
    scene.stage("dda", Integrator::implicit, 2.0, 2e-2).rest = true;
    const double begin = end_of(scene);
    ASSERT_LT(begin, 1.0 - 0.2 * kSlip) << "the stage to rest does not slip enough";
    scene.stage(method, integrator, kTime, dt > 0.0 ? std::optional(dt) : std::nullopt);
    EXPECT_NEAR((begin - end_of(scene)) / rigid, 1.0, 5e-3) << method << (dt > 0.0 ? " implicit" : " explicit");
  }
}

}  // namespace
}  // namespace scree::test::velocity_weakening_test
