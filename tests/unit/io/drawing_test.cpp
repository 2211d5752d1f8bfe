// Drawings by three other programs (ezdxf, potrace, pstoedit), and damaged ones.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "io/drawing/chains.h"
#include "io/drawing/curves.h"
#include "io/drawing/dxf.h"
#include "model/random.h"
#include "tests/unit/io/case_read.h"

namespace scree::io::test::drawing_test {
namespace {

const std::string kDrawings = kFolder + "drawings/";

Drawing read_drawing(const std::string& name, DrawingOptions options = {}) {
  return read_dxf(bytes_of(kDrawings + name), options);
}

std::vector<const DrawnLine*> on(const Drawing& d, const std::string& layer, const std::string& entity = "") {
  std::vector<const DrawnLine*> out;
  for (const DrawnLine& l : d.lines)
    if (l.layer == layer && (entity.empty() || l.entity == entity)) out.push_back(&l);
  return out;
}

double least_distance(const std::vector<Vec2>& line, const Vec2& x) {
  double least = 1e300;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Vec2 d = line[i + 1] - line[i];
    const double s = std::clamp((x - line[i]).dot(d) / d.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (x - line[i] - s * d).norm());
  }
  return least;
}

TEST(Curves, bulges_are_arcs_within_the_tolerance) {
  Random random(2);
  for (int trial = 0; trial < 100; ++trial) {
    const Vec2 p(random.uniform(), random.uniform()), q(3.0 + random.uniform(), random.uniform());
    const double bulge = 4.0 * random.uniform() - 2.0, tolerance = 1e-4;
    std::vector<Vec2> arc{p};
    for (const Vec2& x : bulge_points(p, q, bulge, tolerance)) arc.push_back(x);
    const double d = (q - p).norm(), radius = d * (1.0 + bulge * bulge) / (4.0 * std::abs(bulge));
    // The middle of the arc lies to the right of p -> q where the bulge is positive, by the sagitta d |b|/2.
    const Vec2 right = Vec2((q - p).y(), -(q - p).x()).normalized();
    EXPECT_LT(least_distance(arc, 0.5 * (p + q) + 0.5 * d * bulge * right), 2.0 * tolerance);
    const Vec2 centre = 0.5 * (p + q) + (0.5 * d * bulge - std::copysign(radius, bulge)) * right;
    for (std::size_t i = 0; i + 1 < arc.size(); ++i) {
      EXPECT_NEAR((arc[i] - centre).norm(), radius, 1e-9 * radius);
      EXPECT_GT((0.5 * (arc[i] + arc[i + 1]) - centre).norm(), radius - 1.001 * tolerance);
    }
  }
}

TEST(Curves, a_rational_quadratic_spline_is_a_circle) {
  Spline s;
  s.degree = 2;
  s.knots = {0, 0, 0, 1, 1, 1};
  s.control = {{1, 0}, {1, 1}, {0, 1}};
  s.weights = {1.0, std::sqrt(0.5), 1.0};
  ASSERT_EQ(spline_fault(s), "");
  for (const double t : {0.0, 0.2, 0.5, 0.9, 1.0}) EXPECT_NEAR(spline_at(s, t).norm(), 1.0, 1e-14);
  const std::vector<Vec2> points = spline_points(s, 1e-4);
  EXPECT_EQ(points.front(), Vec2(1, 0));
  EXPECT_LT((points.back() - Vec2(0, 1)).norm(), 1e-14);
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
    EXPECT_GT((0.5 * (points[i] + points[i + 1])).norm(), 1.0 - 1.1e-4);
  EXPECT_LT(points.size(), 80u);
}

TEST(Drawing, r12_needs_a_unit_and_later_headers_have_one) {
  try {
    (void)read_drawing("section-r12.dxf");
    FAIL();
  } catch (const DrawingError& e) {
    EXPECT_TRUE(holds(e.what(), "$INSUNITS")) << e.what();
    EXPECT_TRUE(holds(e.hint, "drawing.unit"));
  }
  DrawingOptions metres;
  metres.unit = 1.0;
  EXPECT_EQ(read_drawing("section-r12.dxf", metres).form, "DXF R12 (AC1009)");
  const Drawing r2018 = read_drawing("section-r2018.dxf");  // in millimetres
  EXPECT_EQ(r2018.form, "DXF R2018 (AC1032)");
  EXPECT_EQ(r2018.unit, 1e-3);
  EXPECT_EQ(r2018.unit_from, "the header");
}

/// Properties of all three sections of ezdxf, independent of version and unit.
void expect_section(const Drawing& d) {
  const std::vector<Chain> outline = chained(on(d, "OUTLINE"), 1e-6);
  ASSERT_EQ(outline.size(), 1u);
  EXPECT_TRUE(outline[0].closed);
  EXPECT_NEAR(std::abs(signed_area(outline[0].points)), 60 * 10 + 25 * 25 + 0.5 * 15 * 25, 1e-6);
  const auto tunnel = on(d, "TUNNEL");
  ASSERT_EQ(tunnel.size(), 1u);
  EXPECT_TRUE(tunnel[0]->closed);
  const double roof = 0.5 * std::numbers::pi * 4.0;  // half a circle of radius 2
  EXPECT_NEAR(signed_area(tunnel[0]->points), 8.0 + roof, 4.0 * d.tolerance * 2.0);
  EXPECT_LT(signed_area(tunnel[0]->points), 8.0 + roof);
  // ECHELON from (1, 1): (0, 0)-(3, 1) on the layer of its INSERT, (3, 1)-(4, 1) on its own.
  const auto has = [&](const std::string& layer, const Vec2& a, const Vec2& b) {
    for (const DrawnLine* l : on(d, layer, "LINE"))
      if ((l->points[0] - a).norm() < 1e-6 && (l->points[1] - b).norm() < 1e-6) return true;
    return false;
  };
  const Mat2 R = rotation(std::numbers::pi / 6.0);
  EXPECT_TRUE(has("Joint-B", {20, 12}, Vec2(20, 12) + R * Vec2(6, 1)));
  EXPECT_TRUE(has("Joint-A", Vec2(20, 12) + R * Vec2(6, 1), Vec2(20, 12) + R * Vec2(8, 1)));
  EXPECT_TRUE(has("Joint-B", {50, 2}, {47, 3}));
  for (const double x : {5.0, 11.0})
    for (const double y : {25.0, 28.0}) EXPECT_TRUE(has("Joint-B", {x, y}, {x + 3, y + 1})) << x << ' ' << y;
  const auto arcs = on(d, "Joint-A", "ARC");
  ASSERT_EQ(arcs.size(), 1u);
  EXPECT_LT((arcs[0]->points.front() - Vec2(13, 35)).norm(), 1e-9);
  EXPECT_LT((arcs[0]->points.back() - Vec2(25 + 6, 35 - 12 * std::sqrt(0.75))).norm(), 1e-6);
  std::set<std::string> left_out;
  for (const DrawnCount& c : d.counts)
    if (!c.left_out.empty()) left_out.insert(c.entity);
  EXPECT_TRUE(left_out.count("TEXT"));
  EXPECT_EQ(d.points.size(), 2u);
}

TEST(Drawing, sections_of_ezdxf_are_read_alike_whatever_the_version) {
  DrawingOptions metres;
  metres.unit = 1.0;
  expect_section(read_drawing("section-r12.dxf", metres));
  expect_section(read_drawing("section-r2000.dxf"));
  expect_section(read_drawing("section-r2018.dxf"));
}

TEST(Drawing, splines_pass_through_the_points_they_were_fitted_to) {
  for (const char* name : {"section-r2000.dxf", "section-r2018.dxf"}) {
    DrawingOptions fine;
    fine.tolerance = 1e-4;
    const Drawing d = read_drawing(name, fine);
    const auto splines = on(d, "Joint-B", "SPLINE");
    ASSERT_EQ(splines.size(), 1u);
    // ezdxf takes the points as control points: the curve begins and ends there, and is cubic between.
    const std::vector<Vec2> c{{2, 5}, {12, 20}, {30, 8}, {45, 22}};
    EXPECT_LT((splines[0]->points.front() - c[0]).norm(), 1e-9);
    EXPECT_LT((splines[0]->points.back() - c[3]).norm(), 1e-9);
    for (const double t : {0.1, 0.37, 0.5, 0.8}) {
      const double s = 1.0 - t;
      const Vec2 x = s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
      EXPECT_LT(least_distance(splines[0]->points, x), 1.01e-4);
    }
    const auto ellipse = on(d, "Joint-B", "ELLIPSE");
    ASSERT_EQ(ellipse.size(), 1u);
    const Vec2 a(6, 2), b(-1, 3);
    for (const double t : {0.2, 1.1, 2.0})
      EXPECT_LT(least_distance(ellipse[0]->points, Vec2(20, 20) + std::cos(t) * a + std::sin(t) * b), 1.01e-4);
  }
}

TEST(Drawing, bulges_of_potrace_enclose_the_area_of_their_arcs) {
  DrawingOptions options;
  options.unit = 1.0;
  options.tolerance = 1e-5;
  const Drawing d = read_drawing("potrace.dxf", options);
  ASSERT_EQ(d.lines.size(), 1u);
  EXPECT_TRUE(d.lines[0].closed);
  // Reference 179.93916...: shoelace formula plus circular segments of the twenty vertices.
  EXPECT_NEAR(std::abs(signed_area(d.lines[0].points)), 179.9391658534231, 1e-5 * 50.0);
}

TEST(Drawing, bezier_curve_of_pstoedit_is_where_it_was_drawn) {
  DrawingOptions options;
  options.unit = 1e-3;
  options.tolerance = 1e-6;
  const Drawing d = read_drawing("pstoedit.dxf", options);
  const auto splines = on(d, "0", "SPLINE");
  ASSERT_EQ(splines.size(), 1u);
  // 5 20 moveto 60 30 120 60 195 30 curveto, in points of 1/72 inch.
  const std::vector<Vec2> c{{5, 20}, {60, 30}, {120, 60}, {195, 30}};
  for (const double t : {0.0, 0.25, 0.6, 1.0}) {
    const double s = 1.0 - t;
    const Vec2 x = s * s * s * c[0] + 3 * s * s * t * c[1] + 3 * s * t * t * c[2] + t * t * t * c[3];
    EXPECT_LT(least_distance(splines[0]->points, 0.0254 / 72.0 * x), 2e-6);  // coordinates written with six digits
  }
  EXPECT_EQ(on(d, "0", "LINE").size(), 7u);
}

/// A file of one entity section.
std::string dxf_of(const std::string& entities, const std::string& blocks = "") {
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n" +
         (blocks.empty() ? std::string() : "0\nSECTION\n2\nBLOCKS\n" + blocks + "0\nENDSEC\n") +
         "0\nSECTION\n2\nENTITIES\n" + entities + "0\nENDSEC\n0\nEOF\n";
}

TEST(Drawing, entities_seen_from_below_are_mirrored) {
  const Drawing d = read_dxf(dxf_of("0\nARC\n8\nA\n10\n1\n20\n2\n40\n1\n50\n0\n51\n90\n210\n0\n220\n0\n230\n-1\n"
                                    "0\nCIRCLE\n8\nB\n10\n1\n20\n2\n40\n1\n210\n0\n220\n1\n230\n0\n"),
                             {});
  ASSERT_EQ(d.lines.size(), 2u);
  EXPECT_LT((d.lines[0].points.front() - Vec2(-2, 2)).norm(), 1e-12);
  EXPECT_LT((d.lines[0].points.back() - Vec2(-1, 3)).norm(), 1e-12);
  EXPECT_EQ(d.lines[1].unusable, "it lies in another plane");
}

TEST(Drawing, paper_space_and_frames_of_splines_are_left_out) {
  const std::string vertex = "0\nVERTEX\n8\nA\n10\n{}\n20\n0\n70\n{}\n";
  const Drawing d =
      read_dxf(dxf_of("0\nLINE\n8\nP\n67\n1\n10\n0\n20\n0\n11\n1\n21\n1\n"
                      "0\nPOLYLINE\n8\nP\n67\n1\n66\n1\n0\nVERTEX\n8\nP\n10\n5\n20\n0\n0\nSEQEND\n8\nP\n"
                      "0\nPOLYLINE\n8\nA\n66\n1\n70\n4\n0\nVERTEX\n8\nA\n10\n0\n20\n0\n70\n16\n"
                      "0\nVERTEX\n8\nA\n10\n1\n20\n0\n70\n8\n0\nVERTEX\n8\nA\n10\n2\n20\n0\n70\n8\n0\nSEQEND\n8\nA\n"),
               {});
  ASSERT_EQ(d.lines.size(), 1u);
  EXPECT_EQ(d.lines[0].points, (std::vector<Vec2>{{1, 0}, {2, 0}}));
}

struct Damage {
  const char *text, *problem;
  int row;
};

TEST(Drawing, damage_is_told_with_its_line) {
  const Damage cases[] = {
      {"0\nLINE\n8\nA\n10\n0\n20\nzero\n11\n1\n21\n1\n", "is no number", 22},
      {"0\nLINE\n8\nA\n10\n0\n20\n1e300\n11\n1\n21\n1\n", "out of range", 22},
      {"0\nLINE\n8\nA\n10\nnan\n20\n0\n11\n1\n21\n1\n", "is not finite", 20},
      {"0\nLINE\n8\nA\n10\n0\n20\n0\n", "no group 11", 16},
      {"0\nLWPOLYLINE\n8\nA\n90\n2000000000\n70\n0\n10\n0\n20\n0\n10\n1\n20\n1\n", "2000000000 vertices and has 2", 20},
      {"0\nLWPOLYLINE\n8\nA\n90\n-1\n70\n0\n10\n0\n20\n0\n", "-1 vertices and has 1", 20},
      {"0\nSPLINE\n8\nA\n71\n3\n72\n99999999\n73\n4\n10\n0\n20\n0\n", "knots", 22},
      {"0\nINSERT\n8\nA\n2\nNONE\n10\n0\n20\n0\n", "does not hold", 16},
      {"0\nINSERT\n8\nA\n2\nNONE\n10\n0\n20\n0\n70\n99999\n", "columns or rows", 26},
      {"0\nVERTEX\n8\nA\n10\n0\n20\n0\n", "outside a POLYLINE", 16},
      {"0\nPOLYLINE\n8\nA\n66\n1\n0\nVERTEX\n10\n0\n20\n0\n", "", 0},
      {"0\nSECTION\n", "has no end", 16},
  };
  for (const Damage& c : cases) try {
      (void)read_dxf(dxf_of(c.text), {});
      if (*c.problem != '\0') ADD_FAILURE() << c.text;
    } catch (const DrawingError& e) {
      EXPECT_TRUE(holds(e.what(), c.problem)) << e.what();
      if (c.row > 0) {
        EXPECT_EQ(e.row, c.row) << e.what();
      }
      EXPECT_FALSE(e.hint.empty());
    }
}

TEST(Drawing, blocks_inserted_in_themselves_end) {
  const std::string block =
      "0\nBLOCK\n8\n0\n2\nSELF\n10\n0\n20\n0\n0\nINSERT\n8\n0\n2\nSELF\n10\n1\n20\n0\n0\nENDBLK\n8\n0\n";
  try {
    (void)read_dxf(dxf_of("0\nINSERT\n8\n0\n2\nSELF\n10\n0\n20\n0\n", block), {});
    FAIL();
  } catch (const DrawingError& e) {
    EXPECT_TRUE(holds(e.what(), "too deeply")) << e.what();
  }
  // Nested rows that would give a hundred million pieces.
  const std::string rows = "70\n10000\n71\n10000\n44\n1\n45\n1\n";
  const std::string line =
      "0\nBLOCK\n8\n0\n2\nONE\n10\n0\n20\n0\n0\nLINE\n8\n0\n10\n0\n20\n0\n11\n1\n21\n0\n0\nENDBLK\n8\n0\n";
  EXPECT_THROW((void)read_dxf(dxf_of("0\nINSERT\n8\n0\n2\nONE\n10\n0\n20\n0\n" + rows, line), {}), DrawingError);
}

/// Cuts the text, changes bytes, or replaces counts and coordinates by extreme numbers.
std::string damaged(std::string text, Random& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random.uniform() * static_cast<double>(n)); };
  switch (below(4)) {
    case 0:
      text.resize(below(text.size()));
      break;
    case 1:
      for (std::size_t k = 1 + below(20); k > 0; --k)
        text[below(text.size())] = static_cast<char>(static_cast<int>(random.uniform() * 256.0));
      break;
    case 2: {
      // The value of a group is replaced by an extreme one.
      const char* wild[] = {"-1",  "4294967295", "2147483647", "1e308",     "-9223372036854775808",
                            "nan", "inf",        "",           "0x7fffffff"};
      for (std::size_t k = 1 + below(4); k > 0; --k) {
        const std::size_t from = text.find('\n', below(text.size()));
        if (from == std::string::npos) continue;
        const std::size_t to = text.find('\n', from + 1);
        if (to == std::string::npos) continue;
        text.replace(from + 1, to - from - 1, wild[below(9)]);
      }
      break;
    }
    default: {
      // A piece is duplicated or removed.
      const std::size_t from = below(text.size()), length = below(std::min<std::size_t>(600, text.size() - from));
      const std::string piece = text.substr(from, length);
      if (below(2) == 0)
        text.erase(from, length);
      else
        text.insert(from, piece);
    }
  }
  return text;
}

TEST(Drawing, damaged_files_are_refused_or_read_without_a_crash) {
  Random random(7);
  int refused = 0, total = 0;
  for (const char* name :
       {"section-r12.dxf", "section-r2000.dxf", "section-r2018.dxf", "potrace.dxf", "pstoedit.dxf"}) {
    const std::string whole = bytes_of(kDrawings + name);
    for (int k = 0; k < 60; ++k, ++total) {
      DrawingOptions options;
      options.unit = 1.0;
      try {
        for (const DrawnLine& l : read_dxf(damaged(whole, random), options).lines)
          for (const Vec2& x : l.points) ASSERT_TRUE(x.allFinite());
      } catch (const DrawingError& e) {
        ++refused;
        EXPECT_NE(std::string(e.what()), "");
        EXPECT_FALSE(e.hint.empty()) << e.what();
        EXPECT_TRUE(e.row > 0 || holds(e.what(), "empty")) << e.what();
      }
    }
  }
  EXPECT_EQ(total, 300);
  EXPECT_GT(refused, 100);  // a cut or an extreme number usually gives an error
}

}  // namespace
}  // namespace scree::io::test::drawing_test
