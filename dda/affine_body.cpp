#include "dda/affine_body.h"

namespace scree::dda {
namespace {

/// Gradients L_j of the unknowns r0, ex, ey, gxy.
const std::array<Mat2, 4>& gradients() {
  static const std::array<Mat2, 4> L{quarter_turn(), (Mat2() << 1.0, 0.0, 0.0, 0.0).finished(),
                                     (Mat2() << 0.0, 0.0, 0.0, 1.0).finished(),
                                     (Mat2() << 0.0, 0.5, 0.5, 0.0).finished()};
  return L;
}

}  // namespace

Mat2 step_gradient(const Vec6& D) { return (Mat2() << D(3), 0.5 * D(5) - D(2), 0.5 * D(5) + D(2), D(4)).finished(); }

Vec6 rates_of(const Vec2& vc, const Mat2& G) {
  Vec6 rate;
  rate << vc.x(), vc.y(), 0.5 * (G(1, 0) - G(0, 1)), G(0, 0), G(1, 1), G(0, 1) + G(1, 0);
  return rate;
}

Mat6 mass_matrix(double mass, const Mat2& S) {
  Mat6 M = Mat6::Zero();
  M(0, 0) = M(1, 1) = mass;
  const auto& L = gradients();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) M(2 + i, 2 + j) = (L[std::size_t(i)] * S * L[std::size_t(j)].transpose()).trace();
  return M;
}

Mat6 stiffness_matrix(double area, const Elasticity& law) {
  Mat6 K = Mat6::Zero();
  K(3, 3) = K(4, 4) = area * law.p_modulus();
  K(3, 4) = K(4, 3) = area * law.lambda;
  K(5, 5) = area * law.mu;
  return K;
}

Vec6 internal_force(double area, const Elasticity& law, const Mat2& F, const Mat2& s0) {
  return unknowns_of_stress(area, elastic_response(law, F, s0).P * F.transpose());
}

Vec6 unknowns_of_stress(double area, const Mat2& tau) {
  Vec6 f = Vec6::Zero();
  f(3) = -area * tau(0, 0);
  f(4) = -area * tau(1, 1);
  f(5) = -area * 0.5 * (tau(0, 1) + tau(1, 0));
  return f;
}

AffineState exact_update(const AffineState& before, const Vec6& D, const Vec6& rate) {
  const Mat2 R = rotation(D(2));
  Mat2 stretch;
  stretch << 1.0 + D(3), 0.5 * D(5), 0.5 * D(5), 1.0 + D(4);
  AffineState after;
  after.c = before.c + D.head<2>();
  after.vc = rate.head<2>();
  after.F = R * (stretch * before.F);
  after.Fdot = R * step_gradient(rate) * R.transpose() * after.F;
  return after;
}

AffineState first_order_update(const AffineState& before, const Vec6& D, const Vec6& rate) {
  AffineState after;
  after.c = before.c + D.head<2>();
  after.vc = rate.head<2>();
  after.F = before.F + step_gradient(D) * before.F;
  after.Fdot = step_gradient(rate) * after.F;
  return after;
}

}  // namespace scree::dda
