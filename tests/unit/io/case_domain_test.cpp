// The table [domain] of a case: names, patterns, points that select blocks, files of lines.
#include <gtest/gtest.h>

#include <algorithm>

#include "io/case/read_parts.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_domain_test {
namespace {

const std::string kDomain = R"(
[model]
default_joint = "rough"
[material.rock]
density = 2600.0
young = 1.0e9
poisson = 0.2
[joint.rough]
friction_deg = 30.0
[joint.clay]
friction_deg = 10.0
[domain]
outline = [[0, 0], [0, 10], [10, 10], [10, 0]]
material = "rock"
[[domain.region]]
name = "base"
polygon = [[0, 0], [10, 0], [10, 4], [0, 4]]
[[domain.trace]]
joint = "clay"
points = [[5, 0], [5, 10]]
[[domain.trace]]
joint = "rough"
points = [[0, 7], [10, 7]]
[[stage]]
name = "rest"
method = "dda"
integrator = "implicit"
dt = 1.0e-3
duration = 0.1
)";

TEST(Domain, blocks_are_named_by_region_and_counted_from_the_bottom_left_up) {
  const Model m = read_text(kDomain).model;
  EXPECT_EQ(names_of(m.blocks),
            (std::vector<std::string>{"base-1", "base-2", "block-1", "block-2", "block-3", "block-4"}));
  EXPECT_EQ(m.blocks[0].polygon.outer, (Ring{{0, 0}, {5, 0}, {5, 4}, {0, 4}}));
  EXPECT_EQ(m.blocks[5].polygon.outer, (Ring{{5, 7}, {10, 7}, {10, 10}, {5, 10}}));
  const JointId clay = m.blocks[0].edges[0][1];
  EXPECT_EQ(m.joints[clay.index()].name, "clay");
  ASSERT_TRUE(m.cutting.has_value());
  EXPECT_EQ(m.cutting->blocks, 6);
  EXPECT_EQ(m.joint_lines.size(), 2u);
}

TEST(Domain, resolved_case_reads_back_to_the_same_blocks) {
  const Case c = read("full_case.toml");
  EXPECT_EQ(dump(read_text(c.resolved)), dump(c));
}

TEST(Domain, block_lists_take_patterns) {
  const Case c = read_text(kDomain +
                           "method_of = [{ blocks = [\"*-1\"], method = \"dda\" }]\n"
                           "[[support]]\nblocks = [\"base-*\", \"block-1\"]\n");
  ASSERT_EQ(c.model.block_supports.size(), 3u);
  EXPECT_EQ(c.model.block_supports[1].block, BlockId{1});
  EXPECT_EQ(c.model.block_supports[2].block, BlockId{2});
  EXPECT_EQ(c.plan.stages[0].rules[0].blocks, (std::vector<BlockId>{BlockId{0}, BlockId{2}}));
}

TEST(Domain, pattern_without_a_block_is_refused_at_its_item) {
  const CaseError e = error_of_text(kDomain + "[[support]]\nblocks = [\"base-1\", \"bese-*\"]\n");
  EXPECT_EQ(e.key, "support.0.blocks.1");
  EXPECT_TRUE(holds(e.problem, "no block fits the pattern")) << e.what();
}

TEST(Domain, block_held_by_a_name_and_by_a_pattern_is_refused) {
  const CaseError e = error_of_text(kDomain + "[[support]]\nblocks = [\"base-1\", \"base-*\"]\n");
  EXPECT_TRUE(holds(e.problem, "\"base-1\" is held twice")) << e.what();
}

TEST(Domain, points_pick_the_block_that_holds_them) {
  const Model m = read_text(kDomain + "[[support]]\nat = [7, 2]\n[[monitor]]\npoint = [2, 8]\n").model;
  EXPECT_EQ(m.block_supports.at(0).block, BlockId{1});
  EXPECT_EQ(m.monitors.at(0).block, BlockId{4});
  EXPECT_EQ(m.monitors.at(0).name, "block-3#1");
}

TEST(Domain, points_in_no_block_or_on_a_boundary_are_refused) {
  const CaseError outside = error_of_text(kDomain + "[[monitor]]\npoint = [12, 8]\n");
  EXPECT_EQ(outside.key, "monitor.0.point");
  EXPECT_TRUE(holds(outside.problem, "in no block")) << outside.what();
  const CaseError between = error_of_text(kDomain + "[[support]]\nat = [5, 2]\n");
  EXPECT_EQ(between.key, "support.0.at");
  EXPECT_TRUE(holds(between.problem, "boundary of blocks \"base-1\" and \"base-2\"")) << between.what();
}

TEST(Domain, support_names_its_block_in_one_way) {
  EXPECT_EQ(error_of_text(kDomain + "[[support]]\nat = [7, 2]\nblock = \"base-1\"\n").key, "support.0.at");
  EXPECT_EQ(error_of_text(kDomain + "[[support]]\nat = [7, 2]\nblocks = [\"base-1\"]\n").key, "support.0.at");
}

TEST(Domain, listed_block_beside_it_comes_first_and_may_not_share_a_name) {
  const std::string block = "[[block]]\nname = \"NAME\"\nmaterial = \"rock\"\npolygon = [[10, 0], [12, 0], [12, 3]]\n";
  const Model m = read_text(kDomain + replaced(block, "NAME", "wall")).model;
  EXPECT_EQ(m.blocks.size(), 7u);
  EXPECT_EQ(m.blocks[0].name, "wall");
  const CaseError e = error_of_text(kDomain + replaced(block, "NAME", "block-2"));
  EXPECT_EQ(e.key, "block.0.name");
  EXPECT_TRUE(holds(e.problem, "same name")) << e.what();
}

TEST(Domain, outline_or_its_file_is_given_once) {
  const CaseError both = error_of_text(
      replaced(kDomain, "material = \"rock\"\n", "material = \"rock\"\noutline_file = \"outline.csv\"\n"));
  EXPECT_EQ(both.key, "domain.outline_file");
  const CaseError none = error_of_text(replaced(kDomain, "outline = [[0, 0], [0, 10], [10, 10], [10, 0]]\n", ""));
  EXPECT_EQ(none.key, "domain.outline");
  EXPECT_TRUE(holds(none.problem, "no outline")) << none.what();
}

TEST(Domain, closed_outline_file_is_the_outline) {
  const std::string text =
      replaced(kDomain, "outline = [[0, 0], [0, 10], [10, 10], [10, 0]]", "outline_file = \"outline.csv\"");
  const CaseError e = error_of_text(text);  // the region of this case lies outside the new outline
  EXPECT_TRUE(holds(e.problem, "region 'base' lies outside the domain")) << e.what();
  const Model m = read_text(text, {"domain.region=[]"}).model;
  ASSERT_EQ(m.blocks.size(), 1u);
  EXPECT_EQ(m.blocks[0].polygon.outer, (Ring{{20, 0}, {30, 0}, {30, 7}, {20, 6}}));
}

/// Changes of the first joint set of the full case, and the error expected for each.
TEST(Domain, joint_sets_that_make_no_sense_are_refused_at_the_key) {
  const struct {
    const char *set, *key, *problem;
  } wrong[] = {
      {"domain.joint_set.0.spacing_distribution=\"exponential\"", "domain.joint_set.0.spacing_deviation",
       "has no deviation of its own"},
      {"domain.joint_set.0.gap=0", "domain.joint_set.0.gap", "varies, but has no mean value"},
      {"domain.joint_set.1={joint=\"rough\", dip_deg=90, spacing=2, gap=1}", "domain.joint_set.1.gap", "no traces"},
      {"domain.joint_set.0.dip_deg=181", "domain.joint_set.0.dip_deg", "out of range"},
      {"domain.joint_set.1={joint=\"rough\", dip_deg=90, spacing=2, spacing_deviation=3, "
       "spacing_distribution=\"uniform\"}",
       "domain.joint_set.1.spacing_deviation", "more than spacing itself"},
      {"domain.joint_set.0.region=[[20, 1], [30, 6], [30, 1], [20, 6]]", "domain.joint_set.0.region", "crosses"},
      {"domain.trace.0.points=[[20, 5], [20, 5], [30, 5.5]]", "domain.trace.0.points", "(20, 5) twice"},
      {"domain.trace.0.points=[[20, 5]]", "domain.trace.0.points", "has no length"},
      {"domain.trace.1.file=\"nowhere.csv\"", "domain.trace.1.file", "does not exist"},
      {"domain.arc.0.to_deg=180", "domain.arc.0.to_deg", "no length"},
      {"domain.snap=1", "domain.snap", "too coarse"},
      {"domain.region.0.name=\"cut\"", "domain.region.0.name", "same name"}};
  for (const auto& w : wrong) {
    const CaseError e = error_of_text(bytes_of(kFolder + "full_case.toml"), {w.set});
    EXPECT_EQ(e.key, w.key) << e.what();
    EXPECT_TRUE(holds(e.problem, w.problem)) << e.what();
    EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
  }
}

TEST(Domain, cutting_by_many_joints_is_told_before_it_begins) {
  const auto told = [](const char* origin) {
    std::vector<std::string> lines;
    (void)read_case_text(
        kDomain + "[[domain.joint_set]]\njoint = \"clay\"\ndip_deg = 0\nspacing = 5\norigin = " + origin + "\n",
        kFolder + "in_memory.toml", {}, kMethods, [&](const std::string& line) { lines.push_back(line); });
    return lines;
  };
  EXPECT_TRUE(told("[0, 5]").empty());
  // Lines are generated from the origin on: most of them lie below the domain.
  const std::vector<std::string> lines = told("[0, -1e5]");
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_TRUE(holds(lines[0], "draw about 4e+04 lines")) << lines[0];
}

TEST(Matches, stars_stand_for_any_characters) {
  EXPECT_TRUE(matches("base-*", "base-12"));
  EXPECT_TRUE(matches("*", ""));
  EXPECT_TRUE(matches("*a*b", "xxaxxbab"));
  EXPECT_TRUE(matches("a**", "a"));
  EXPECT_FALSE(matches("base-*", "abase-1"));
  EXPECT_FALSE(matches("*-1", "base-12"));
  EXPECT_FALSE(matches("", "a"));
}

}  // namespace
}  // namespace scree::io::test::case_domain_test
