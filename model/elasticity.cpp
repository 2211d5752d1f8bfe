#include "model/elasticity.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "model/dense_algebra.h"

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

namespace {

/// Changes of the stretch U and of the rotation for the unit changes of F.
struct StretchRates {
  std::array<Mat2, 4> dU;
  std::array<double, 4> turn{};
};

StretchRates stretch_rates(const Mat2& R, const Mat2& U) {
  StretchRates out;
  const Mat2 WU = quarter_turn() * U;
  for (std::size_t k = 0; k < 4; ++k) {
    Mat2 dF = Mat2::Zero();
    dF.data()[k] = 1.0;
    const Mat2 RdF = R.transpose() * dF;
    out.turn[k] = (RdF(1, 0) - RdF(0, 1)) / U.trace();
    const Mat2 dU = RdF - out.turn[k] * WU;
    out.dU[k] = 0.5 * (dU + dU.transpose());
  }
  return out;
}

}  // namespace

Tangent material_tangent(const Elasticity& law, const Mat2& F) {
  const Mat2 R = polar_rotation(F);
  const StretchRates rates = stretch_rates(R, R.transpose() * F);
  Tangent out;
  for (std::size_t k = 0; k < 4; ++k) {
    const Mat2 ds = law.stress(rates.dU[k]);
    for (std::size_t i = 0; i < 4; ++i)
      out(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) = ds.cwiseProduct(rates.dU[i]).sum();
  }
  return out;
}

Tangent elastic_tangent(const Elasticity& law, const Mat2& F, const Mat2& s0) {
  const Mat2 R = polar_rotation(F), W = quarter_turn();
  const Mat2 U = R.transpose() * F;
  const double r = U.trace();
  const Mat2 s = law.stress(0.5 * (U + U.transpose()) - Mat2::Identity()) + s0;
  const Mat2 sU = s0 * U;
  const double w = -(sU(1, 0) - sU(0, 1)) / r;
  const Mat2 turned = W * (s + w * W);
  const StretchRates rates = stretch_rates(R, U);
  Tangent out;
  for (std::size_t k = 0; k < 4; ++k) {
    const Mat2& dU = rates.dU[k];
    const Mat2 sdu = s0 * dU;
    const double dw = -(sdu(1, 0) - sdu(0, 1) + w * dU.trace()) / r;
    const Mat2 dP = R * (law.stress(dU) + dw * W + rates.turn[k] * turned);
    out.col(static_cast<Eigen::Index>(k)) = Eigen::Map<const Eigen::Vector4d>(dP.data());
  }
  return 0.5 * (out + out.transpose());
}

ElasticResponse linear_response(const Elasticity& law, const Mat2& F, const Mat2& s0) {
  ElasticResponse out;
  out.R = Mat2::Identity();
  const Mat2 e = 0.5 * (F + F.transpose()) - Mat2::Identity();
  const Mat2 se = law.stress(e);
  out.stress = se + s0;
  out.P = out.stress;
  out.energy = 0.5 * se.cwiseProduct(e).sum() + s0.cwiseProduct(e).sum();
  return out;
}

Tangent linear_tangent(const Elasticity& law) {
  Tangent out;
  for (int k = 0; k < 4; ++k) {
    Mat2 dF = Mat2::Zero();
    dF.data()[k] = 1.0;
    const Mat2 dP = law.stress(0.5 * (dF + dF.transpose()));
    out.col(k) = Eigen::Map<const Eigen::Vector4d>(dP.data());
  }
  return out;
}

Tangent positive_part(const Tangent& tangent) {
  const Modes modes = symmetric_modes(tangent);
  if (modes.values(0) >= 0.0) return tangent;
  Tangent out = Tangent::Zero();
  for (Eigen::Index k = 0; k < 4; ++k) {
    const Eigen::Vector4d x = modes.vectors.col(k);
    out += std::max(modes.values(k), 0.0) * x * x.transpose();
  }
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
