// Load of a floor while a surcharge is removed, released and placed again, by every scheme: against the weights.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "tests/support/schemes.h"

namespace scree::test::statics_test {
namespace {

using namespace coupling;

constexpr double kDensity = 2500.0, kGravity = 10.0, kLower = 2.0 * 1.0 * kDensity * kGravity,
                 kUpper = 1.0 * 1.0 * kDensity * kGravity;

/// A block on a fixed floor, with a surcharge on it.
struct Pile : Scene {
  BlockId floor, lower, upper;
  Pile() : Scene(1e9, 0.2, kDensity) {
    model.gravity = {0.0, -kGravity};
    floor = add("floor", rectangle(-1.0, -1.0, 3.0, 0.0), true);
    lower = add("lower", rectangle(0.0, 0.0, 2.0, 1.0));
    upper = add("upper", rectangle(0.5, 1.0, 1.5, 2.0));
  }
  Stage& at_rest(const Scheme& scheme, std::vector<BlockId> absent, std::optional<double> release, double time) {
    Stage& s =
        stage(scheme.method, scheme.integrator, 4.0, scheme.implicit() ? std::optional(0.02) : std::nullopt, 0.5);
    s.rest = true;
    s.rest_force = 1e-7;
    s.construction.absent = std::move(absent);
    s.construction.release = release;
    s.construction.release_time = ticks(time);
    return s;
  }
};

/// Vertical force of the contacts of a block with the floor.
double borne(const State& state, BlockId floor) {
  double sum = 0.0;
  for (const ContactMemory& m : state.contacts)
    if (m.key.block_p == floor.value || m.key.block_e == floor.value) sum += m.fn;
  return sum;
}

/// Load of the floor at the end of each stage.
struct AtEnds final : Sink {
  explicit AtEnds(const Driver& run, BlockId floor) : run_(&run), floor_(floor) {}
  void event(const Event& e) override {
    if (e.kind == EventKind::excavated || e.kind == EventKind::filled) told.emplace_back(name(e.kind));
    if (e.kind != EventKind::stage_end) return;
    load.push_back(borne(run_->state(), floor_));
    closure = std::max(closure, std::abs(run_->state().ledger.closure()) / run_->state().ledger.moved());
  }
  std::vector<double> load;
  std::vector<std::string> told;
  double closure = 0.0;

 private:
  const Driver* run_;
  BlockId floor_;
};

class Construct : public ::testing::TestWithParam<Scheme> {};

TEST_P(Construct, floor_bears_what_is_there_and_what_is_not_released) {
  Pile pile;
  pile.at_rest(GetParam(), {}, {}, 0.0);
  pile.at_rest(GetParam(), {pile.upper}, 0.4, 0.1);
  pile.at_rest(GetParam(), {pile.upper}, 0.4, 0.0);  // goes on as it is
  pile.at_rest(GetParam(), {pile.upper}, 1.0, 0.0);
  pile.at_rest(GetParam(), {}, {}, 0.0);
  Driver run(pile.model, pile.plan, methods());
  AtEnds look(run, pile.floor);
  run.add_sink(look);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const std::vector<double> expected = {kLower + kUpper, kLower + 0.6 * kUpper, kLower + 0.6 * kUpper, kLower,
                                        kLower + kUpper};
  ASSERT_EQ(look.load.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(look.load[i] / expected[i], 1.0, 1e-5) << i;
  EXPECT_EQ(look.told, (std::vector<std::string>{"excavated", "filled"}));
  std::printf("closure %.1e\n", look.closure);
  EXPECT_LT(look.closure, 1e-12);
  // Back where it was: the same stress in what has stayed.
  EXPECT_TRUE(run.state().support.forces.empty());
}

TEST(ConstructSupports, support_of_a_block_that_comes_back_is_free_of_force) {
  // The transfer from NMM to DDA has moved the anchor of the support so that its force was kept.
  Scene scene(1e7, 0.2, kDensity);
  scene.model.gravity = {0.0, -kGravity};
  scene.add("floor", rectangle(-1.0, -1.0, 3.0, 0.0), true);
  scene.add("lower", rectangle(0.0, 0.0, 2.0, 1.0));
  const BlockId hung = scene.add("hung", rectangle(4.0, 0.0, 5.0, 1.0));
  scene.model.point_supports.push_back({hung, {4.0, 1.0}, true, true, 1e6});
  scene.model.point_supports.push_back({hung, {5.0, 1.0}, false, true, 1e6});
  for (const char* method : {"nmm", "dda", "dda", "dda"}) {
    Stage& s = scene.stage(method, Integrator::implicit, 1.0, 0.1, 0.3);
    s.rest = true;
    if (scene.plan.stages.size() == 3) {
      s.construction.absent = {hung};
      s.construction.release = 1.0;
    }
  }
  scene.plan.output.history_every = scene.plan.output.every = ticks(1.0);
  struct Look final : Sink {
    void history(const HistoryView& h) override {
      held[std::lround(h.time)].push_back((*h.ledger)[Column::support_springs]);
    }
    std::map<long, std::vector<double>> held;  // by time [s]: before and after the changes between stages
  } look;
  Driver run(scene.model, scene.plan, methods());
  run.add_sink(look);
  const RunEnd end = run.run();
  ASSERT_EQ(end.status, RunEnd::Status::done) << end.reason;
  const double weight = kDensity * kGravity, energy = 2.0 * 0.5 * (0.5 * weight) * (0.5 * weight) / 1e6;
  EXPECT_NEAR(look.held.at(1).back(), energy, 1e-3 * energy);
  EXPECT_NEAR(look.held.at(2).front(), energy, 1e-3 * energy);
  EXPECT_EQ(look.held.at(2).back(), 0.0);
  EXPECT_EQ(look.held.at(3).front(), 0.0);
  EXPECT_NEAR(look.held.at(3).back(), 0.0, 1e-20);
  EXPECT_NEAR(look.held.at(4).back(), energy, 1e-3 * energy);
  EXPECT_LT(std::abs(run.state().ledger.closure()), 1e-12 * run.state().ledger.moved());
}

INSTANTIATE_TEST_SUITE_P(Schemes, Construct, ::testing::ValuesIn(kAllSchemes),
                         [](const auto& tested) { return std::string(tested.param.name); });

}  // namespace
}  // namespace scree::test::statics_test
