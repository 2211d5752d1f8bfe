// Damping of the deformation of sliding blocks in explicit steps.
#include <Eigen/LU>
#include <algorithm>

#include "coupling/integrate/central_difference.h"

namespace scree::coupling {
namespace {

/// Products of the three rigid motions x, y, turn of a body with the momenta of translations (m), of the turn (L) and
/// of its velocity (P), in one pass over its nodes.
struct RigidSums {
  double mass = 0.0, lx = 0.0, ly = 0.0, inertia = 0.0, px = 0.0, py = 0.0, spin = 0.0;
  RigidSums(std::span<const double> t, const double* turn, const double* m, const double* L, const double* P) {
    double s0 = 0.0, s1 = 0.0, s2 = 0.0, s3 = 0.0, s4 = 0.0, s5 = 0.0, s6 = 0.0;
#pragma omp simd reduction(+ : s0, s1, s2, s3, s4, s5, s6)
    for (std::size_t k = 0; k < t.size(); ++k) {
      const std::size_t i = 2 * k;
      s0 += t[k] * m[i];
      s1 += t[k] * L[i];
      s2 += t[k] * L[i + 1];
      s3 += turn[i] * L[i] + turn[i + 1] * L[i + 1];
      s4 += t[k] * P[i];
      s5 += t[k] * P[i + 1];
      s6 += turn[i] * P[i] + turn[i + 1] * P[i + 1];
    }
    mass = s0, lx = s1, ly = s2, inertia = s3, px = s4, py = s5, spin = s6;
  }
};

}  // namespace

void CentralDifference::damp_sliding(std::span<const double> q, double half, State& state) {
  stack_friction_ = 0.0;
  sliding_.begin();
  sliding_.count(setup_->outlines(), contact_.list());
  if (!sliding_.find()) {
    state.sliding.clear();
    return;
  }
  if (state.sliding.size() != q.size()) {
    state.sliding.assign(q.size(), 0.0);
  } else {  // driven nodes have none
    chunks_.for_free([&](const Chunk& c, std::size_t) {
      std::fill_n(state.sliding.begin() + static_cast<std::ptrdiff_t>(c.begin), c.size(), 0.0);
    });
  }
  for (std::size_t i = 0; i < setup_->bodies().size(); ++i) {
    const double rate = sliding_.rates()[i];
    if (rate == 0.0) continue;
    const Body& b = setup_->bodies()[i];
    const Pool& pool = setup_->pool_of(b);
    const auto p = static_cast<std::size_t>(b.pool), begin = 2 * static_cast<std::size_t>(b.first_node);
    rigid_turn(*setup_, b, q, rigid_turn_);
    const auto momentum_of = [&](const std::vector<double>& v, std::vector<double>& out) {
      pool.mass_apply(b.index, setup_->part(q, p), setup_->part(std::span<const double>(v), p),
                      setup_->part(std::span<double>(out), p));
    };
    momentum_of(v_new_, momentum_);
    momentum_of(rigid_turn_, turn_momentum_);
    const std::span<const double> t = pool.translation(b.index);
    const double *turn = rigid_turn_.data(), *P = momentum_.data(), *L = turn_momentum_.data(), *m = unit_mass_.data();
    // G = R^T M R, R = (x, y, turn).
    const RigidSums sum(t, turn + begin, m + begin, L + begin, P + begin);
    const Eigen::Matrix3d G =
        (Eigen::Matrix3d() << sum.mass, 0.0, sum.lx, 0.0, sum.mass, sum.ly, sum.lx, sum.ly, sum.inertia).finished();
    const Eigen::Vector3d rigid = G.inverse() * Eigen::Vector3d(sum.px, sum.py, sum.spin);
    // v_d <- v_d/(1 + a h/2), the force -a M v_d, and its part of the acceleration.
    const double factor = 1.0 / (1.0 + rate * half);
    double *v = v_new_.data(), *a = a_new_.data(), *f = state.sliding.data();
    const auto damp = [&](std::size_t k, double t_momentum, double slide) {
      const double along = slide + rigid.z() * turn[k], w = factor * (v[k] - along);
      v[k] = along + w;
      a[k] -= rate * w;
      f[k] = -rate * factor * (P[k] - t_momentum - rigid.z() * L[k]);
    };
    for (std::size_t n = 0; n < t.size(); ++n) {
      if (b.divided && pool.idle(static_cast<std::int32_t>(n) + pool.first_node(b.index))) continue;
      const std::size_t k = begin + 2 * n;
      damp(k, rigid.x() * m[k], rigid.x() * t[n]);
      damp(k + 1, rigid.y() * m[k + 1], rigid.y() * t[n]);
    }
  }
  if (!stacks_.find(sliding_, setup_->outlines(), contact_.list())) return;
  stacks_.act(setup_->outlines(), contact_.list(), q, v_new_, half);
  stacks_.add_acceleration(1.0, a_new_);
  stacks_.add_acceleration(half, v_new_);
  stacks_.add_force(q, state.sliding);
  stack_friction_ = stacks_.friction();
}

}  // namespace scree::coupling
