// Point supports, and edge supports of bodies that do not hold their edges themselves: springs between a point of a
// body and its position in the model, or the position that a transfer has shifted it to.
#pragma once

#include <span>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

struct PointSpring {
  Row row;  // in the state's nodes
  BodyIndex body;
  std::int32_t support = -1;     // into Model::point_supports; -1: spring of an edge support
  Vec2 anchor{0.0, 0.0};         // [m]
  Vec2 k{0.0, 0.0};              // [N/m] along the axes; 0 where free
  Mat2 axes = Mat2::Identity();  // columns: unit vectors
};

/// One spring per point support of a free body; auto stiffness: 10 (K + 4G/3). Then two springs per edge support of a
/// body that does not hold its edges, at the Gauss points of the span with half the bedding each: exact where the
/// displacement is linear along the span, as in an affine body. Without a bedding: 10 (K + 4G/3)/sqrt(area) [Pa/m].
[[nodiscard]] std::vector<PointSpring> point_springs(const Setup& setup, const State& state);

/// Shifts the anchors of bodies that have been replaced, so that their springs pull as before: in an affine body the
/// point is elsewhere than in the bent one that it replaces. The stiffness is the support's own, so the energy stays
/// too.
/// @param before   point_springs() of the old bodies, at q_before
/// @param to       the new bodies, at state.q   @param changed  one flag per body
void keep_elongations(const std::vector<PointSpring>& before, std::span<const double> q_before, const Setup& to,
                      const std::vector<char>& changed, State& state);

/// keep_elongations() for edge supports: anchors move so that springs apply the force that held the edge before, and so
/// that a new body which holds its edge itself holds it at its present place. Where bodies hold their edges before and
/// after, anchors stay.
void keep_edges(const Setup& from, std::span<const double> q_before, const std::vector<BodyRecord>& bodies_before,
                Setup& to, const std::vector<char>& changed, State& state);

/// Force on the body and energy of a spring.
[[nodiscard]] inline Vec2 spring_force(const PointSpring& s, std::span<const double> q) {
  return -s.axes * s.k.cwiseProduct(s.axes.transpose() * (position(s.row, q) - s.anchor));
}
[[nodiscard]] inline double spring_energy(const PointSpring& s, std::span<const double> q) {
  const Vec2 u = s.axes.transpose() * (position(s.row, q) - s.anchor);
  return 0.5 * u.dot(s.k.cwiseProduct(u));
}

}  // namespace scree::coupling
