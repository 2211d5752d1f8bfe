// Estimated size of the NMM meshes of a stage, before they are created.
#pragma once

#include "coupling/plan.h"
#include "model/model.h"

namespace scree::coupling {

struct MeshEstimate {
  double elements = 0.0;
  double bytes = 0.0;       // at the peak of a run, by measurements with 2e4 to 4e5 elements per block
  BlockId finest;           // the block whose mesh has most bytes; invalid: no block has a mesh
  double cover_size = 0.0;  // of that block [m]
};

/// Elements from areas and outlines: whole triangles inside, and three per cover size of outline length. Bytes: those
/// of the elements, which include the factor of the matrix for implicit steps, and of the table of lattice cells.
[[nodiscard]] MeshEstimate mesh_estimate(const Model& model, const Stage& stage);

/// Largest allowed number of elements: beyond it elements and covers could not be counted any more.
inline constexpr double kMostElements = 1e8;

}  // namespace scree::coupling
