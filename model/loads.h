// Loads on blocks, initial stress, and supports of edges.
#pragma once

#include <optional>
#include <vector>

#include "model/geometry.h"
#include "model/ids.h"

namespace scree {

/// A corner or edge of a block's outline; independent of meshes and methods.
struct OutlineEdge {
  std::int32_t ring = 0, edge = 0;
  auto operator<=>(const OutlineEdge&) const = default;
};

/// A stretch of an outline edge, s from 0 to 1 along it.
struct EdgeSpan {
  BlockId block;
  OutlineEdge edge;
  double s0 = 0.0, s1 = 1.0;
};

/// A force on a material point, of constant direction. Invalid time function: constant in time.
struct PointLoad {
  BlockId block;
  Vec2 point{0.0, 0.0};  // [m], model coordinates
  Vec2 force{0.0, 0.0};  // [N] for unit thickness
  FunctionId function;
};

/// Force per length of the initial outline, of constant direction (a dead load).
struct EdgeTraction {
  EdgeSpan span;
  Vec2 traction{0.0, 0.0};  // [Pa]
  FunctionId function;
};

/// Force per mass on blocks, beside gravity.
struct BodyAcceleration {
  std::vector<BlockId> blocks;  // empty: all
  Vec2 acceleration{0.0, 0.0};  // [m/s2]
  FunctionId function;
};

/// An edge that absorbs waves: traction -rho (c_p v.n n + c_s v.t t), exact for plane waves at right angles. With a
/// motion it is a compliant base: the rock beyond emits a wave of the velocity u, which adds twice rho (c_p u.n n +
/// c_s u.t t).
/// @source [Lysmer1969], [Joyner1975]; docs/theory/seismic-input.md, "Viscous edges", "Compliant base"
struct ViscousEdge {
  EdgeSpan span;
  MotionId motion{};     // of the incoming wave; invalid: none
  double upgoing = 1.0;  // of the motion's velocity: 1 for that of the wave itself, 1/2 for an outcrop
};

/// A stretch of outline that is fixed at its position in the model along some directions and slides freely along the
/// others. Without a bedding the edge is only as compliant as its discretisation requires: by Nitsche's method if the
/// method of the block has a stress field, else on springs of 10 (K + 4G/3)/sqrt(area).
/// @source docs/theory/supports.md, "Held edges"
struct EdgeSupport {
  EdgeSpan span;
  Mat2 held = Mat2::Identity();   // projector on the directions that are held: I, or a a^T with a unit vector a
  std::optional<double> bedding;  // [Pa/m]; user-defined springs, which are compliant
};

/// In-situ stress of a material, in the model's axes: s(y) = stress + (level - y) gradient. Tension positive.
struct InitialStress {
  Mat2 stress = Mat2::Zero();    // at `level` [Pa]
  Mat2 gradient = Mat2::Zero();  // growth with depth [Pa/m]
  double level = 0.0;            // [m]
  [[nodiscard]] Mat2 at(const Vec2& x) const { return stress + (level - x.y()) * gradient; }
};

}  // namespace scree
