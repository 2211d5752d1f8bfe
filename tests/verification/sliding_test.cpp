// A block on an inclined plane: NMM and DDA, explicit and implicit, against g (sin a - cos a tan phi) t^2/2.
#include <gtest/gtest.h>

#include "tests/support/scene.h"

namespace scree::test::sliding_test {
namespace {

using coupling::Integrator;

struct Outcome {
  double distance, closure;
};

/// A 1 x 1 m block on a long fixed plane at 30 degrees, released at rest.
Outcome slide(const std::string& method, Integrator integrator, double friction_deg, double duration,
              std::optional<double> dt, double young = 1e9) {
  Scene scene(young, 0.2, 2600.0, friction_deg);
  const double a = 30.0 * kDegree;
  const Mat2 R = rotation(-a);
  scene.add("plane", transformed(rectangle(-5, -2, 30, 0), Vec2(0, 0), R), true);
  const BlockId slider = scene.add("slider", transformed(rectangle(0, 0, 1, 1), Vec2(0, 0), R));
  scene.stage(method, integrator, duration, dt, 0.4);
  static const coupling::Methods kMethods = coupling::standard_methods();
  coupling::Driver driver(scene.model, scene.plan, kMethods);
  const Vec2 start = R * Vec2(0.5, 0.5);
  const coupling::RunEnd end = driver.run();
  EXPECT_EQ(end.status, coupling::RunEnd::Status::done) << end.reason;
  const coupling::Ledger& ledger = driver.state().ledger;
  return {(centre_of(driver, slider) - start).dot(R * Vec2(1, 0)), ledger.relative_closure()};
}

double analytic(double friction_deg, double t) {
  const double a = 30.0 * kDegree;
  return 0.5 * 9.81 * (std::sin(a) - std::cos(a) * std::tan(friction_deg * kDegree)) * t * t;
}

class Sliding : public testing::TestWithParam<std::tuple<std::string, double>> {};

TEST_P(Sliding, incline_follows_coulomb) {
  const auto& [scheme, phi] = GetParam();
  const bool implicit = scheme.ends_with("-implicit");
  // Until its springs are stretched, less than Coulomb's friction acts on the block: in stiff rock for a shorter time.
  const bool stiff = scheme == "nmm-implicit";
  const double t = stiff ? 2.0 : 1.0;
  const Outcome o = slide(scheme.substr(0, 3), implicit ? Integrator::implicit : Integrator::explicit_, phi, t,
                          implicit ? std::optional<double>(1e-3) : std::nullopt, stiff ? 5e10 : 1e9);
  std::printf("%s phi %g: distance %.6f analytic %.6f error %.2e closure %.1e\n", scheme.c_str(), phi, o.distance,
              analytic(phi, t), o.distance / analytic(phi, t) - 1.0, o.closure);
  EXPECT_NEAR(o.distance / analytic(phi, t), 1.0, stiff ? 5e-4 : 0.01);
  EXPECT_LT(o.closure, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(all, Sliding,
                         testing::Combine(testing::Values("nmm-explicit", "nmm-implicit", "dda-explicit",
                                                          "dda-implicit"),
                                          testing::Values(10.0, 20.0)));

class Holding : public testing::TestWithParam<std::string> {};

/// Position of the first monitor at each instant of the history.
struct Path final : coupling::Sink {
  std::vector<double> time, x;
  void history(const coupling::HistoryView& h) override {
    time.push_back(h.time);
    x.push_back(std::hypot(h.displacement[0], h.displacement[1]));
  }
};

TEST_P(Holding, incline_steeper_friction_stays) {
  const bool implicit = GetParam().ends_with("-implicit");
  Scene scene(1e9, 0.2, 2600.0, 40.0);
  scene.model.joints[0].penalty = 1e8;
  const Mat2 R = rotation(-30.0 * kDegree);
  scene.add("plane", transformed(rectangle(-5, -2, 30, 0), Vec2(0, 0), R), true);
  const BlockId slider = scene.add("slider", transformed(rectangle(0, 0, 1, 1), Vec2(0, 0), R));
  scene.model.monitors.push_back({"centre", slider, R * Vec2(0.5, 0.5)});
  // Friction can keep an elastic block without material damping bouncing; rock has some damping.
  scene
      .stage(GetParam().substr(0, 3), implicit ? Integrator::implicit : Integrator::explicit_, 2.0,
             implicit ? std::optional<double>(1e-3) : std::nullopt, 0.4)
      .damping = 200.0;
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(scene.model, scene.plan, methods);
  Path path;
  run.add_sink(path);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  const double settled = path.x[path.x.size() / 2], end = path.x.back();
  std::printf("%s phi 40: settles %.2e m, creeps %.1e m in the second half, closure %.1e\n", GetParam().c_str(),
              settled, end - settled, run.state().ledger.relative_closure());
  EXPECT_LT(end, 2e-3);                      // sudden gravity: the springs oscillate up to twice m g/2k = 2.6e-4 m
  EXPECT_LT(std::abs(end - settled), 1e-5);  // the oscillation that is left after a second
  // Newton's method leaves 1e-11 of the largest force.
  EXPECT_LT(run.state().ledger.relative_closure(), GetParam() == "nmm-implicit" ? 1e-10 : 1e-12);
}
INSTANTIATE_TEST_SUITE_P(all, Holding, testing::Values("nmm-explicit", "nmm-implicit", "dda-explicit", "dda-implicit"));

}  // namespace
}  // namespace scree::test::sliding_test
