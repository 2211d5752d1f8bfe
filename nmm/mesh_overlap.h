// The material that elements of two meshes of one shape have in common.
#pragma once

#include <vector>

#include "nmm/cover_mesh.h"

namespace scree::nmm {

/// A part of an element of one mesh that lies in an element of the other.
struct Overlap {
  std::int32_t from = 0, to = 0;  // elements
  Moments common;                 // of the material that both have
};

/// All overlaps of two meshes of the same outline, by elements of `to`. Together they make up the material of each:
/// what intersections leave out of an element of `to` (slivers, ends of cracks that one mesh trims) is added to the
/// other overlaps of that element, or assigned to the nearest element of `from`.
[[nodiscard]] std::vector<Overlap> overlaps(const CoverMesh& from, const CoverMesh& to);

}  // namespace scree::nmm
