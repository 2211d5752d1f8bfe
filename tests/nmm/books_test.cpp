// The ledger closes through a staged run: statics with in-situ stress, shaking, runout by DDA, and the NMM again.
#include <gtest/gtest.h>

#include "tests/support/schemes.h"

namespace scree::test::books_test {
namespace {

using namespace coupling;

/// Blocks on a slope, with an in-situ stress that balances their weight.
Scene slope(bool stressed) {
  Scene scene(5e8, 0.25, 2500.0, 15.0);
  Model& m = scene.model;
  const Mat2 R = rotation(-25.0 * kDegree);
  scene.add("base", transformed(rectangle(-6, -2, 20, 0), {0, 0}, R), true);
  const BlockId lower = scene.add("lower", transformed(rectangle(0, 0, 2, 1), {0, 0}, R));
  scene.add("upper", transformed(rectangle(0.2, 1, 1.8, 2), {0, 0}, R));
  scene.add("behind", transformed(rectangle(-2.5, 0, -0.5, 1.2), {0, 0}, R));
  m.functions.push_back({"pulse", TimeFunction::Shape::sine_squared, 1.0, 0.2, 0.01, 0.0, {}, {}, {}});
  m.tractions.push_back({{lower, {0, 3}, 0.0, 1.0}, {2e5, -1e4}, FunctionId{0}});
  m.viscous_edges.push_back({{lower, {0, 1}, 0.0, 1.0}});
  m.point_loads.push_back({lower, transformed(rectangle(1, 0.5, 2, 1), {0, 0}, R).outer[0], {1e3, 2e3}, FunctionId{}});
  if (stressed)
    m.materials[0].initial_stress =
        InitialStress{Mat2::Zero(), (Mat2() << -0.4 * 24525.0, 0.0, 0.0, -24525.0).finished(), 2.0};
  m.cracks.push_back({m.blocks[1].polygon.outer[0] + R * Vec2(0.7, -0.1),
                      m.blocks[1].polygon.outer[0] + R * Vec2(0.9, 0.6), JointId{0}, lower});
  return scene;
}

class NmmBooks : public testing::TestWithParam<bool> {};

TEST_P(NmmBooks, close_in_every_stage_of_a_staged_run) {
  Scene scene = slope(GetParam());
  Stage& still = scene.stage("nmm", Integrator::implicit, 0.2, 2e-3, 0.4);
  still.rest = true;
  still.cracks = true;
  Stage& shake = scene.stage("nmm", Integrator::explicit_, 0.03, std::nullopt, 0.4);
  shake.stiffness_damping = 1e-5;
  shake.damping = 2.0;
  shake.cracks = true;
  scene.stage("dda", Integrator::implicit, 0.4, 1e-3);
  Stage& again = scene.stage("nmm", Integrator::explicit_, 0.02, std::nullopt, 0.25);
  again.local_damping = 0.1;
  scene.stage("nmm", Integrator::implicit, 0.02, 1e-3, 0.3);
  scene.stage("dda", Integrator::explicit_, 0.02, std::nullopt);
  scene.plan.output.every = scene.plan.output.history_every = ticks(0.01);

  struct Frames final : Sink {
    double closure = 0.0;
    std::size_t transfers = 0;
    void history(const HistoryView& view) override { closure = std::max(closure, view.ledger->relative_closure()); }
    void event(const Event& e) override {
      if (e.kind == EventKind::transfer) ++transfers;
      if (e.kind != EventKind::step_cut) std::printf("  %.4f s  %.1e  %s\n", e.time, closure, e.text.c_str());
    }
  } frames;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(frames);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  EXPECT_LT(frames.closure, 1e-9);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
  for (const double x : run.state().q) ASSERT_TRUE(std::isfinite(x));
}

INSTANTIATE_TEST_SUITE_P(, NmmBooks, testing::Bool(),
                         [](const auto& p) { return p.param ? "in_situ_stress" : "no_stress"; });

}  // namespace
}  // namespace scree::test::books_test
