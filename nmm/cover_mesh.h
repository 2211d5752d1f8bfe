// Covers and manifold elements of one block (thesis 3.2, 6.2.1), in its reference shape.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "model/pool.h"

namespace scree::nmm {

/// One connected piece of block and mesh triangle, with the triangle's three covers.
struct Element {
  std::array<std::int32_t, 3> cover{};
  std::array<Vec2, 3> star{};  // reference positions of the covers [m]
  Polygon piece;               // the material [m]
  double area = 0.0;           // [m2]
  Vec2 centroid{0.0, 0.0};
  double fraction = 0.0;  // area over the triangle's area

  /// Gradients of the three weights, one a column [1/m].
  [[nodiscard]] Eigen::Matrix<double, 2, 3> gradients() const;
  /// Barycentric weights of a point in the reference triangle (any point: weights may be negative).
  [[nodiscard]] std::array<double, 3> weights(const Vec2& X) const;
};

/// A cover without an element of at least half its triangle follows three others by barycentric extrapolation.
/// @source nmm.md "Small cuts"; aggregated finite elements: Badia, Verdugo, Martin 2018
struct Tie {
  std::int32_t cover;
  std::array<std::int32_t, 3> root;
  std::array<double, 3> w;
};

struct CoverMesh {
  std::vector<Vec2> star;  // reference position of each physical cover [m]
  std::vector<Element> elements;
  std::vector<Tie> ties;  // by cover; roots are never tied
  Boundary boundary;      // outline, split where it crosses mesh lines; nodes and cells counted from this mesh
  bool onefold = false;   // one triangle around the whole block

  /// Element that holds a point, or the nearest one.
  [[nodiscard]] std::int32_t locate(const Vec2& X) const;
  [[nodiscard]] Row row(std::int32_t element, const Vec2& X) const;
};

/// Covers a block with the hexagonal stars of a lattice of edge length `cover_size` [m], anchored to its centre of
/// mass. A block with no element of half a triangle takes one triangle of its own (onefold cover, thesis 7.3.1).
/// Connected pieces share covers only where they share an edge length, so a narrow slot separates its two sides.
[[nodiscard]] CoverMesh make_cover_mesh(const Polygon& outline, double cover_size);

/// The onefold cover of a block.
[[nodiscard]] CoverMesh make_onefold(const Polygon& outline);

}  // namespace scree::nmm
