// Covers and manifold elements of one block ([Qu2013] 3.2, 6.2.1), in its reference shape.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "model/planar.h"
#include "model/pool.h"

namespace scree::nmm {

/// Gradients of an element's three weights, one per column [1/m].
using Gradients = Eigen::Matrix<double, 2, 3>;
[[nodiscard]] Gradients gradients_of(const std::array<Vec2, 3>& star);

/// A cover without an element of at least half its triangle follows three others by barycentric extrapolation.
/// @source docs/theory/kinematics-and-nmm.md, "Ties"; aggregated finite elements: [Badia2018]
struct Tie {
  std::int32_t cover;
  std::array<std::int32_t, 3> root;
  std::array<double, 3> w;
};

/// Structure of arrays: most elements are whole triangles of the lattice and need no data of their own but covers.
/// An element is one connected piece of block and mesh triangle, with the triangle's three covers. Elements and covers
/// are numbered by rows of the lattice and along them, so that neighbours are near in memory.
struct CoverMesh {
  // One entry per physical cover.
  std::vector<Vec2> star;               // reference position [m]
  std::vector<std::int32_t> component;  // connected part of the block, counted from 0
  std::int32_t components = 0;
  // One entry per element.
  std::vector<std::array<std::int32_t, 3>> cover;  // counter-clockwise
  std::vector<std::uint16_t> shape;                // into shapes
  std::vector<double> area;                        // of the material [m2]
  std::vector<std::int32_t> piece;                 // into pieces; -1: the whole triangle

  std::vector<Gradients> shapes;       // the lattice's two triangles, then one per onefold cover
  std::vector<double> triangle_areas;  // per shape [m2]
  std::vector<Polygon> pieces;         // material of the elements that boundaries or cracks cut [m]
  std::vector<Tie> ties;               // by cover; roots are never tied
  std::vector<char> explicit_part;     // per component of a divided block: 1 in the explicit half; else empty
  std::vector<Pool::InterfaceConstraint> interface_constraints;  // covers of the two halves at one star
  std::vector<std::int32_t> undivided;  // per cover of a divided block: its number in the undivided block
  double area_left_out = 0.0;           // of elements that half_of() removed [m2]
  Boundary boundary;            // outline, split where it crosses mesh lines; nodes and cells counted from this mesh
  bool onefold = false;         // one triangle around the whole block
  double crack_length = 0.0;    // along which the block is cut [m]
  double trimmed_length = 0.0;  // of crack ends within triangles, which do not cut [m]

  [[nodiscard]] std::size_t elements() const { return area.size(); }
  [[nodiscard]] bool in_explicit_half(std::size_t e) const {
    return !explicit_part.empty() &&
           explicit_part[static_cast<std::size_t>(component[static_cast<std::size_t>(cover[e][0])])] != 0;
  }
  /// Area of the whole block's material as it is drawn [m2].
  [[nodiscard]] double drawn_area() const;
  [[nodiscard]] std::array<Vec2, 3> stars(std::size_t element) const;
  /// The material of an element.
  [[nodiscard]] Polygon material(std::size_t element) const;
  [[nodiscard]] Vec2 centroid(std::size_t element) const;
  /// Fraction of the triangle that is material.
  [[nodiscard]] double fraction(std::size_t element) const { return area[element] / triangle_areas[shape[element]]; }
  /// Barycentric weights of a point in the element's triangle (any point: weights may be negative).
  [[nodiscard]] std::array<double, 3> weights(std::size_t element, const Vec2& X) const;
  /// Element that contains a point, or the nearest one.
  [[nodiscard]] std::int32_t locate(const Vec2& X) const;
  [[nodiscard]] Row row(std::int32_t element, const Vec2& X) const;
};

/// x and y of a physical cover in an array of two numbers per cover.
[[nodiscard]] inline Vec2 node(std::span<const double> q, std::int32_t cover) {
  const auto i = 2 * static_cast<std::size_t>(cover);
  return {q[i], q[i + 1]};
}

/// True if two rows of a point are the same sum of nodes for all positions of the nodes.
[[nodiscard]] bool same_place(const Row& a, const Row& b);

/// Covers a block with the hexagonal stars of a lattice of edge length `cover_size` [m], anchored to its centre of
/// mass, which lies at `offset` in a cell (fractions of the cover size). Connected pieces share covers only where they
/// share an edge length that is not on a crack, so a narrow slot separates its two sides, and a crack its two faces. A
/// crack that ends inside a triangle does not cut it. A connected part without an element of half a triangle takes one
/// triangle of its own (onefold cover, [Qu2013] 7.3.1).
/// @throws std::runtime_error if GEOS cannot intersect
/// @param explicit_at  divides the block: true at the centroids of elements of its explicit half; empty: one body
[[nodiscard]] CoverMesh make_cover_mesh(const Polygon& outline, double cover_size, const Vec2& offset = {0.317, 0.271},
                                        std::span<const CutLine> cracks = {},
                                        const std::function<bool(const Vec2&)>& explicit_at = {});

/// A divided mesh, or a half of it, with the elements and ties of one half; covers and outline are those of the whole.
[[nodiscard]] CoverMesh half_of(const CoverMesh& mesh, bool explicit_half);

/// The triangle of a onefold cover: equilateral; its inscribed circle about the points' middle contains all points.
[[nodiscard]] std::array<Vec2, 3> onefold_triangle(std::span<const Vec2> points);

/// A onefold cover of a block: on a triangle around it, or on a given one.
[[nodiscard]] CoverMesh make_onefold(const Polygon& outline);
[[nodiscard]] CoverMesh make_onefold(const Polygon& outline, const std::array<Vec2, 3>& star);

}  // namespace scree::nmm
