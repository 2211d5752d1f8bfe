#include "nmm/tangent.h"

namespace scree::nmm {

Mat6 element_stiffness(const StiffElement& e, const Mat2& F, Stiffness kind) {
  Tangent D;
  if (e.kinematics == Kinematics::linear)
    D = linear_tangent(e.law);
  else if (kind == Stiffness::material)
    D = material_tangent(e.law, F);
  else
    D = elastic_tangent(e.law, F, e.initial_stress);
  if (kind == Stiffness::definite) D = positive_part(D);
  // B: column 2 k + d holds dF of the unit move of cover k along d, e_d (grad w_k)^T, over (F11, F21, F12, F22).
  Eigen::Matrix<double, 4, 6> B = Eigen::Matrix<double, 4, 6>::Zero();
  for (int k = 0; k < 3; ++k)
    for (int d = 0; d < 2; ++d) {
      B(d, 2 * k + d) = e.gradient(0, k);
      B(2 + d, 2 * k + d) = e.gradient(1, k);
    }
  return e.area * (B.transpose() * D * B);
}

}  // namespace scree::nmm
