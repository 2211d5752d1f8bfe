#include "nmm/field_projection.h"

#include <Eigen/LU>
#include <Eigen/SparseCholesky>
#include <numeric>
#include <stdexcept>

#include "nmm/cover_chart.h"
#include "nmm/mesh_overlap.h"

namespace scree::nmm {
namespace {

constexpr double kSoft = 1e-6;  // kappa over the P-wave modulus and the square of the block's size

using Weights3 = Eigen::Vector3d;
using Mat6 = Eigen::Matrix<double, 6, 6>;
using Vec6 = Eigen::Matrix<double, 6, 1>;

Weights3 weights_at(const CoverMesh& mesh, std::int32_t e, const Vec2& X) {
  const auto w = mesh.weights(static_cast<std::size_t>(e), X);
  return {w[0], w[1], w[2]};
}
const Gradients& slopes(const CoverMesh& mesh, std::int32_t e) {
  return mesh.shapes[mesh.shape[static_cast<std::size_t>(e)]];
}
const std::array<std::int32_t, 3>& covers(const CoverMesh& mesh, std::int32_t e) {
  return mesh.cover[static_cast<std::size_t>(e)];
}

/// Unknown places of a mesh: free covers; the covers of an interface constraint count once.
class Places {
 public:
  explicit Places(const CoverMesh& mesh) : share_(mesh.star.size()) {
    std::vector<std::int32_t> leader(mesh.star.size());
    std::iota(leader.begin(), leader.end(), 0);
    const auto find = [&](std::int32_t c) {
      while (leader[static_cast<std::size_t>(c)] != c) c = leader[static_cast<std::size_t>(c)];
      return c;
    };
    for (const Pool::InterfaceConstraint& s : mesh.interface_constraints) {
      const std::int32_t a = find(s.explicit_node), b = find(s.implicit_node);
      leader[static_cast<std::size_t>(std::max(a, b))] = std::min(a, b);
    }
    std::vector<const Tie*> tie_of(mesh.star.size(), nullptr);
    for (const Tie& t : mesh.ties) tie_of[static_cast<std::size_t>(t.cover)] = &t;
    std::vector<std::int32_t> number(mesh.star.size(), -1);  // of a leader
    for (std::size_t c = 0; c < mesh.star.size(); ++c) {
      std::int32_t& n = number[static_cast<std::size_t>(find(static_cast<std::int32_t>(c)))];
      if (tie_of[c] == nullptr && n < 0) n = count_++;
    }
    for (std::size_t c = 0; c < mesh.star.size(); ++c) {
      const std::int32_t own = number[static_cast<std::size_t>(find(static_cast<std::int32_t>(c)))];
      if (own >= 0) {
        share_[c].push_back({own, 1.0});
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k)
        share_[c].push_back({number[static_cast<std::size_t>(find(tie_of[c]->root[k]))], tie_of[c]->w[k]});
    }
  }
  [[nodiscard]] std::int32_t count() const { return count_; }
  /// The unknowns that represent a cover.
  [[nodiscard]] std::span<const Share> of(std::int32_t cover) const { return share_[static_cast<std::size_t>(cover)]; }

 private:
  std::int32_t count_ = 0;
  std::vector<std::vector<Share>> share_;
};

/// A field of a mesh about its affine part, value(X) = mean + slope (X - centre) + the rest on the covers.
struct SplitField {
  Vec2 mean = Vec2::Zero();
  Mat2 slope = Mat2::Zero();
  std::vector<double> rest;
};

class Projection {
 public:
  Projection(const CoverMesh& from, const CoverMesh& to)
      : from_(from), to_(to), places_(to), common_(overlaps(from, to)) {
    for (const Overlap& o : common_) {
      area_ += o.common.area;
      centre_ += o.common.area * o.common.centroid;
    }
    centre_ /= area_;
    for (const Overlap& o : common_) {
      const Vec2 r = o.common.centroid - centre_;
      second_ += o.common.second + o.common.area * r * r.transpose();
    }
    make_mass();
  }

  [[nodiscard]] SplitField split(std::span<const double> field) const;
  /// Unknowns of the projection in the mass.
  [[nodiscard]] Eigen::MatrixX2d in_mass(const SplitField& field) const;
  /// Unknowns of the projection in the elastic energy of displacements that are small apart from the rotation R.
  [[nodiscard]] Eigen::MatrixX2d in_energy(const SplitField& field, const Elasticity& law, const Mat2& R) const;
  /// Writes the covers of `to` from the affine part and the unknowns.
  void write(const SplitField& field, const Eigen::MatrixX2d& rest, std::span<double> out) const;

 private:
  using Sparse = Eigen::SparseMatrix<double, Eigen::ColMajor, std::int32_t>;
  void make_mass();
  /// int w'_i w_j over an overlap.
  [[nodiscard]] static Eigen::Matrix3d products(const CoverMesh& a, std::int32_t e, const CoverMesh& b, std::int32_t f,
                                                const Moments& m) {
    return m.area * weights_at(a, e, m.centroid) * weights_at(b, f, m.centroid).transpose() +
           slopes(a, e).transpose() * m.second * slopes(b, f);
  }
  /// int w' field, one row per unknown.
  [[nodiscard]] Eigen::MatrixX2d moments_of(const SplitField& field) const;

  const CoverMesh &from_, &to_;
  Places places_;
  std::vector<Overlap> common_;
  double area_ = 0.0;
  Vec2 centre_ = Vec2::Zero();
  Mat2 second_ = Mat2::Zero();
  std::vector<Eigen::Triplet<double, std::int32_t>> mass_;  // over unknowns, both triangles
};

void Projection::make_mass() {
  for (std::size_t i = 0; i < common_.size();) {
    const std::int32_t f = common_[i].to;
    Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
    for (; i < common_.size() && common_[i].to == f; ++i) M += products(to_, f, to_, f, common_[i].common);
    const auto& c = covers(to_, f);
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        for (const Share& s : places_.of(c[a]))
          for (const Share& t : places_.of(c[b]))
            mass_.emplace_back(s.cover, t.cover,
                               s.w * t.w * M(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)));
  }
}

SplitField Projection::split(std::span<const double> field) const {
  SplitField out;
  Mat2 moment = Mat2::Zero();
  for (const Overlap& o : common_) {
    const auto& c = covers(from_, o.from);
    const Weights3 w = weights_at(from_, o.from, o.common.centroid);
    Vec2 here = Vec2::Zero();
    Mat2 F = Mat2::Zero();
    for (int k = 0; k < 3; ++k) {
      const Vec2 x = node(field, c[static_cast<std::size_t>(k)]);
      here += w[k] * x;
      F += x * slopes(from_, o.from).col(k).transpose();
    }
    out.mean += o.common.area * here;
    moment += o.common.area * here * (o.common.centroid - centre_).transpose() + F * o.common.second;
  }
  out.mean /= area_;
  out.slope = moment * second_.inverse();
  out.rest.resize(field.size());
  for (std::size_t k = 0; k < from_.star.size(); ++k) {
    const Vec2 rest = node(field, static_cast<std::int32_t>(k)) - out.mean - out.slope * (from_.star[k] - centre_);
    out.rest[2 * k] = rest.x();
    out.rest[2 * k + 1] = rest.y();
  }
  return out;
}

Eigen::MatrixX2d Projection::moments_of(const SplitField& field) const {
  Eigen::MatrixX2d rhs = Eigen::MatrixX2d::Zero(places_.count(), 2);
  for (const Overlap& o : common_) {
    const Eigen::Matrix3d C = products(to_, o.to, from_, o.from, o.common);
    const auto &to = covers(to_, o.to), &from = covers(from_, o.from);
    for (std::size_t a = 0; a < 3; ++a) {
      Vec2 sum = Vec2::Zero();
      for (std::size_t b = 0; b < 3; ++b)
        sum += C(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) * node(field.rest, from[b]);
      for (const Share& s : places_.of(to[a])) rhs.row(s.cover) += s.w * sum.transpose();
    }
  }
  return rhs;
}

Eigen::MatrixX2d Projection::in_mass(const SplitField& field) const {
  Sparse M(places_.count(), places_.count());
  M.setFromTriplets(mass_.begin(), mass_.end());
  const Eigen::SimplicialLDLT<Sparse> ldlt(M);
  if (ldlt.info() != Eigen::Success) throw std::runtime_error("fields could not be put on another mesh");
  return ldlt.solve(moments_of(field));
}

Eigen::MatrixX2d Projection::in_energy(const SplitField& field, const Elasticity& law, const Mat2& R) const {
  const double kappa = kSoft * law.p_modulus() / second_.trace() * area_;
  const std::int32_t n = places_.count();
  std::vector<Eigen::Triplet<double, std::int32_t>> entries;
  for (const auto& m : mass_)
    for (int d = 0; d < 2; ++d) entries.emplace_back(2 * m.row() + d, 2 * m.col() + d, kappa * m.value());
  const Eigen::MatrixX2d soft = kappa * moments_of(field);
  Eigen::VectorXd rhs(2 * n);
  for (std::int32_t k = 0; k < n; ++k) rhs.segment<2>(2 * k) = soft.row(k).transpose();

  // Stiffness for sym(R^T F) in (xx, yy, 2 xy).
  const Eigen::Matrix3d D =
      (Eigen::Matrix3d() << law.p_modulus(), law.lambda, 0.0, law.lambda, law.p_modulus(), 0.0, 0.0, 0.0, law.mu)
          .finished();
  for (std::size_t i = 0; i < common_.size();) {
    const std::int32_t f = common_[i].to;
    Eigen::Matrix<double, 3, 6> B;
    for (int k = 0; k < 3; ++k) {
      const Vec2 g = slopes(to_, f).col(k);
      for (int d = 0; d < 2; ++d) {
        const Mat2 e = R.row(d).transpose() * g.transpose();  // R^T (unit vector d) g^T
        B.col(2 * k + d) << e(0, 0), e(1, 1), e(0, 1) + e(1, 0);
      }
    }
    double area = 0.0;
    Mat2 e = Mat2::Zero();
    for (; i < common_.size() && common_[i].to == f; ++i) {
      const Overlap& o = common_[i];
      area += o.common.area;
      for (int k = 0; k < 3; ++k)
        e += o.common.area * node(field.rest, covers(from_, o.from)[static_cast<std::size_t>(k)]) *
             slopes(from_, o.from).col(k).transpose();
    }
    e = R.transpose() * e;
    const Mat6 K = area * B.transpose() * D * B;
    const Vec6 b = B.transpose() * (D * Eigen::Vector3d(e(0, 0), e(1, 1), e(0, 1) + e(1, 0)));
    const auto& c = covers(to_, f);
    for (int k = 0; k < 6; ++k)
      for (const Share& s : places_.of(c[static_cast<std::size_t>(k / 2)])) {
        rhs[2 * s.cover + k % 2] += s.w * b[k];
        for (int m = 0; m < 6; ++m)
          for (const Share& t : places_.of(c[static_cast<std::size_t>(m / 2)]))
            entries.emplace_back(2 * s.cover + k % 2, 2 * t.cover + m % 2, s.w * t.w * K(k, m));
      }
  }
  Sparse K(2 * n, 2 * n);
  K.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SimplicialLDLT<Sparse> ldlt(K);
  if (ldlt.info() != Eigen::Success) throw std::runtime_error("fields could not be put on another mesh");
  const Eigen::VectorXd x = ldlt.solve(rhs);
  Eigen::MatrixX2d out(n, 2);
  for (std::int32_t k = 0; k < n; ++k) out.row(k) = x.segment<2>(2 * k).transpose();
  return out;
}

void Projection::write(const SplitField& field, const Eigen::MatrixX2d& rest, std::span<double> out) const {
  for (std::size_t c = 0; c < to_.star.size(); ++c) {
    Vec2 value = field.mean + field.slope * (to_.star[c] - centre_);
    for (const Share& s : places_.of(static_cast<std::int32_t>(c))) value += s.w * rest.row(s.cover).transpose();
    out[2 * c] = value.x();
    out[2 * c + 1] = value.y();
  }
}

}  // namespace

void project_motion(const MovingMesh& from, const CoverMesh& to, const Elasticity& law, Kinematics kinematics,
                    std::span<double> q, std::span<double> v) {
  const Projection projection(*from.mesh, to);
  const SplitField position = projection.split(from.q), velocity = projection.split(from.v);
  const Mat2 R = kinematics == Kinematics::linear ? Mat2::Identity().eval() : polar_rotation(position.slope);
  projection.write(position, projection.in_energy(position, law, R), q);
  projection.write(velocity, projection.in_mass(velocity), v);
}

}  // namespace scree::nmm
