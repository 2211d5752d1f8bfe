// Bolts and compliant bases in case files.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_bolts_test {
namespace {

const std::string kText = R"(
material.rock = { density = 2600.0, young = "1 GPa", poisson = 0.2 }
support = [{ block = "base" }]
block = [
  { name = "base", material = "rock", polygon = [[0, 0], [4, 0], [4, 1], [0, 1]] },
  { name = "top", material = "rock", polygon = [[0, 1], [4, 1], [4, 2], [0, 2]] },
]
stage = [{ name = "first", method = "dda", integrator = "implicit", dt = "1 ms", duration = 1.0 },
         { name = "bolting", method = "dda", integrator = "implicit", dt = "1 ms", duration = 1.0 }]
[[bolt]]
head = [1.0, 2.0]
toe = [1.0, 0.2]
axial_stiffness = "100 MN"
)";

Bolt bolt_of(const std::string& keys) { return read_text(kText + keys).model.bolts.at(0); }

TEST(Bolts, those_of_later_stages_are_no_part_of_a_factor_of_safety) {
  std::string text = kText;
  text.replace(text.find("duration"), 0, "rest = true, ");
  const auto bolts = [&text](const std::string& stage) {
    return read_text(text + "stage = \"" + stage + "\"\n[reduction]\nfactor = 1.5\n").model.bolts.size();
  };
  EXPECT_EQ(bolts("first"), 1U);
  EXPECT_EQ(bolts("bolting"), 0U);
}

TEST(Bolts, numbers_of_one_bolt_are_divided_by_the_spacing) {
  const Bolt b = bolt_of(
      "name = \"b\"\nstage = \"bolting\"\nspacing = \"2 m\"\nyield = \"300 kN\"\npretension = \"50 kN\"\n"
      "bond_length = 1.0\nbond_stiffness = \"1 GN/m2\"\nbond_strength = \"400 kN/m\"\nsegment = 0.25\n"
      "shear_stiffness = \"60 MN/m\"\nshear_strength = \"130 kN\"\nrupture_shear = 0.05\nrupture_strain = 0.1\n");
  EXPECT_EQ(b.name, "b");
  EXPECT_EQ(b.stage, StageId{1});
  EXPECT_EQ(b.stiffness, 50e6);
  EXPECT_EQ(b.yield, 150e3);
  EXPECT_EQ(b.pretension, 25e3);
  EXPECT_EQ(b.bond_stiffness, 0.5e9);
  EXPECT_EQ(b.bond_strength, 200e3);
  EXPECT_EQ(b.shear_stiffness, 30e6);
  EXPECT_EQ(b.shear_strength, 65e3);
  EXPECT_EQ(b.rupture_shear, 0.05);
  EXPECT_EQ(b.rupture_strain, 0.1);
  // The bond extends from 0.8 m to 1.8 m from the head: one piece in the upper block, four in the base.
  ASSERT_EQ(b.nodes.size(), 6U);
  EXPECT_EQ(b.nodes[0].length, 0.0);
  EXPECT_NEAR(b.nodes[1].length, 0.2, 1e-12);
  EXPECT_NEAR(b.nodes[2].length, 0.2, 1e-12);
  EXPECT_EQ(b.nodes[1].block, BlockId{1});
  EXPECT_EQ(b.nodes[2].block, BlockId{0});
  ASSERT_EQ(b.crossings.size(), 1U);
  EXPECT_EQ(b.crossings[0].segment, 1);
}

/// The same model with bolts from the layer of a drawing.
std::string drawn(const std::string& columns) {
  std::ofstream(::testing::TempDir() + "bolts.csv") << columns;
  std::string text = replaced(kText, "head = [1.0, 2.0]\ntoe = [1.0, 0.2]\n", "layer = \"bolts\"\nname = \"row\"\n");
  return "drawing = { file = \"" + ::testing::TempDir() + "bolts.csv\" }\n" + text;
}

TEST(Bolts, each_line_of_a_layer_is_one_from_its_first_point) {
  const Model m = read_text(drawn("1.0,2.0,BOLTS\n1.0,0.2,BOLTS\n\n3.0,2.0,BOLTS\n2.5,0.2,BOLTS\n")).model;
  ASSERT_EQ(m.bolts.size(), 2U);
  EXPECT_EQ(m.bolts[0].name, "row-1");
  EXPECT_EQ(m.bolts[1].name, "row-2");
  EXPECT_EQ(m.bolts[1].head, Vec2(3.0, 2.0));
  EXPECT_EQ(m.bolts[1].toe, Vec2(2.5, 0.2));
  EXPECT_EQ(m.bolts[1].stiffness, 100e6);
}

TEST(Bolts, a_line_with_a_kink_is_refused_with_its_row) {
  const CaseError e = error_of_text(drawn("1.0,2.0,BOLTS\n1.2,1.2,BOLTS\n1.0,0.2,BOLTS\n"));
  EXPECT_TRUE(holds(e.what(), "bolts.csv:1:1")) << e.what();
  EXPECT_TRUE(holds(e.what(), "of 3 points is no bolt")) << e.what();
}

TEST(Bolts, head_and_layer_exclude_each_other_and_one_is_needed) {
  EXPECT_TRUE(
      holds(error_of_text(replaced(kText, "head =", "layer = \"x\"\nhead =")).what(), "head and layer are both given"));
  EXPECT_TRUE(holds(error_of_text(replaced(kText, "toe = [1.0, 0.2]\n", "")).what(), "the bolt has no toe"));
}

TEST(Bolts, anchor_from_point_to_point_has_two_nodes_and_no_limits) {
  const Bolt b = bolt_of("");
  EXPECT_EQ(b.name, "bolt#1");
  EXPECT_FALSE(b.stage.valid());
  EXPECT_EQ(b.nodes.size(), 2U);
  EXPECT_EQ(b.yield, Bolt::kNever);
  EXPECT_TRUE(b.slack(0));
}

TEST(Bolts, positions_follow_the_local_origin) {
  std::string text = kText;
  for (const char* from : {"[0, 0], [4, 0], [4, 1], [0, 1]", "[0, 1], [4, 1], [4, 2], [0, 2]"}) {
    std::string to = from;
    for (std::size_t at = 0; (at = to.find('[', at)) != std::string::npos; ++at) to.insert(at + 1, "100000");
    text = replaced(text, from, to);
  }
  text = replaced(replaced(text, "head = [1.0", "head = [1000001.0"), "toe = [1.0", "toe = [1000001.0");
  const Case c = read_text(text);
  const Case near = read_text(kText);
  EXPECT_GT(c.model.origin.x(), 0.0);
  EXPECT_EQ(c.model.bolts[0].head + c.model.origin, Vec2(1000001.0, 2.0));
  EXPECT_EQ(c.model.bolts[0].nodes.size(), near.model.bolts[0].nodes.size());
}

struct WrongBolt {
  const char *keys, *key, *problem, *allowed, *hint;
};

TEST(Bolts, wrong_ones_are_refused_with_what_to_change) {
  const WrongBolt kWrong[] = {
      {"bond_strength = 1e5\n", "bolt.0.bond_strength", "nothing without bond_length", "beside bond_length", "remove"},
      {"bond_length = 5.0\nbond_stiffness = 1e9\n", "bolt.0.bond_length", "1.8 m long", "at most 1.8 m", "shorten"},
      {"bond_length = 1.0\n", "bolt.0.bond_stiffness", "no stiffness", "> 0", "slip"},
      {"plate = false\n", "bolt.0.plate", "held by nothing", "bond along the whole", "bond_length"},
      {"rupture_strain = 0.1\n", "bolt.0.rupture_strain", "nothing without yield", "beside yield", "remove"},
      {"shear_strength = 1e5\n", "bolt.0.shear_strength", "without shear_stiffness", "beside", "remove"},
      {"yield = 1e5\npretension = 1e5\n", "bolt.0.pretension", "yields before", "less than yield", "lower"},
      {"bond_length = 1.0\nbond_stiffness = 1e9\nbond_strength = 1e5\npretension = 2e5\n", "bolt.0.pretension",
       "slips before", "100000", "lengthen"},
      {"stage = \"boltng\"\n", "bolt.0.stage", "no stage of that name", "\"bolting\"", "did you mean"},
      {"spacing = 0.0\n", "bolt.0.spacing", "", "> 0", ""},
  };
  for (const WrongBolt& w : kWrong) {
    const CaseError e = error_of_text(kText + w.keys);
    EXPECT_EQ(e.key, w.key) << e.what();
    EXPECT_TRUE(holds(e.problem, w.problem)) << e.what();
    EXPECT_TRUE(holds(e.allowed, w.allowed)) << e.what();
    EXPECT_TRUE(holds(e.hint, w.hint)) << e.what();
    EXPECT_GT(e.line, 0) << e.what();
  }
}

TEST(Bolts, places_outside_of_blocks_and_along_joints_are_refused) {
  const auto error = [](const std::string& head, const std::string& toe) {
    return error_of_text(
        replaced(replaced(kText, "head = [1.0, 2.0]", "head = " + head), "toe = [1.0, 0.2]", "toe = " + toe));
  };
  const auto told = [&](const std::string& head, const std::string& toe) { return error(head, toe).problem; };
  EXPECT_EQ(error("[1.0, 2.5]", "[1.0, 0.5]").key, "bolt.0.head");
  EXPECT_EQ(error("[1.0, 1.5]", "[1.0, -0.5]").key, "bolt.0.toe");
  EXPECT_TRUE(holds(told("[1.0, 2.5]", "[1.0, 0.5]"), "head is in no block"));
  EXPECT_TRUE(holds(told("[1.0, 1.5]", "[1.0, -0.5]"), "toe is in no block"));
  EXPECT_TRUE(holds(told("[9.0, 1.5]", "[9.0, 0.5]"), "through no block"));
  EXPECT_TRUE(holds(told("[1.0, 0.8]", "[1.0, 0.2]"), "held whole already"));
  EXPECT_TRUE(holds(told("[1.0, 2.0]", "[1.0, 2.0]"), "where the head is"));
}

TEST(Bolts, two_of_one_name_are_refused) {
  const CaseError e = error_of_text(kText +
                                    "name = \"a\"\n[[bolt]]\nname = \"a\"\nhead = [2.0, 2.0]\ntoe = [2.0, 0.2]\n"
                                    "axial_stiffness = 1e8\n");
  EXPECT_TRUE(holds(e.problem, "same name")) << e.what();
}

TEST(Bolts, example_of_the_documentation_reads) {
  const Case c = read_case(SCREE_SOURCE_DIR "/docs/examples/bolted-slope.toml", {}, kMethods);
  ASSERT_EQ(c.model.bolts.size(), 2U);
  EXPECT_EQ(c.model.bolts[1].crossings.size(), 1U);
}

std::string with_strength(const std::string& keys) {
  return replaced(kText, "poisson = 0.2 }", "poisson = 0.2, rock_strength = {" + keys + "} }");
}

TEST(RockStrengthKeys, are_mohr_coulomb_or_hoek_and_brown) {
  const Material m = read_text(with_strength("cohesion = \"1 MPa\", friction_deg = 45.0")).model.materials[0];
  const auto* mohr = std::get_if<MohrCoulombStrength>(&m.rock_strength.value());
  ASSERT_NE(mohr, nullptr);
  EXPECT_EQ(mohr->cohesion, 1e6);
  EXPECT_NEAR(mohr->tension, 1e6, 1e-6);  // c/tan(phi)
  const Material h = read_text(with_strength("ucs = \"50 MPa\", gsi = 45.0, mi = 10.0, d = 0.5")).model.materials[0];
  const auto* hoek = std::get_if<HoekBrownStrength>(&h.rock_strength.value());
  ASSERT_NE(hoek, nullptr);
  EXPECT_NEAR(hoek->mb, 10.0 * std::exp(-55.0 / 21.0), 1e-12);
}

TEST(RockStrengthKeys, are_refused_where_they_do_not_fit) {
  const auto told = [](const std::string& keys) { return std::string(error_of_text(with_strength(keys)).what()); };
  EXPECT_TRUE(holds(told("cohesion = 1e6"), "needs cohesion and friction_deg"));
  EXPECT_TRUE(holds(told("ucs = 1e6, gsi = 40"), "needs ucs, gsi and mi"));
  EXPECT_TRUE(holds(told("cohesion = 1e6, friction_deg = 30, ucs = 1e6"), "one of the two"));
  EXPECT_TRUE(holds(told("cohesion = 1e6, friction_deg = 45, tension = 2e6"), "ends before the tension"));
  EXPECT_TRUE(holds(told("d = 0.5"), "is empty"));
  EXPECT_TRUE(holds(told("ucs = 1e6, gsi = 101, mi = 10"), "gsi"));
}

}  // namespace
}  // namespace scree::io::test::case_bolts_test
