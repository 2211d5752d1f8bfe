#include "coupling/integrate/deformation_damping.h"

#include <Eigen/LU>
#include <algorithm>

#include "coupling/integrate/sliding_damping.h"

namespace scree::coupling {
namespace {

/// True if the rigid motions R of a body are its first three unknowns and no others, as in Shi's form: C, the
/// complement of their mass, has rows of the others only.
bool leave_rigid_unknowns(const Eigen::Ref<const Eigen::MatrixX3d>& R) {
  constexpr double kRoundOff = 1e-12;
  return R.bottomRows(R.rows() - 3).cwiseAbs().maxCoeff() <= kRoundOff * R.cwiseAbs().maxCoeff();
}

}  // namespace

DeformationDamping::DeformationDamping(const Setup& setup, const ImplicitSystem& system)
    : setup_(&setup), system_(&system) {
  product_.assign(static_cast<std::size_t>(system.dofs()), 0.0);
}

void DeformationDamping::multiply(const Damped& b, double factor, std::span<const double> x,
                                  std::span<double> y) const {
  const SymmetricPattern& p = system_->pattern();
  const std::span<const double> M = system_->mass();
  for (std::size_t c = b.first; c < b.first + b.count; ++c) {
    double sum = 0.0;
    for (auto k = static_cast<std::size_t>(p.column_start[c]); k < static_cast<std::size_t>(p.column_start[c + 1]);
         ++k) {
      const auto r = static_cast<std::size_t>(p.row[k]);
      sum += M[k] * x[r];
      if (r != c) y[r] += factor * M[k] * x[c];
    }
    y[c] += factor * sum;
  }
}

void DeformationDamping::find(std::span<const double> q, std::span<const double> rates, double factor) {
  clear();
  factor_ = factor;
  momenta_.clear();
  for (auto* v : {&x_, &y_, &turn_}) v->resize(q.size());
  rates_.resize(product_.size());
  const SymmetricPattern& pattern = system_->pattern();
  for (std::size_t i = 0; i < rates.size(); ++i) {
    if (rates[i] == 0.0) continue;
    const Body& body = setup_->bodies()[i];
    const Pool& pool = setup_->pool_of(body);
    const auto p = static_cast<std::size_t>(body.pool);
    Damped b;
    b.first = static_cast<std::size_t>(system_->first_dof(i));
    b.count = static_cast<std::size_t>(pool.dofs(body.index));
    b.rate = rates[i];
    b.full = static_cast<std::size_t>(pattern.column_start[b.first + b.count] - pattern.column_start[b.first]) ==
             b.count * (b.count + 1) / 2;
    b.momenta = momenta_.size();
    momenta_.resize(b.momenta + 3 * b.count, 0.0);
    rigid_motions(*setup_, body, q, x_, y_, turn_);
    motion_.resize(std::max(motion_.size(), 3 * b.count));
    Eigen::Map<Eigen::MatrixX3d> R(motion_.data(), static_cast<Eigen::Index>(b.count), 3);
    const std::array motions{&x_, &y_, &turn_};
    for (std::size_t j = 0; j < 3; ++j) {
      const auto rate = std::span(rates_).subspan(b.first, b.count);
      pool.rates(body.index, setup_->part(q, p), setup_->part(std::span<const double>(*motions[j]), p), rate);
      R.col(static_cast<Eigen::Index>(j)) =
          Eigen::Map<const Eigen::VectorXd>(rate.data(), static_cast<Eigen::Index>(b.count));
      std::fill_n(product_.begin() + static_cast<std::ptrdiff_t>(b.first), b.count, 0.0);
      multiply(b, 1.0, rates_, product_);
      std::copy_n(product_.begin() + static_cast<std::ptrdiff_t>(b.first), b.count,
                  momenta_.begin() + static_cast<std::ptrdiff_t>(b.momenta + j * b.count));
    }
    const Eigen::Map<const Eigen::MatrixX3d> Z(&momenta_[b.momenta], static_cast<Eigen::Index>(b.count), 3);
    const Eigen::Matrix3d G = R.transpose() * Z;
    b.inverse = G.inverse();
    if (b.full && leave_rigid_unknowns(R)) {
      // Kept, the rows of the rigid motions would be round-off of a M: a force, where a is large.
      for (std::size_t j = 0; j < 3; ++j)
        std::copy_n(momenta_.begin() + static_cast<std::ptrdiff_t>(b.momenta + j * b.count + 3), b.count - 3,
                    momenta_.begin() + static_cast<std::ptrdiff_t>(b.momenta + j * (b.count - 3)));
      b.first += 3;
      b.count -= 3;
      momenta_.resize(b.momenta + 3 * b.count);
    }
    bodies_.push_back(b);
  }
  for (const Damped& b : bodies_)
    if (!b.full) terms_.push_back({b.first, b.count, &momenta_[b.momenta], factor * b.rate * b.inverse});
}

void DeformationDamping::add_matrix(std::span<double> A) const {
  const SymmetricPattern& p = system_->pattern();
  for (const Damped& b : bodies_) {
    const double scale = factor_ * b.rate;
    const auto begin = static_cast<std::size_t>(p.column_start[b.first]),
               end = static_cast<std::size_t>(p.column_start[b.first + b.count]);
    for (std::size_t k = begin; k < end; ++k) A[k] += scale * system_->mass()[k];
    if (!b.full) continue;
    const Eigen::Map<const Eigen::MatrixX3d> Z(&momenta_[b.momenta], static_cast<Eigen::Index>(b.count), 3);
    for (std::size_t c = 0; c < b.count; ++c) {
      const Eigen::Vector3d w = scale * (b.inverse * Z.row(static_cast<Eigen::Index>(c)).transpose());
      for (auto k = static_cast<std::size_t>(p.column_start[b.first + c]);
           k < static_cast<std::size_t>(p.column_start[b.first + c + 1]); ++k) {
        const auto r = p.row[k] - static_cast<Eigen::Index>(b.first);
        A[k] -= Z(r, 0) * w(0) + Z(r, 1) * w(1) + Z(r, 2) * w(2);
      }
    }
  }
}

void DeformationDamping::add_force(double factor, std::span<const double> rate, std::span<double> out) const {
  for (const Damped& b : bodies_) {
    const double scale = factor * b.rate;
    multiply(b, scale, rate, out);
    const Eigen::Map<const Eigen::MatrixX3d> Z(&momenta_[b.momenta], static_cast<Eigen::Index>(b.count), 3);
    const auto of_rate = Eigen::Map<const Eigen::VectorXd>(rate.data() + b.first, static_cast<Eigen::Index>(b.count));
    const Eigen::Vector3d z = scale * (b.inverse * (Z.transpose() * of_rate));
    Eigen::Map<Eigen::VectorXd> y(out.data() + b.first, static_cast<Eigen::Index>(b.count));
    for (Eigen::Index k = 0; k < y.size(); ++k) y(k) -= Z(k, 0) * z(0) + Z(k, 1) * z(1) + Z(k, 2) * z(2);
  }
}

}  // namespace scree::coupling
