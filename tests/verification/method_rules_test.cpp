// Blocks that change between the NMM and the DDA by rules on their motion: momentum and energy are conserved.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "tests/support/schemes.h"

namespace scree::test::method_rules_test {
namespace {

using namespace coupling;

struct Kind {
  const char* name;
  Integrator integrator;
};
std::ostream& operator<<(std::ostream& out, const Kind& k) { return out << k.name; }

/// A bar that floats is struck at the middle by one block and later by another; its bending is damped out in between.
Scene struck(Integrator integrator) {
  Scene scene(2e8, 0.2, 2600.0);
  const BlockId bar = scene.add("bar", rectangle(-2, 0, 2, 0.5));
  const BlockId first = scene.add("first", rectangle(-0.15, 0.52, 0.15, 0.82));
  const BlockId second = scene.add("second", rectangle(-0.15, -2.3, 0.15, -2.0));
  scene.model.gravity = {0.0, 0.0};
  scene.model.initial_velocities.push_back({first, {0.0, -2.0}, 0.0});
  scene.model.initial_velocities.push_back({second, {0.0, 3.0}, 0.0});
  Stage& s = scene.stage("nmm", integrator, 1.8,
                         integrator == Integrator::explicit_ ? std::nullopt : std::optional<double>(5e-4), 0.25);
  s.damping = 40.0;  // acts on the motion that is not affine
  s.partition.explicit_blocks = {first, second};
  s.change.used = true;
  s.change.blocks = {bar};
  s.change.kinetic = 1e-3;
  s.change.elastic = 5e-3;
  s.change.hold = ticks(0.05);
  s.change.back.acceleration = 5.0;
  scene.plan.output.every = ticks(0.1);
  scene.plan.output.history_every = ticks(0.01);
  return scene;
}

/// Momentum of all blocks.
Vec2 momentum(const Driver& run) {
  Vec2 sum(0.0, 0.0);
  for (const Body& b : run.setup().bodies()) sum += totals_of(run.setup(), run.state(), b).momentum;
  return sum;
}

class MethodRules : public testing::TestWithParam<Kind> {};

TEST_P(MethodRules, a_struck_bar_goes_to_the_nmm_and_back_and_keeps_all) {
  const Scene scene = struck(GetParam().integrator);
  Driver run(scene.model, scene.plan, methods());
  std::vector<std::string> told;
  double lost = 0.0;
  bool began = false;
  Vec2 begin(0.0, 0.0);
  struct All final : Sink {
    std::function<void()> see;
    std::vector<std::string>* told = nullptr;
    void event(const Event& e) override {
      if (e.kind == EventKind::transfer) told->push_back(e.text);
    }
    void step(double, const RunStats&, const Ledger&) override { see(); }
    void history(const HistoryView& h) override {
      // Before the first impact energies are so small that round-off would dominate.
      if (h.ledger->moved() > 1.0) closure = std::max(closure, h.ledger->relative_closure());
      see();
    }
    double closure = 0.0;
  } all;
  all.told = &told;
  const double m = 2600.0 * 0.09, scale = m * 2.0;
  all.see = [&] {
    const Vec2 now = momentum(run);
    if (!began) begin = now;
    began = true;
    lost = std::max(lost, (now - begin).norm() / scale);
  };
  run.add_sink(all);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  double energy_error = 0.0, momentum_error = 0.0, reservoir = 0.0;
  std::string way;
  for (const TransferRow& row : run.transfers()) {
    EXPECT_TRUE(row.by_rule);
    EXPECT_EQ(row.block.value, 0);
    energy_error = std::max(energy_error, row.energy_error);
    momentum_error = std::max({momentum_error, row.momentum_error, row.angular_error, row.mass_error});
    reservoir += row.reservoir_kinetic + row.reservoir_elastic;
    way += row.to + ' ';
    if (row.to == "dda") {
      EXPECT_LE(row.measures.kinetic, 1e-3);
      EXPECT_LE(row.measures.elastic, 5e-3);
      EXPECT_LT(row.measures.cost_after, row.measures.cost_before);
      const double whole = row.before.kinetic + std::abs(row.before.elastic);
      EXPECT_NEAR(row.reservoir_kinetic / whole, row.measures.kinetic, 1e-9);
      EXPECT_NEAR(row.reservoir_elastic / whole, row.measures.elastic, 1e-9);
      // The ratio of stresses is the square root of the ratio of energies.
      EXPECT_NEAR(row.reservoir_elastic / std::abs(row.before.elastic), std::pow(row.measures.inhomogeneity, 2), 1e-9);
    } else {
      EXPECT_GT(row.measures.acceleration, 5.0);
    }
  }
  for (const std::string& t : told) std::printf("  %s\n", t.c_str());
  std::printf("%s: %s; closure %.1e, momentum %.1e, rows: energy %.1e, momenta %.1e\n", GetParam().name, way.c_str(),
              all.closure, lost, energy_error, momentum_error);
  EXPECT_EQ(way, "dda nmm dda ");
  EXPECT_EQ(told.size(), run.transfers().size());
  EXPECT_LT(all.closure, 1e-9);
  EXPECT_LT(lost, 1e-9);
  EXPECT_LT(energy_error, 1e-12);
  EXPECT_LT(momentum_error, 1e-12);
  EXPECT_NEAR(run.state().ledger[Column::reservoir], reservoir, 1e-12 * run.state().ledger.moved());
}

INSTANTIATE_TEST_SUITE_P(schemes, MethodRules,
                         testing::Values(Kind{"explicit_", Integrator::explicit_},
                                         Kind{"implicit", Integrator::implicit},
                                         Kind{"partitioned", Integrator::partitioned}),
                         [](const auto& of) { return std::string(of.param.name); });

TEST(MethodRulesApart, a_block_of_the_dda_that_is_struck_is_meshed) {
  Scene scene = struck(Integrator::explicit_);
  scene.plan.stages[0].method = "dda";
  scene.plan.stages[0].duration = ticks(0.1);
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(run.transfers().size(), 1U);
  EXPECT_EQ(run.transfers()[0].from, "dda");
  EXPECT_EQ(run.transfers()[0].to, "nmm");
  EXPECT_GT(run.state().q.size(), 2U * 9U);
  EXPECT_LT(run.state().ledger.relative_closure(), 1e-9);
}

TEST(MethodRulesApart, blocks_that_would_not_be_cheaper_or_cannot_stay) {
  Scene scene = struck(Integrator::explicit_);
  Stage& s = scene.plan.stages[0];
  s.duration = ticks(0.2);
  s.change.blocks = {};
  s.change.kinetic = s.change.elastic = 1.0;  // any motion counts as calm
  s.change.back = {};
  s.rules.push_back({{BlockId{1}}, "nmm", 0.0, true});  // onefold
  scene.model.cracks.push_back({{-0.1, -1.45}, {0.1, -1.45}, JointId{0}, BlockId{2}});
  Driver run(scene.model, scene.plan, methods());
  ASSERT_EQ(run.run().status, RunEnd::Status::done);
  ASSERT_EQ(run.transfers().size(), 1U);
  EXPECT_EQ(run.transfers()[0].block.value, 0);
}

TEST(MethodRulesApart, stages_that_cannot_are_refused_before_their_first_step) {
  const auto refusal = [](auto change) {
    Scene scene = struck(Integrator::implicit);
    change(scene.plan.stages[0]);
    Driver run(scene.model, scene.plan, methods());
    try {
      (void)run.run();
    } catch (const PlanError& e) {
      return std::string(e.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal([](Stage& s) { s.rest = true; }).find("runs to rest"), std::string::npos);
  EXPECT_NE(refusal([](Stage& s) { s.kinematics = Kinematics::linear; }).find("linear"), std::string::npos);
  EXPECT_NE(refusal([](Stage& s) { s.newmark = NewmarkScheme::trapezoidal; }).find("trapezoidal"), std::string::npos);
}

}  // namespace
}  // namespace scree::test::method_rules_test
