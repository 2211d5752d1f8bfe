#include "nmm/affine_mass.h"

#include <Eigen/Dense>

#include "model/parallel.h"

namespace scree::nmm {
namespace {

Eigen::Vector3d basis(const Vec2& X) { return {1.0, X.x(), X.y()}; }

Vec2 at(std::span<const double> v, std::size_t node) { return {v[2 * node], v[2 * node + 1]}; }

}  // namespace

bool AffineMass::make(const CoverMesh& mesh, const ReferenceShape& shape, std::int32_t first) {
  first_ = first;
  X_ = mesh.star;
  ties_ = mesh.ties;
  tie_of_.assign(X_.size(), -1);
  for (std::size_t t = 0; t < ties_.size(); ++t)
    tie_of_[static_cast<std::size_t>(ties_[t].cover)] = static_cast<std::int32_t>(t);

  double area = 0.0;
  for (const Element& e : mesh.elements) area += e.area;
  const double density = shape.mass / area;
  std::vector<double> raw(X_.size(), 0.0);
  for (const Element& e : mesh.elements) {
    const auto w = e.weights(e.centroid);  // weights are linear: their integral is the area times the mean
    for (std::size_t k = 0; k < 3; ++k) raw[static_cast<std::size_t>(e.cover[k])] += density * e.area * w[k];
  }
  lumped_ = raw;  // row sums of C^T M C are C^T m, because C 1 = 1
  for (const Tie& t : ties_) {
    lumped_[static_cast<std::size_t>(t.cover)] = 0.0;
    for (std::size_t k = 0; k < 3; ++k)
      lumped_[static_cast<std::size_t>(t.root[k])] += t.w[k] * raw[static_cast<std::size_t>(t.cover)];
  }
  Eigen::Matrix3d hat = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < X_.size(); ++k) {
    if (tie_of_[k] >= 0) continue;
    if (!(lumped_[k] > 0.0)) return false;
    hat += lumped_[k] * basis(X_[k]) * basis(X_[k]).transpose();
  }
  Eigen::Matrix3d exact = Eigen::Matrix3d::Zero();
  exact(0, 0) = shape.mass;
  exact.bottomRightCorner<2, 2>() = shape.second;
  const Eigen::Matrix3d hat_inverse = hat.inverse(), exact_inverse = exact.inverse();
  inverse_correction_ = exact_inverse - hat_inverse;
  hat_inverse_ = hat_inverse;
  correction_ = hat_inverse * (hat - exact) * hat_inverse;
  theta_ =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix3d>(hat, exact, Eigen::EigenvaluesOnly).eigenvalues()(2);
  const Eigen::Vector3d y = hat_inverse * exact.col(0);
  unit_.assign(X_.size(), 0.0);
  for (std::size_t k = 0; k < X_.size(); ++k) unit_[k] = lumped_[k] * basis(X_[k]).dot(y);
  return true;
}

AffineMass::Moments3 AffineMass::projection(std::span<const double> v, bool weighted) const {
  const auto count = static_cast<std::int64_t>(X_.size()), chunks = (count + kChunk - 1) / kChunk;
  partial_.resize(static_cast<std::size_t>(chunks));
  parallel_for_chunks(count, [&](std::int64_t begin, std::int64_t end) {
    Moments3 z = Moments3::Zero();
    for (auto k = static_cast<std::size_t>(begin); k < static_cast<std::size_t>(end); ++k) {
      if (tie_of_[k] >= 0) continue;
      const Vec2 a = weighted ? Vec2(lumped_[k] * at(v, static_cast<std::size_t>(first_) + k))
                              : at(v, static_cast<std::size_t>(first_) + k);
      z.row(0) += a.transpose();
      z.row(1) += X_[k].x() * a.transpose();
      z.row(2) += X_[k].y() * a.transpose();
    }
    partial_[static_cast<std::size_t>(begin / kChunk)] = z;
  });
  Moments3 sum = Moments3::Zero();
  for (const Moments3& z : partial_) sum += z;
  return sum;
}

void AffineMass::solve(std::span<const double> f, std::span<double> a) const {
  const auto first = static_cast<std::size_t>(first_);
  const auto count = static_cast<std::int64_t>(X_.size());
  parallel_for(count, [&](std::int64_t k) {
    const std::size_t i = 2 * (first + static_cast<std::size_t>(k));
    a[i] = f[i];
    a[i + 1] = f[i + 1];
  });
  for (const Tie& t : ties_)
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t d = 0; d < 2; ++d)
        a[2 * (first + static_cast<std::size_t>(t.root[k])) + d] +=
            t.w[k] * f[2 * (first + static_cast<std::size_t>(t.cover)) + d];
  const Moments3 z = inverse_correction_ * projection(a, false);
  parallel_for(count, [&](std::int64_t n) {
    const auto k = static_cast<std::size_t>(n);
    if (tie_of_[k] >= 0) return;
    const std::size_t i = 2 * (first + k);
    const double inverse = 1.0 / lumped_[k];
    a[i] = a[i] * inverse + z(0, 0) + X_[k].x() * z(1, 0) + X_[k].y() * z(2, 0);
    a[i + 1] = a[i + 1] * inverse + z(0, 1) + X_[k].x() * z(1, 1) + X_[k].y() * z(2, 1);
  });
  for (const Tie& t : ties_)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0.0;
      for (std::size_t k = 0; k < 3; ++k) sum += t.w[k] * a[2 * (first + static_cast<std::size_t>(t.root[k])) + d];
      a[2 * (first + static_cast<std::size_t>(t.cover)) + d] = sum;
    }
}

void AffineMass::apply(std::span<const double> v, std::span<double> p) const {
  const Moments3 z = correction_ * projection(v, true);
  for (std::size_t k = 0; k < X_.size(); ++k) {
    const std::size_t i = 2 * (static_cast<std::size_t>(first_) + k);
    for (std::size_t d = 0; d < 2; ++d)
      p[i + d] = lumped_[k] * (v[i + d] - z(0, int(d)) - X_[k].x() * z(1, int(d)) - X_[k].y() * z(2, int(d)));
  }
}

double AffineMass::kinetic_energy(std::span<const double> v) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < X_.size(); ++k)
    sum += lumped_[k] * at(v, static_cast<std::size_t>(first_) + k).squaredNorm();
  const Moments3 z = projection(v, true);
  return 0.5 * (sum - (z.transpose() * correction_ * z).trace());
}

void AffineMass::damp(double factor, double rate, std::span<double> v, std::span<double> f, std::span<double> a) const {
  const Moments3 z = hat_inverse_ * projection(v, true);
  parallel_for(static_cast<std::int64_t>(X_.size()), [&](std::int64_t n) {
    const auto k = static_cast<std::size_t>(n);
    const std::size_t i = 2 * (static_cast<std::size_t>(first_) + k);
    for (std::size_t d = 0; d < 2; ++d) {
      const auto c = static_cast<Eigen::Index>(d);
      const double affine = z(0, c) + X_[k].x() * z(1, c) + X_[k].y() * z(2, c), w = factor * (v[i + d] - affine);
      v[i + d] = affine + w;
      f[i + d] = -rate * lumped_[k] * w;  // P^T M_L w = 0, so M~ w = M_L w
      a[i + d] -= rate * w;
    }
  });
}

void AffineMass::add_weight(const Vec2& g, std::span<double> f) const {
  for (std::size_t k = 0; k < X_.size(); ++k) {
    const std::size_t i = 2 * (static_cast<std::size_t>(first_) + k);
    f[i] += unit_[k] * g.x();
    f[i + 1] += unit_[k] * g.y();
  }
}

void AffineMass::fold(const Row& row, std::vector<std::pair<std::int32_t, double>>& folded) const {
  folded.clear();
  const auto add = [&](std::int32_t cover, double w) {
    for (auto& [c, sum] : folded)
      if (c == cover) {
        sum += w;
        return;
      }
    folded.emplace_back(cover, w);
  };
  for (std::size_t k = 0; k < 3; ++k) {
    const std::int32_t local = row.node[k] - first_;
    if (const std::int32_t t = tie_of_[static_cast<std::size_t>(local)]; t >= 0) {
      const Tie& tie = ties_[static_cast<std::size_t>(t)];
      for (std::size_t m = 0; m < 3; ++m) add(tie.root[m], row.w[k] * tie.w[m]);
    } else {
      add(local, row.w[k]);
    }
  }
}

}  // namespace scree::nmm
