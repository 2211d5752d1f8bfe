#include "nmm/onefold.h"

#include <Eigen/LU>

namespace scree::nmm {

OnefoldCover::OnefoldCover(const std::array<Vec2, 3>& star, const ReferenceShape& shape, const Elasticity& law,
                           Kinematics kinematics, const Mat2& initial, std::int32_t first)
    : star_(star),
      slope_(gradients_of(star)),
      mass_(shape.mass),
      second_(shape.second),
      second_inverse_(shape.second.inverse()),
      form_(shape, law, kinematics, initial),
      first_(first) {
  const double twice = cross(star[1] - star[0], star[2] - star[0]);
  for (std::size_t k = 0; k < 3; ++k) weight_[k] = cross(star[(k + 1) % 3], star[(k + 2) % 3]) / twice;
}

Vec2 OnefoldCover::centre(std::span<const double> q) const {
  Vec2 c = Vec2::Zero();
  for (std::size_t k = 0; k < 3; ++k) c += weight_[k] * Vec2(q[at(k)], q[at(k) + 1]);
  return c;
}

Mat2 OnefoldCover::gradient(std::span<const double> q) const {
  Mat2 F = Mat2::Zero();
  for (std::size_t k = 0; k < 3; ++k)
    F += Vec2(q[at(k)], q[at(k) + 1]) * slope_.col(static_cast<Eigen::Index>(k)).transpose();
  return F;
}

void OnefoldCover::place(const Vec2& c, const Mat2& F, std::span<double> q) const {
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 x = c + F * star_[k];
    q[at(k)] = x.x();
    q[at(k) + 1] = x.y();
  }
}

Vec2 OnefoldCover::point(const Row& row) const {
  Vec2 X = Vec2::Zero();
  for (std::size_t k = 0; k < 3; ++k) X += row.w[k] * star_[static_cast<std::size_t>(row.node[k] - first_)];
  return X;
}

void OnefoldCover::mass_solve(std::span<const double> f, std::span<double> a) const {
  Vec2 force = Vec2::Zero();
  Mat2 moment = Mat2::Zero();
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 of_star(f[at(k)], f[at(k) + 1]);
    force += of_star;
    moment += of_star * star_[k].transpose();
  }
  place(force / mass_, moment * second_inverse_, a);
}

void OnefoldCover::mass_apply(std::span<const double> v, std::span<double> p) const {
  const Vec2 momentum = mass_ * centre(v);
  const Mat2 moment = gradient(v) * second_;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 of_star = weight_[k] * momentum + moment * slope_.col(static_cast<Eigen::Index>(k));
    p[at(k)] = of_star.x();
    p[at(k) + 1] = of_star.y();
  }
}

void OnefoldCover::add_weight(const Vec2& g, std::span<double> f) const {
  for (std::size_t k = 0; k < 3; ++k) {
    f[at(k)] += weight_[k] * mass_ * g.x();
    f[at(k) + 1] += weight_[k] * mass_ * g.y();
  }
}

double OnefoldCover::kinetic_energy(std::span<const double> v) const {
  const Mat2 G = gradient(v);
  return 0.5 * mass_ * centre(v).squaredNorm() + 0.5 * (G * second_ * G.transpose()).trace();
}

double OnefoldCover::compliance(const Row& row) const {
  const Vec2 X = point(row);
  const double weight = row.w[0] + row.w[1] + row.w[2];
  return weight * weight / mass_ + X.dot(second_inverse_ * X);
}

ChartRow OnefoldCover::chart_row(const Row& row) const {
  return form_.chart_row(row.w[0] + row.w[1] + row.w[2], point(row));
}

void OnefoldCover::rates(std::span<const double> v, std::span<double> rate) const {
  form_.unknowns(centre(v), gradient(v), rate);
}

void OnefoldCover::retract(std::span<const double> d, std::span<const double> rate, std::span<double> q,
                           std::span<double> v) const {
  const Vec2 dc = AffineForm::translation(d);
  const Mat2 dF = form_.gradient(d);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec2 u = dc + dF * star_[k];
    q[at(k)] += u.x();
    q[at(k) + 1] += u.y();
  }
  place(AffineForm::translation(rate), form_.gradient(rate), v);
}

Mat6 OnefoldCover::star_map() const {
  Mat6 B = Mat6::Zero();
  for (int k = 0; k < 3; ++k)
    for (int d = 0; d < 2; ++d) {
      const Vec2& X = star_[static_cast<std::size_t>(k)];
      B(2 * k + d, d) = 1.0;
      B(2 * k + d, 2 + d) = X.x() / form_.length();
      B(2 * k + d, 4 + d) = X.y() / form_.length();
    }
  return B;
}

Mat6 OnefoldCover::star_mass() const {
  Mat6 M = Mat6::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const double m = mass_ * weight_[static_cast<std::size_t>(i)] * weight_[static_cast<std::size_t>(j)] +
                       slope_.col(i).dot(second_ * slope_.col(j));
      M(2 * i, 2 * j) = M(2 * i + 1, 2 * j + 1) = m;
    }
  return M;
}

}  // namespace scree::nmm
