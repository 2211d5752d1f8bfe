// The random generator and its distributions, compared with reference values and with the stated moments.
#include "model/random.h"

#include <gtest/gtest.h>

#include <cmath>

namespace scree::random_test {
namespace {

TEST(Random, bits_equal_the_published_generator) {
  // xoshiro256** seeded by splitmix64, from an independent implementation.
  Random zero(0), answer(42);
  EXPECT_EQ(zero.bits(), 0x99ec5f36cb75f2b4U);
  EXPECT_EQ(zero.bits(), 0xbf6e1f784956452aU);
  EXPECT_EQ(zero.bits(), 0x1a5f849d4933e6e0U);
  EXPECT_EQ(answer.bits(), 0x15780b2e0c2ec716U);
  EXPECT_EQ(answer.bits(), 0x6104d9866d113a7eU);
}

TEST(Random, transforms_of_seed_seven_are_pinned) {
  Random u(7), n(7), e(7);
  EXPECT_EQ(u.uniform(), 0.7005764821796896);
  EXPECT_EQ(u.uniform(), 0.2787512294737843);
  // The reference values use the system's logarithm: the last bits may differ. The logarithm tested is portable.
  EXPECT_DOUBLE_EQ(n.normal(), 0.9643618527255184);
  EXPECT_DOUBLE_EQ(n.normal(), -0.3039301238656567);
  EXPECT_DOUBLE_EQ(e.exponential(), 1.2058962602474497);
  EXPECT_DOUBLE_EQ(e.exponential(), 0.3267711658043091);
}

TEST(Random, own_logarithm_and_exponential_agree_with_the_library) {
  Random random(3);
  for (int i = 0; i < 10000; ++i) {
    const double x = std::ldexp(random.uniform() + 1e-9, static_cast<int>(random.uniform() * 200.0) - 100);
    EXPECT_NEAR(portable_log(x), std::log(x), 4e-16 * std::max(1.0, std::abs(std::log(x)))) << x;
    const double y = 40.0 * (random.uniform() - 0.5);
    EXPECT_NEAR(portable_exp(y), std::exp(y), 1e-14 * std::exp(y)) << y;  // error |y| eps of the reduction
  }
}

/// Mean and standard deviation of many draws.
std::pair<double, double> moments_of(const Spread& spread, int n) {
  Random random(11);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = spread.draw(random);
    sum += x;
    squares += x * x;
  }
  const double mean = sum / n;
  return {mean, std::sqrt(squares / n - mean * mean)};
}

TEST(Spread, draws_have_the_stated_mean_and_deviation) {
  constexpr int kDraws = 200000;  // standard error of the mean 0.5/sqrt(n) = 1e-3; the tolerance is four of them
  const std::pair<Spread, double> cases[] = {{{2.0, 0.5, Distribution::normal}, 0.5},
                                             {{2.0, 0.5, Distribution::uniform}, 0.5 / std::sqrt(3.0)},
                                             {{2.0, 0.5, Distribution::lognormal}, 0.5},
                                             {{2.0, 0.0, Distribution::exponential}, 2.0}};
  for (const auto& [spread, deviation] : cases) {
    const auto [mean, found] = moments_of(spread, kDraws);
    EXPECT_NEAR(mean, 2.0, 4.0 * deviation / std::sqrt(kDraws)) << static_cast<int>(spread.distribution);
    EXPECT_NEAR(found, deviation, 0.015 * deviation) << static_cast<int>(spread.distribution);
  }
}

TEST(Spread, constant_leaves_the_generator_alone) {
  Random used(5), fresh(5);
  EXPECT_EQ((Spread{3.0, 0.0, Distribution::normal}.draw(used)), 3.0);
  EXPECT_EQ(used.bits(), fresh.bits());
}

TEST(Spread, positive_draws_are_positive) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) EXPECT_GT((Spread{1.0, 3.0, Distribution::normal}.draw_positive(random)), 0.0);
}

}  // namespace
}  // namespace scree::random_test
