// The report on a stage that does not come to rest.
#include "coupling/stages/rest_watch.h"

#include <gtest/gtest.h>

#include "coupling/transfer/transfer.h"
#include "tests/support/scene.h"

namespace scree::coupling::rest_watch_test {
namespace {

/// The report for three blocks that have moved by `way` at the beginning of each quarter and now.
std::string told_of(const std::vector<std::array<double, 3>>& way, const std::vector<double>& least) {
  test::Scene scene;
  scene.add("base", test::rectangle(-9, -1, 9, 0), true);
  scene.add("a", test::rectangle(0, 0, 1, 1));
  scene.add("b", test::rectangle(2, 0, 3, 1));
  scene.stage("dda", Integrator::implicit, 1.0, 0.01);
  const Methods methods = standard_methods();
  const Setup setup(scene.model, methods,
                    initial_records(scene.model, body_requests(scene.model, scene.plan.stages[0])));
  RestTrace trace;
  for (std::size_t part = 0; part + 1 < way.size(); ++part) {
    EXPECT_TRUE(trace.begins_part(0.25 * static_cast<double>(part)));
    const std::vector<Vec2> centres{{way[part][0], 0.0}, {way[part][1], 0.0}, {way[part][2], 0.0}};
    trace.begin_part(centres);
    if (!least.empty()) trace.follow(least[part]);
  }
  const std::vector<Vec2> now{{way.back()[0], 0.0}, {way.back()[1], 0.0}, {way.back()[2], 0.0}};
  return rest_text(trace, setup, now, 8.0);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(RestWatch, block_that_goes_on_as_fast_slides) {
  const std::string text =
      told_of({{0, 0, 0}, {0, 0.1, 0}, {0, 0.2, 0}, {0, 0.3, 0}, {0, 0.41, 1e-9}}, {0.5, 0.4, 0.4, 0.39});
  EXPECT_TRUE(has(text,
                  "'a' slides, and does not slow down: 0.11 m in the last quarter of the stage, 0.1 m in the one "
                  "before"))
      << text;
  EXPECT_TRUE(has(text, "it does not fall any more")) << text;
}

TEST(RestWatch, blocks_whose_ways_get_shorter_creep_and_the_fall_is_told) {
  const std::string text =
      told_of({{0, 0, 0}, {0, 1, 1}, {0, 1.1, 1.1}, {0, 1.11, 1.11}, {0, 1.112, 1.111}}, {1.0, 0.1, 0.01, 0.001});
  EXPECT_TRUE(has(text, "'a', 'b' creep, and slow down: 0.002 m in the last")) << text;
  EXPECT_TRUE(has(text, "was 1, 0.1, 0.01 and 0.001 of the largest")) << text;
  EXPECT_TRUE(has(text, "it falls tenfold in 2 s")) << text;  // a quarter of 8 s
}

TEST(RestWatch, blocks_that_stand_still_are_told_so) {
  const std::string text = told_of({{0, 0, 0}, {0, 0.1, 0}, {0, 0.1, 0}, {0, 0.1, 0}, {0, 0.1 + 1e-7, 0}}, {});
  EXPECT_TRUE(has(text, "no block moves any more")) << text;
  EXPECT_FALSE(has(text, "least unbalanced")) << text;
}

TEST(RestWatch, held_blocks_do_not_count_and_short_stages_say_nothing) {
  EXPECT_TRUE(has(told_of({{0, 0, 0}, {1, 0.1, 0}, {2, 0.2, 0}, {3, 0.3, 0}, {4, 0.4, 0}}, {}), "'a' slides"));
  EXPECT_EQ(told_of({{0, 0, 0}, {0, 1, 0}, {0, 2, 0}}, {}), "");
}

}  // namespace
}  // namespace scree::coupling::rest_watch_test
