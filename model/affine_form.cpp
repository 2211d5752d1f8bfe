#include "model/affine_form.h"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>

namespace scree {
namespace {

Tangent tangent(const Elasticity& law, Kinematics kinematics, const Mat2& F, const Mat2& initial, Stiffness kind) {
  if (kinematics == Kinematics::linear) return linear_tangent(law);
  if (kind == Stiffness::material) return material_tangent(law, F);
  const Tangent exact = elastic_tangent(law, F, initial);
  return kind == Stiffness::definite ? positive_part(exact) : exact;
}

}  // namespace

AffineForm::AffineForm(const ReferenceShape& shape, const Elasticity& law, Kinematics kinematics, const Mat2& initial)
    : mass_(shape.mass),
      area_(shape.area),
      length_(std::sqrt(shape.second.trace() / shape.mass)),
      second_(shape.second),
      initial_(initial),
      law_(law),
      kinematics_(kinematics) {}

ChartRow AffineForm::chart_row(double weight, const Vec2& X) const {
  ChartRow row;
  row.n = kUnknowns;
  row.dof = {0, 1, 2, 3, 4, 5};
  row.tx = {weight, 0.0, X.x() / length_, 0.0, X.y() / length_, 0.0};
  row.ty = {0.0, weight, 0.0, X.x() / length_, 0.0, X.y() / length_};
  return row;
}

void AffineForm::mass(std::span<double> lower) const {
  const Mat2 S = second_ / (length_ * length_);
  std::size_t at = 0;
  for (int j = 0; j < kUnknowns; ++j)
    for (int i = j; i < kUnknowns; ++i, ++at) {
      if (i % 2 != j % 2 || (j < 2 && i != j))
        lower[at] = 0.0;
      else
        lower[at] = j < 2 ? mass_ : S(i / 2 - 1, j / 2 - 1);
    }
}

double AffineForm::linearise(const Mat2& F, Stiffness kind, std::span<double> lower, std::span<double> force) const {
  const ElasticResponse r =
      kinematics_ == Kinematics::linear ? linear_response(law_, F, initial_) : elastic_response(law_, F, initial_);
  force[0] = force[1] = 0.0;
  for (std::size_t k = 0; k < 4; ++k) force[2 + k] = -area_ / length_ * r.P.data()[k];
  if (!lower.empty()) {
    // F column after column, in the order of the unknowns.
    const Tangent K = area_ / (length_ * length_) * tangent(law_, kinematics_, F, initial_, kind);
    std::size_t at = 0;
    for (int j = 0; j < kUnknowns; ++j)
      for (int i = j; i < kUnknowns; ++i) lower[at++] = j < 2 ? 0.0 : K(i - 2, j - 2);
  }
  return area_ * r.energy;
}

void AffineForm::unknowns(const Vec2& dc, const Mat2& dF, std::span<double> d) const {
  d[0] = dc.x();
  d[1] = dc.y();
  for (std::size_t k = 0; k < 4; ++k) d[2 + k] = length_ * dF.data()[k];
}

Mat2 AffineForm::gradient(std::span<const double> d) const {
  return (Mat2() << d[2], d[4], d[3], d[5]).finished() / length_;
}

double affine_frequency(const ReferenceShape& shape, const Elasticity& law) {
  const Mat2 inverse = shape.second.inverse();
  Eigen::Matrix3d BB, C;
  BB << inverse(0, 0), 0.0, inverse(0, 1),  //
      0.0, inverse(1, 1), inverse(0, 1),    //
      inverse(0, 1), inverse(0, 1), inverse(0, 0) + inverse(1, 1);
  C << law.p_modulus(), law.lambda, 0.0, law.lambda, law.p_modulus(), 0.0, 0.0, 0.0, law.mu;
  const Eigen::Matrix3d root = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(C).operatorSqrt();
  const Eigen::Matrix3d H = shape.area * root * BB * root;
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(H, Eigen::EigenvaluesOnly).eigenvalues()(2);
}

}  // namespace scree
