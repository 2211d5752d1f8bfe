#include "coupling/step_limit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace scree::coupling::step_limit_test {
namespace {

/// A stage whose steps converge up to a length: the steps taken, and the failed attempts.
struct Stage {
  StepLimit limit;
  int failed = 0;
  Tick quick = std::numeric_limits<Tick>::max();  // longer steps take long iterations
  std::vector<Tick> taken;
  void step(Tick whole, Tick converges) {
    Tick h = limit.length > 0 ? limit.length : whole;
    StepLimit::Iteration iteration = h > quick ? StepLimit::Iteration::long_ : StepLimit::Iteration::short_;
    for (; h > converges; h /= 3) {
      iteration = StepLimit::Iteration::failed;
      ++failed;
    }
    limit.taken(h, iteration, whole);
    taken.push_back(h);
  }
};

TEST(StepLimit, attempts_in_vain_become_rare) {
  Stage s;
  constexpr int kSteps = 500;
  for (int i = 0; i < kSteps; ++i) s.step(900, 400);
  EXPECT_LT(s.failed, kSteps / 10);
  Tick way = 0;
  for (const Tick h : s.taken) way += h;
  EXPECT_GT(way, kSteps * Tick{160});  // on average at least 0.4 of the possible length
}

TEST(StepLimit, once_steps_converge_again_they_are_whole_and_so_are_the_next) {
  Stage s;
  for (int i = 0; i < 100; ++i) s.step(900, 20);
  for (int i = 0; i < 60; ++i) s.step(900, 900);
  EXPECT_EQ(s.taken.back(), 900);
  EXPECT_EQ(s.limit.length, 0);
  EXPECT_EQ(s.limit.next_hold, 1);  // earlier failures are forgotten
  const int failed = s.failed;
  for (int i = 0; i < 20; ++i) s.step(900, 900);
  EXPECT_EQ(s.failed, failed);
}

TEST(StepLimit, steps_of_long_iterations_are_halved_and_seldom_tried_again) {
  Stage s;
  s.quick = 300;
  constexpr int kSteps = 500;
  for (int i = 0; i < kSteps; ++i) s.step(900, 900);
  EXPECT_EQ(s.failed, 0);
  EXPECT_LT(std::count_if(s.taken.begin(), s.taken.end(), [&](Tick h) { return h > s.quick; }), kSteps / 10);
  s.quick = 900;
  for (int i = 0; i < 60; ++i) s.step(900, 900);
  EXPECT_EQ(s.limit.length, 0);
}

TEST(StepLimit, steps_that_always_converge_are_never_limited) {
  Stage s;
  for (int i = 0; i < 20; ++i) s.step(900, 900);
  EXPECT_EQ(s.taken, std::vector<Tick>(20, 900));
}

}  // namespace
}  // namespace scree::coupling::step_limit_test
