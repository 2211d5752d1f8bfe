#include "nmm/consistent_mass.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <stdexcept>

#include "model/dense_algebra.h"
#include "model/parallel.h"

namespace scree::nmm {
namespace {

/// The affine map after which the pieces together have the centroid 0 and the second moment of the block.
struct Correction {
  Vec2 from;
  Mat2 A;
};

Correction correction(std::span<const MassElement> elements, double density, const Mat2& second) {
  double area = 0.0;
  Vec2 first = Vec2::Zero();
  for (const MassElement& e : elements) {
    area += e.material.area;
    first += e.material.area * e.material.centroid;
  }
  const Vec2 centre = first / area;
  Mat2 S = Mat2::Zero();
  for (const MassElement& e : elements) {
    const Vec2 r = e.material.centroid - centre;
    S += density * (e.material.second + e.material.area * r * r.transpose());
  }
  const Mat2 L_to = cholesky_factor(second), L_from = cholesky_factor(S);
  return {centre, L_to * L_from.inverse()};
}

}  // namespace

struct ConsistentMass::Factor {
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t>> ldlt;
  Eigen::MatrixX2d rhs;
};

ConsistentMass::ConsistentMass() = default;
ConsistentMass::ConsistentMass(ConsistentMass&&) noexcept = default;
ConsistentMass& ConsistentMass::operator=(ConsistentMass&&) noexcept = default;
ConsistentMass::~ConsistentMass() = default;

void ConsistentMass::make(const FoldedElements& folded, std::span<const MassElement> elements,
                          std::span<const Vec2> star, double density, const Mat2* second, std::int32_t first) {
  first_ = first;
  star_.assign(star.begin(), star.end());
  chart_ = folded.chart();
  const Correction moved =
      second == nullptr ? Correction{Vec2::Zero(), Mat2::Identity()} : correction(elements, density, *second);

  const auto free = static_cast<std::size_t>(folded.free_covers());
  element_.resize(elements.size());
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  std::array<double, 45> lower{};
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const MassElement& e = elements[i];
    const Vec2 shift = moved.A * (e.material.centroid - moved.from) - e.material.centroid;
    const Eigen::Vector3d w = Eigen::Vector3d(e.weight[0], e.weight[1], e.weight[2]) + e.gradient.transpose() * shift;
    const Mat2 S = density * moved.A * e.material.second * moved.A.transpose();
    element_[i] = density * e.material.area * w * w.transpose() + e.gradient.transpose() * S * e.gradient;
    element_[i] = 0.5 * (element_[i] + element_[i].transpose()).eval();
    folded.fold(i, element_[i], lower);
    const auto places = folded.places(i);
    std::size_t at = 0;
    for (std::size_t b = 0; b < places.size(); ++b)
      for (std::size_t a = b; a < places.size(); ++a, ++at) {
        entries.emplace_back(places[a], places[b], lower[at]);
        if (a != b) entries.emplace_back(places[b], places[a], lower[at]);
      }
  }
  M_.resize(folded.free_covers(), folded.free_covers());
  M_.setFromTriplets(entries.begin(), entries.end());

  cover_of_.resize(free);
  basis_.assign(free, Eigen::Vector3d::Zero());
  for (std::size_t k = 0; k < free; ++k) {
    cover_of_[k] = folded.cover_of(static_cast<std::int32_t>(k));
  }
  Mat3 PMP = Mat3::Zero();
  row_sum_.assign(star.size(), 0.0);
  for (std::size_t k = 0; k < free; ++k) {
    for (decltype(M_)::InnerIterator it(M_, static_cast<Eigen::Index>(k)); it; ++it)
      basis_[k] +=
          it.value() * affine_basis(star[static_cast<std::size_t>(cover_of_[static_cast<std::size_t>(it.col())])]);
    PMP += basis_[k] * affine_basis(star[static_cast<std::size_t>(cover_of_[k])]).transpose();
    row_sum_[static_cast<std::size_t>(cover_of_[k])] = basis_[k][0];
  }
  inverse_ = (0.5 * (PMP + PMP.transpose())).inverse();
  factor_.reset();
}

void ConsistentMass::solve(std::span<const double> f, std::span<double> a) const {
  if (!factor_) {
    factor_ = std::make_unique<Factor>();
    factor_->ldlt.compute(M_);
    if (factor_->ldlt.info() != Eigen::Success) throw std::runtime_error("the consistent mass could not be factorised");
  }
  const auto first = static_cast<std::size_t>(first_);
  Eigen::MatrixX2d& rhs = factor_->rhs;
  rhs.resize(static_cast<Eigen::Index>(cover_of_.size()), 2);
  const std::size_t size = 2 * star_.size();
  const auto own = f.subspan(2 * first, size);
  std::vector<double> whole(own.begin(), own.end());
  chart_.fold_forces(whole);
  for (std::size_t k = 0; k < cover_of_.size(); ++k)
    rhs.row(static_cast<Eigen::Index>(k)) = node(whole, cover_of_[k]).transpose();
  const Eigen::MatrixX2d x = factor_->ldlt.solve(rhs);
  for (std::size_t k = 0; k < cover_of_.size(); ++k)
    for (std::size_t d = 0; d < 2; ++d)
      a[2 * (first + static_cast<std::size_t>(cover_of_[k])) + d] =
          x(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(d));
  chart_.follow(a.subspan(2 * first, size));
}

void ConsistentMass::apply(std::span<const double> v, std::span<double> p) const {
  const auto first = static_cast<std::size_t>(first_);
  for (const Tie& t : chart_.ties())
    for (std::size_t d = 0; d < 2; ++d) p[2 * (first + static_cast<std::size_t>(t.cover)) + d] = 0.0;
  parallel_for(static_cast<std::int64_t>(cover_of_.size()), [&](std::int64_t k) {
    Vec2 sum = Vec2::Zero();
    for (decltype(M_)::InnerIterator it(M_, k); it; ++it) {
      const std::size_t i = 2 * (first + static_cast<std::size_t>(cover_of_[static_cast<std::size_t>(it.col())]));
      sum += it.value() * Vec2(v[i], v[i + 1]);
    }
    const std::size_t i = 2 * (first + static_cast<std::size_t>(cover_of_[static_cast<std::size_t>(k)]));
    p[i] = sum.x();
    p[i + 1] = sum.y();
  });
}

double ConsistentMass::kinetic_energy(std::span<const double> v) const {
  std::vector<double> partial;
  const auto first = static_cast<std::size_t>(first_);
  const double twice =
      parallel_sum(static_cast<std::int64_t>(cover_of_.size()), partial, [&](std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (std::int64_t k = begin; k < end; ++k) {
          Vec2 p = Vec2::Zero();
          for (decltype(M_)::InnerIterator it(M_, k); it; ++it) {
            const std::size_t i = 2 * (first + static_cast<std::size_t>(cover_of_[static_cast<std::size_t>(it.col())]));
            p += it.value() * Vec2(v[i], v[i + 1]);
          }
          const std::size_t i = 2 * (first + static_cast<std::size_t>(cover_of_[static_cast<std::size_t>(k)]));
          sum += p.x() * v[i] + p.y() * v[i + 1];
        }
        return sum;
      });
  return 0.5 * twice;
}

AffineMoments ConsistentMass::affine_part(std::span<const double> v) const {
  AffineMoments z = AffineMoments::Zero();
  for (std::size_t k = 0; k < cover_of_.size(); ++k) {
    const std::size_t i = 2 * static_cast<std::size_t>(first_ + cover_of_[k]);
    z += basis_[k] * Eigen::RowVector2d(v[i], v[i + 1]);
  }
  return inverse_ * z;
}

double ConsistentMass::damp(double factor, double rate, std::span<const double> along, std::span<double> v,
                            std::span<double> f, std::span<double> a) const {
  const AffineMoments z = affine_part(v);
  const auto first = static_cast<std::size_t>(first_);
  std::vector<double> rest(v.size(), 0.0);
  const auto split = [&](std::size_t cover, const Vec2& X) {
    for (std::size_t d = 0; d < 2; ++d) {
      const std::size_t i = 2 * (first + cover) + d;
      const double affine = affine_basis(X).dot(z.col(static_cast<Eigen::Index>(d)));
      rest[i] = factor * (v[i] - affine);
      v[i] = affine + rest[i];
      a[i] -= rate * rest[i];
    }
  };
  for (std::size_t c = 0; c < star_.size(); ++c) split(c, star_[c]);  // tied covers too: they follow affine fields
  apply(rest, f);
  double power = 0.0;
  for (std::size_t i = 2 * first; i < 2 * (first + star_.size()); ++i) {
    f[i] *= -rate;
    power += f[i] * along[i];
  }
  return power;
}

void ConsistentMass::add_weight(const Vec2& g, std::span<double> f) const {
  for (std::size_t c = 0; c < row_sum_.size(); ++c) {
    const std::size_t i = 2 * (static_cast<std::size_t>(first_) + c);
    f[i] += row_sum_[c] * g.x();
    f[i + 1] += row_sum_[c] * g.y();
  }
}

}  // namespace scree::nmm
