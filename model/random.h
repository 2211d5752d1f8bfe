// Random numbers that are the same on every platform: generator, logarithm and exponential from IEEE operations alone.
#pragma once

#include <array>
#include <cstdint>

namespace scree {

/// Draws from one stream of bits. The distributions of the standard library differ between implementations, and
/// std::log differs in the last bit, so both are replaced here.
/// @source [Blackman2021]: xoshiro256** 1.0 and splitmix64 (public domain)
class Random {
 public:
  explicit Random(std::uint64_t seed);

  [[nodiscard]] std::uint64_t bits();
  [[nodiscard]] double uniform();      // 0 <= u < 1, 53 bits
  [[nodiscard]] double normal();       // mean 0, variance 1 (polar method of Marsaglia, one of the pair)
  [[nodiscard]] double exponential();  // mean 1

 private:
  std::array<std::uint64_t, 4> state_;
};

/// ln x and e^x within 2 units of the last place, from + - * / alone.   @pre x > 0 and normal; |x| < 700
[[nodiscard]] double portable_log(double x);
[[nodiscard]] double portable_exp(double x);

enum class Distribution { normal, uniform, exponential, lognormal };

/// A quantity that varies from line to line.
struct Spread {
  double mean = 0.0;
  double deviation = 0.0;  // standard deviation (normal, lognormal); half the width (uniform); unused (exponential)
  Distribution distribution = Distribution::normal;

  [[nodiscard]] bool varies() const { return deviation > 0.0 || distribution == Distribution::exponential; }
  /// A draw, or the mean if nothing varies; then the generator is not used.
  [[nodiscard]] double draw(Random& random) const;
  /// A draw, repeated until it is positive.   @pre mean > 0
  [[nodiscard]] double draw_positive(Random& random) const;
};

}  // namespace scree
