// Free-field sides read from a case: the outlines and the base they use, and wrong input that is refused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupling/stages/driver.h"
#include "model/free_field.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::free_field_keys_test {
namespace {

const std::string kBases = "viscous_edge=[{block=\"ledge\", edge=2, motion=\"upward\", motion_is=\"upgoing\"}]",
                  kMeshes = "stage.1.method_of=[{blocks=[\"slider\", \"ledge\"], method=\"nmm\"}]";

Model with(const std::string& sides) { return read("full_case.toml", {kBases, kMeshes, sides}).model; }

/// Largest value and last time of the functions of free-field tractions on an edge, and the number of tractions.
struct Found {
  double largest = 0.0, last = 0.0;
  std::size_t tractions = 0;
};
Found on(const Model& m, std::int32_t block, std::int32_t edge) {
  Found out;
  for (const EdgeTraction& t : m.tractions) {
    if (t.span.block != BlockId{block} || t.span.edge != OutlineEdge{0, edge} || !of_free_field(m, t.function))
      continue;
    const TimeFunction& f = m.functions[t.function.index()];
    for (const double v : f.table) out.largest = std::max(out.largest, std::abs(v));
    out.last = std::max(out.last, f.end());
    ++out.tractions;
  }
  return out;
}

TEST(FreeFields, stand_on_the_base_that_their_motion_drives) {
  const Model m = with(
      "free_field=[{block=\"slider\", edge=1, motion=\"pulse\"}, "
      "{block=\"ledge\", edge=1, motion=\"upward\", bottom=1, top=3.5}]");
  ASSERT_EQ(m.viscous_edges.size(), 3U);
  EXPECT_EQ(m.viscous_edges[1].span.block, BlockId{1});
  EXPECT_EQ(m.viscous_edges[2].span.block, BlockId{4});
  EXPECT_FALSE(m.viscous_edges[1].motion.valid());
  const Found rigid = on(m, 1, 1), compliant = on(m, 4, 1);
  // On the shaken base the ground rings until the end of the run. Over the compliant base the motion ends with the last
  // wave, and its velocity is at most twice that of the upgoing wave.
  double run = 0.0;
  for (const auto& stage : read("full_case.toml").plan.stages) run += seconds(stage.duration);
  EXPECT_NEAR(rigid.last, run, 2e-3);
  EXPECT_LT(compliant.last, 0.32);
  EXPECT_GT(compliant.last, 0.3);
  EXPECT_NEAR(compliant.largest / (2.0 * m.motions[1].facts().pgv), 1.0, 0.05);
  EXPECT_EQ(rigid.tractions % 4, 0U) << "velocity and stress of both directions";
  EXPECT_EQ(compliant.tractions % 2, 0U) << "it moves up and down only";
}

TEST(FreeFields, a_line_holds_the_edges_of_several_blocks_beside_one_column) {
  const Model m = with("free_field=[{on=[[2, 1], [2, 3]], blocks=[\"slider\", \"ledge\"], motion=\"pulse\"}]");
  ASSERT_EQ(m.viscous_edges.size(), 3U);
  EXPECT_GT(on(m, 1, 1).tractions, 0U);
  EXPECT_EQ(on(m, 1, 1).tractions, on(m, 4, 3).tractions);
}

TEST(FreeFields, are_no_part_of_a_reduction) {
  const Model m = read("full_case.toml", {kBases, kMeshes, "free_field=[{block=\"slider\", edge=1, motion=\"pulse\"}]",
                                          "reduction={factor=1.1}"})
                      .model;
  EXPECT_EQ(on(m, 1, 1).tractions, 0U);
  for (const ViscousEdge& e : m.viscous_edges) EXPECT_FALSE(e.motion.valid());
}

TEST(FreeFields, need_a_mesh_only_where_their_motion_shakes) {
  EXPECT_NO_THROW((void)read("full_case.toml", {"viscous_edge=[]", "motion.pulse.baseline=\"none\"",
                                                "motion.pulse.until=0.1", "motion.upward.until=0.1",
                                                "stage.0.duration=0.2", "free_field=[{block=\"slider\", edge=1}]"}));
}

TEST(FreeFields, of_a_case_let_a_wave_go_up_undistorted) {
  const Case c = read_text(
      "[model]\ngravity = [0, 0]\n"
      "[material.soil]\ndensity = 2000\nyoung = 2e8\npoisson = 0.25\n"
      "[motion.up]\nfile = \"pulse.csv\"\nunit = \"g\"\ndirection = [1, 0]\nscale = 0.1\n"
      "[[block]]\nname = \"ground\"\npolygon = [[0, 0], [9, 0], [9, 8], [0, 8]]\nmaterial = \"soil\"\n"
      "[[viscous_edge]]\nblock = \"ground\"\nedge = 0\nmotion = \"up\"\n"
      "[[free_field]]\non = [[0, 0], [0, 8]]\n[[free_field]]\non = [[9, 0], [9, 8]]\n"
      "[[monitor]]\npoint = [9, 8]\n[[monitor]]\npoint = [4.5, 8]\n"
      "[[stage]]\nname = \"shaking\"\nmethod = \"nmm\"\nintegrator = \"explicit\"\ncover_size = 1\nduration = 0.4\n"
      "[output]\nevery = 0.4\nhistory_every = 1e-3\n");
  struct Look final : coupling::Sink {
    void history(const coupling::HistoryView& h) override {
      const Vec2 free = motion->velocity(h.time - 8.0 / 200.0);  // an outcrop moves as the top: twice the upgoing wave
      for (std::size_t k = 0; k < 4; k += 2)
        error = std::max(error, (Vec2(h.velocity[k], h.velocity[k + 1]) - free).norm());
    }
    const GroundMotion* motion = nullptr;
    double error = 0.0;
  } look;
  look.motion = &c.model.motions[0];
  const coupling::Methods methods = coupling::standard_methods();
  coupling::Driver run(c.model, c.plan, methods);
  run.add_sink(look);
  ASSERT_EQ(run.run().status, coupling::RunEnd::Status::done);
  std::printf("within %.5f of the largest velocity\n", look.error / look.motion->facts().pgv);
  EXPECT_LT(look.error, 0.02 * look.motion->facts().pgv);
}

struct WrongSide {
  const char *side, *key, *problem;  // the key is compared whole, the problem in part
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
        WrongSide{"{block=\"slider\", motion=\"pulse\"}", "free_field.0.on", "outlines are not given"},
        WrongSide{"{block=\"slider\", edge=2, motion=\"pulse\"}", "free_field.0.edge", "leans by 90 degrees"},
        WrongSide{"{block=\"wall\", edge=1, motion=\"pulse\"}", "free_field.0.edge", "held whole"},
        WrongSide{"{block=\"slider\", edge=1}", "free_field.0.motion", "2 bases"},
        WrongSide{"{block=\"slider\", edge=1, motion=\"upward\"}",
                  "free_field.0.motion",
                  "no base is driven",
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
}  // namespace scree::io::test::free_field_keys_test
