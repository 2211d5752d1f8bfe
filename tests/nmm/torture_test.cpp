// Blocks, cracks and holes in adverse positions: through stars, along mesh lines, crossing, touching, at random.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "tests/support/nmm_block.h"

namespace scree::test::torture_test {
namespace {

const Material kRock{"rock", 2000.0, 1e9, 0.25};
const double kRow = std::sqrt(3.0) / 2.0;

Crack crack(const Vec2& from, const Vec2& to) { return {from, to, JointId{}, BlockId{0}}; }
Polygon box(double x0, double y0, double x1, double y1) { return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}}; }
Polygon scaled(Polygon p, double s) {
  for (std::size_t r = 0; r < p.rings(); ++r)
    for (Vec2& x : p.ring(r)) x *= s;
  return p;
}

/// Areas of the block's connected parts, smallest first.
std::vector<double> part_areas(const NmmBlock& b) {
  std::vector<double> area(static_cast<std::size_t>(b.mesh().components), 0.0);
  for (std::size_t e = 0; e < b.mesh().elements(); ++e)
    area[static_cast<std::size_t>(b.mesh().component[static_cast<std::size_t>(b.mesh().cover[e][0])])] +=
        b.mesh().area[e];
  std::sort(area.begin(), area.end());
  return area;
}

/// What holds for every discretised block, however it is cut: areas, masses, momenta, no force in rigid motion and in
/// none of its parts, the patch test, a certified step that is positive.
void expect_sound(const NmmBlock& b, const std::string& what) {
  SCOPED_TRACE(what);
  const nmm::CoverMesh& mesh = b.mesh();
  const Moments whole = moments(b.model.blocks[0].polygon);
  double area = 0.0;
  for (std::size_t e = 0; e < mesh.elements(); ++e) {
    area += mesh.area[e];
    ASSERT_GT(mesh.area[e], 0.0);
    for (const std::int32_t c : mesh.cover[e])
      ASSERT_EQ(mesh.component[static_cast<std::size_t>(c)],
                mesh.component[static_cast<std::size_t>(mesh.cover[e][0])]);
  }
  const Box extent = bounds(b.model.blocks[0].polygon);
  EXPECT_NEAR(area, whole.area, 1e-11 * whole.area + 1e-15 * (extent.hi - extent.lo).squaredNorm());
  const auto n = static_cast<std::size_t>(b.pool.first_node(1));
  for (std::size_t c = 0; c < n; ++c)
    if (!b.pool.chart().tied(static_cast<std::int32_t>(c))) {
      ASSERT_GT(b.pool.compliance(0, Row{{static_cast<std::int32_t>(c), 0, 0}, {1.0, 0.0, 0.0}}), 0.0);
    }
  EXPECT_TRUE(std::isfinite(b.pool.frequency_bound(0)) && b.pool.frequency_bound(0) > 0.0);
  EXPECT_TRUE(std::isfinite(b.pool.mass_ratio(0)) && b.pool.mass_ratio(0) > 0.0) << b.pool.mass_ratio(0);

  // Mass of each part, by the force of a uniform acceleration.
  std::vector<double> weight(2 * n, 0.0);
  b.pool.body_force({1.0, 0.0}, weight);
  std::vector<double> mass(static_cast<std::size_t>(mesh.components), 0.0), wanted = mass;
  for (std::size_t c = 0; c < n; ++c) mass[static_cast<std::size_t>(mesh.component[c])] += weight[2 * c];
  for (std::size_t e = 0; e < mesh.elements(); ++e)
    wanted[static_cast<std::size_t>(mesh.component[static_cast<std::size_t>(mesh.cover[e][0])])] +=
        kRock.density * mesh.area[e];
  for (std::size_t p = 0; p < mass.size(); ++p) EXPECT_NEAR(mass[p], wanted[p], 1e-9 * wanted[p]) << "part " << p;

  // An affine motion of the whole block has exact momenta and a uniform stress; interior covers have no force.
  AffineMotion m;
  m.c = whole.centroid;
  m.F << 1.001, 2e-4, -3e-4, 0.9995;
  const double size = std::sqrt(whole.area);
  m.vc = {0.3, -0.2};
  m.Fdot << 0.1, -0.7, 0.9, 0.2;
  m.Fdot /= size;
  std::vector<double> q(2 * n), v(2 * n), f(2 * n, 0.0), a(2 * n);
  b.pool.place(0, m, q, v);
  const BodyTotals t = b.pool.totals(0, q, v);
  EXPECT_NEAR(t.mass, b.shape.mass, 1e-10 * b.shape.mass);
  EXPECT_LT((t.centre - whole.centroid).norm(), 1e-9 * size);
  EXPECT_LT((t.momentum - b.shape.mass * m.vc).norm(), 1e-9 * b.shape.mass);
  if (b.pool.mesh(0).components == 1) {  // lumped masses apart: here they are affine-exact
    const double kinetic =
        0.5 * b.shape.mass * m.vc.squaredNorm() + 0.5 * (m.Fdot * b.shape.second * m.Fdot.transpose()).trace();
    EXPECT_NEAR(t.kinetic, kinetic, 1e-8 * kinetic);
  }
  std::vector<double> cells(3 * std::max<std::size_t>(1, mesh.elements()));
  MeshPart drawn;
  b.pool.topology(drawn);
  cells.assign(3 * drawn.body.size(), 0.0);
  b.pool.stress(q, cells);
  double spread = 0.0, largest = 0.0;
  for (std::size_t e = 0; e < drawn.body.size(); ++e)
    for (std::size_t d = 0; d < 3; ++d) {
      ASSERT_TRUE(std::isfinite(cells[3 * e + d]));
      spread = std::max(spread, std::abs(cells[3 * e + d] - cells[d]));
      largest = std::max(largest, std::abs(cells[d]));
    }
  EXPECT_LT(spread, 1e-7 * largest);
  const double energy = b.pool.internal_force(q, f);
  EXPECT_TRUE(std::isfinite(energy) && energy > 0.0);
  b.pool.mass_solve(q, f, a);
  double total = 0.0;
  std::vector<Vec2> sum(static_cast<std::size_t>(mesh.components), Vec2::Zero());
  for (std::size_t c = 0; c < n; ++c) {
    ASSERT_TRUE(std::isfinite(a[2 * c]) && std::isfinite(a[2 * c + 1])) << "cover " << c;
    sum[static_cast<std::size_t>(mesh.component[c])] += Vec2(f[2 * c], f[2 * c + 1]);
    total += std::abs(f[2 * c]) + std::abs(f[2 * c + 1]);
  }
  for (const Vec2& s : sum) EXPECT_LT(s.norm(), 1e-9 * total);

  // Patch test: tractions of this stress on outline and crack faces balance the internal force; without cracks the
  // outline alone carries them.
  if (b.model.cracks.empty()) {
    Mat2 P;
    const ElasticResponse r = elastic_response(b.law(), m.F, Mat2::Zero());
    P = r.P;
    std::vector<double> load(2 * n, 0.0);
    b.add_traction([&](const Vec2&, const Vec2& normal) -> Vec2 { return P * normal; }, load);
    const Eigen::VectorXd inner = b.folded(f), outer = b.folded(load);
    EXPECT_LT((inner + outer).lpNorm<Eigen::Infinity>(), 1e-8 * outer.lpNorm<Eigen::Infinity>());
  }
  // The outline goes once around and its weights are those of points.
  for (const Row& row : b.pool.boundary(0).nodes) {
    ASSERT_NEAR(row.w[0] + row.w[1] + row.w[2], 1.0, 1e-9);
  }
  // A constant stress is recovered exactly.
  std::vector<double> nodes(3 * n);
  b.pool.recovered_stress(q, std::vector<char>(n, 1), nodes);
  for (std::size_t c = 0; c < n; ++c)
    for (std::size_t d = 0; d < 3; ++d) ASSERT_NEAR(nodes[3 * c + d], cells[d], 1e-5 * largest) << "cover " << c;
}

NmmBlock make(const Polygon& p, double h, const std::vector<Crack>& cracks = {}, double ox = 0.317, double oy = 0.271) {
  Formulation form{.cover_size = h};
  form.cracks = !cracks.empty();
  form.offset_x = ox;
  form.offset_y = oy;
  return {p, form, kRock, Plane::strain, cracks};
}

/// A star of the lattice of a block centred at the origin.
Vec2 star(double h, int i, int j, double ox = 0.317, double oy = 0.271) {
  return h * Vec2(i + 0.5 * j - ox, kRow * j - oy);
}

TEST(Torture, crack_through_stars_and_along_mesh_lines) {
  const Polygon square = box(-1, -1, 1, 1);
  const double h = 0.2;
  // Through a star at a slope that is no mesh line, right through the block.
  for (const auto& [i, j] : {std::pair(0, 0), std::pair(1, 2), std::pair(-2, 1)})
    for (const double angle : {0.0, 17.0, 30.0, 60.0, 90.0, 120.0, 150.0}) {
      const Vec2 s = star(h, i, j),
                 d(std::cos(angle * std::numbers::pi / 180.0), std::sin(angle * std::numbers::pi / 180.0));
      const NmmBlock b = make(square, h, {crack(s - 4.0 * d, s + 4.0 * d)});
      expect_sound(b, "star " + std::to_string(i) + "," + std::to_string(j) + " angle " + std::to_string(angle));
      EXPECT_EQ(b.mesh().components, 2) << i << " " << j << " " << angle;
      double length = 0.0;  // of the chord
      double t0 = -10.0, t1 = 10.0;
      for (int k = 0; k < 2; ++k)
        if (std::abs(d[k]) > 1e-12) {
          const double lo = (-1.0 - s[k]) / d[k], hi = (1.0 - s[k]) / d[k];
          t0 = std::max(t0, std::min(lo, hi));
          t1 = std::min(t1, std::max(lo, hi));
        }
      length = t1 - t0;
      EXPECT_NEAR(part_areas(b)[0] + part_areas(b)[1], 4.0, 1e-11);
      EXPECT_GT(length, 0.0);
    }
  // Between two stars inside the block, along mesh lines and across them.
  for (const auto& [i, j] : {std::pair(3, 0), std::pair(0, 3), std::pair(-3, 3), std::pair(1, 2)}) {
    const NmmBlock b = make(square, h, {crack(star(h, 0, 0), star(h, i, j))});
    expect_sound(b, "from star to star");
    EXPECT_EQ(b.mesh().components, 1);
    EXPECT_GT(b.mesh().star.size(), make(square, h).mesh().star.size()) << "stars on the crack have two covers";
  }
}

TEST(Torture, crossing_and_touching_cracks) {
  const Polygon square = box(-1, -1, 1, 1);
  for (const double h : {0.11, 0.2, 0.5, 1.3}) {
    const auto name = [&](const char* what) { return std::string(what) + " h " + std::to_string(h); };
    NmmBlock x = make(square, h, {crack({-1, -0.2}, {1, 0.3}), crack({-0.3, -1}, {0.2, 1})});
    expect_sound(x, name("X"));
    EXPECT_EQ(x.mesh().components, 4) << h;
    const Vec2 star0 = star(h, 0, 0);
    NmmBlock xs = make(
        square, h, {crack(star0 - Vec2(4, 1), star0 + Vec2(4, 1)), crack(star0 - Vec2(-1, 4), star0 + Vec2(-1, 4))});
    expect_sound(xs, name("X on a star"));
    EXPECT_EQ(xs.mesh().components, 4) << h;
    NmmBlock t = make(square, h, {crack({-1, -0.2}, {1, 0.3}), crack({0.0, 0.05}, {0.1, 1})});
    expect_sound(t, name("T"));
    EXPECT_EQ(t.mesh().components, 3) << h;
    NmmBlock corner = make(square, h, {crack({-1, -1}, {1, 1})});
    expect_sound(corner, name("from corner to corner"));
    EXPECT_EQ(corner.mesh().components, 2) << h;
    NmmBlock corner_half = make(square, h, {crack({-1, -1}, {0.3, 0.1})});
    expect_sound(corner_half, name("from a corner"));
    EXPECT_EQ(corner_half.mesh().components, 1) << h;
    NmmBlock close = make(square, h, {crack({-1, 0.0}, {1, 0.0}), crack({-1, 0.1 * h}, {1, 0.1 * h})});
    expect_sound(close, name("two parallel ones closer than a mesh size"));
    EXPECT_EQ(close.mesh().components, 3) << h;
    EXPECT_NEAR(part_areas(close)[0], 2.0 * 0.1 * h, 1e-10) << h;
    NmmBlock twice =
        make(square, h, {crack({-1, 0.1}, {1, 0.2}), crack({-1, 0.1}, {1, 0.2}), crack({1, 0.2}, {-1, 0.1})});
    expect_sound(twice, name("thrice the same"));
    EXPECT_EQ(twice.mesh().components, 2) << h;
    NmmBlock edge = make(square, h, {crack({-1, -1}, {1, -1})});
    expect_sound(edge, name("along the outline"));
    EXPECT_EQ(edge.mesh().components, 1) << h;
    Polygon holed = square;
    holed.holes.push_back({{0.3, 0.3}, {0.3, -0.3}, {-0.3, -0.3}, {-0.3, 0.3}});
    NmmBlock hole = make(holed, h, {crack({-1, 0.0}, {-0.3, 0.0}), crack({0.3, 0.1}, {1, 0.1})});
    expect_sound(hole, name("on a hole"));
    EXPECT_EQ(hole.mesh().components, 2) << h;
    NmmBlock one = make(holed, h, {crack({-1, 0.0}, {-0.3, 0.0})});
    expect_sound(one, name("one on a hole"));
    EXPECT_EQ(one.mesh().components, 1) << h;
    NmmBlock at_corner = make(holed, h, {crack({-1, -1}, {-0.3, -0.3}), crack({0.3, 0.3}, {1, 1})});
    expect_sound(at_corner, name("corners of outline and hole"));
    EXPECT_EQ(at_corner.mesh().components, 2) << h;
  }
}

TEST(Torture, random_cracks_fall_apart_as_geos_polygonises_them) {
  std::mt19937 random(7);
  const auto uniform = [&](double a, double b) { return a + (b - a) * (static_cast<double>(random()) / 4294967296.0); };
  int trouble = 0;
  for (int trial = 0; trial < 12; ++trial) {
    const double h = uniform(0.08, 0.6);
    std::vector<Crack> cracks;
    std::vector<CutLine> lines;
    // Only through cracks must cut as in GEOS at any mesh; crack ends inside are trimmed by less than a mesh size.
    for (int k = 0; k < (trial < 6 ? 50 : 12); ++k) {
      Vec2 a(uniform(-1, 1), uniform(-1, 1)), b(uniform(-1, 1), uniform(-1, 1));
      if (trial >= 6) {
        const Vec2 d = (b - a).normalized();
        a -= 4.0 * d;
        b += 4.0 * d;
      }
      cracks.push_back(crack(a, b));
      lines.push_back({a, b});
    }
    try {
      const NmmBlock b = make(box(-1, -1, 1, 1), h, cracks);
      expect_sound(b, "trial " + std::to_string(trial) + " h " + std::to_string(h));
      const std::vector<Polygon> faces = cut_by_lines(box(-1, -1, 1, 1), lines);
      if (trial >= 6) {
        std::vector<double> wanted;
        wanted.reserve(faces.size());
        for (const Polygon& f : faces) wanted.push_back(moments(f).area);
        std::sort(wanted.begin(), wanted.end());
        const std::vector<double> found = part_areas(b);
        ASSERT_EQ(found.size(), wanted.size()) << trial;
        for (std::size_t i = 0; i < wanted.size(); ++i) EXPECT_NEAR(found[i], wanted[i], 1e-9);
      } else {
        EXPECT_LE(static_cast<std::size_t>(b.mesh().components), faces.size()) << trial;
      }
    } catch (const std::runtime_error& e) {
      ++trouble;
      ADD_FAILURE() << "trial " << trial << " h " << h << ": " << e.what();
    }
  }
  EXPECT_EQ(trouble, 0);
}

TEST(Torture, blocks_that_fit_the_lattice_exactly) {
  const double h = 0.25;
  // A parallelogram of mesh lines around the centre of mass; with offset 0 its centre is at a star.
  const Vec2 u(4.0 * h, 0.0), w(2.0 * h, 4.0 * kRow * h);
  const Ring ring{-0.5 * u - 0.5 * w, 0.5 * u - 0.5 * w, 0.5 * u + 0.5 * w, -0.5 * u + 0.5 * w};
  const NmmBlock aligned = make({ring, {}}, h, {}, 0.0, 0.0);
  expect_sound(aligned, "aligned");
  EXPECT_EQ(aligned.mesh().elements(), 32U);
  EXPECT_EQ(aligned.mesh().star.size(), 25U);
  Polygon holed{
      ring,
      {{{-h, 0.0}, {-0.5 * h, kRow * h}, {0.5 * h, kRow * h}, {h, 0.0}, {0.5 * h, -kRow * h}, {-0.5 * h, -kRow * h}}}};
  const NmmBlock hole = make(holed, h, {}, 0.0, 0.0);
  expect_sound(hole, "hole of mesh lines");
  EXPECT_EQ(hole.mesh().elements(), 26U);
  const NmmBlock split = make({ring, {}}, h, {crack(-2.0 * u, 2.0 * u)}, 0.0, 0.0);
  expect_sound(split, "split along a row of stars");
  EXPECT_EQ(split.mesh().components, 2);
  EXPECT_EQ(split.mesh().star.size(), 30U);
  // A hole that touches mesh lines at its corners only.
  for (const double s : {0.5, 1.0, 1.5}) {
    Polygon p = box(-1, -1, 1, 1);
    const Vec2 c = star(h, 1, 1);
    p.holes.push_back({c + s * h * Vec2(1, 0), c + s * h * Vec2(0.5, -kRow), c + s * h * Vec2(-0.5, -kRow),
                       c - s * h * Vec2(1, 0), c + s * h * Vec2(-0.5, kRow), c + s * h * Vec2(0.5, kRow)});
    expect_sound(make(p, h), "hexagonal hole");
  }
}

TEST(Torture, sizes_from_a_millimetre_to_ten_kilometres_and_slender_shapes) {
  Polygon shape{{{-0.8, -0.5}, {0.9, -0.6}, {0.7, 0.8}, {-0.6, 0.9}}, {{{0.1, 0.1}, {0.1, -0.2}, {-0.2, -0.2}}}};
  for (const double s : {1e-3, 1.0, 1e4})
    for (const double h : {0.1, 0.4, 1.0, 5.0, 1e3}) {
      expect_sound(make(scaled(shape, s), h * s), "size " + std::to_string(s) + " h/size " + std::to_string(h));
      std::vector<Crack> cracks{crack(s * Vec2(-1, -0.4), s * Vec2(1, -0.35)),
                                crack(s * Vec2(-0.1, 0.5), s * Vec2(0.4, 0.6))};
      expect_sound(make(scaled(shape, s), h * s, cracks),
                   "cracked, size " + std::to_string(s) + " h/size " + std::to_string(h));
    }
  for (const double flat : {1e-1, 1e-3, 1e-6})
    for (const double h : {0.05, 0.5, 3.0}) {
      expect_sound(make({{{0, 0}, {1, 0}, {0.4, flat}}, {}}, h),
                   "flat " + std::to_string(flat) + " h " + std::to_string(h));
      const Mat2 R = (Mat2() << 0.5, -kRow, kRow, 0.5).finished();  // along the lattice's other lines
      expect_sound(make({{R * Vec2(0, 0), R * Vec2(1, 0), R * Vec2(0.4, flat)}, {}}, h), "flat, turned");
    }
}

TEST(Torture, blocks_far_from_the_origin_are_cut_alike) {
  for (const Vec2& at : {Vec2(0, 0), Vec2(3e5, -2e6)}) {
    const Polygon p = box(at.x(), at.y(), at.x() + 2.0, at.y() + 2.0);
    const NmmBlock b =
        make(p, 0.2, {crack(at + Vec2(0, 0.7), at + Vec2(2, 1.1)), crack(at + Vec2(1, 0), at + Vec2(1, 2))});
    EXPECT_EQ(b.mesh().components, 4) << at.x();
    EXPECT_NEAR(part_areas(b)[0] + part_areas(b)[3], 2.0, 1e-6);
  }
}

}  // namespace
}  // namespace scree::test::torture_test
