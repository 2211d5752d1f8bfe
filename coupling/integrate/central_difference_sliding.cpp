// Damping of the deformation of sliding blocks in explicit steps.
#include <Eigen/LU>
#include <algorithm>

#include "coupling/integrate/central_difference.h"

namespace scree::coupling {
namespace {

/// Sum of x.y over a range of numbers.
double dot(std::size_t begin, std::size_t end, const double* x, const double* y) {
  double sum = 0.0;
#pragma omp simd reduction(+ : sum)
  for (std::size_t i = begin; i < end; ++i) sum += x[i] * y[i];
  return sum;
}

}  // namespace

void CentralDifference::damp_sliding(std::span<const double> q, double half, State& state) {
  stack_friction_ = 0.0;
  sliding_.begin();
  sliding_.count(setup_->outlines(), contact_.list());
  if (!sliding_.find()) {
    state.sliding.clear();
    return;
  }
  state.sliding.assign(q.size(), 0.0);
  for (std::size_t i = 0; i < setup_->bodies().size(); ++i) {
    const double rate = sliding_.rates()[i];
    if (rate == 0.0) continue;
    const Body& b = setup_->bodies()[i];
    const Pool& pool = setup_->pool_of(b);
    const auto p = static_cast<std::size_t>(b.pool), begin = 2 * static_cast<std::size_t>(b.first_node),
               end = begin + 2 * static_cast<std::size_t>(b.nodes);
    rigid_motions(*setup_, b, q, rigid_x_, rigid_y_, rigid_turn_);
    const auto momentum_of = [&](const std::vector<double>& v, std::vector<double>& out) {
      pool.mass_apply(b.index, setup_->part(q, p), setup_->part(std::span<const double>(v), p),
                      setup_->part(std::span<double>(out), p));
    };
    momentum_of(v_new_, momentum_);
    momentum_of(rigid_turn_, turn_momentum_);
    const double *x = rigid_x_.data(), *y = rigid_y_.data(), *turn = rigid_turn_.data(), *P = momentum_.data(),
                 *L = turn_momentum_.data(), *m = unit_mass_.data();
    // G = R^T M R, R = (x, y, turn).
    const double mass = dot(begin, end, x, m), lx = dot(begin, end, x, L), ly = dot(begin, end, y, L);
    const Eigen::Matrix3d G =
        (Eigen::Matrix3d() << mass, 0.0, lx, 0.0, mass, ly, lx, ly, dot(begin, end, turn, L)).finished();
    const Eigen::Vector3d rigid =
        G.inverse() * Eigen::Vector3d(dot(begin, end, x, P), dot(begin, end, y, P), dot(begin, end, turn, P));
    // v_d <- v_d/(1 + a h/2), the force -a M v_d, and what it takes from the acceleration.
    const double factor = 1.0 / (1.0 + rate * half);
    double *v = v_new_.data(), *a = a_new_.data(), *f = state.sliding.data();
    const auto damp = [&](std::size_t k, double t_momentum, double slide) {
      const double along = slide + rigid.z() * turn[k], w = factor * (v[k] - along);
      v[k] = along + w;
      a[k] -= rate * w;
      f[k] = -rate * factor * (P[k] - t_momentum - rigid.z() * L[k]);
    };
    for (std::size_t k = begin; k < end; k += 2) {
      if (b.divided && pool.idle(static_cast<std::int32_t>((k - begin) / 2) + pool.first_node(b.index))) continue;
      damp(k, rigid.x() * m[k], rigid.x() * x[k]);
      damp(k + 1, rigid.y() * m[k + 1], rigid.y() * y[k + 1]);
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
