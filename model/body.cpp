#include "model/body.h"

#include <Eigen/LU>
#include <cmath>

namespace scree {

AffineMotion affine_fit(const Polygon& from, const Polygon& to) {
  Vec2 mean_from = Vec2::Zero(), mean_to = Vec2::Zero();
  double count = 0.0;
  for (std::size_t r = 0; r < from.rings(); ++r)
    for (std::size_t i = 0; i < from.ring(r).size(); ++i, count += 1.0) {
      mean_from += from.ring(r)[i];
      mean_to += to.ring(r)[i];
    }
  mean_from /= count;
  mean_to /= count;
  Mat2 square = Mat2::Zero(), mixed = Mat2::Zero();
  for (std::size_t r = 0; r < from.rings(); ++r)
    for (std::size_t i = 0; i < from.ring(r).size(); ++i) {
      const Vec2 X = from.ring(r)[i] - mean_from;
      square += X * X.transpose();
      mixed += (to.ring(r)[i] - mean_to) * X.transpose();
    }
  AffineMotion map;
  map.F = mixed * square.inverse();
  map.c = mean_to - map.F * mean_from;
  return map;
}

InSituStress::InSituStress(const Model& model, const BodyRecord& record) {
  if (record.placed) return;  // fill is placed without stress
  const auto& stress = model.material_of(record.block).initial_stress;
  if (!stress) return;
  stress_ = &*stress;
  centroid_ = moments(record.shape.outline).centroid;
  origin_ = affine_fit(record.shape.outline, record.shape.origin);
  turn_ = polar_rotation(origin_.F);
}

Mat2 InSituStress::at(const Vec2& X) const {
  if (none()) return Mat2::Zero();
  return turn_.transpose() * stress_->at(origin_.c + origin_.F * X) * turn_;
}

}  // namespace scree
