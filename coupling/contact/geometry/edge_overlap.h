// The overlap of two edges that face each other, divided among the vertices on either side.
#pragma once

#include <span>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// Per vertex of one edge that lies over the other, with the length of joint that it stands for.
struct OverlapPoint {
  VertexIndex vertex;
  EdgeIndex edge;                    // the edge that it faces
  double tributary = 0.0;            // [m], half of the pieces on either side
  double behind = 0.0, ahead = 0.0;  // their lengths, against and along the direction given [m]
};

/// Cuts the overlap of two edges at every vertex of either side; each end of a piece carries half of its length. The
/// trapezoidal rule is exact for pressures and displacements that are linear in every piece, so a uniform pressure
/// is transferred exactly for any vertices (contact patch test), and each length counts once, not once per body.
class EdgeOverlap {
 public:
  /// @param x        positions of the outline nodes
  /// @param along    unit vector along edge a and against edge b
  /// @param middle   false: only corners carry shares, the vertices of a mesh between them do not
  /// @return points with a share above zero, in no promised order; valid until the next call
  std::span<const OverlapPoint> divide(const Outlines& o, OutlinePositions x, EdgeIndex a, EdgeIndex b,
                                       const Vec2& along, bool middle);

 private:
  struct Kink {
    double s = 0.0;
    VertexIndex vertex;
    EdgeIndex edge;
  };
  /// Gives each kink half of the pieces beside it.   @param kinks  in order
  void share(std::span<const Kink> kinks);
  std::vector<Kink> of_a_, of_b_, kinks_;  // on either edge, in its direction; on both
  std::vector<OverlapPoint> points_;
};

}  // namespace scree::coupling
