// How a stage represents a block, beside the name of the method.
#pragma once

#include "model/geometry.h"

namespace scree {

enum class Kinematics {
  corotational,  // small strain in a frame that turns with the rock
  linear         // small strain and rotation: for comparisons with linear theory
};

enum class MassKind {
  affine_exact,  // row sums, corrected so that mass, momenta and rotational inertia are the block's
  lumped,        // row sums ([Qu2013] 4.3.1)
  consistent     // int rho w_i w_j; implicit steps only
};

/// How an implicit DDA step moves a block.
enum class BlockRotation {
  exact,       // Shi's six unknowns about the block's place, then an exact rotation
  affine,      // (c, F) themselves with Newton's method on the co-rotated energy, as on a onefold NMM cover
  first_order  // Shi's linear update, which makes rotating blocks grow, with a summed strain: for comparisons
};

/// Per block: division of one continuum into a half that takes explicit steps, the elements whose centroid was
/// initially in the region, and a half that takes implicit steps, the others. Covers that both halves need exist twice
/// (Pool::interface_constraints).
/// @source docs/theory/explicit-implicit-coupling.md, "Divided blocks"; [Qu2013] 7.2.2, element partition
struct Division {
  enum class Acts { both, explicit_half, implicit_half };
  Ring region;             // at the block's initial position in the model; empty: one body [m]
  Acts acts = Acts::both;  // the nodes of the other half exist, without mass or force

  bool operator==(const Division&) const = default;
  [[nodiscard]] bool divides() const { return !region.empty(); }
};

/// Options of the methods; a method ignores the options that it does not have.
struct Formulation {
  Kinematics kinematics = Kinematics::corotational;
  MassKind mass = MassKind::affine_exact;
  double cover_size = 0.0;  // edge length of the mathematical mesh [m]
  // Position of the block's centre of mass in a cell of the mesh, as fractions of the cover size: not round numbers,
  // so that edges of regular blocks seldom run along mesh lines.
  double offset_x = 0.317, offset_y = 0.271;
  bool onefold = false;         // one triangle around the whole block in place of a mesh
  bool model_triangle = false;  // of onefold covers: one around the whole model, the same for all blocks
  bool cracks = false;          // cut the block's interior along its cracks
  BlockRotation rotation = BlockRotation::exact;  // DDA
  Division division{};                            // NMM, meshes only

  bool operator==(const Formulation&) const = default;
  /// True if bodies of the two formulations have the same unknowns.
  [[nodiscard]] bool same_mesh(const Formulation& other) const {
    return same_covers(other) && division.region == other.division.region;
  }
  /// True if bodies of the two formulations have the same covers, apart from those that a division duplicates.
  [[nodiscard]] bool same_covers(const Formulation& other) const {
    return cover_size == other.cover_size && offset_x == other.offset_x && offset_y == other.offset_y &&
           onefold == other.onefold && model_triangle == other.model_triangle && cracks == other.cracks &&
           (rotation == BlockRotation::first_order) == (other.rotation == BlockRotation::first_order);
  }
};

}  // namespace scree
