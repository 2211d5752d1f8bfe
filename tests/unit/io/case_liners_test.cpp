// Liners in case files.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_liners_test {
namespace {

const std::string kText = R"(
material.rock = { density = 2600.0, young = "1 GPa", poisson = 0.2 }
support = [{ block = "base" }]
block = [
  { name = "base", material = "rock", polygon = [[0, 0], [4, 0], [4, 1], [0, 1]] },
  { name = "top", material = "rock", polygon = [[0, 1], [2, 1], [2, 2], [0, 2]] },
  { name = "plug", material = "rock", polygon = [[2, 1], [4, 1], [4, 2], [2, 2]] },
]
stage = [{ name = "first", method = "dda", integrator = "implicit", dt = "1 ms", duration = 1.0 },
         { name = "open", method = "dda", integrator = "implicit", dt = "1 ms", duration = 1.0, excavate = ["plug"] }]
[[liner]]
)";
const std::string kOpen =
    "along = [[2.0, 1.9], [2.0, 1.0], [3.9, 1.0]]\nspacing = 0.3\nthickness = \"20 cm\"\nyoung = \"9.6 GPa\"\n"
    "stage = \"open\"\n";

Bolt liner_of(const std::string& keys) { return read_text(kText + keys).model.bolts.at(0); }

TEST(Liners, section_has_the_stiffness_of_plane_strain_and_strengths_for_unit_length) {
  const Bolt b = liner_of(kOpen +
                          "tensile_strength = \"2 MPa\"\ncompressive_strength = \"30 MPa\"\n"
                          "rupture_strain = 0.01\nname = \"skin\"\ntolerance = 0.02\n");
  EXPECT_EQ(b.name, "skin");
  EXPECT_EQ(b.stage, StageId{1});
  EXPECT_NEAR(b.stiffness, 9.6e9 / 0.96 * 0.2, 1e-6 * b.stiffness);
  EXPECT_NEAR(b.bending, 9.6e9 / 0.96 * 0.008 / 12.0, 1e-6 * b.bending);
  EXPECT_NEAR(b.yield, 4e5, 1e-6);
  EXPECT_NEAR(b.crushing, 6e6, 1e-6);
  EXPECT_EQ(b.rupture_strain, 0.01);
  EXPECT_EQ(b.tolerance, 0.02);
  EXPECT_FALSE(b.plate);
  // Line not covered by the plug: three bars downward, seven along the floor. No node lies in the plug.
  ASSERT_EQ(b.nodes.size(), 11U);
  EXPECT_EQ(b.nodes[0].block, BlockId{1});
  EXPECT_EQ(b.nodes[10].block, BlockId{0});
  EXPECT_EQ(liner_of(kOpen).name, "liner#1");
}

TEST(Liners, wrong_ones_are_told_with_place_and_hint) {
  struct Wrong {
    std::string keys, key, problem, hint;
  };
  const auto in = [](const std::string& from, const std::string& to) { return replaced(kOpen, from, to); };
  for (const Wrong& w : std::vector<Wrong>{
           {replaced(in("stage = \"open\"\n", ""), "[[2.0, 1.9], [2.0, 1.0], [3.9, 1.0]]", "[[2.5, 2.0], [3.5, 2.0]]"),
            "liner.0.along", "block \"plug\", which it is glued to, is not there", "end"},
           {in("[2.0, 1.9]", "[2.0, 2.5]"), "liner.0.along", "0.5 m away", "raise tolerance"},
           {in("[2.0, 1.9]", "[2.0, 1.0]"), "liner.0.along", "where the point before", "remove"},
           {in("[2.0, 1.9], ", ""), "liner.0.along", "held whole already", "move"},
           {kOpen + "rupture_strain = 0.1\n", "liner.0.rupture_strain", "nothing without", "give tensile_strength"},
           {in("\"open\"", "\"opn\""), "liner.0.stage", "no stage of that name", "did you mean"},
           {in("spacing = 0.3\n", ""), "liner.0.spacing", "missing", ""},
           {in("spacing = 0.3", "spacing = -1"), "liner.0.spacing", "out of range", ""}}) {
    const std::string text = error_of_text(kText + w.keys).what();
    EXPECT_TRUE(holds(text, w.key)) << text;
    EXPECT_TRUE(holds(text, w.problem)) << text;
    EXPECT_TRUE(holds(text, w.hint)) << text;
  }
}

TEST(Liners, coordinates_far_from_the_origin_are_taken_near_it) {
  const std::string far = replaced(replaced(kText + kOpen, "[[0, 0], [4, 0], [4, 1], [0, 1]]",
                                            "[[0, 0], [4, 0], [4, 1], [0, 1], [-1000000, 1], [-1000000, 0]]"),
                                   "name = \"first\"", "name = \"first\"");
  const Case c = read_text(far);
  const Bolt& b = c.model.bolts[0];
  EXPECT_EQ(b.nodes.size(), 11U);
  EXPECT_LT((b.nodes[0].place + c.model.origin - Vec2(2.0, 1.9)).norm(), 1e-9);
  EXPECT_LT((b.along[0] + c.model.origin - Vec2(2.0, 1.9)).norm(), 1e-9);
}

}  // namespace
}  // namespace scree::io::test::case_liners_test
