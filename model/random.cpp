#include "model/random.h"

#include <bit>
#include <cmath>
#include <numbers>

namespace scree {

Random::Random(std::uint64_t seed) : state_{} {
  for (std::uint64_t& word : state_) {  // splitmix64
    seed += 0x9E3779B97F4A7C15U;
    std::uint64_t z = seed;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
    word = z ^ (z >> 31U);
  }
}

std::uint64_t Random::bits() {
  const std::uint64_t result = std::rotl(state_[1] * 5U, 7) * 9U, t = state_[1] << 17U;
  state_[2] ^= state_[0];
  state_[3] ^= state_[1];
  state_[1] ^= state_[2];
  state_[0] ^= state_[3];
  state_[2] ^= t;
  state_[3] = std::rotl(state_[3], 45);
  return result;
}

double Random::uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }

double Random::normal() {
  while (true) {
    const double x = 2.0 * uniform() - 1.0, y = 2.0 * uniform() - 1.0, s = x * x + y * y;
    if (s > 0.0 && s < 1.0) return x * std::sqrt(-2.0 * portable_log(s) / s);
  }
}

double Random::exponential() { return -portable_log(1.0 - uniform()); }

double portable_log(double x) {
  // x = m 2^e with 1/sqrt(2) <= m < sqrt(2), ln m = 2 (s + s^3/3 + s^5/5 + ...), s = (m - 1)/(m + 1), s^2 < 0.0295
  int e = 0;
  double m = std::frexp(x, &e);  // exact
  if (m < 0.5 * std::numbers::sqrt2) m *= 2.0, --e;
  const double s = (m - 1.0) / (m + 1.0), s2 = s * s;
  double sum = 0.0;
  for (int k = 23; k >= 3; k -= 2) sum = s2 * (sum + 1.0 / k);
  return 2.0 * (s + s * sum) + e * std::numbers::ln2;
}

double portable_exp(double x) {
  // x = k ln 2 + r with |r| <= ln 2 / 2; the Taylor series of e^r
  const double k = std::floor(x / std::numbers::ln2 + 0.5);
  const double r = x - k * std::numbers::ln2;
  double sum = 1.0;
  for (int n = 18; n >= 1; --n) sum = 1.0 + sum * r / n;
  return std::ldexp(sum, static_cast<int>(k));  // exact
}

double Spread::draw(Random& random) const {
  if (!varies()) return mean;
  switch (distribution) {
    case Distribution::normal:
      return mean + deviation * random.normal();
    case Distribution::uniform:
      return mean + deviation * (2.0 * random.uniform() - 1.0);
    case Distribution::exponential:
      return mean * random.exponential();
    case Distribution::lognormal: {
      // variance of the logarithm s2 = ln(1 + (deviation/mean)^2); its mean ln(mean) - s2/2
      const double s2 = portable_log(1.0 + deviation / mean * (deviation / mean));
      return mean * portable_exp(std::sqrt(s2) * random.normal() - 0.5 * s2);
    }
  }
  return mean;
}

double Spread::draw_positive(Random& random) const {
  double value = draw(random);
  while (!(value > 0.0)) value = draw(random);
  return value;
}

}  // namespace scree
