// The certified step bound, compared with the highest frequency of a power iteration.
#include "nmm/step_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/unit/nmm/one_block.h"

namespace scree::nmm::step_bound_test {
namespace {

double true_highest(const One& one) {
  // Power iteration on M~^-1 K; K acts through differences of the internal force about the state at rest.
  std::vector<double> q = one.q, f(q.size()), a(q.size()), x(q.size());
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  for (double& v : x) v = u(generator);
  one.pool.mass_solve(q, x, a);
  x = a;
  double lambda = 0.0;
  for (int it = 0; it < 3000; ++it) {
    double norm = 0.0;
    for (double v : x) norm = std::max(norm, std::abs(v));
    for (std::size_t i = 0; i < q.size(); ++i) q[i] = one.q[i] + 1e-6 * x[i] / norm;
    std::fill(f.begin(), f.end(), 0.0);
    one.pool.internal_force(q, f);
    one.pool.mass_solve(q, f, a);
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      x[i] = -a[i] / 1e-6;
      largest = std::max(largest, std::abs(x[i]));
    }
    lambda = largest;
  }
  return lambda;
}

TEST(StepBound, is_certified_and_small_cuts_do_not_cost_the_step) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> u(-1.0, 1.0);
  const double h = 1.0;
  double least = 1e9, least_true = 1e9;
  for (int k = 0; k < 40; ++k) {
    const Polygon box{{{-1.5, -1.5}, {1.5, -1.5}, {1.5, 1.5}, {-1.5, 1.5}}, {}};
    One one(transformed(box, {u(generator), u(generator)}, rotation(3.14159 * u(generator))), h);
    AffineMotion m;
    one.pool.place(0, m, one.q, one.v);
    const double bound = 2.0 / std::sqrt(one.pool.mass_ratio(0) * one.pool.frequency_bound(0));
    const double real = 2.0 / std::sqrt(true_highest(one));
    EXPECT_LE(bound, real * (1.0 + 1e-3));  // the power iteration approaches the frequency from below
    const Elasticity law = one.model.elasticity_of(BlockId{0});
    const double uncut = 0.866 * h / std::sqrt(law.p_modulus() / 2.0);
    least = std::min(least, bound / uncut);
    least_true = std::min(least_true, real / uncut);
  }
  std::printf("least stable step over that of the uncut mesh: %.3f true, %.3f certified\n", least_true, least);
  EXPECT_GE(least_true, 0.5);
}

}  // namespace
}  // namespace scree::nmm::step_bound_test
