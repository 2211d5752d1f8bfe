#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "app/studies/oscillator.h"
#include "app/studies/studies.h"
#include "coupling/integrate/newmark_theory.h"

namespace scree::app {
namespace {

using coupling::damping_measure;
using coupling::Integrator;
using coupling::NewmarkTheory;
using coupling::period_error;
using coupling::spectral_radius;

const NewmarkTheory kImplicit{0.5, 1.0}, kTrapezoidal{0.25, 0.5}, kExplicit{0.0, 0.5};
constexpr int kSteps = 200;  // measured at every Omega
constexpr int kSamples = 400;

/// Omega of the least spectral radius, by thirds: the formula of the bifurcation is not used.
double optimum(const NewmarkTheory& scheme, double low, double high) {
  const auto radius = [&](double Omega) { return spectral_radius(scheme.amplification(Omega)); };
  while (high - low > 1e-9) {
    const double third = (high - low) / 3.0;
    if (radius(low + third) < radius(high - third))
      high -= third;
    else
      low += third;
  }
  return 0.5 * (low + high);
}

/// Omega above which the spectral radius exceeds 1, by halving.
double limit(const NewmarkTheory& scheme, double low, double high) {
  while (high - low > 1e-12 * high) {
    const double middle = 0.5 * (low + high);
    (spectral_radius(scheme.amplification(middle)) > 1.0 + 1e-9 ? high : low) = middle;
  }
  return low;
}

struct Measured {
  io::PlotSeries radius, damping, period;
  double radius_error = 0.0, damping_error = 0.0, period_error = 0.0, misfit = 0.0;
};

/// Scree's steps against theory.
Measured measure_steps(Integrator integrator, const NewmarkTheory& theory, const std::vector<double>& Omegas,
                       const std::string& name) {
  Measured m;
  for (io::PlotSeries* s : {&m.radius, &m.damping, &m.period}) s->name = name, s->points = true, s->x = Omegas;
  for (const double Omega : Omegas) {
    const MeasuredStep step = measured_step(oscillator_steps(integrator, Omega, kSteps));
    const Mat2 A = theory.amplification(Omega);
    m.misfit = std::max(m.misfit, step.misfit);
    m.radius.y.push_back(spectral_radius(step.A));
    m.damping.y.push_back(damping_measure(step.A, Omega));
    m.period.y.push_back(period_error(step.A, Omega));
    m.radius_error = std::max(m.radius_error, std::abs(m.radius.y.back() - spectral_radius(A)));
    m.damping_error = std::max(m.damping_error, std::abs(m.damping.y.back() - damping_measure(A, Omega)));
    const double period = period_error(A, Omega);
    if (std::isnan(period) != std::isnan(m.period.y.back()))
      m.period_error = std::numeric_limits<double>::infinity();  // one oscillates, the other does not
    else if (!std::isnan(period))
      m.period_error = std::max(m.period_error, std::abs(m.period.y.back() - period));
  }
  return m;
}

template <class Value>
io::PlotSeries theory_curve(const std::string& name, double from, double to, bool log, Value&& value) {
  io::PlotSeries s;
  s.name = name;
  for (int i = 0; i <= kSamples; ++i) {
    const double f = static_cast<double>(i) / kSamples;
    s.x.push_back(log ? from * std::pow(to / from, f) : from + f * (to - from));
    s.y.push_back(value(s.x.back()));
  }
  return s;
}

/// Between two values of Omega the curve is not drawn beyond the stable limit: it would leave the picture.
double stable_radius(const NewmarkTheory& scheme, double Omega) {
  const double radius = spectral_radius(scheme.amplification(Omega));
  return radius <= 1.5 ? radius : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

StudyResult sdof(Tier) {
  StudyResult out;
  const std::vector<double> betas{0.50, 0.52, 0.54, 0.60, 1.00};
  io::LinePlot damping{"Damping of Newmark's scheme, gamma = 1", "Omega", "xi", {}};
  for (const double beta : betas) {
    const NewmarkTheory scheme{beta, 1.0};
    out.numbers[fmt::format("largest_damping_{:.2f}", beta)] = scheme.largest_damping(30.0).value;
    damping.series.push_back(theory_curve(fmt::format("beta = {:.2f}", beta), 1e-3, 8.0, false, [&](double Omega) {
      return damping_measure(scheme.amplification(Omega), Omega);
    }));
  }
  out.numbers["implicit_optimum"] = optimum(kImplicit, 1.0, 10.0);
  out.numbers["implicit_least_radius"] = spectral_radius(kImplicit.amplification(out.numbers["implicit_optimum"]));
  out.numbers["explicit_limit"] = limit(kExplicit, 1.0, 3.0);

  // The bifurcation itself is left out: there the radius is the root of round-off.
  const Measured implicit = measure_steps(Integrator::implicit, kImplicit,
                                          {0.05, 0.1, 0.3, 0.5, 1.0, 1.5, 2.0, 2.8, 3.5, 5.0, 7.0}, "Scree, implicit");
  const Measured central =
      measure_steps(Integrator::explicit_, kExplicit, {0.05, 0.1, 0.3, 0.5, 1.0, 1.5, 1.8, 1.95}, "Scree, explicit");
  for (const auto& [name, m] : {std::pair{"implicit", &implicit}, std::pair{"explicit", &central}}) {
    const std::string prefix(name);
    out.numbers[prefix + "_radius_error"] = m->radius_error;
    out.numbers[prefix + "_damping_error"] = m->damping_error;
    out.numbers[prefix + "_period_error"] = m->period_error;
    out.numbers[prefix + "_misfit"] = m->misfit;
  }
  const double below = 0.999 * 2.0, above = 1.001 * 2.0;
  const std::vector<Vec2> stable = oscillator_steps(Integrator::explicit_, below, 2000);
  double farthest = 0.0;
  for (const Vec2& z : stable) farthest = std::max(farthest, std::abs(z.x()));
  // u_n = h v_0 sin(n w' h)/s with s = Omega (1 - Omega^2/4)^1/2: bounded, for ever.
  out.numbers["explicit_below_limit_amplitude"] =
      farthest / stable.front().y() * below * std::sqrt(1.0 - 0.25 * below * below);
  const double growth = spectral_radius(measured_step(oscillator_steps(Integrator::explicit_, above, 200)).A);
  out.numbers["explicit_above_limit_growth"] = growth;
  out.numbers["explicit_above_limit_error"] = std::abs(growth - spectral_radius(kExplicit.amplification(above)));

  damping.series.push_back(implicit.damping);
  io::LinePlot radius{"Spectral radius", "Omega", "spectral radius", {}, true};
  io::LinePlot period{"Period error", "Omega", "T'/T - 1", {}};
  const std::pair<const char*, const NewmarkTheory*> schemes[] = {{"beta = 1/2, gamma = 1", &kImplicit},
                                                                  {"beta = 1/4, gamma = 1/2", &kTrapezoidal},
                                                                  {"beta = 0, gamma = 1/2", &kExplicit}};
  for (const auto& [name, of] : schemes) {
    const NewmarkTheory scheme = *of;
    radius.series.push_back(
        theory_curve(name, 0.01, 1000.0, true, [&](double Omega) { return stable_radius(scheme, Omega); }));
    period.series.push_back(theory_curve(
        name, 0.01, 3.8, false, [&](double Omega) { return period_error(scheme.amplification(Omega), Omega); }));
  }
  for (const Measured* m : {&implicit, &central}) {
    radius.series.push_back(m->radius);
    period.series.push_back(m->period);
  }
  out.plots = {std::move(radius), std::move(damping), std::move(period)};
  return out;
}

}  // namespace scree::app
