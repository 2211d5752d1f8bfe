// Round numbers and units for axes.
#pragma once

#include <string>
#include <vector>

namespace scree::io {

/// Ticks at 1, 2 or 5 times a power of ten, their labels with equal digits.
struct Ticks {
  std::vector<double> at;
  std::vector<std::string> label;
};
/// About `count` ticks within [low, high], at least two where rounding allows.   @pre low < high, both finite
[[nodiscard]] Ticks round_ticks(double low, double high, int count);
/// Powers of ten within [low, high] (exponents), labelled 10⁻³; thinned to at most `count`.
[[nodiscard]] Ticks power_ticks(int low, int high, int count);

/// A unit with a prefix: value in SI = value shown * factor.
struct Unit {
  double factor = 1.0;
  std::string name;
};
/// The prefix (micro to giga) that brings `largest` between 1 and 1000; for lengths and speeds none above 1.
[[nodiscard]] Unit prefixed(const std::string& si, double largest);

}  // namespace scree::io
