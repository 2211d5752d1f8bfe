// How large the NMM meshes of a stage will be, before they are made.
#pragma once

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

struct MeshEstimate {
  double elements = 0.0;
  double bytes = 0.0;       // at the peak of a run, by what runs with 2e4 to 4e5 elements of a block had
  BlockId finest;           // the block with the largest part of it; invalid: no block has a mesh
  double cover_size = 0.0;  // its own [m]
};

/// Elements from areas and outlines: whole triangles inside, and three for every length of an outline as long as a
/// cover. Bytes of the table of lattice cells beside those of the elements; implicit steps factor a matrix.
[[nodiscard]] MeshEstimate mesh_estimate(const Model& model, const Stage& stage);

/// What there may be at most: beyond it numbers of elements and covers would not be counted any more.
inline constexpr double kMostElements = 1e8;

}  // namespace scree::coupling
