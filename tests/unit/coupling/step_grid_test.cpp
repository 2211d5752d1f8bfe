// Where the steps of a stage end.
#include "coupling/stages/step_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace scree::coupling::step_grid_test {
namespace {

TEST(StepGrid, steps_of_a_whole_part_are_dt) {
  for (Tick now = 100; now < 1100; now += 50) EXPECT_EQ(next_step(100, 1100, now, 50, 50), 50);
}

TEST(StepGrid, stage_that_is_no_multiple_has_equal_parts_within_a_tick) {
  for (const Tick length : {1000, 999, 1001, 7, 1, 49, 51}) {
    std::vector<Tick> steps;
    for (Tick now = 3; now < 3 + length; now += steps.back()) steps.push_back(next_step(3, 3 + length, now, 50, 50));
    EXPECT_EQ(static_cast<Tick>(steps.size()), (length + 49) / 50) << length;
    const auto [least, most] = std::minmax_element(steps.begin(), steps.end());
    EXPECT_LE(*most - *least, 1) << length;
    EXPECT_LE(*most, 50) << length;
  }
}

TEST(StepGrid, without_dt_what_is_left_is_divided_evenly) {
  std::vector<Tick> steps;
  for (Tick now = 0; now < 1000; now += steps.back()) steps.push_back(next_step(0, 1000, now, 0, 300));
  EXPECT_EQ(steps, (std::vector<Tick>{250, 250, 250, 250}));
}

TEST(StepGrid, after_a_cut_steps_come_back_to_multiples_of_dt) {
  Tick now = 200;
  now += next_step(0, 1000, now, 50, 16);  // a third of dt: 13 steps to 400, the end of eight parts
  EXPECT_EQ(now, 215);
  now += next_step(0, 1000, now, 50, 50);
  EXPECT_EQ(now, 250);
  EXPECT_EQ(next_step(0, 1000, now, 50, 50), 50);
}

TEST(StepGrid, point_that_is_near_is_passed_over) {
  Tick now = 249;  // one tick before a multiple of dt
  now += next_step(0, 1000, now, 50, 50);
  now += next_step(0, 1000, now, 50, 50);
  EXPECT_EQ(now, 300);
}

/// With a limit below dt, the number of steps exceeds the least possible one by at most an eighth.
TEST(StepGrid, shorter_steps_are_nearly_as_long_as_they_may_be) {
  for (Tick cap = 5000; cap < 10000; cap += 77) {
    Tick count = 0;
    for (Tick now = 0; now < 1000000; ++count) now += next_step(0, 1000000, now, 10000, cap);
    EXPECT_LE(static_cast<double>(count), 1.125 * 1e6 / static_cast<double>(cap) + 1.0) << cap;
  }
}

TEST(StepGrid, whatever_is_allowed_the_stage_is_gone_through_and_no_step_is_too_long) {
  std::mt19937_64 random(5);
  for (int run = 0; run < 200; ++run) {
    const Tick begin = static_cast<Tick>(random() % 1000), end = begin + 1 + static_cast<Tick>(random() % 100000),
               dt = run % 3 == 0 ? 0 : 1 + static_cast<Tick>(random() % 2000);
    Tick now = begin;
    for (int guard = 0; now < end && guard < 300000; ++guard) {
      const Tick cap = 1 + static_cast<Tick>(random() % static_cast<std::uint64_t>(std::max<Tick>(dt, 500)));
      const Tick h = next_step(begin, end, now, dt, cap);
      ASSERT_GE(h, 1);
      ASSERT_LE(h, cap);
      now += h;
    }
    EXPECT_EQ(now, end);
  }
}

}  // namespace
}  // namespace scree::coupling::step_grid_test
