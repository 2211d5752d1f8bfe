// Energy of a vibration after some periods, the ratio of runs with and without damping, compared with exp(-2 xi w t):
// mass-proportional damping of rate a has xi = a/(2 w), damping proportional to stiffness of rate b has xi = b w/2.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>

#include "coupling/integrate/newmark.h"
#include "tests/support/by_hand.h"
#include "tests/support/schemes.h"

namespace scree::test::damping_rates_test {
namespace {

using namespace coupling;

constexpr double kYoung = 1e8, kDensity = 2000.0, kLength = 4.0, kHeight = 0.5;
constexpr double kXi = 0.04, kPeriods = 3.0;

struct Damping {
  double mass = 0.0, stiffness = 0.0;
  bool rigid = false;  // mass damping acts on the whole velocity, rigid motion included
};

/// Method and scheme for a bar that stretches along its axis; without Poisson's effect it has no other motion.
struct Way {
  const char* name;
  const char* method;
  Integrator integrator;
  Kinematics kinematics = Kinematics::corotational;
  NewmarkScheme newmark = NewmarkScheme::damped;
  BlockRotation rotation = BlockRotation::exact;
  [[nodiscard]] bool meshed() const { return std::string(method) == "nmm"; }
  /// Angular frequency of the excited mode [1/s]: two half waves in a mesh, which contain no affine motion, or the
  /// stretch of an affine block, whose inertia is that of a linear field, omega^2 = 12 E/(rho L^2).
  [[nodiscard]] double omega() const {
    const double c = std::sqrt(kYoung / kDensity);
    return (meshed() ? 2.0 * std::numbers::pi : std::sqrt(12.0)) * c / kLength;
  }
};
std::ostream& operator<<(std::ostream& out, const Way& w) { return out << w.name; }

/// The bar's energy after kPeriods of its mode.
double energy_left(const Way& way, const Damping& damping, double steps_a_period) {
  Scene scene(kYoung, 0.0, kDensity);
  scene.model.gravity = {0.0, 0.0};
  scene.add("bar", rectangle(0.0, 0.0, kLength, kHeight));
  Stage& stage = scene.stage(way.method, way.integrator, 1.0, 1e-3, 0.25);
  stage.kinematics = way.kinematics;
  stage.rotation = way.rotation;
  ByHand hand(scene.model, stage);
  const double speed = 1e-3;
  if (way.meshed()) {
    for (std::size_t i = 0; i < hand.state.q.size(); i += 2)
      hand.state.v[i] = speed * std::cos(2.0 * std::numbers::pi * hand.state.q[i] / kLength);
    hand.setup->pool(0).settle(0, hand.state.q, hand.state.v);
    hand.state.ledger.open(std::array{hand.kinetic()});
  } else {
    Mat2 stretch = Mat2::Zero();
    stretch(0, 0) = speed;
    hand.move(0, {0.0, 0.0}, stretch);
  }
  const StepControl control{.max_displacement = 0.1};
  std::unique_ptr<TimeIntegrator> integrator;
  if (way.integrator == Integrator::explicit_)
    integrator = std::make_unique<CentralDifference>(
        *hand.setup, control, 0.05,
        ExplicitDamping{.mass = damping.mass, .rigid = damping.rigid, .stiffness = damping.stiffness});
  else
    integrator = std::make_unique<Newmark>(*hand.setup, control, 0.05,
                                           ImplicitOptions{.scheme = way.newmark,
                                                           .damping = damping.mass,
                                                           .damp_rigid_motion = damping.rigid,
                                                           .stiffness_damping = damping.stiffness});
  (void)integrator->enter(hand.state);
  const double period = 2.0 * std::numbers::pi / way.omega();
  const Tick h = ticks(period / steps_a_period);
  const int steps = static_cast<int>(std::lround(kPeriods * steps_a_period));
  for (int i = 0; i < steps; ++i) {
    const StepReport report = integrator->step(hand.state, h);
    EXPECT_EQ(report.status, StepReport::Status::ok) << report.cause;
    if (report.status != StepReport::Status::ok) return 0.0;
  }
  integrator->update_ledger(hand.state);
  EXPECT_LT(hand.state.ledger.relative_closure(), 1e-9);
  const BodyTotals t = hand.totals(hand.setup->bodies()[0]);
  return t.kinetic + t.elastic;
}

class DecayRate : public testing::TestWithParam<Way> {
 protected:
  /// -log(energy with damping / energy without damping)/(2 xi w t).
  static double rate(const Damping& damping) {
    const Way way = GetParam();
    // Newmark (1/2, 1) has numerical damping, which is in both runs, and lengthens the period.
    const double steps = way.integrator == Integrator::explicit_ ? 100.0 : 200.0;
    const double with = energy_left(way, damping, steps), without = energy_left(way, {}, steps);
    return -std::log(with / without) / (2.0 * kXi * 2.0 * std::numbers::pi * kPeriods);
  }
  static constexpr double kTolerance = 0.05;  // a mesh of sixteen covers has w to 2 %, (1/2, 1) adds its first order
};

TEST_P(DecayRate, of_damping_proportional_to_stiffness) {
  EXPECT_NEAR(rate({.stiffness = 2.0 * kXi / GetParam().omega()}), 1.0, kTolerance);
}

TEST_P(DecayRate, of_mass_damping_beside_affine_motion) {
  // An affine block has only affine motion.
  EXPECT_NEAR(rate({.mass = 2.0 * kXi * GetParam().omega()}), GetParam().meshed() ? 1.0 : 0.0, kTolerance);
}

TEST_P(DecayRate, of_mass_damping_of_all_motion) {
  EXPECT_NEAR(rate({.mass = 2.0 * kXi * GetParam().omega(), .rigid = true}), 1.0, kTolerance);
}

INSTANTIATE_TEST_SUITE_P(
    ways, DecayRate,
    testing::Values(Way{"nmm_explicit", "nmm", Integrator::explicit_},
                    Way{"nmm_explicit_linear", "nmm", Integrator::explicit_, Kinematics::linear},
                    Way{"nmm_implicit", "nmm", Integrator::implicit},
                    Way{"nmm_trapezoidal", "nmm", Integrator::implicit, Kinematics::linear, NewmarkScheme::trapezoidal},
                    Way{"dda_explicit", "dda", Integrator::explicit_}, Way{"dda_implicit", "dda", Integrator::implicit},
                    Way{"dda_affine", "dda", Integrator::implicit, Kinematics::corotational, NewmarkScheme::damped,
                        BlockRotation::affine}),
    [](const auto& of) { return std::string(of.param.name); });

/// A block in free flight under v' = -a v: its momentum falls as exp(-a t), with an error of first order in the step of
/// (1/2, 1).
TEST(DecayRateOfFlight, mass_damping_of_all_motion_slows_a_block_down) {
  for (const Scheme& scheme : kAllSchemes) {
    Scene scene(1e8, 0.2, kDensity);
    scene.model.gravity = {0.0, 0.0};
    const BlockId id = scene.add("block", rectangle(0.0, 0.0, 1.0, 1.0));
    scene.model.initial_velocities.push_back({id, {0.3, -0.1}, 0.0});
    Stage& stage = scene.stage(scheme.method, scheme.integrator, 0.2, 5e-4, 0.4);
    stage.damping = 8.0;
    stage.damp_rigid_motion = true;
    stage.control.max_displacement = 0.1;
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const BodyTotals t = totals_of(run, id);
    EXPECT_NEAR(t.momentum.x() / (t.mass * 0.3 * std::exp(-8.0 * 0.2)), 1.0, 0.005) << scheme.name;
    EXPECT_NEAR(t.momentum.y() / (t.mass * -0.1 * std::exp(-8.0 * 0.2)), 1.0, 0.005) << scheme.name;
  }
}

/// A stage with dynamics d keeps this fraction of the velocity in each step: a block in free flight has d^n of its
/// velocity after n steps, and the energy removed is in the column rest_damping.
TEST(DecayRateOfFlight, dynamics_hands_its_fraction_of_the_velocity_on) {
  for (const char* method : {"nmm", "dda"}) {
    Scene scene(1e8, 0.2, kDensity);
    scene.model.gravity = {0.0, 0.0};
    const BlockId id = scene.add("block", rectangle(0.0, 0.0, 1.0, 1.0));
    scene.model.initial_velocities.push_back({id, {0.3, 0.0}, 0.0});
    Stage& stage = scene.stage(method, Integrator::implicit, 0.02, 1e-3, 0.4);
    stage.dynamics = 0.95;
    stage.control.max_displacement = 0.1;
    Driver run(scene.model, scene.plan, methods());
    ASSERT_EQ(run.run().status, RunEnd::Status::done);
    const BodyTotals t = totals_of(run, id);
    EXPECT_NEAR(t.momentum.x() / (t.mass * 0.3 * std::pow(0.95, 20)), 1.0, 1e-9) << method;
    EXPECT_NEAR(run.state().ledger[Column::rest_damping] / (0.5 * t.mass * 0.09 * (1.0 - std::pow(0.95, 40))), 1.0,
                1e-9)
        << method;
  }
}

}  // namespace
}  // namespace scree::test::damping_rates_test
