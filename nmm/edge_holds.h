// Outline edges that are held in place: Nitsche's method on the elements that the edges cut.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "model/body.h"
#include "nmm/tangent.h"

namespace scree::nmm {

/// A stretch of a held edge within one element.
///   E = int_edge [ -(P N).D w + gamma/2 w.D w ] ds,   w = x(X) - x_0(X) - shift,   P = P(F) of the element
/// D projects on the directions that are held. The first term makes the form consistent: where the exact solution has
/// D w = 0, its traction is the reaction, so that fields of constant stress are exact on any cut. With a user-defined
/// bedding the first term is omitted and gamma is the bedding: the edge is then displaced by traction/bedding.
/// @source docs/theory/supports.md, "Held edges"; [Nitsche1971]
struct EdgeHold {
  std::size_t element = 0;                  // counted from the block's first
  std::size_t support = 0;                  // counted among the edge supports of the block
  std::array<double, 3> w0{}, w1{};         // weights of the element's covers at the two ends
  Vec2 at0{0.0, 0.0}, at1{0.0, 0.0};        // where the ends are held [m]
  double from = 0.0, to = 1.0;              // the ends, as fractions of the support's span
  Vec2 shift0{0.0, 0.0}, shift1{0.0, 0.0};  // of the anchors, by transfers [m]
  Vec2 normal{0.0, 0.0};                    // outward, in the reference shape
  double length = 0.0;                      // [m]
  Mat2 held = Mat2::Identity();             // D
  double gamma = 0.0;                       // [Pa/m]
  bool consistent = true;                   // the first term acts
};

/// Energy of a hold and its forces on the three covers of its element at their positions x.
struct HoldResponse {
  double energy = 0.0;                                                      // [J]
  Eigen::Matrix<double, 6, 1> force = Eigen::Matrix<double, 6, 1>::Zero();  // -dE/dx, x and y of each cover [N]
};
[[nodiscard]] HoldResponse hold_response(const EdgeHold& h, const StiffElement& e, const std::array<Vec2, 3>& x);

/// d2E/dx2 without the term of d2P/dF2, whose factor w vanishes with refinement; exact for linear kinematics [N/m].
[[nodiscard]] Mat6 hold_stiffness(const EdgeHold& h, const StiffElement& e, const std::array<Vec2, 3>& x);

/// Traction by which a hold keeps its edge in place, at a fraction of its length [Pa].
[[nodiscard]] Vec2 hold_traction(const EdgeHold& h, const StiffElement& e, const std::array<Vec2, 3>& x, double s);

/// The holds of a block, in the order of its supports, then along its outline.
/// @param mesh       not divided, not onefold; cells of its boundary counted from the block's first
/// @param to_origin  from the reference shape to the block's initial position in the model
[[nodiscard]] std::vector<EdgeHold> edge_holds(const Model& model, const BodyRecord& record, const CoverMesh& mesh,
                                               const AffineMotion& to_origin, const Elasticity& law);

/// Moves anchors.   @param shift  x, y at the two ends of every support of the block; empty: none
void shift_holds(std::span<const double> shift, std::vector<EdgeHold>& holds);

/// Bound of the contribution of the holds to the block's largest eigenvalue [1/s2]: the largest, over the free covers,
/// of the sum of the eigenvalues of (K_hold, M_lumped) of the holds on a cover.
/// @param lumped  row sums, per cover of the pool [kg]
[[nodiscard]] double hold_frequency(std::span<const EdgeHold> holds, const CoverMesh& mesh, const CoverChart& chart,
                                    std::int32_t first, std::span<const double> lumped, const Elasticity& law);

}  // namespace scree::nmm
