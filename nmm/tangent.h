// Stiffness of one manifold element: the consistent tangent of its energy.
#pragma once

#include "model/elasticity.h"
#include "model/formulation.h"
#include "model/pool.h"
#include "nmm/folded_elements.h"

namespace scree::nmm {

/// Data of an element for its stiffness, independent of their storage in the pool.
struct StiffElement {
  Eigen::Matrix<double, 2, 3> gradient;  // of the three weights [1/m]
  double area = 0.0;                     // [m2]
  Elasticity law;
  Kinematics kinematics = Kinematics::corotational;
  Mat2 initial_stress = Mat2::Zero();  // co-rotated [Pa]
};

/// Response of an element with the deformation gradient F.
[[nodiscard]] inline ElasticResponse response(const StiffElement& e, const Mat2& F) {
  return e.kinematics == Kinematics::linear ? linear_response(e.law, F, e.initial_stress)
                                            : elastic_response(e.law, F, e.initial_stress);
}

/// Forces -A P grad w_k on the covers, x and y of each [N].
[[nodiscard]] inline Eigen::Matrix<double, 6, 1> element_force(const StiffElement& e, const Mat2& P) {
  const Eigen::Matrix<double, 2, 3> f = -e.area * P * e.gradient;
  return Eigen::Map<const Eigen::Matrix<double, 6, 1>>(f.data());
}

/// K = A B^T (dP/dF) B over x and y of the three covers, F = sum_k x_k (grad w_k)^T [N/m].
[[nodiscard]] Mat6 element_stiffness(const StiffElement& e, const Mat2& F, Stiffness kind);

}  // namespace scree::nmm
