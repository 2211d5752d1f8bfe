#include "model/elasticity.h"

#include <Eigen/LU>
#include <cmath>

namespace scree {

Elasticity Elasticity::from(double young, double poisson, Plane plane) {
  Elasticity law;
  law.mu = young / (2.0 * (1.0 + poisson));
  law.lambda = plane == Plane::strain ? young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson))
                                      : young * poisson / (1.0 - poisson * poisson);
  return law;
}

Mat2 Elasticity::strain(const Mat2& stress) const {
  const double trace = stress.trace() / (2.0 * (lambda + mu));
  return (stress - lambda * trace * Mat2::Identity()) / (2.0 * mu);
}

Mat2 polar_rotation(const Mat2& F) {
  const double a = F(0, 0) + F(1, 1), b = F(1, 0) - F(0, 1);
  const double r = std::sqrt(a * a + b * b);
  return (Mat2() << a / r, -b / r, b / r, a / r).finished();
}

ElasticResponse elastic_response(const Elasticity& law, const Mat2& F, const Mat2& s0) {
  ElasticResponse out;
  out.R = polar_rotation(F);
  const Mat2 U = out.R.transpose() * F;
  const Mat2 e = 0.5 * (U + U.transpose()) - Mat2::Identity();  // U is symmetric but for round-off
  const Mat2 se = law.stress(e);
  out.stress = se + s0;
  out.energy = 0.5 * se.cwiseProduct(e).sum() + s0.cwiseProduct(e).sum();
  const Mat2 sU = s0 * U;  // the isotropic part commutes with U
  const double w = -(sU(1, 0) - sU(0, 1)) / U.trace();
  out.P = out.R * (out.stress + w * quarter_turn());
  return out;
}

ElasticResponse linear_response(const Elasticity& law, const Mat2& F, const Mat2& s0) {
  ElasticResponse out;
  out.R = Mat2::Identity();
  const Mat2 e = 0.5 * (F + F.transpose()) - Mat2::Identity();
  const Mat2 se = law.stress(e);
  out.stress = se + s0;
  out.energy = 0.5 * se.cwiseProduct(e).sum() + s0.cwiseProduct(e).sum();
  out.P = out.stress;
  return out;
}

Mat2 strain_of_kirchhoff(const Elasticity& law, const Mat2& kirchhoff, const Mat2& s0) {
  Mat2 e = law.strain(kirchhoff - s0);
  for (int i = 0; i < 60; ++i) {
    const Mat2 stress = kirchhoff * (Mat2::Identity() + e).inverse();  // C:e and I + e commute
    const Mat2 next = law.strain(0.5 * (stress + stress.transpose()) - s0);
    const double change = (next - e).norm();
    e = next;
    if (change <= 1e-17 * e.norm()) break;
  }
  return e;
}

}  // namespace scree
