// Sides beside level ground as a case gives them: which outlines, which base, and what is refused.
#include <gtest/gtest.h>

#include "tests/unit/io/case_read.h"

namespace scree::io::test {
namespace {

const std::string kBases = "viscous_edge=[{block=\"ledge\", edge=2, motion=\"upward\", motion_is=\"upgoing\"}]",
                  kMeshes = "stage.1.method_of=[{blocks=[\"slider\", \"ledge\"], method=\"nmm\"}]";

Model with(const std::string& sides) { return read("full_case.toml", {kBases, kMeshes, sides}).model; }

TEST(FreeFields, stand_on_the_base_that_their_motion_drives_and_are_as_high_as_the_side) {
  const Model m = with(
      "free_field=[{block=\"slider\", edge=1, motion=\"pulse\"}, "
      "{block=\"ledge\", edge=1, motion=\"upward\", bottom=1, top=3.5}]");
  ASSERT_EQ(m.viscous_edges.size(), 3U);
  const ViscousEdge &rigid = m.viscous_edges[1], &compliant = m.viscous_edges[2];
  ASSERT_TRUE(rigid.free_field && compliant.free_field && !m.viscous_edges[0].free_field);
  EXPECT_TRUE(rigid.free_field->rigid);
  EXPECT_EQ(rigid.motion, MotionId{0});
  EXPECT_EQ(rigid.free_field->bottom, 1.0);
  EXPECT_EQ(rigid.free_field->top, 2.0);
  EXPECT_FALSE(compliant.free_field->rigid);
  EXPECT_EQ(compliant.motion, MotionId{1});
  EXPECT_EQ(compliant.upgoing, 1.0);
  EXPECT_EQ(compliant.free_field->bottom, 1.0);
  EXPECT_EQ(compliant.free_field->top, 3.5);
}

TEST(FreeFields, a_line_holds_the_edges_of_several_blocks_beside_one_column) {
  const Model m = with("free_field=[{on=[[2, 1], [2, 3]], blocks=[\"slider\", \"ledge\"], motion=\"pulse\"}]");
  ASSERT_EQ(m.viscous_edges.size(), 3U);
  for (std::size_t i : {1U, 2U}) {
    EXPECT_EQ(m.viscous_edges[i].free_field->bottom, 1.0);
    EXPECT_EQ(m.viscous_edges[i].free_field->top, 3.0);
  }
}

TEST(FreeFields, need_a_mesh_only_where_their_motion_shakes) {
  EXPECT_NO_THROW((void)read("full_case.toml", {"viscous_edge=[]", "motion.pulse.until=0.1", "motion.upward.until=0.1",
                                                "stage.0.duration=0.2", "free_field=[{block=\"slider\", edge=1}]"}));
}

struct WrongSide {
  const char *side, *key, *problem;  // key whole, problem in part
  std::vector<std::string> more{};
};
std::ostream& operator<<(std::ostream& out, const WrongSide& wrong) { return out << wrong.side; }
class WrongSides : public testing::TestWithParam<WrongSide> {};

TEST_P(WrongSides, are_refused_at_the_key) {
  std::vector<std::string> set{kBases, kMeshes, std::string("free_field=[") + GetParam().side + "]"};
  set.insert(set.end(), GetParam().more.begin(), GetParam().more.end());
  const CaseError e = error_of_file(kFolder + "full_case.toml", set);
  EXPECT_EQ(e.key, GetParam().key) << e.what();
  EXPECT_TRUE(holds(e.problem, GetParam().problem)) << e.what();
  EXPECT_FALSE(e.allowed.empty() || e.hint.empty()) << e.what();
}

INSTANTIATE_TEST_SUITE_P(
    Case, WrongSides,
    testing::Values(
        WrongSide{"{block=\"slider\", motion=\"pulse\"}", "free_field.0.on", "nothing says"},
        WrongSide{"{block=\"slider\", edge=2, motion=\"pulse\"}", "free_field.0.edge", "leans by 90 degrees"},
        WrongSide{"{block=\"wall\", edge=1, motion=\"pulse\"}", "free_field.0.edge", "held whole"},
        WrongSide{"{block=\"slider\", edge=1}", "free_field.0.motion", "2 bases"},
        WrongSide{"{block=\"slider\", edge=1, motion=\"upward\"}",
                  "free_field.0.motion",
                  "no base follows",
                  {"viscous_edge=[]"}},
        WrongSide{"{block=\"slider\", edge=1}",
                  "free_field.0.motion",
                  "no base that a motion drives",
                  {"viscous_edge=[]", "support.0={block=\"base\"}"}},
        WrongSide{"{block=\"slider\", edge=1, motion=\"puls\"}", "free_field.0.motion", "no motion of that name"},
        WrongSide{"{block=\"slider\", edge=1, motion=\"pulse\", top=1}", "free_field.0.top", "no height"},
        WrongSide{"{block=\"slider\", edge=1, motion=\"pulse\", bottom=1.5}", "free_field.0.bottom",
                  "reaches below the base"},
        WrongSide{"{block=\"slider\", edge=1, motion=\"pulse\", top=1.5}", "free_field.0.top",
                  "reaches above the surface"},
        WrongSide{"{block=\"slider\", edge=1, motion=\"pulse\"}, {block=\"slider\", edge=1, motion=\"upward\"}",
                  "free_field.1.edge", "viscous already"},
        WrongSide{"{on=[[2, 1], [2, 3]], blocks=[\"slider\", \"ledge\"], motion=\"pulse\"}",
                  "free_field.0.on",
                  "of another material",
                  {"block.4.material=\"soil\""}},
        WrongSide{"{block=\"slider\", edge=1, motion=\"pulse\"}",
                  "free_field.0.edge",
                  "no mesh in stage \"runout\"",
                  {"stage.1.method_of=[]"}},
        WrongSide{"{block=\"slider\", edge=1, motion=\"pulse\"}",
                  "free_field.0.edge",
                  "no mesh in stage \"shaking\"",
                  {"stage.0.method_of=[{blocks=[\"slider\"], method=\"nmm\", onefold=true}]"}}));

}  // namespace
}  // namespace scree::io::test
