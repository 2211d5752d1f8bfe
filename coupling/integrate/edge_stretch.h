// The part of an outline that a stretch of an edge covers, on the discretised bodies of a stage.
#pragma once

#include <span>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

/// Part of one boundary segment a -> b, between two fractions of it.
struct EdgeStretch {
  BodyIndex body;
  Row a, b;  // in the state's nodes
  double from = 0.0, to = 1.0;
  double length = 0.0;            // in the initial geometry of the model [m]
  double begin = 0.0, end = 1.0;  // as fractions of the edge

  /// Position, or velocity, at a fraction of the segment.
  [[nodiscard]] Vec2 at(double s, std::span<const double> q) const {
    return (1.0 - s) * position(a, q) + s * position(b, q);
  }
  /// f += J^T force at a fraction of the segment.
  void push(double s, const Vec2& force, std::span<double> f) const {
    add_force(a, (1.0 - s) * force, f);
    add_force(b, s * force, f);
  }
};

/// Pieces of a span, along the edge; none on a driven body.
/// @pre the span's edge exists and 0 <= s0 < s1 <= 1
[[nodiscard]] std::vector<EdgeStretch> edge_stretches(const Setup& setup, const State& state, const EdgeSpan& span);

}  // namespace scree::coupling
