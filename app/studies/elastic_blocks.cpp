#include "app/studies/elastic_blocks.h"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/dense_algebra.h"
#include "model/elasticity.h"

namespace scree::app {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd, Eigen::RowVectorXd;

/// Gauss-Legendre points and weights on [0, 1], exact to degree 15: for products of polynomials of degree 7.
constexpr std::array<std::array<double, 2>, 8> kGauss{{{0.0198550717512319, 0.0506142681451882},
                                                       {0.1016667612931866, 0.1111905172266873},
                                                       {0.2372337950418355, 0.1568533229389437},
                                                       {0.4082826787521751, 0.1813418916891810},
                                                       {0.5917173212478249, 0.1813418916891810},
                                                       {0.7627662049581645, 0.1568533229389437},
                                                       {0.8983332387068134, 0.1111905172266873},
                                                       {0.9801449282487682, 0.0506142681451882}}};

/// One block as modes of its own: displacement at a point is row(x) q for either direction.
class RitzBlock {
 public:
  explicit RitzBlock(const ElasticBlocks& e) : degree_(e.degree) {
    const Moments m = moments({e.shape, {}});
    centre_ = m.centroid;
    for (const Vec2& x : e.shape) length_ = std::max(length_, (x - centre_).norm());
    const Eigen::Index n = 2 * terms();
    MatrixXd mass = MatrixXd::Zero(n, n), stiffness = mass;
    const Elasticity law = Elasticity::from(e.young, e.poisson, Plane::strain);
    const double g = law.mu, lambda = law.lambda;
    for (std::size_t i = 1; i + 1 < e.shape.size(); ++i) {  // triangles of a fan, each as a collapsed square
      const Vec2 a = e.shape[0], b = e.shape[i] - a, c = e.shape[i + 1] - a;
      const double area2 = b.x() * c.y() - b.y() * c.x();
      for (const auto& [r, wr] : kGauss)
        for (const auto& [s, ws] : kGauss) {
          const double w = wr * ws * r * area2;
          const Vec2 x = a + r * ((1.0 - s) * b + s * c);
          const MatrixXd u = displacement(x);
          mass += w * e.density * u.transpose() * u;
          const MatrixXd d = gradient(x);  // rows xx, xy, yx, yy
          const RowVectorXd volume = d.row(0) + d.row(3), shear = d.row(1) + d.row(2);
          stiffness += w * (lambda * volume.transpose() * volume + g * shear.transpose() * shear +
                            2.0 * g * (d.row(0).transpose() * d.row(0) + d.row(3).transpose() * d.row(3)));
        }
    }
    const Modes own = generalized_modes(stiffness, mass);
    modes_ = own.vectors;
    square_ = own.values;
    square_.head(3).setZero();  // the rigid motions
    load_ = MatrixXd(2, n);
    for (const int k : {0, 1}) load_.row(k) = displacement(centre_).row(k) * mass * modes_;
  }

  [[nodiscard]] const VectorXd& square() const { return square_; }  // of the natural frequencies
  /// Modal force of a uniform acceleration, rows x and y.
  [[nodiscard]] const MatrixXd& load() const { return load_; }
  [[nodiscard]] Vec2 centre() const { return centre_; }
  [[nodiscard]] MatrixXd modes_at(const Vec2& x) const { return displacement(x) * modes_; }

 private:
  [[nodiscard]] Eigen::Index terms() const { return (degree_ + 1) * (degree_ + 2) / 2; }
  /// x^i y^j by increasing degree, and derivatives.
  template <class Take>
  void monomials(const Vec2& x, const Take& take) const {
    const Vec2 z = (x - centre_) / length_;
    Eigen::Index k = 0;
    for (int n = 0; n <= degree_; ++n)
      for (int j = 0; j <= n; ++j, ++k) {
        const int i = n - j;
        const double xi = std::pow(z.x(), i), yj = std::pow(z.y(), j);
        take(k, xi * yj, i == 0 ? 0.0 : i * std::pow(z.x(), i - 1) * yj / length_,
             j == 0 ? 0.0 : j * xi * std::pow(z.y(), j - 1) / length_);
      }
  }
  [[nodiscard]] MatrixXd displacement(const Vec2& x) const {
    MatrixXd u = MatrixXd::Zero(2, 2 * terms());
    monomials(x, [&](Eigen::Index k, double v, double, double) { u(0, k) = u(1, terms() + k) = v; });
    return u;
  }
  [[nodiscard]] MatrixXd gradient(const Vec2& x) const {
    MatrixXd d = MatrixXd::Zero(4, 2 * terms());
    monomials(x, [&](Eigen::Index k, double, double dx, double dy) {
      d(0, k) = d(2, terms() + k) = dx;
      d(1, k) = d(3, terms() + k) = dy;
    });
    return d;
  }

  int degree_;
  Vec2 centre_;
  double length_ = 0.0;
  MatrixXd modes_, load_;
  VectorXd square_;
};

struct Point {
  int below = -1, above = 0;  // blocks; -1: the plane
  VectorXd n_below, s_below, n_above, s_above;
  double k = 0.0, c = 0.0, friction = 0.0;
  double stretch = 0.0;
  int slips = 0;  // -1: down the plane
};

std::vector<Point> contacts(const ElasticBlocks& e, const RitzBlock& block) {
  std::vector<Point> out;
  const Box box = bounds({e.shape, {}});
  const auto side = [&](int below, int above, const Vec2& on_below, const Vec2& on_above, const Vec2& along,
                        const Vec2& normal, double friction, double stiffness) {
    const double length = along.norm();
    const Vec2 tangent = along / length;
    for (int i = 0; i < e.points; ++i) {
      const double f = static_cast<double>(i) / (e.points - 1);
      Point p;
      p.below = below;
      p.above = above;
      const MatrixXd a = block.modes_at(on_above + f * along), b = block.modes_at(on_below + f * along);
      p.n_above = a.transpose() * normal;
      p.s_above = a.transpose() * tangent;
      p.n_below = b.transpose() * normal;
      p.s_below = b.transpose() * tangent;
      p.k = stiffness * length / (e.points - 1) * (i == 0 || i + 1 == e.points ? 0.5 : 1.0);
      const double flexibility = p.n_above.squaredNorm() + (below < 0 ? 0.0 : p.n_below.squaredNorm());
      p.c = 2.0 * e.damping * std::sqrt(p.k / flexibility);
      p.friction = friction;
      out.push_back(std::move(p));
    }
  };
  const Vec2 wide(box.hi.x() - box.lo.x(), 0.0), high(0.0, box.hi.y() - box.lo.y());
  const auto id = [&](int i, int j) { return i * e.stack + j; };
  for (int i = 0; i < e.row; ++i)
    for (int j = 0; j < e.stack; ++j) {
      if (j == 0) side(-1, id(i, j), box.lo, box.lo, wide, Vec2(0, 1), e.friction_plane, e.stiffness_plane);
      if (j > 0)
        side(id(i, j - 1), id(i, j), box.lo + high, box.lo, wide, Vec2(0, 1), e.friction_between, e.stiffness_stack);
      if (i > 0)
        side(id(i - 1, j), id(i, j), box.lo + wide, box.lo, high, Vec2(1, 0), e.friction_between, e.stiffness_row);
    }
  return out;
}

}  // namespace

std::vector<double> elastic_ways(const ElasticBlocks& e, const std::function<Vec2(double)>& acceleration, double from,
                                 double end, double fraction) {
  const RitzBlock block(e);
  std::vector<Point> points = contacts(e, block);
  const auto blocks = static_cast<std::size_t>(e.row) * static_cast<std::size_t>(e.stack);
  const Eigen::Index n = block.square().size();
  std::vector<VectorXd> q(blocks, VectorXd::Zero(n)), v = q, f = q;
  // The stable step of kick and drift: of the stiffest mode, all contacts closed, dashpots and springs.
  double k_of_contacts = 0.0, c_of_contacts = 0.0;
  for (const Point& p : points) {
    const double flexibility = p.n_above.squaredNorm() + p.s_above.squaredNorm();
    k_of_contacts = std::max(k_of_contacts, p.k * flexibility * e.points);
    c_of_contacts = std::max(c_of_contacts, p.c * flexibility);
  }
  const double w2 = block.square()(n - 1) + k_of_contacts;
  const double bound = (std::sqrt(c_of_contacts * c_of_contacts + 4.0 * w2) - c_of_contacts) / w2;
  const auto steps = static_cast<std::int64_t>(std::ceil(end / (fraction * bound)));
  const double h = end / static_cast<double>(steps), rate = 2.0 * e.sliding_damping * std::sqrt(block.square()(3));
  const double period = 2.0 * std::numbers::pi / std::sqrt(block.square()(3));
  std::vector<double> slid(blocks, -period);  // when a contact of the block slipped down the plane last
  const VectorXd at_centre = block.modes_at(block.centre()).row(0);
  std::vector<double> begin(blocks, 0.0), out(blocks);
  for (std::int64_t step = 0; step < steps; ++step) {
    const double t = static_cast<double>(step) * h;
    if (t <= from)
      for (std::size_t b = 0; b < blocks; ++b) begin[b] = at_centre.dot(q[b]);
    const Vec2 a = acceleration(t);
    for (std::size_t b = 0; b < blocks; ++b) f[b] = block.load().transpose() * a - block.square().cwiseProduct(q[b]);
    for (Point& p : points) {
      const VectorXd& qa = q[static_cast<std::size_t>(p.above)];
      const VectorXd& va = v[static_cast<std::size_t>(p.above)];
      double gap = p.n_above.dot(qa), gap_rate = p.n_above.dot(va), slip_rate = p.s_above.dot(va);
      if (p.below >= 0) {
        const VectorXd& qb = q[static_cast<std::size_t>(p.below)];
        const VectorXd& vb = v[static_cast<std::size_t>(p.below)];
        gap -= p.n_below.dot(qb);
        gap_rate -= p.n_below.dot(vb);
        slip_rate -= p.s_below.dot(vb);
      }
      const double normal = gap < 0.0 ? std::max(0.0, -p.k * gap - p.c * gap_rate) : 0.0;
      const double most = p.friction * normal / p.k;
      p.stretch += h * slip_rate;
      const bool slips = std::abs(p.stretch) >= most;
      p.stretch = std::clamp(p.stretch, -most, most);
      const double shear = -p.k * p.stretch;
      f[static_cast<std::size_t>(p.above)] += normal * p.n_above + shear * p.s_above;
      if (p.below >= 0) f[static_cast<std::size_t>(p.below)] -= normal * p.n_below + shear * p.s_below;
      if (slips && normal > 0.0 && p.below < 0 && slip_rate < 0.0) slid[static_cast<std::size_t>(p.above)] = t;
    }
    for (std::size_t b = 0; b < blocks; ++b) {
      v[b] += h * f[b];
      if (t - slid[b] < period) v[b].tail(n - 3) /= 1.0 + rate * h;
      q[b] += h * v[b];
    }
  }
  for (std::size_t b = 0; b < blocks; ++b) out[b] = begin[b] - at_centre.dot(q[b]);
  return out;
}

}  // namespace scree::app
