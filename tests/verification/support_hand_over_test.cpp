// Point supports of bent blocks that change method: their forces are continuous, and the ledger closes.
#include <gtest/gtest.h>

#include <cstdio>

#include "coupling/integrate/point_springs.h"
#include "tests/support/schemes.h"

namespace scree::test::support_hand_over_test {
namespace {

using namespace coupling;

/// Forces of all point supports.
std::vector<Vec2> support_forces(const Driver& run) {
  std::vector<Vec2> out;
  for (const PointSpring& s : point_springs(run.setup(), run.state())) out.push_back(spring_force(s, run.state().q));
  return out;
}

class SupportHandOver : public testing::TestWithParam<Scheme> {};

/// A beam that oscillates on its two end points and changes to another scheme while it is bent.
TEST_P(SupportHandOver, a_bent_beam_keeps_the_forces_of_its_supports) {
  const Scheme second = GetParam();
  Scene scene(1e8, 0.2, 2600.0);
  const BlockId beam = scene.add("beam", rectangle(0, 0, 4, 0.4));
  scene.model.point_supports.push_back({beam, {0.0, 0.2}, true, true, {}});
  scene.model.point_supports.push_back({beam, {4.0, 0.2}, false, true, 4e8});
  const auto stage = [&](const char* method, Integrator integrator) {
    const bool implicit = integrator != Integrator::explicit_;
    scene.stage(method, integrator, 0.03, implicit ? std::optional<double>(1e-3) : std::nullopt, 0.2);
  };
  stage("nmm", Integrator::explicit_);
  stage(second.method, second.integrator);
  stage("nmm", Integrator::implicit);
  scene.plan.output.every = ticks(0.03);
  Driver run(scene.model, scene.plan, methods());
  std::vector<Vec2> before;
  std::int32_t at = 0;
  double worst = 0.0, largest = 0.0, closure = 0.0, springs = 0.0, jump = 0.0;
  Watch watch;
  watch.see = [&](const FrameView& view) {
    const std::vector<Vec2> now = support_forces(run);
    const double energy = view.state->ledger[Column::support_springs];
    closure = std::max(closure, view.state->ledger.relative_closure());
    if (view.stage != at) {
      for (std::size_t i = 0; i < now.size(); ++i) {
        worst = std::max(worst, (now[i] - before[i]).norm());
        largest = std::max(largest, before[i].norm());
      }
      double held = 0.0;
      for (const PointSpring& s : point_springs(run.setup(), run.state())) held += spring_energy(s, run.state().q);
      jump = std::max(jump, std::abs(held - springs) / springs);
    }
    before = now;
    springs = energy;
    at = view.stage;
  };
  run.add_sink(watch);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  std::printf("%s: forces jump by %.1e of %.3g N, energies by %.1e, closure %.1e\n", second.name, worst, largest, jump,
              closure);
  EXPECT_GT(largest, 1e4);
  EXPECT_LT(worst, 1e-8 * largest);  // round-off of positions of 4 m in a spring of 1e9 N/m
  EXPECT_LT(jump, 1e-8);
  EXPECT_LT(closure, 1e-9);
}
INSTANTIATE_TEST_SUITE_P(schemes, SupportHandOver,
                         testing::Values(Scheme{"dda", "dda", Integrator::explicit_},
                                         Scheme{"dda_implicit", "dda", Integrator::implicit}),
                         [](const auto& of) { return std::string(of.param.name); });

}  // namespace
}  // namespace scree::test::support_hand_over_test
