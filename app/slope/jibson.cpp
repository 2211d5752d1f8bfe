#include "app/slope/jibson.h"

#include <fmt/format.h>

#include <cmath>

namespace scree::app {
namespace {

constexpr double kLeastYield = 0.05, kLargestYield = 0.4;         // of the data [g]
constexpr double kLeastMagnitude = 5.3, kLargestMagnitude = 7.6;  // of the earthquakes

RegressionResult result(int equation, std::string form, double log_median, double sigma, std::string outside) {
  RegressionResult r{equation, std::move(form), std::pow(10.0, log_median), sigma, 0.0, 0.0, std::move(outside)};
  r.lower = r.median * std::pow(10.0, -sigma);
  r.upper = r.median * std::pow(10.0, sigma);
  return r;
}

/// Why an equation is used beyond its data.
std::string outside_of(const Shaking& s, bool by_ratio) {
  std::string why;
  const auto add = [&why](std::string text) { why += (why.empty() ? "" : "; ") + std::move(text); };
  if (s.yield < kLeastYield || s.yield > kLargestYield)
    add(fmt::format("a_c = {:.3g} g, the data have {:g} to {:g} g", s.yield, kLeastYield, kLargestYield));
  if (s.magnitude && (*s.magnitude < kLeastMagnitude || *s.magnitude > kLargestMagnitude))
    add(fmt::format("M = {:g}, the data have {:g} to {:g}", *s.magnitude, kLeastMagnitude, kLargestMagnitude));
  if (by_ratio && s.pga && s.yield >= *s.pga)
    add(fmt::format("a_c = {:.3g} g is not below a_max = {:.3g} g: a rigid block does not slide", s.yield, *s.pga));
  return why;
}

}  // namespace

std::vector<RegressionResult> jibson_2007(const Shaking& s) {
  std::vector<RegressionResult> out;
  if (s.pga) {
    const double r = s.yield / *s.pga;
    const auto sliding = [r](double rise, double fall) {
      return r < 1.0 ? rise * std::log10(1.0 - r) - fall * std::log10(r) : -INFINITY;
    };
    out.push_back(result(6, "a_c/a_max", 0.215 + sliding(2.341, 1.438), 0.510, outside_of(s, true)));
    if (s.magnitude)
      out.push_back(
          result(7, "a_c/a_max, M", -2.710 + sliding(2.335, 1.478) + 0.424 * *s.magnitude, 0.454, outside_of(s, true)));
    if (s.arias && *s.arias > 0.0)
      out.push_back(result(8, "I_a, a_c/a_max", 0.561 * std::log10(*s.arias) - 3.833 * std::log10(r) - 1.474, 0.616,
                           outside_of(s, true)));
  }
  if (s.arias && *s.arias > 0.0)
    out.push_back(result(9, "I_a, a_c", 2.401 * std::log10(*s.arias) - 3.481 * std::log10(s.yield) - 3.230, 0.656,
                         outside_of(s, false)));
  return out;
}

}  // namespace scree::app
