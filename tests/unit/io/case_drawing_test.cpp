// Cases whose geometry is read from a drawing.
#include <gtest/gtest.h>

#include <numbers>
#include <set>

#include "tests/unit/io/case_read.h"

namespace scree::io::test::case_drawing_test {
namespace {

const std::string kCase = R"(
title = "from a drawing"
model = { default_joint = "a" }
material.rock = { density = 2600.0, young = "5 GPa", poisson = 0.25 }
material.base = { density = 2700.0, young = "20 GPa", poisson = 0.25 }
joint.a = { friction_deg = 30.0 }
joint.b = { friction_deg = 25.0 }
[drawing]
file = "drawings/section-r2018.dxf"
[domain]
outline_layer = "outline"
holes_layer = "TUNNEL"
material = "rock"
least_width = 0.02
[[domain.region]]
name = "base"
layer = "BASE"
material = "base"
cut = false
[[domain.trace]]
layer = "joint-a"
joint = "a"
[[domain.trace]]
layer = "JOINT-B"
joint = "b"
[[water]]
layer = "WATER"
[[support]]
blocks = ["base*"]
[[monitor]]
layer = "MONITORS"
name = "target"
[[stage]]
name = "s"
method = "dda"
integrator = "implicit"
dt = 1e-3
duration = 0.01
)";

TEST(CaseDrawing, a_slope_is_cut_from_the_layers_of_a_drawing) {
  const Case c = read_text(kCase);
  double area = 0.0;
  for (const Block& b : c.model.blocks) area += moments(b.polygon).area;
  const double whole = 60 * 10 + 25 * 25 + 0.5 * 15 * 25 - 8.0 - 2.0 * std::numbers::pi;
  EXPECT_NEAR(area, whole, 4.0 * c.drawing->tolerance * 2.0);
  EXPECT_EQ(c.model.blocks.size(), 6u);
  ASSERT_EQ(c.model.waters.size(), 1u);
  EXPECT_EQ(c.model.waters[0].line.size(), 4u);
  ASSERT_EQ(c.model.monitors.size(), 2u);
  EXPECT_EQ(c.model.monitors[1].name, "target-2");
  std::set<std::string> fates;
  for (const DrawingRow& r : c.drawing->rows) fates.insert(r.layer + " " + r.entity + ": " + r.fate);
  EXPECT_TRUE(fates.count("TUNNEL LWPOLYLINE: domain.holes"));
  EXPECT_TRUE(fates.count("BOLTS LINE: left out: no section of the case uses the layer"));
  EXPECT_TRUE(fates.count("NOTES TEXT: left out: this kind is not read"));
}

TEST(CaseDrawing, what_is_missing_or_open_is_told) {
  const auto told = [](const std::string& from, const std::string& to) {
    return error_of_text(replaced(kCase, from, to));
  };
  CaseError e = told("outline_layer = \"outline\"", "outline_layer = \"OUTLNE\"");
  EXPECT_TRUE(holds(e.problem, "no such layer")) << e.what();
  EXPECT_TRUE(holds(e.allowed, "\"OUTLINE\"")) << e.what();
  e = told("outline_layer = \"outline\"", "outline_layer = \"WATER\"");
  EXPECT_TRUE(holds(e.problem, "open")) << e.what();
  EXPECT_TRUE(holds(e.file, "section-r2018.dxf"));
  EXPECT_GT(e.line, 0);
  e = told("layer = \"MONITORS\"", "layer = \"BOLTS\"");
  EXPECT_TRUE(holds(e.problem, "no point")) << e.what();
  e = told("file = \"drawings/section-r2018.dxf\"", "file = \"drawings/section-r12.dxf\"");
  EXPECT_TRUE(holds(e.problem, "$INSUNITS")) << e.what();
  e = told("file = \"drawings/section-r2018.dxf\"", "file = \"drawings/none.dxf\"");
  EXPECT_TRUE(holds(e.problem, "does not exist")) << e.what();
  EXPECT_EQ(e.key, "drawing.file");
  e = told("[drawing]\nfile = \"drawings/section-r2018.dxf\"\n", "");
  EXPECT_TRUE(holds(e.problem, "no drawing")) << e.what();
  e = told("layer = \"BASE\"", "layer = \"BASE\"\npolygon = [[0,0],[1,0],[1,1]]");
  EXPECT_TRUE(holds(e.problem, "both given")) << e.what();
}

}  // namespace
}  // namespace scree::io::test::case_drawing_test
