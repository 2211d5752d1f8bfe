// One affine block: x = c + F X, mass m, reference second moment S0 = int rho X X^T dA, area A0.
#pragma once

#include "model/elasticity.h"
#include "model/pool.h"

namespace scree::dda {

/// Shi's unknowns of a step, D = (u0, v0, r0, ex, ey, gxy) about the centroid:
///   u = u0 - (y-y0) r0 + (x-x0) ex + (y-y0) gxy/2,  v = v0 + (x-x0) r0 + (y-y0) ey + (x-x0) gxy/2
/// @source [Shi1988]; [Sitar1997] 2.1
inline constexpr int kUnknowns = 6;
using Vec6 = Eigen::Matrix<double, kUnknowns, 1>;
using Mat6 = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Mat26 = Eigen::Matrix<double, 2, kUnknowns>;

/// Shi's matrix T at a point, r = x - x0: displacement = T D.
[[nodiscard]] inline Mat26 shi_matrix(const Vec2& r) {
  Mat26 T;
  T << 1.0, 0.0, -r.y(), r.x(), 0.0, 0.5 * r.y(),  //
      0.0, 1.0, r.x(), 0.0, r.y(), 0.5 * r.x();
  return T;
}
/// Displacement gradient of the unknowns: [[ex, gxy/2 - r0], [gxy/2 + r0, ey]].
[[nodiscard]] Mat2 step_gradient(const Vec6& D);
/// Unknowns (without translation) of a velocity gradient G: r0 = (G21-G12)/2, ex, ey, gxy = G12 + G21.
[[nodiscard]] Vec6 rates_of(const Vec2& vc, const Mat2& G);

struct AffineState {
  Vec2 c, vc;
  Mat2 F, Fdot;
};

/// Mass matrix in the unknowns: diag(m, m) and tr(L_i S L_j^T), S = F S0 F^T [kg, kg m2].
[[nodiscard]] Mat6 mass_matrix(double mass, const Mat2& S);
/// Elastic stiffness in the unknowns, area times C on (ex, ey, gxy) [N m].
[[nodiscard]] Mat6 stiffness_matrix(double area, const Elasticity& law);
/// Generalised internal force -A0 tau : L_j of the Kirchhoff stress tau = P F^T; exactly zero for r0.
/// @param s0  initial stress in the co-rotated frame [Pa]
[[nodiscard]] Vec6 internal_force(double area, const Elasticity& law, const Mat2& F, const Mat2& s0);
/// Generalised internal force -A0 tau : L_j of a given Kirchhoff stress tau.
[[nodiscard]] Vec6 unknowns_of_stress(double area, const Mat2& kirchhoff);

/// Exact rotation: F <- R(r0)(I + e) F, c <- c + u, G <- R G R^T, so a free spin neither slows nor grows.
/// It omits centrifugal and Coriolis terms within the step (the true rate equation is G' = T S^-1 - G^2; strain error
/// about rho w^2 L^2 / 12 E).
/// @source docs/theory/dda.md, "Exact rotation"; [MacLaughlin1997] for the remedy that [Sitar1997] 2.1 names
[[nodiscard]] AffineState exact_update(const AffineState& before, const Vec6& D, const Vec6& rate);

/// The linear update of the original DDA: F <- (I + L) F, c <- c + u, G unchanged. A step that turns by r0 makes every
/// edge longer by sqrt(1 + r0^2).
/// @source docs/theory/dda.md, "First-order update"; [Shi1988]
[[nodiscard]] AffineState first_order_update(const AffineState& before, const Vec6& D, const Vec6& rate);

}  // namespace scree::dda
