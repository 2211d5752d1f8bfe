// Blocks that fall asleep and wake, compared with the same runs in which all blocks take all steps.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "tests/support/schemes.h"

namespace scree::test::sleep_test {
namespace {

using namespace coupling;

constexpr Scheme kSchemes[] = {{"dda_explicit", "dda", Integrator::explicit_},
                               {"dda_implicit", "dda", Integrator::implicit},
                               {"nmm_explicit", "nmm", Integrator::explicit_},
                               {"nmm_implicit", "nmm", Integrator::implicit}};

/// Times at which blocks fall asleep and wake [s].
struct Times {
  std::vector<double> fell, woke;
  std::string last;
  std::int64_t steps = 0, asleep_steps = 0;
};

struct Told final : Sink, Times {
  void event(const Event& e) override {
    if (e.kind != EventKind::sleep) return;
    (e.text.find("asleep: ") != std::string::npos ? fell : woke).push_back(e.time);
    last = e.text;
  }
  void step(double, const RunStats& stats, const Ledger&) override {
    ++steps;
    if (stats.asleep > 0) ++asleep_steps;
  }
};

/// Stacks of two blocks, ten metres apart on a held base; without more damping than the defaults.
struct Stacks : Scene {
  explicit Stacks(int stacks, double young = 5e9) : Scene(young, 0.2, 2500.0, 31.0) {
    for (int k = 0; k < stacks; ++k) {
      const double x = 4.0 * k;
      low.push_back(add("low" + std::to_string(k), rectangle(x, 0.0, x + 1.0, 0.5)));
      high.push_back(add("high" + std::to_string(k), rectangle(x, 0.5, x + 1.0, 1.0)));
    }
    base = add("base", rectangle(-6.0, -1.0, 4.0 * stacks, 0.0), true);
  }
  std::vector<BlockId> low, high;
  BlockId base;
};

constexpr double kTolerance = 1e-9;

Stage& add_stage(Scene& scene, const Scheme& scheme, double duration, double dt, double sleep) {
  Stage& stage = scene.stage(scheme.method, scheme.integrator, duration, dt, 0.5);
  stage.sleep = sleep;
  return stage;
}

double step_of(const Scheme& scheme) { return scheme.implicit() ? 1e-3 : 5e-5; }

struct Ran {
  std::vector<Vec2> centre, moved;  // per block [m]
  double closure = 0.0, fell_asleep = 0.0, momentum = 0.0, audit = 0.0, moves = 0.0;
  std::int64_t asleep = 0;
  Times told;
};

Ran run(const Scene& given, double sleep, bool audit = false) {
  Scene scene = given;
  for (Stage& stage : scene.plan.stages) stage.sleep = sleep;
  scene.plan.audit = audit;
  Driver driver(scene.model, scene.plan, methods());
  Ran out;
  Told told;
  driver.add_sink(told);
  const RunEnd end = driver.run();
  EXPECT_EQ(end.status, RunEnd::Status::done) << end.reason;
  for (std::size_t i = 0; i < scene.model.blocks.size(); ++i) {
    out.centre.push_back(centre_of(driver, BlockId{static_cast<std::int32_t>(i)}));
    out.moves = std::max(out.moves, totals_of(driver, BlockId{static_cast<std::int32_t>(i)}).momentum.norm());
    out.moved.push_back(out.centre.back() - moments(scene.model.blocks[i].polygon).centroid);
  }
  out.closure = driver.state().ledger.relative_closure();
  out.fell_asleep = driver.state().ledger[Column::falling_asleep];
  out.momentum = driver.stats().sleep_momentum;
  out.asleep = driver.stats().asleep;
  out.audit = driver.stats().audit_worst;
  out.told = static_cast<const Times&>(told);
  return out;
}

/// The largest difference of positions over the displacement of the block.
double difference(const Ran& a, const Ran& b, std::size_t blocks) {
  double most = 0.0;
  for (std::size_t i = 0; i < blocks; ++i)
    most = std::max(most, (a.centre[i] - b.centre[i]).norm() / b.moved[i].norm());
  return most;
}

class Sleep : public testing::TestWithParam<Scheme> {};

TEST_P(Sleep, agrees_with_never_sleeping_after_100000_steps) {
  const Scheme scheme = GetParam();
  Stacks scene(2);
  const bool mesh = std::string_view(scheme.method) == "nmm";
  const double steps = 1e5;
  add_stage(scene, scheme, steps * step_of(scheme), step_of(scheme), kTolerance);
  if (mesh) scene.plan.stages[0].stiffness_damping = 2e-5;
  const Ran never = run(scene, 0.0), slept = run(scene, kTolerance);
  std::printf(
      "%s: asleep in %lld of %lld steps, difference %.2e of the displacement %.3e m, %.2e J, %.2e N s removed\n",
      scheme.name, static_cast<long long>(slept.told.asleep_steps), static_cast<long long>(slept.told.steps),
      difference(slept, never, 4), never.moved[0].norm(), slept.fell_asleep, slept.momentum);
  EXPECT_EQ(slept.asleep, 4);
  EXPECT_GT(slept.told.asleep_steps, 0.5 * steps);
  EXPECT_LT(difference(slept, never, 4), 1e-8);
  EXPECT_LT(slept.closure, 1e-12);
  EXPECT_EQ(slept.moves, 0.0);
  EXPECT_GT(slept.fell_asleep, 0.0);
  EXPECT_LT(slept.fell_asleep, 1e-15);
}

/// What wakes the stacks, which are asleep at kAct.
constexpr double kAct = 0.9;

struct Cause {
  const char* name;
  std::function<void(Stacks&)> add;
  int stacks;      // that wake; -1: all
  double allowed;  // largest difference of positions, over the displacement
};
std::ostream& operator<<(std::ostream& out, const Cause& c) { return out << c.name; }

FunctionId ramp(Model& model) {
  TimeFunction f;
  f.name = "act";
  f.shape = TimeFunction::Shape::table;
  f.time = {kAct, kAct + 0.1};
  f.table = {1.0, 1.2};
  model.functions.push_back(f);
  return FunctionId{static_cast<std::int32_t>(model.functions.size()) - 1};
}

const Cause kCauses[] = {
    {"point_load",
     [](Stacks& s) {
       s.model.point_loads.push_back({s.high[0], {0.3, 1.0}, {200.0, -3000.0}, ramp(s.model)});
     },
     1, 1e-6},
    {"traction",
     [](Stacks& s) {
       s.model.tractions.push_back({{s.high[1], {0, 2}}, {0.0, -2e3}, ramp(s.model)});
     },
     1, 1e-6},
    {"body_acceleration",
     [](Stacks& s) {
       s.model.body_accelerations.push_back({{s.low[0]}, {0.4, -0.5}, ramp(s.model)});
     },
     1, 1e-6},
    {"acceleration_of_all",
     [](Stacks& s) {
       s.model.body_accelerations.push_back({{}, {0.4, -0.5}, ramp(s.model)});
     },
     -1, 1e-6},
    {"base_motion",
     [](Stacks& s) {
       s.model.motions.emplace_back(std::vector<double>{0.0, 0.05, 0.15, 0.2}, std::vector<double>{0.0, 1.0, -1.0, 0.0},
                                    Vec2(1.0, 0.0), GroundMotion::Setting{kAct});
       s.model.block_supports[0].motion = MotionId{0};
     },
     -1, 1e-6},
    {"block_that_hits",
     [](Stacks& s) {
       // Slides along the base and hits the first stack after 1.6 s.
       const BlockId b = s.add("slider", rectangle(-2.6, 0.0, -2.1, 0.5));
       s.model.initial_velocities.push_back({b, {2.0, 0.0}, 0.0});
       s.model.joints[0].friction = 5.0 * kDegree;
     },
     1, 1e-4},
};

class Wakes : public testing::TestWithParam<std::tuple<Scheme, Cause>> {};

TEST_P(Wakes, before_something_acts_and_ends_where_it_would_have_without_sleep) {
  const auto& [scheme, cause] = GetParam();
  const bool hits = std::string_view(cause.name) == "block_that_hits";
  Stacks scene(2);
  cause.add(scene);
  add_stage(scene, scheme, hits ? 3.0 : 1.6, step_of(scheme), 0.0);
  const Ran never = run(scene, 0.0), slept = run(scene, 1e-8, true);
  const double off = difference(slept, never, 4);
  std::printf(
      "%s, %s: asleep in %lld of %lld steps, %zu fell, %zu woke; %s; difference %.2e, audit %.2g, closure %.2e and "
      "%.2e\n",
      scheme.name, cause.name, static_cast<long long>(slept.told.asleep_steps),
      static_cast<long long>(slept.told.steps), slept.told.fell.size(), slept.told.woke.size(), slept.told.last.c_str(),
      off, slept.audit, slept.closure, never.closure);
  ASSERT_FALSE(slept.told.fell.empty());
  ASSERT_FALSE(slept.told.woke.empty());
  if (!hits) {
    EXPECT_LT(slept.told.fell.front(), kAct);
    EXPECT_LE(slept.told.woke.front(), kAct);
    EXPECT_GT(slept.told.woke.front(), kAct - 1.01 * step_of(scheme));
  }
  EXPECT_LT(off, cause.allowed);
  EXPECT_LT(slept.closure, never.closure + 1e-12);
  EXPECT_LE(slept.audit, 1.0);
}

INSTANTIATE_TEST_SUITE_P(Causes, Wakes,
                         testing::Combine(testing::Values(kSchemes[0], kSchemes[1]), testing::ValuesIn(kCauses)),
                         [](const auto& p) {
                           return std::string(std::get<0>(p.param).name) + "_" + std::get<1>(p.param).name;
                         });

/// All blocks are awake as a stage begins, and where a stage removes the lower block of a stack the upper one falls.
TEST(SleepStages, begin_with_all_blocks_awake) {
  Stacks scene(2);
  add_stage(scene, kSchemes[1], 1.0, 1e-3, 1e-8);
  Stage& dug = add_stage(scene, kSchemes[1], 0.2, 1e-3, 1e-8);
  dug.construction.absent = {scene.low[0]};
  dug.construction.release = 1.0;
  const Ran slept = run(scene, 1e-8);
  EXPECT_FALSE(slept.told.fell.empty());
  EXPECT_NEAR(slept.moved[1].y(), -0.5 * 9.81 * 0.04, 1e-3);
  EXPECT_EQ(slept.asleep, 0);  // a stage of 200 steps is too short
}

/// A stage that ends once forces balance ends at the same time with blocks asleep.
TEST(SleepStages, that_end_by_a_balance_of_forces_leave_out_blocks_that_are_asleep) {
  Stacks scene(2);
  Stage& stage = add_stage(scene, kSchemes[0], 2.0, 5e-5, 0.0);
  stage.end.force_below = 1e-4;
  stage.end.hold = ticks(0.5);
  const Ran never = run(scene, 0.0), slept = run(scene, 1e-8);
  EXPECT_GT(slept.told.asleep_steps, 5000);
  EXPECT_LT(slept.told.steps, 20000);
  EXPECT_EQ(slept.told.steps, never.told.steps);
}

/// In the other stack nothing changes to the last bit, whatever is asleep.
TEST(SleepExplicit, blocks_that_are_awake_take_the_same_steps) {
  Stacks scene(2);
  scene.model.body_accelerations.push_back({{scene.low[0]}, {2.0, 0.0}, {}});
  TimeFunction f;
  f.name = "shake";
  f.shape = TimeFunction::Shape::sine;
  f.frequency = 3.0;
  f.duration = 1e3;
  scene.model.functions.push_back(f);
  scene.model.body_accelerations[0].function = FunctionId{0};
  add_stage(scene, kSchemes[0], 1.0, 5e-5, 0.0);
  const Ran never = run(scene, 0.0), slept = run(scene, 1e-8);
  EXPECT_EQ(slept.asleep, 2);
  for (const std::size_t i : {0U, 1U}) {
    EXPECT_EQ(slept.centre[i].x(), never.centre[i].x());
    EXPECT_EQ(slept.centre[i].y(), never.centre[i].y());
  }
}

TEST(SleepExplicit, an_automatic_step_does_not_grow_over_a_pulse_while_all_blocks_are_asleep) {
  Stacks scene(1);
  TimeFunction f;
  f.name = "pulse";
  f.shape = TimeFunction::Shape::half_sine;
  f.start = 0.7;
  f.duration = 0.01;
  scene.model.functions.push_back(f);
  scene.model.point_loads.push_back({scene.high[0], {0.5, 1.0}, {0.0, -5000.0}, FunctionId{0}});
  scene.stage("dda", Integrator::explicit_, 1.2, std::nullopt);
  const Ran never = run(scene, 0.0), slept = run(scene, 1e-8);
  ASSERT_EQ(slept.told.woke.size(), 1U);
  EXPECT_NEAR(slept.told.woke[0], 0.7, 1e-4);
  EXPECT_EQ(slept.asleep, 2);
  EXPECT_NEAR(static_cast<double>(slept.told.steps), static_cast<double>(never.told.steps), 2.0);
}

TEST(SleepExplicit, the_ledger_closes_where_blocks_fall_asleep_with_a_part_of_their_forces) {
  Stacks scene(2);
  add_stage(scene, kSchemes[0], 0.5, 5e-5, 0.0);
  const Ran slept = run(scene, 1e-3);
  EXPECT_EQ(slept.asleep, 4);
  EXPECT_GT(slept.fell_asleep, 1e-12);
  EXPECT_LT(slept.closure, 1e-14);
}

/// Keeps checkpoints after some steps.
struct KeepMany final : Keeper {
  bool due(std::int64_t step) override { return step >= first && step < first + many; }
  void keep(const Checkpoint& c) override {
    if (due(c.state.step)) kept.push_back(c);
  }
  std::int64_t first = 0, many = 40;
  std::vector<Checkpoint> kept;
};

class SleepResume : public testing::TestWithParam<Scheme> {};

TEST_P(SleepResume, with_blocks_asleep_ends_with_the_same_bits) {
  const Scheme scheme = GetParam();
  Stacks scene(3);
  const double x = scheme.implicit() ? 1.2 : 3.0;  // it hits the second stack
  const BlockId slider = scene.add("slider", rectangle(x, 0.0, x + 0.5, 0.5));
  scene.model.initial_velocities.push_back({slider, {scheme.implicit() ? 2.6 : 1.2, 0.0}, 0.0});
  scene.model.joints[0].friction = 5.0 * kDegree;
  add_stage(scene, scheme, scheme.implicit() ? 1.5 : 0.6, step_of(scheme), 1e-6);
  Driver whole(scene.model, scene.plan, methods());
  Told told;
  KeepMany keeper;
  whole.add_sink(told);
  // Around the steps at which blocks fall asleep and wake.
  Driver first(scene.model, scene.plan, methods());
  Told times;
  first.add_sink(times);
  (void)first.run();
  ASSERT_FALSE(times.fell.empty());
  ASSERT_FALSE(times.woke.empty());
  keeper.first = static_cast<std::int64_t>(std::llround(times.woke.front() / step_of(scheme))) - 20;
  whole.set_keeper(keeper);
  (void)whole.run();
  const std::uint64_t hash = state_hash(whole.state());
  EXPECT_EQ(hash, state_hash(first.state()));
  ASSERT_EQ(keeper.kept.size(), 40U);
  int with_sleep = 0;
  for (const Checkpoint& c : keeper.kept) {
    with_sleep += c.stats.asleep > 0 ? 1 : 0;
    Driver again(scene.model, scene.plan, methods());
    again.continue_from(c);
    (void)again.run();
    EXPECT_EQ(state_hash(again.state()), hash) << "from step " << c.state.step;
  }
  EXPECT_GE(with_sleep, 20);
}

INSTANTIATE_TEST_SUITE_P(Schemes, SleepResume, testing::Values(kSchemes[0], kSchemes[1]),
                         [](const auto& scheme) { return std::string(scheme.param.name); });

INSTANTIATE_TEST_SUITE_P(Schemes, Sleep, testing::ValuesIn(kSchemes),
                         [](const auto& scheme) { return std::string(scheme.param.name); });

}  // namespace
}  // namespace scree::test::sleep_test
