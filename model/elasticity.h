// The elastic law shared by every method: isotropic, co-rotated small strain.
#pragma once

#include "model/geometry.h"

namespace scree {

enum class Plane { strain, stress };

/// Isotropic plane elasticity, sigma = lambda tr(e) I + 2 mu e [Pa].
struct Elasticity {
  double lambda = 0.0;  // in-plane Lame constant (already reduced for plane stress) [Pa]
  double mu = 0.0;      // shear modulus [Pa]

  [[nodiscard]] static Elasticity from(double young, double poisson, Plane plane);
  [[nodiscard]] Mat2 stress(const Mat2& strain) const {
    return lambda * strain.trace() * Mat2::Identity() + 2.0 * mu * strain;
  }
  /// Strain that gives a stress.
  [[nodiscard]] Mat2 strain(const Mat2& stress) const;
  /// P-wave modulus lambda + 2 mu [Pa].
  [[nodiscard]] double p_modulus() const { return lambda + 2.0 * mu; }
};

/// Rotation of the polar decomposition F = R U, in closed form.   @pre tr or skew part of F not both zero
[[nodiscard]] Mat2 polar_rotation(const Mat2& F);

/// Co-rotated response: R = polar(F), e = R^T F - I, s = C:e + s0, W = 1/2 e:C:e + s0:e.
struct ElasticResponse {
  double energy = 0.0;  // per reference area [J/m2 for unit thickness]
  Mat2 P;               // first Piola-Kirchhoff stress, the exact gradient dW/dF [Pa]
  Mat2 R;               // rotation
  Mat2 stress;          // co-rotated stress s [Pa]
};
/// P = R (s + w W), w = -[(sU)_21 - (sU)_12]/tr U; w vanishes for isotropic s0.
/// @source docs/theory/kinematics-and-nmm.md, "Elastic law"; initial stress s0 is given in the co-rotated frame
[[nodiscard]] ElasticResponse elastic_response(const Elasticity& law, const Mat2& F, const Mat2& s0);

/// dP/dF of elastic_response(), 4 x 4 over (F11, F21, F12, F22): exact, in closed form, symmetric. With R = polar(F),
/// r = tr U and W the quarter turn, a change dF turns by dt = [W:(R^T dF)]/r and stretches by dU = R^T dF - dt W U:
///   dP = R [C:dU + dw W + dt W (s + w W)],  dw = -[(s0 dU)_21 - (s0 dU)_12 + w tr dU]/r.
using Tangent = Eigen::Matrix<double, 4, 4>;
[[nodiscard]] Tangent elastic_tangent(const Elasticity& law, const Mat2& F, const Mat2& s0);

/// The part de:C:de of the second derivative, e(F) = U - I: positive semi-definite, zero for rigid motion.
[[nodiscard]] Tangent material_tangent(const Elasticity& law, const Mat2& F);

/// Response without rotation: W = 1/2 e:C:e + s0:e with e = sym(F) - I, P = C:e + s0.
[[nodiscard]] ElasticResponse linear_response(const Elasticity& law, const Mat2& F, const Mat2& s0);
[[nodiscard]] Tangent linear_tangent(const Elasticity& law);

/// The nearest positive semi-definite tangent: negative eigenvalues become zero.
[[nodiscard]] Tangent positive_part(const Tangent& tangent);

/// Strain e of an affine body in the co-rotated frame whose Kirchhoff stress (C:e + s0)(I + e) is the one given [Pa].
/// @pre the strain is small against 1 (fixed-point iteration with the factor |e|)
[[nodiscard]] Mat2 strain_of_kirchhoff(const Elasticity& law, const Mat2& kirchhoff, const Mat2& s0);

}  // namespace scree
