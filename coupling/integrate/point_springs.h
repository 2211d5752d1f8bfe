// Point supports: springs between a point of a body and where that point was in the model, or where a hand-over has
// shifted it.
#pragma once

#include <span>
#include <vector>

#include "coupling/bodies/setup.h"

namespace scree::coupling {

struct PointSpring {
  Row row;  // in the state's nodes
  std::int32_t body = -1;
  std::int32_t support = -1;  // into Model::point_supports
  Vec2 anchor{0.0, 0.0};      // [m]
  Vec2 k{0.0, 0.0};           // [N/m] in x and y; 0 where free
};

/// One spring a point support of a free body. auto stiffness: 10 (K + 4G/3).
[[nodiscard]] std::vector<PointSpring> point_springs(const Setup& setup, const State& state);

/// Shifts the anchors of bodies that have been made anew, so that their springs pull as before: an affine body has the
/// point elsewhere than the bent one that it comes from. The stiffness is the support's own, so the energy stays too.
/// @param before   point_springs() of the bodies that were, at q_before
/// @param to       the bodies that are, at state.q   @param changed  one flag a body
void keep_elongations(const std::vector<PointSpring>& before, std::span<const double> q_before, const Setup& to,
                      const std::vector<char>& changed, State& state);

/// Force on the body and energy of a spring.
[[nodiscard]] inline Vec2 spring_force(const PointSpring& s, std::span<const double> q) {
  return -s.k.cwiseProduct(position(s.row, q) - s.anchor);
}
[[nodiscard]] inline double spring_energy(const PointSpring& s, std::span<const double> q) {
  const Vec2 u = position(s.row, q) - s.anchor;
  return 0.5 * u.dot(s.k.cwiseProduct(u));
}

}  // namespace scree::coupling
