// Motions and time functions whose time begins with a stage.
#include "coupling/bodies/clocks.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "coupling/bodies/setup.h"

namespace scree::coupling::clocks_test {
namespace {

TimeFunction made(TimeFunction::Shape shape, double start, double duration, int stage = -1) {
  TimeFunction f;
  f.name = "f";
  f.shape = shape, f.start = start, f.duration = duration, f.stage = StageId{stage};
  return f;
}

GroundMotion motion(double start, int stage = -1) {
  return {{0.0, 0.5, 1.0}, {0.0, 1.0, 0.0}, {1.0, 0.0}, {start, Between::linear, "m", StageId{stage}}};
}

/// Three stages of 1 s, 2 s and 4 s.
Plan plan() {
  Plan out;
  for (const double duration : {1.0, 2.0, 4.0}) {
    Stage s;
    s.name = std::to_string(out.stages.size());
    s.duration = ticks(duration);
    out.stages.push_back(s);
  }
  return out;
}

using Shape = TimeFunction::Shape;

TEST(Clocks, stage_that_has_not_begun_starts_nothing) {
  Model model;
  model.motions = {motion(0.0, 1), motion(0.25)};
  model.functions = {made(Shape::constant, 0.0, 0.0, 2), made(Shape::constant, 0.0, 0.0)};
  const std::array<Tick, 1> first{0};
  const Clocks clocks = clocks_of(model, first, ticks(1.0));
  EXPECT_TRUE(std::isinf(clocks.motion[0]));
  EXPECT_EQ(clocks.motion[1], 0.0);
  EXPECT_TRUE(std::isinf(clocks.function[0]));
  EXPECT_EQ(clocks.function[1], 0.0);
}

TEST(Clocks, count_from_where_the_stage_has_really_begun) {
  Model model;
  model.motions = {motion(0.1, 1)};
  model.functions = {made(Shape::ramp, 0.2, 1.0, 1)};
  const std::array<Tick, 2> begun{0, ticks(0.3)};
  const Clocks clocks = clocks_of(model, begun, ticks(2.3));
  EXPECT_EQ(clocks.motion[0], 0.3);
  EXPECT_EQ(clocks.function[0], 0.3);
  const scree::coupling::Setup setup(model, Methods(), {}, {}, clocks);
  EXPECT_EQ(setup.factor(FunctionId{0}, 0.4), 0.0);
  EXPECT_NEAR(setup.factor(FunctionId{0}, 0.75), 0.25, 1e-15);
}

/// The step that ends with a stage has no load of a function that begins there, however its time was written.
TEST(Clocks, function_that_begins_where_the_stage_ends_is_not_of_it) {
  for (const double end : {0.3, 0.1 + 0.2, 60.7, 123.456}) {
    Model model;
    model.functions = {made(Shape::constant, end, 0.0), made(Shape::constant, 0.999 * end, 0.0),
                       made(Shape::table, 0.0, 0.0)};
    model.functions[2].time = {end, end + 1.0};
    model.functions[2].table = {1.0, 1.0};
    const std::array<Tick, 1> begun{0};
    const Clocks clocks = clocks_of(model, begun, ticks(end));
    EXPECT_TRUE(std::isinf(clocks.function[0])) << end;
    EXPECT_EQ(clocks.function[1], 0.0) << end;
    EXPECT_TRUE(std::isinf(clocks.function[2])) << end;
    const std::array<Tick, 2> next{0, ticks(end)};
    EXPECT_EQ(clocks_of(model, next, ticks(end + 2.0)).function[0], 0.0) << end;
  }
}

TEST(TimeFaults, plan_that_meets_everything_has_none) {
  Model model;
  model.motions = {motion(0.0, 2), motion(5.5), motion(0.0)};
  model.functions = {made(Shape::constant, 6.99, 0.0), made(Shape::half_sine, -0.5, 1.0), made(Shape::sine, 3.0, 0.0),
                     made(Shape::constant, -3.0, 0.0)};
  EXPECT_TRUE(time_faults(model, plan()).empty());
}

TEST(TimeFaults, what_no_stage_meets_and_what_outlasts_the_run_are_told_apart) {
  using Kind = TimeFault::Kind;
  Model model;
  model.motions = {motion(7.0), motion(6.5), motion(3.5, 2), motion(4.0, 2)};
  model.functions = {made(Shape::constant, 7.0, 0.0), made(Shape::half_sine, -2.0, 1.0), made(Shape::ramp, 0.0, 8.0),
                     made(Shape::constant, 0.0, 0.0, 2), made(Shape::constant, 6.0, 0.0, 1)};
  const std::vector<TimeFault> found = time_faults(model, plan());
  struct Expected {
    Kind kind;
    bool motion;
    std::size_t index;
  };
  const std::vector<Expected> expected{{Kind::missed, true, 0},    {Kind::outlasts, true, 1}, {Kind::outlasts, true, 2},
                                       {Kind::missed, true, 3},    {Kind::missed, false, 0},  {Kind::missed, false, 1},
                                       {Kind::outlasts, false, 2}, {Kind::missed, false, 4}};
  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    EXPECT_TRUE(found[i].same({expected[i].kind, expected[i].motion, expected[i].index, 0.0, 0.0, 0.0})) << i;
}

TEST(TimeFaults, stage_that_ends_early_takes_a_time_on_the_clock_out_of_reach_and_not_one_of_a_stage) {
  Model model;
  model.motions = {motion(5.5), motion(0.0, 2)};
  const std::array<Tick, 2> begun{0, ticks(0.25)};  // the first stage of 1 s ended after 0.25 s
  const std::vector<TimeFault> found = time_faults(model, plan(), begun, ticks(2.25));
  ASSERT_EQ(found.size(), 1U);
  EXPECT_TRUE(found[0].same({TimeFault::Kind::outlasts, true, 0, 0.0, 0.0, 0.0}));
  EXPECT_NE(text(found[0], model).find("goes on until 6.5 s, but the run is over at 6.25 s"), std::string::npos);
  EXPECT_EQ(stages_met(model, plan())[0], StageId{2});
  model.motions[0] = motion(2.5);
  EXPECT_EQ(stages_met(model, plan())[0], StageId{1});
  EXPECT_EQ(stages_met(model, plan(), begun, ticks(2.25))[0], StageId{2});
}

}  // namespace
}  // namespace scree::coupling::clocks_test
