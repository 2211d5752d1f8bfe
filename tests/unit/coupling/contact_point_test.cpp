// Rows of gap and stretch against finite differences of their definitions; resultants of a force along these rows.
#include "coupling/contact/table/contact_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace scree::coupling::contact_point_test {
namespace {

struct Drawn {
  Vec2 corner, first, second;
  double anchor = 0.0;
};

Drawn draw(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const auto point = [&] { return Vec2(unit(random), unit(random)); };
  Drawn d{point(), point(), point(), unit(random)};
  while ((d.second - d.first).norm() < 0.05) d.second = point();
  return d;
}

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

TEST(ContactPoint, rows_are_the_gradients_of_gap_and_stretch_at_random_places) {
  std::mt19937_64 random(21);
  for (int i = 0; i < 10000; ++i) {
    const Drawn d = draw(random);
    const ContactGeometry at = contact_geometry(d.corner, d.first, d.second);
    const ContactRow gap = gap_row(at), stretch = stretch_row(at, d.anchor);
    // Elongation of a spring from the anchor, a point of the segment.
    const auto elongation = [&](const std::array<Vec2, 3>& x) {
      const ContactGeometry g = contact_geometry(x[0], x[1], x[2]);
      return g.t.dot(x[0] - ((1.0 - d.anchor) * x[1] + d.anchor * x[2]));
    };
    constexpr double h = 1e-6;
    for (std::size_t k = 0; k < 3; ++k)
      for (int axis = 0; axis < 2; ++axis) {
        std::array<Vec2, 3> more{d.corner, d.first, d.second}, less = more;
        more[k][axis] += h;
        less[k][axis] -= h;
        const double by_gap =
            (contact_geometry(more[0], more[1], more[2]).gap - contact_geometry(less[0], less[1], less[2]).gap) /
            (2.0 * h);
        // Second derivatives scale with the offset over the square of the length.
        const double bound = 1e-7 * (1.0 + 1.0 / (at.length * at.length));
        EXPECT_NEAR(gap[k][axis], by_gap, bound) << i;
        EXPECT_NEAR(stretch[k][axis], (elongation(more) - elongation(less)) / (2.0 * h), bound) << i;
      }
  }
}

TEST(ContactPoint, forces_along_rows_add_to_zero_and_make_no_torque) {
  std::mt19937_64 random(22);
  for (int i = 0; i < 10000; ++i) {
    const Drawn d = draw(random);
    const ContactGeometry at = contact_geometry(d.corner, d.first, d.second);
    for (const ContactRow& row : {gap_row(at), stretch_row(at, d.anchor)}) {
      const Vec2 sum = row[0] + row[1] + row[2];
      const double torque = cross(d.corner, row[0]) + cross(d.first, row[1]) + cross(d.second, row[2]);
      const double scale = 1.0 + std::abs(at.gap) / at.length + std::abs(at.xi);
      EXPECT_LE(sum.norm(), 1e-14 * scale);
      EXPECT_LE(std::abs(torque), 1e-14 * scale);
    }
  }
}

TEST(ContactPoint, geometry_is_that_of_the_segment) {
  std::mt19937_64 random(23);
  for (int i = 0; i < 10000; ++i) {
    const Drawn d = draw(random);
    const ContactGeometry at = contact_geometry(d.corner, d.first, d.second);
    EXPECT_NEAR(cross(at.n, at.t), 1.0, 1e-15);  // the normal is to the right of the direction
    const Vec2 back = d.first + at.xi * at.length * at.t + at.gap * at.n;
    EXPECT_LE((back - d.corner).norm(), 1e-14);
  }
}

TEST(ContactPoint, corner_leaves_by_the_nearer_edge_and_ties_are_the_edge_that_ends_there) {
  EXPECT_TRUE(leaves_by(1.0, 2.0, false));
  EXPECT_FALSE(leaves_by(2.0, 1.0, true));
  for (const double other : {1.0, 1.0 + 1e-9, 1.0 - 1e-9}) {
    EXPECT_TRUE(leaves_by(1.0, other, true));
    EXPECT_FALSE(leaves_by(1.0, other, false));
  }
}

}  // namespace
}  // namespace scree::coupling::contact_point_test
