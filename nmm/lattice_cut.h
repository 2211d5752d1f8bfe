// The pieces that a block's outline and cracks cut out of the lattice's triangles.
#pragma once

#include <span>

#include "nmm/cover_mesh.h"
#include "nmm/lattice.h"

namespace scree::nmm {

/// Triangles of the lattice around a block, in a dense table, and the elements in each.
struct LatticePieces {
  Lattice lattice;
  LatticeNode low;  // the table's first cell
  std::int32_t columns = 0, rows = 0;
  std::vector<std::int32_t> first;        // per triangle: its first element; one more at the end
  std::vector<LatticeTriangle> triangle;  // per element
  std::vector<char> cracked;              // per triangle: a crack runs through or along it

  [[nodiscard]] bool inside(const LatticeTriangle& t) const {
    return t.i >= low.i && t.i < low.i + columns && t.j >= low.j && t.j < low.j + rows;
  }
  [[nodiscard]] std::size_t index(const LatticeTriangle& t) const {
    return 2 * (static_cast<std::size_t>(t.j - low.j) * static_cast<std::size_t>(columns) +
                static_cast<std::size_t>(t.i - low.i)) +
           static_cast<std::size_t>(t.down);
  }
  /// Elements of a triangle.
  [[nodiscard]] std::pair<std::int32_t, std::int32_t> elements(const LatticeTriangle& t) const {
    if (!inside(t)) return {0, 0};
    return {first[index(t)], first[index(t) + 1]};
  }
};

/// Fills the mesh's elements (not their covers), shapes and pieces. Triangles that are not near any line are inside or
/// outside as a whole; GEOS intersects only the others.
[[nodiscard]] LatticePieces cut_lattice(const Polygon& outline, std::span<const CutLine> cracks, const Lattice& lattice,
                                        CoverMesh& mesh);

/// Numbers the physical covers: pieces of neighbouring triangles that share an edge length that is not on a crack
/// share the two covers at its ends. Covers are numbered by rows of the lattice and along them.
/// @param is_explicit  an element of a divided block: 1 in the explicit half; pieces of different halves share no
///                     cover, and covers that they would have shared become interface constraints. Empty: one body
/// @source docs/theory/kinematics-and-nmm.md, "Covers and elements"; [Qu2013] 6.2.1
void number_covers(const LatticePieces& pieces, std::span<const CutLine> cracks, std::span<const char> is_explicit,
                   CoverMesh& mesh);

/// Ties every cover without a root element (half its triangle is material) to the root element that is reached over the
/// fewest elements; of several, to the nearest. The path is in the material, so that the two sides of a slot are never
/// tied to each other. Connected parts without any root element get a onefold cover.
void tie_covers(CoverMesh& mesh);
/// Releases covers whose ties take more mass from a root than it has: between cracks a root may be far away. Each
/// released cover keeps its own mass, which is positive, and the step may become shorter.
void loosen_ties(CoverMesh& mesh);

/// The outline with rows, split where it crosses lattice lines and cracks.   @param pieces  null for a onefold cover
void make_boundary(const Polygon& outline, const LatticePieces* pieces, std::span<const CutLine> cracks,
                   CoverMesh& mesh);

/// The faces of the cracks with rows, split where they cross lattice lines, the outline and each other.
void make_crack_faces(const Polygon& outline, const LatticePieces& pieces, std::span<const CutLine> cracks,
                      CoverMesh& mesh);

}  // namespace scree::nmm
