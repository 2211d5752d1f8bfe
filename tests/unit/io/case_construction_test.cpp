// Excavation and filling in case files.
#include <gtest/gtest.h>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_construction_test {
namespace {

const std::string kText = R"(
material.rock = { density = 2600.0, young = "1 GPa", poisson = 0.2 }
support = [{ block = "base" }]
block = [
  { name = "base", material = "rock", polygon = [[0, 0], [4, 0], [4, 1], [0, 1]] },
  { name = "left", material = "rock", polygon = [[0, 1], [2, 1], [2, 2], [0, 2]] },
  { name = "right", material = "rock", polygon = [[2, 1], [4, 1], [4, 2], [2, 2]] },
  { name = "top", material = "rock", polygon = [[0, 2], [4, 2], [4, 3], [0, 3]] },
]
[[stage]]
name = "first"
method = "dda"
integrator = "implicit"
dt = "1 ms"
duration = 1.0
rest = true
[[stage]]
name = "second"
method = "dda"
integrator = "implicit"
dt = "1 ms"
duration = 1.0
rest = true
[[stage]]
name = "third"
method = "dda"
integrator = "implicit"
dt = "1 ms"
duration = 1.0
)";

coupling::Plan plan_of(const std::vector<std::string>& set) { return read_text(kText, set).plan; }

/// Names of the blocks that are absent in a stage.
std::string without(const std::vector<std::string>& set, std::size_t stage) {
  const Case c = read_text(kText, set);
  std::string out;
  for (const BlockId b : c.plan.stages[stage].construction.absent)
    out += (out.empty() ? "" : " ") + c.model.blocks[b.index()].name;
  return out;
}

TEST(Construction, what_leaves_is_gone_until_it_is_filled) {
  const std::vector<std::string> set = {R"(stage.1.excavate=["left", "t*"])", R"(stage.2.fill=["top"])"};
  EXPECT_EQ(without(set, 0), "");
  EXPECT_EQ(without(set, 1), "left top");
  EXPECT_EQ(without(set, 2), "left");
}

TEST(Construction, what_is_filled_first_is_not_there_from_the_start) {
  const std::vector<std::string> set = {R"(stage.1.fill=["top"])", R"(stage.2.excavate=["top"])"};
  EXPECT_EQ(without(set, 0), "top");
  EXPECT_EQ(without(set, 1), "");
  EXPECT_EQ(without(set, 2), "top");
}

TEST(Construction, regions_mean_the_blocks_whose_centroid_is_inside_and_that_are_there) {
  const std::string region = "=[[0, 1.2], [4, 1.2], [4, 2.6], [0, 2.6]]";
  EXPECT_EQ(without({"stage.1.excavate_in" + region}, 1), "left right top");
  EXPECT_EQ(without({R"(stage.1.excavate=["left"])", "stage.2.excavate_in" + region}, 2), "left right top");
  EXPECT_EQ(without({"stage.1.excavate_in" + region, R"(stage.2.fill_in=[[0, 1], [2, 1], [2, 2], [0, 2]])"}, 2),
            "right top");
}

TEST(Construction, release_is_whole_and_at_once_where_a_stage_excavates_and_nothing_elsewhere) {
  const coupling::Plan plan = plan_of({R"(stage.1.excavate=["top"])"});
  EXPECT_FALSE(plan.stages[0].construction.release.has_value());
  EXPECT_EQ(plan.stages[1].construction.release, 1.0);
  EXPECT_EQ(plan.stages[1].construction.release_time, 0);
  EXPECT_FALSE(plan.stages[2].construction.release.has_value());
  const coupling::Plan parts = plan_of(
      {R"(stage.1.excavate=["top"])", "stage.1.release=0.4", "stage.1.release_time=\"500 ms\"", "stage.2.release=1"});
  EXPECT_EQ(parts.stages[1].construction.release, 0.4);
  EXPECT_EQ(parts.stages[1].construction.release_time, ticks(0.5));
  EXPECT_EQ(parts.stages[2].construction.release, 1.0);
}

TEST(Construction, a_reduction_has_the_blocks_of_the_stages_to_rest_and_releases_nothing_again) {
  const coupling::Plan plan = plan_of({R"(stage.1.excavate=["top"])", "stage.1.release=0.4", "stage.1.release_time=0.5",
                                       R"(stage.2.excavate=["left"])", "reduction={factor=1.5}"});
  ASSERT_EQ(plan.stages.size(), 5U);
  EXPECT_EQ(plan.stages[1].construction.release, 0.4);
  for (std::size_t i = 2; i < 5; ++i) {
    EXPECT_EQ(plan.stages[i].construction.absent, std::vector<BlockId>{BlockId{3}});
    EXPECT_FALSE(plan.stages[i].construction.release.has_value());
    EXPECT_EQ(plan.stages[i].construction.release_time, 0);
  }
}

struct Wrong {
  std::vector<std::string> set;
  const char *key, *problem;
};

TEST(Construction, what_does_not_go_together_is_refused_at_its_key) {
  const std::string bolt = R"(bolt=[{head=[1, 3], toe=[1, 1.5], axial_stiffness=1e8}])";
  for (const Wrong& w : std::vector<Wrong>{
           {{R"(stage.1.excavate=["roof"])"}, "stage.1.excavate.0", "no block of that name"},
           {{R"(stage.1.excavate=["x*"])"}, "stage.1.excavate.0", "no block fits the pattern"},
           {{"stage.1.excavate=[]"}, "stage.1.excavate", "the list of blocks is empty"},
           {{R"(stage.0.excavate=["top"])"}, "stage.0.excavate", "without forces between them"},
           {{R"(stage.0.fill=["top"])"}, "stage.0.fill", "without forces between them"},
           {{R"(stage.1.excavate=["top"])", R"(stage.2.excavate=["left", "top"])"},
            "stage.2.excavate.1",
            "is not there"},
           {{R"(stage.1.excavate=["t*"])", R"(stage.2.excavate=["t*"])"}, "stage.2.excavate.0", "excavated already"},
           {{R"(stage.1.fill=["left"])", R"(stage.2.fill=["left"])"}, "stage.2.fill.0", "is there already"},
           {{R"(stage.1.excavate=["*"])"}, "stage.1.excavate", "no block is left"},
           {{R"(stage.1.excavate=["top"])", R"(stage.1.fill=["top"])"}, "stage.1.excavate.0", "is not there"},
           {{"stage.1.excavate_in=[[5, 0], [6, 0], [6, 1]]"}, "stage.1.excavate_in", "no block has its centroid"},
           {{"stage.1.excavate_in=[[0, 1], [4, 3], [4, 1], [0, 3]]"}, "stage.1.excavate_in", "not a polygon"},
           {{"stage.1.release=0.5"}, "stage.1.release", "nothing has been excavated"},
           {{R"(stage.1.excavate=["top"])", "stage.1.release=0.5", "stage.2.release=0.5"},
            "stage.2.release",
            "0.5 and more of it is released already"},
           {{R"(stage.1.excavate=["top"])", "stage.1.release=1.5"}, "stage.1.release", "out of range"},
           {{"stage.1.release_time=0.5"}, "stage.1.release_time", "releases nothing"},
           {{R"(stage.1.excavate=["top"])", "stage.1.release_time=1.5"},
            "stage.1.release_time",
            "the stage ends before"},
           {{R"(stage.1.excavate=["top"])", "stage.1.release=0", "stage.1.release_time=0.5"},
            "stage.1.release_time",
            "releases nothing"},
           {{R"(stage.1.excavate=["left"])", bolt}, "stage.1.excavate", "holds block \"left\""},
           {{R"(stage.1.fill=["left"])", bolt}, "stage.0", "holds block \"left\""},
           {{R"(stage.2.excavate=["top"])", R"(stage.2.newmark="trapezoidal")"}, "stage.2.newmark", "trapezoidal"}}) {
    const CaseError e = error_of_text(kText, w.set);
    EXPECT_TRUE(e.key.starts_with(w.key)) << e.what();
    EXPECT_TRUE(holds(e.problem, w.problem)) << w.key << ": " << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
  }
}

TEST(Construction, a_bolt_may_come_after_the_block_that_it_holds_and_end_in_rock_that_stays) {
  EXPECT_NO_THROW((void)read_text(
      kText,
      {R"(stage.1.fill=["top"])", R"(bolt=[{head=[1, 3], toe=[1, 1.5], axial_stiffness=1e8, stage="second"}])"}));
  EXPECT_NO_THROW((void)read_text(
      kText, {R"(stage.1.excavate=["right"])", R"(bolt=[{head=[1, 3], toe=[1, 1.5], axial_stiffness=1e8}])"}));
}

}  // namespace
}  // namespace scree::io::test::case_construction_test
