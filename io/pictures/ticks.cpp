#include "io/pictures/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace scree::io {

namespace {

/// A number with a real minus sign.
std::string shown(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", std::abs(value), decimals);
  return value < 0.0 ? "−" + text : text;
}

std::string superscript(int exponent) {
  static constexpr std::array<const char*, 10> kDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "⁻" : "";
  for (const char digit : std::to_string(std::abs(exponent))) text += kDigits[static_cast<std::size_t>(digit - '0')];
  return text;
}

}  // namespace

Ticks round_ticks(double low, double high, int count) {
  const double rough = (high - low) / std::max(count, 1);
  const int power = static_cast<int>(std::floor(std::log10(rough)));
  const double decade = std::pow(10.0, power);
  // The largest of 1, 2, 5, 10 that is not above the rough step by more than a half.
  const double mantissa = rough / decade, m = mantissa < 1.5 ? 1.0 : mantissa < 3.5 ? 2.0 : mantissa < 7.5 ? 5.0 : 10.0;
  const double step = m * decade;
  const int decimals = std::clamp(m == 10.0 ? -power - 1 : -power, 0, 12);
  Ticks ticks;
  const double slack = 1e-9 * (high - low);
  for (double k = std::ceil((low - slack) / step); k * step <= high + slack; k += 1.0) {
    const double value = k == 0.0 ? 0.0 : k * step;
    ticks.at.push_back(value);
    ticks.label.push_back(shown(value, decimals));
  }
  return ticks;
}

Ticks power_ticks(int low, int high, int count) {
  const int every = std::max(1, (high - low + count - 1) / std::max(count - 1, 1));
  Ticks ticks;
  for (int e = high; e >= low; e -= every) {
    ticks.at.push_back(e);
    ticks.label.push_back(e == 0 ? "1" : "10" + superscript(e));
  }
  return ticks;
}

Unit prefixed(const std::string& si, double largest) {
  static constexpr std::array<std::pair<double, const char*>, 6> kPrefix{
      {{1e9, "G"}, {1e6, "M"}, {1e3, "k"}, {1.0, ""}, {1e-3, "m"}, {1e-6, "µ"}}};
  if (si == "1") return {1.0, si};
  const bool metric = si.front() == 'm';  // km are unusual for a slope
  for (const auto& [factor, prefix] : kPrefix)
    if (largest >= factor && !(metric && factor > 1.0)) return {factor, prefix + si};
  return largest > 0.0 && std::isfinite(largest) ? Unit{1e-6, "µ" + si} : Unit{1.0, si};
}

}  // namespace scree::io
