#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "app/studies/mass_chain.h"
#include "app/studies/studies.h"

namespace scree::app {
namespace {

constexpr double kDt = 1e-4;                                   // the step of [Qu2013] [s]
constexpr double kFrequency = std::numbers::pi / 100.0 / kDt;  // sin(pi N/100) at step N of that length [rad/s]
constexpr double kDamping = 0.1;                               // of the damped half of table 2.2
constexpr double kTime = 1.0;                                  // duration of the comparison, as in figure 2.11 [s]

ChainSetting setting_of(int n, double damping) {
  ChainSetting s;
  s.n = n;
  s.damping = damping;
  s.frequency = kFrequency;
  return s;
}

/// Histories of the pushed mass at equal times, whatever the step.
struct Histories {
  std::vector<double> time, exact, central, implicit;
};

Histories histories(int n, double h, int every, double damping = 0.0) {
  const ChainSetting s = setting_of(n, damping);
  MassChain left(s, h), right(s, h);
  Histories out;
  const auto end = static_cast<std::size_t>(n - 1);
  const int steps = static_cast<int>(std::lround(kTime / h));
  for (int i = 1; i <= steps; ++i) {
    left.step_explicit();
    right.step_implicit();
    if (i % every != 0) continue;
    out.time.push_back(left.time());
    out.exact.push_back(MassChain::exact(s, n - 1, left.time()));
    out.central.push_back(left.displacement()[end]);
    out.implicit.push_back(right.displacement()[end]);
  }
  return out;
}

double relative_difference(const std::vector<double>& a, const std::vector<double>& b,
                           const std::vector<double>& scale) {
  double most = 0.0, peak = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    most = std::max(most, std::abs(a[i] - b[i]));
    peak = std::max(peak, std::abs(scale[i]));
  }
  return most / peak;
}

double slope(const std::vector<double>& sizes, const std::vector<double>& errors) {
  return std::log(errors.front() / errors.back()) / std::log(sizes.front() / sizes.back());
}

template <class Step>
double seconds_of(int steps, Step&& step) {
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < steps; ++i) step();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Time of an explicit over that of an implicit step: windows of 500 steps in turns, the least of each.
double cost_ratio(int n, int rounds, double damping = 0.0) {
  constexpr int kWindow = 500, kExplicitWindows = 20;  // the clock must resolve the explicit ones, too
  MassChain left(setting_of(n, damping), kDt), right(setting_of(n, damping), kDt);
  double explicit_time = std::numeric_limits<double>::infinity(), implicit_time = explicit_time;
  for (int round = 0; round < rounds; ++round) {
    explicit_time = std::min(explicit_time,
                             seconds_of(kExplicitWindows * kWindow, [&] { left.step_explicit(); }) / kExplicitWindows);
    implicit_time = std::min(implicit_time, seconds_of(kWindow, [&] { right.step_implicit(); }));
  }
  return explicit_time / implicit_time;
}

}  // namespace

StudyResult spring_chain(Tier tier) {
  StudyResult out;
  const std::vector<int> sizes{10, 50, 100, 200, 500};
  io::PlotSeries ratios{"Scree", {}, {}, true},
      thesis{"thesis, table 2.2", {}, {0.237, 0.097, 0.062, 0.044, 0.031}, true},
      damped_ratios{"Scree, damped", {}, {}, true},
      damped_thesis{"thesis, damped", {}, {0.237, 0.097, 0.061, 0.040, 0.033}, true};
  double damped_explicit = 0.0, damped_difference = 0.0;
  for (const int n : sizes) {
    const Histories h = histories(n, kDt, 1);
    out.numbers[fmt::format("difference_{}", n)] = relative_difference(h.central, h.implicit, h.exact);
    out.numbers[fmt::format("explicit_error_{}", n)] = relative_difference(h.central, h.exact, h.exact);
    out.numbers[fmt::format("implicit_error_{}", n)] = relative_difference(h.implicit, h.exact, h.exact);
    out.numbers[fmt::format("cost_ratio_{}", n)] = cost_ratio(n, tier >= Tier::full ? 10 : 4);
    for (io::PlotSeries* s : {&ratios, &thesis, &damped_ratios, &damped_thesis}) s->x.push_back(n);
    ratios.y.push_back(out.numbers[fmt::format("cost_ratio_{}", n)]);
    const Histories d = histories(n, kDt, 1, kDamping);
    damped_explicit = std::max(damped_explicit, relative_difference(d.central, d.exact, d.exact));
    damped_difference = std::max(damped_difference, relative_difference(d.central, d.implicit, d.exact));
    damped_ratios.y.push_back(cost_ratio(n, tier >= Tier::full ? 10 : 4, kDamping));
    out.numbers[fmt::format("damped_cost_ratio_{}", n)] = damped_ratios.y.back();
    if (n == 100)
      out.plots.push_back({"Displacement of the pushed mass, n = 100",
                           "time [s]",
                           "displacement [m]",
                           {{"exact", h.time, h.exact, false, true},
                            {"explicit", h.time, h.central},
                            {"implicit", h.time, h.implicit}}});
  }
  out.numbers["damped_explicit_error"] = damped_explicit;
  out.numbers["damped_difference"] = damped_difference;
  out.numbers["cost_ratio_fall"] = out.numbers["cost_ratio_10"] / out.numbers["cost_ratio_500"];

  std::vector<double> steps, differences, explicit_errors, implicit_errors;
  for (int refine = 1; refine <= (tier >= Tier::full ? 16 : 4); refine *= 2) {
    const Histories h = histories(100, kDt / refine, refine);
    steps.push_back(kDt / refine);
    differences.push_back(relative_difference(h.central, h.implicit, h.exact));
    explicit_errors.push_back(relative_difference(h.central, h.exact, h.exact));
    implicit_errors.push_back(relative_difference(h.implicit, h.exact, h.exact));
  }
  out.numbers["difference_order"] = slope(steps, differences);
  out.numbers["explicit_order"] = slope(steps, explicit_errors);
  out.numbers["implicit_order"] = slope(steps, implicit_errors);
  out.plots.push_back({"Errors by the step, n = 100",
                       "dt [s]",
                       "error over peak",
                       {{"explicit", steps, explicit_errors, true},
                        {"implicit", steps, implicit_errors, true},
                        {"explicit - implicit", steps, differences, true}},
                       true,
                       true});
  out.plots.push_back({"CPU time of an explicit step over that of an implicit one",
                       "masses",
                       "ratio",
                       {ratios, thesis, damped_ratios, damped_thesis},
                       true,
                       true});
  return out;
}

}  // namespace scree::app
