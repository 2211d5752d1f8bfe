#include "nmm/edge_holds.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <map>

#include "model/dense_algebra.h"

namespace scree::nmm {
namespace {

/// gamma = kGamma (lambda + 2 mu)/h. Coercive if gamma > L/A of an element whose covers are free: 4.6/h for a chord
/// of h over half a triangle; the extrapolation of tied covers requires more.
constexpr double kGamma = 20.0;

/// Displacement from the anchors at the ends.
struct Strays {
  Vec2 a, b;
};
Strays strays(const EdgeHold& h, const std::array<Vec2, 3>& x) {
  Strays w{-h.at0 - h.shift0, -h.at1 - h.shift1};
  for (std::size_t k = 0; k < 3; ++k) {
    w.a += h.w0[k] * x[k];
    w.b += h.w1[k] * x[k];
  }
  return w;
}

Mat2 gradient_of(const StiffElement& e, const std::array<Vec2, 3>& x) {
  Mat2 F = Mat2::Zero();
  for (int k = 0; k < 3; ++k) F += x[static_cast<std::size_t>(k)] * e.gradient.col(k).transpose();
  return F;
}

Tangent tangent_of(const StiffElement& e, const Mat2& F) {
  return e.kinematics == Kinematics::linear ? linear_tangent(e.law) : elastic_tangent(e.law, F, e.initial_stress);
}

}  // namespace

HoldResponse hold_response(const EdgeHold& h, const StiffElement& e, const std::array<Vec2, 3>& x) {
  const Strays w = strays(h, x);
  const Vec2 a = h.held * w.a, b = h.held * w.b, middle = 0.5 * (a + b);
  HoldResponse out;
  // w is linear along the edge: int |w|^2 = L/3 (a.a + a.b + b.b), int w_k w = L/6 [(2 a + b) w_k(0) + (a + 2 b)
  // w_k(1)].
  out.energy = h.gamma * h.length / 6.0 * (a.squaredNorm() + a.dot(b) + b.squaredNorm());
  const Vec2 at_a = h.gamma * h.length / 6.0 * (2.0 * a + b), at_b = h.gamma * h.length / 6.0 * (a + 2.0 * b);
  for (int k = 0; k < 3; ++k)
    out.force.segment<2>(2 * k) = -h.w0[static_cast<std::size_t>(k)] * at_a - h.w1[static_cast<std::size_t>(k)] * at_b;
  if (!h.consistent) return out;
  const Mat2 F = gradient_of(e, x);
  const Vec2 traction = response(e, F).P * h.normal, held = h.held * traction;
  out.energy -= h.length * held.dot(middle);
  // d(P N).D w = dF:A:(D w N^T)
  const Mat2 pull = middle * h.normal.transpose();
  const Eigen::Vector4d T = tangent_of(e, F) * Eigen::Map<const Eigen::Vector4d>(pull.data());
  const Mat2 change = Eigen::Map<const Mat2>(T.data());
  for (int k = 0; k < 3; ++k) {
    const double mean = 0.5 * (h.w0[static_cast<std::size_t>(k)] + h.w1[static_cast<std::size_t>(k)]);
    out.force.segment<2>(2 * k) += h.length * (mean * held + change * e.gradient.col(k));
  }
  return out;
}

Mat6 hold_stiffness(const EdgeHold& h, const StiffElement& e, const std::array<Vec2, 3>& x) {
  Mat6 K = Mat6::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const double mass =
          h.length / 6.0 * (2.0 * h.w0[a] * h.w0[b] + h.w0[a] * h.w1[b] + h.w1[a] * h.w0[b] + 2.0 * h.w1[a] * h.w1[b]);
      K.block<2, 2>(2 * i, 2 * j) += h.gamma * mass * h.held;
    }
  if (!h.consistent) return K;
  const Tangent A = tangent_of(e, gradient_of(e, x));
  // t: traction P N of the unit move of a cover, per column; w: the mean of D w.
  Eigen::Matrix<double, 2, 6> t, w = Eigen::Matrix<double, 2, 6>::Zero();
  for (int k = 0; k < 3; ++k)
    for (int d = 0; d < 2; ++d) {
      Eigen::Vector4d dF = Eigen::Vector4d::Zero();
      dF[d] = e.gradient(0, k);
      dF[2 + d] = e.gradient(1, k);
      const Eigen::Vector4d dP = A * dF;
      t.col(2 * k + d) = Eigen::Map<const Mat2>(dP.data()) * h.normal;
      w(d, 2 * k + d) = 0.5 * (h.w0[static_cast<std::size_t>(k)] + h.w1[static_cast<std::size_t>(k)]);
    }
  const Mat6 pull = h.length * t.transpose() * h.held * w;
  return K - pull - pull.transpose();
}

Vec2 hold_traction(const EdgeHold& h, const StiffElement& e, const std::array<Vec2, 3>& x, double s) {
  const Strays w = strays(h, x);
  Vec2 traction = -h.gamma * ((1.0 - s) * w.a + s * w.b);
  if (h.consistent) traction += response(e, gradient_of(e, x)).P * h.normal;
  return h.held * traction;
}

std::vector<EdgeHold> edge_holds(const Model& model, const BodyRecord& record, const CoverMesh& mesh,
                                 const AffineMotion& to_origin, const Elasticity& law) {
  std::vector<EdgeHold> out;
  std::size_t support = 0;
  for (const EdgeSupport& s : model.edge_supports) {
    if (s.span.block != record.block) continue;
    const Ring& ring = record.shape.outline.ring(static_cast<std::size_t>(s.span.edge.ring));
    const auto corner = static_cast<std::size_t>(s.span.edge.edge);
    const Vec2 &A = ring[corner], &B = ring[(corner + 1) % ring.size()], edge = B - A;
    for (const Boundary::Segment& segment : mesh.boundary.segments) {
      if (segment.edge != s.span.edge) continue;
      const double begin = std::max(segment.s0, s.span.s0), end = std::min(segment.s1, s.span.s1);
      if (!(end > begin)) continue;
      EdgeHold h;
      h.element = static_cast<std::size_t>(segment.cell);
      h.support = support;
      const Vec2 a = A + begin * edge, b = A + end * edge;
      h.w0 = mesh.weights(h.element, a);
      h.w1 = mesh.weights(h.element, b);
      h.at0 = to_origin.c + to_origin.F * a;
      h.at1 = to_origin.c + to_origin.F * b;
      h.from = (begin - s.span.s0) / (s.span.s1 - s.span.s0);
      h.to = (end - s.span.s0) / (s.span.s1 - s.span.s0);
      h.normal = -quarter_turn() * edge.normalized();
      h.length = (end - begin) * edge.norm();
      h.held = s.held;
      h.consistent = !s.bedding;
      h.gamma = s.bedding.value_or(kGamma * law.p_modulus() / record.form.cover_size);
      out.push_back(h);
    }
    ++support;
  }
  shift_holds(record.edge_shift, out);
  return out;
}

void shift_holds(std::span<const double> shift, std::vector<EdgeHold>& holds) {
  for (EdgeHold& h : holds) {
    const std::size_t i = 4 * h.support;
    if (i + 4 > shift.size()) continue;
    const Vec2 first(shift[i], shift[i + 1]), last(shift[i + 2], shift[i + 3]);
    h.shift0 = (1.0 - h.from) * first + h.from * last;
    h.shift1 = (1.0 - h.to) * first + h.to * last;
  }
}

double hold_frequency(std::span<const EdgeHold> holds, const CoverMesh& mesh, const CoverChart& chart,
                      std::int32_t first, std::span<const double> lumped, const Elasticity& law) {
  std::map<std::int32_t, double> sum;
  for (const EdgeHold& h : holds) {
    const StiffElement element{mesh.shapes[mesh.shape[h.element]], mesh.area[h.element], law, Kinematics::linear,
                               Mat2::Zero()};
    const Mat6 K = hold_stiffness(h, element, mesh.stars(h.element));
    std::vector<std::int32_t> places;
    const auto place_of = [&](std::int32_t cover) {
      const auto at = std::find(places.begin(), places.end(), cover);
      if (at != places.end()) return at - places.begin();
      places.push_back(cover);
      return static_cast<std::ptrdiff_t>(places.size()) - 1;
    };
    Eigen::MatrixXd C = Eigen::MatrixXd::Zero(6, 18);
    for (int k = 0; k < 3; ++k)
      for (const Share& s : chart.shares(first + mesh.cover[h.element][static_cast<std::size_t>(k)]))
        for (int d = 0; d < 2; ++d) C(2 * k + d, 2 * place_of(s.cover) + d) += s.w;
    const auto n = 2 * static_cast<Eigen::Index>(places.size());
    Eigen::MatrixXd folded = C.leftCols(n).transpose() * K * C.leftCols(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const double root = 1.0 / std::sqrt(lumped[static_cast<std::size_t>(places[static_cast<std::size_t>(i / 2)])]);
      folded.row(i) *= root;
      folded.col(i) *= root;
    }
    const double largest = std::max(0.0, symmetric_eigenvalues(folded)(n - 1));
    for (const std::int32_t c : places) sum[c] += largest;
  }
  double worst = 0.0;
  for (const auto& [cover, lambda] : sum) worst = std::max(worst, lambda);
  return worst;
}

}  // namespace scree::nmm
