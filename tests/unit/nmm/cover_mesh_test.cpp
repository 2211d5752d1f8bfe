// Cover meshes of blocks: area, slots, and the certified step of narrow blocks.
#include "nmm/cover_mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/unit/nmm/one_block.h"

namespace scree::nmm::cover_mesh_test {
namespace {

TEST(CoverMesh, elements_fill_the_block) {
  for (double h : {0.7, 0.33, 0.17}) {
    const ReferenceShape s = test::shape_of(quadrilateral(), 1.0);
    const CoverMesh mesh = make_cover_mesh(s.outline, h);
    double area = 0.0;
    for (const double a : mesh.area) area += a;
    EXPECT_NEAR(area, s.area, 1e-13 * s.area);
  }
}

TEST(CoverMesh, slot_separates_its_two_sides) {
  // A U-shaped block: the distance of its arms is less than a cover, so stars there must be doubled.
  const Polygon u{{{0, 0}, {3, 0}, {3, 3}, {1.6, 3}, {1.6, 1}, {1.4, 1}, {1.4, 3}, {0, 3}}, {}};
  const CoverMesh mesh = make_cover_mesh(test::shape_of(u, 1.0).outline, 0.5);
  int doubled = 0;
  for (std::size_t i = 0; i < mesh.star.size(); ++i)
    for (std::size_t j = i + 1; j < mesh.star.size(); ++j)
      doubled += (mesh.star[i] - mesh.star[j]).norm() < 1e-9 ? 1 : 0;
  EXPECT_GE(doubled, 3);
  for (const Tie& t : mesh.ties)
    for (std::size_t e = 0; e < mesh.elements(); ++e)
      if (mesh.cover[e] == t.root) {  // a tie never reaches across the slot
        const double side = mesh.centroid(e).x() + moments(u).centroid.x();
        for (std::size_t own = 0; own < mesh.elements(); ++own)
          for (const std::int32_t c : mesh.cover[own])
            if (c == t.cover && mesh.centroid(own).y() + moments(u).centroid.y() > 1.5) {
              EXPECT_EQ(side > 1.5, mesh.centroid(own).x() + moments(u).centroid.x() > 1.5);
            }
      }
}

TEST(CoverMesh, narrow_blocks_keep_a_quarter_of_the_step_or_take_a_onefold_cover) {
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> u(0.0, 1.0);
  int onefold = 0;
  for (int k = 0; k < 300; ++k) {
    const double width = 0.2 + 1.3 * u(generator), length = width + 6.0 * u(generator);
    const Polygon bar{{{0, 0}, {length, 0}, {length, width}, {0, width}}, {}};
    One one(transformed(bar, {0.0, 0.0}, rotation(7.0 * u(generator))), 1.0);
    onefold += one.pool.mesh(0).onefold ? 1 : 0;
    const double uncut = 0.866 / std::sqrt(one.model.elasticity_of(BlockId{0}).p_modulus() / 2.0);
    const double own = std::min(1.0, width);  // the stiffness of a onefold cover follows from the size of its block
    EXPECT_GE(2.0 / std::sqrt(one.pool.mass_ratio(0) * one.pool.frequency_bound(0)),
              (one.pool.mesh(0).onefold ? 0.25 * own : 0.25) * uncut)
        << width << " x " << length;
  }
  EXPECT_GT(onefold, 10);
  EXPECT_LT(onefold, 290);
}

}  // namespace
}  // namespace scree::nmm::cover_mesh_test
