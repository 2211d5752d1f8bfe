// Blocks with cracks: several physical covers per star, separation into parts, opening of a crack against Westergaard.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "tests/support/nmm_block.h"
#include "tests/support/order_table.h"

namespace scree::test::cracks_test {
namespace {

const Material kRock{"rock", 2000.0, 1e9, 0.25};
const Polygon kSquare{{{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}, {}};

Crack crack(const Vec2& from, const Vec2& to) { return {from, to, JointId{}, BlockId{0}}; }

NmmBlock cracked(double h, const std::vector<Crack>& cracks, const Polygon& polygon = kSquare) {
  Formulation form{.cover_size = h};
  form.cracks = true;
  return {polygon, form, kRock, Plane::strain, cracks};
}

TEST(Cracks, stars_on_a_crack_have_two_covers_and_the_area_stays) {
  const NmmBlock whole = cracked(0.2, {}), cut = cracked(0.2, {crack({-0.5, 0.1}, {0.5, 0.25})});
  EXPECT_EQ(cut.mesh().components, 1);
  EXPECT_GT(cut.mesh().star.size(), whole.mesh().star.size() + 3);
  double area = 0.0;
  for (const double a : cut.mesh().area) area += a;
  EXPECT_NEAR(area, 4.0, 1e-13);
  // Only the crack ends within triangles do not cut: less than a triangle's height at each tip.
  const double length = std::hypot(1.0, 0.15);
  EXPECT_NEAR(cut.mesh().crack_length + cut.mesh().trimmed_length, length, 1e-12);
  EXPECT_GT(cut.mesh().trimmed_length, 0.0);
  EXPECT_LT(cut.mesh().trimmed_length, 2 * 0.2);
}

TEST(Cracks, crack_within_a_triangle_cuts_nothing) {
  const NmmBlock cut = cracked(0.5, {crack({0.0, 0.0}, {0.01, 0.02})});
  EXPECT_EQ(cut.mesh().crack_length, 0.0);
  EXPECT_NEAR(cut.mesh().trimmed_length, std::hypot(0.01, 0.02), 1e-15);
}

TEST(Cracks, along_mesh_lines_cut_too) {
  // A horizontal crack on a row of stars: rows lie at -0.271 h + k sqrt(3)/2 h about the centre.
  const double h = 0.2, y = h * (2.0 * std::sqrt(3.0) / 2.0 - 0.271);
  const NmmBlock cut = cracked(h, {crack({-1.2, y}, {1.2, y})});
  EXPECT_EQ(cut.mesh().components, 2);
}

/// Cracks right through the block: a force on one part moves it as a free body; the other parts stay the same, bit for
/// bit.
TEST(Cracks, block_cut_through_falls_apart_without_ties) {
  for (const double h : {0.15, 0.4, 0.9}) {
    const NmmBlock block = cracked(h, {crack({-1.0, -0.3}, {1.0, 0.2}), crack({0.1, 1.0}, {0.15, -0.2})});
    ASSERT_EQ(block.mesh().components, 3) << h;
    const auto part_of = [&](std::size_t c) { return block.mesh().component[c]; };
    for (std::int32_t part = 0; part < 3; ++part) {
      std::vector<double> q = block.q, f(q.size(), 0.0), a(q.size()), still(q.size());
      block.pool.internal_force(q, f);  // round-off of bodies at rest
      block.pool.mass_solve(q, f, still);
      std::fill(f.begin(), f.end(), 0.0);
      for (std::size_t c = 0; c < block.mesh().star.size(); ++c)
        if (part_of(c) == part) {
          q[2 * c] += 0.01 * std::sin(3.0 * block.mesh().star[c].x());
          q[2 * c + 1] += 0.3;
        }
      block.pool.internal_force(q, f);
      block.pool.mass_solve(q, f, a);
      double moved = 0.0;
      for (std::size_t c = 0; c < block.mesh().star.size(); ++c) {
        if (part_of(c) == part) {
          moved = std::max(moved, std::abs(a[2 * c]));
        } else {
          ASSERT_EQ(a[2 * c], still[2 * c]) << "cover " << c;
          ASSERT_EQ(a[2 * c + 1], still[2 * c + 1]);
        }
      }
      EXPECT_GT(moved, 1.0);
      // Internal forces give the part no momentum.
      Vec2 sum = Vec2::Zero();
      double size = 0.0;
      for (std::size_t c = 0; c < block.mesh().star.size(); ++c) {
        sum += Vec2(f[2 * c], f[2 * c + 1]);
        size += std::abs(f[2 * c]);
      }
      EXPECT_LT(sum.norm(), 1e-12 * size);
    }
    // Each part has its own exact mass and inertia: a spin of one part alone.
    double mass = 0.0, area[3] = {0.0, 0.0, 0.0};
    std::vector<double> weight(block.q.size(), 0.0);
    block.pool.body_force({1.0, 0.0}, weight);
    for (std::size_t e = 0; e < block.mesh().elements(); ++e)
      area[part_of(static_cast<std::size_t>(block.mesh().cover[e][0]))] += block.mesh().area[e];
    for (std::int32_t part = 0; part < 3; ++part) {
      double m = 0.0;
      for (std::size_t c = 0; c < block.mesh().star.size(); ++c)
        if (part_of(c) == part) m += weight[2 * c];
      EXPECT_NEAR(m, kRock.density * area[part], 1e-10 * m);
      mass += m;
    }
    EXPECT_NEAR(mass, block.shape.mass, 1e-12 * mass);
  }
}

/// A crack of length 2a in an infinite plate under tension s across it, plane strain [Westergaard1939]:
///   Z = s z/sqrt(z^2 - a^2),  sxx = Re Z - y Im Z' - s,  syy = Re Z + y Im Z',  sxy = -y Re Z',
/// where the -s leaves tension in y alone. Opening 4 s sqrt(a^2 - x^2)/E', E' = E/(1 - nu^2).
struct Westergaard {
  double a, s;
  [[nodiscard]] Mat2 stress(const Vec2& x) const {
    const std::complex<double> z(x.x(), x.y()), root = std::sqrt(z - a) * std::sqrt(z + a);
    const std::complex<double> Z = s * z / root, dZ = -s * a * a / (root * root * root);
    const double y = x.y();
    return (Mat2() << Z.real() - y * dZ.imag() - s, -y * dZ.real(), -y * dZ.real(), Z.real() + y * dZ.imag())
        .finished();
  }
};

TEST(Cracks, centre_crack_opens_as_westergaard_has_it) {
  // The outline of the square carries the tractions of the infinite plate, so that its size has no influence.
  const double a = 0.5, s = 1e3, half = 0.7;
  const Polygon square{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}, {}};
  const Westergaard exact{a, s};
  const double plate = kRock.young / (1.0 - kRock.poisson * kRock.poisson);
  OrderRow row{"centre crack: opening at its middle, over cover size", {}, {}, 0.6};
  for (const double n : {12.0, 24.0, 48.0, 96.0}) {
    const double h = a / n;
    const NmmBlock block = cracked(h, {crack({-a, 0.0}, {a, 0.0})}, square);
    std::vector<double> f(block.q.size(), 0.0);
    block.add_traction([&](const Vec2& x, const Vec2& normal) -> Vec2 { return exact.stress(x) * normal; }, f);
    const std::vector<double> u = block.spread(solve_free(block, block.folded(f)));
    // Opening: jump of the displacement across the crack, at points along it.
    double worst = 0.0, middle = 0.0;
    for (const double x : {0.0, 0.25 * a, 0.5 * a, 0.75 * a}) {
      double jump = 0.0;
      for (const double side : {1.0, -1.0}) {
        const Vec2 X = Vec2(x, side * 1e-7) - block.centre();
        const auto e = static_cast<std::size_t>(block.mesh().locate(X));
        const auto w = block.mesh().weights(e, X);
        for (std::size_t k = 0; k < 3; ++k)
          jump += side * w[k] * u[2 * static_cast<std::size_t>(block.mesh().cover[e][k]) + 1];
      }
      const double wanted = 4.0 * s / plate * std::sqrt(a * a - x * x), error = std::abs(jump - wanted) / wanted;
      worst = std::max(worst, error);
      if (x == 0.0) middle = error;
    }
    row.size.push_back(h);
    row.error.push_back(middle);
    std::printf("a/h = %2.0f: error of the opening %.2f %% at the middle, %.2f %% at worst over |x| <= 0.75 a\n", n,
                100.0 * middle, 100.0 * worst);
    if (n == 96.0) {
      EXPECT_LT(worst, 0.03);
    }
  }
  expect_order(row);
}

}  // namespace
}  // namespace scree::test::cracks_test
