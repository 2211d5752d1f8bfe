#include "app/studies/studies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "app/studies/mass_chain.h"
#include "app/studies/oscillator.h"

namespace scree::app::studies_test {
namespace {

TEST(MeasuredStep, map_of_a_sequence_is_found) {
  Mat2 A;
  A << 0.9, 0.2, -0.3, 0.8;
  std::vector<Vec2> z{{1.0, 0.5}};
  for (int i = 0; i < 20; ++i) z.emplace_back(A * z.back());
  const MeasuredStep step = measured_step(z);
  EXPECT_LT((step.A - A).norm(), 1e-12);
  EXPECT_LT(step.misfit, 1e-12);
}

TEST(MeasuredStep, sequence_of_no_map_shows_in_the_misfit) {
  std::vector<Vec2> z{{1.0, 0.5}};
  for (int i = 0; i < 20; ++i) z.emplace_back(0.9 * z.back() + Vec2(0.0, 0.1 * std::abs(z.back().x())));
  z[10].x() += 1e-3;
  EXPECT_GT(measured_step(z).misfit, 1e-4);
}

TEST(MassChain, exact_solution_of_one_mass_is_the_textbook_s) {
  ChainSetting s;
  s.n = 1;
  s.frequency = 40.0;
  const double w = std::sqrt(s.stiffness / s.mass), t = 0.123;
  const double static_u = s.force / s.stiffness, ratio = s.frequency / w;
  EXPECT_NEAR(MassChain::exact(s, 0, t),
              static_u / (1.0 - ratio * ratio) * (std::sin(s.frequency * t) - ratio * std::sin(w * t)),
              1e-12 * static_u);
}

TEST(MassChain, exact_solution_satisfies_the_equation_of_motion) {
  ChainSetting s;
  s.n = 6;
  s.frequency = 70.0;
  for (const double damping : {0.0, 0.3}) {
    s.damping = damping;
    const double t = 0.2, d = 1e-4;
    const auto u = [&](int k, double at) { return k < 0 ? 0.0 : MassChain::exact(s, k, at); };
    const auto v = [&](int k) { return (u(k, t + d) - u(k, t - d)) / (2.0 * d); };
    for (int i = 0; i < s.n; ++i) {
      const double a = (u(i, t + d) - 2.0 * u(i, t) + u(i, t - d)) / (d * d);
      double f = -s.stiffness * (u(i, t) - u(i - 1, t)) - s.dashpot() * (v(i) - v(i - 1));
      f += i + 1 < s.n ? s.stiffness * (u(i + 1, t) - u(i, t)) + s.dashpot() * (v(i + 1) - v(i))
                       : s.force * std::sin(s.frequency * t);
      EXPECT_NEAR(s.mass * a, f, 1e-4 * s.force) << i << ", " << damping;
    }
    EXPECT_NEAR(MassChain::exact(s, 3, 0.0), 0.0, 1e-18);
  }
}

TEST(MassChain, both_schemes_converge_with_their_orders) {
  ChainSetting s;
  s.n = 8;
  s.frequency = 100.0 * std::numbers::pi;
  const auto error = [&](double h, bool implicit) {
    MassChain chain(s, h);
    double worst = 0.0;
    while (chain.time() < 0.1) {
      implicit ? chain.step_implicit() : chain.step_explicit();
      worst = std::max(worst, std::abs(chain.displacement().back() - MassChain::exact(s, s.n - 1, chain.time())));
    }
    return worst;
  };
  EXPECT_NEAR(std::log2(error(2e-4, false) / error(1e-4, false)), 2.0, 0.1);
  EXPECT_NEAR(std::log2(error(2e-4, true) / error(1e-4, true)), 1.0, 0.1);
  s.damping = 0.3;  // the explicit dashpots lag by half a step
  EXPECT_NEAR(std::log2(error(2e-4, false) / error(1e-4, false)), 1.0, 0.1);
  EXPECT_NEAR(std::log2(error(2e-4, true) / error(1e-4, true)), 1.0, 0.1);
}

TEST(Studies, sdof_gives_the_same_numbers_twice) {
  const StudyResult a = sdof(Tier::quick), b = sdof(Tier::full);
  EXPECT_EQ(a.numbers, b.numbers);
  EXPECT_EQ(a.plots.size(), 3U);
}

}  // namespace
}  // namespace scree::app::studies_test
