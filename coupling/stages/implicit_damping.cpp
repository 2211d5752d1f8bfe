#include "coupling/stages/implicit_damping.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string_view>

#include "model/free_field.h"

namespace scree::coupling {
namespace {

constexpr double kEnergy = 0.95;  // fraction of the spectrum below the highest driven frequency
constexpr double kCovers = 10.0;  // length of the reported wave

/// Discrete Fourier transform in place.   @pre a power of two values
void transform(std::vector<std::complex<double>>& a) {
  const std::size_t n = a.size();
  for (std::size_t i = 1, j = 0; i < n; ++i) {
    std::size_t bit = n >> 1U;
    for (; (j & bit) != 0; bit >>= 1U) j ^= bit;
    j ^= bit;
    if (i < j) std::swap(a[i], a[j]);
  }
  for (std::size_t length = 2; length <= n; length *= 2) {
    const auto half = length / 2;
    for (std::size_t k = 0; k < half; ++k) {
      const auto w = std::polar(1.0, -std::numbers::pi * static_cast<double>(k) / static_cast<double>(half));
      for (std::size_t i = k; i < n; i += length) {
        const auto u = a[i], x = w * a[i + half];
        a[i] = u + x;
        a[i + half] = u - x;
      }
    }
  }
}

/// Frequency below which kEnergy of the energy of a signal lies [Hz].   @param at  its value at a time [s]
template <class At>
double bandwidth(double from, double to, std::size_t samples, At&& at) {
  std::size_t n = 64;
  while (n < 4 * samples && n < (std::size_t{1} << 18U)) n *= 2;
  const double step = 2.0 * (to - from) / static_cast<double>(n);  // zero padding: frequency lines are close enough
  if (!(step > 0.0)) return 0.0;
  std::vector<std::complex<double>> a(n, 0.0);
  for (std::size_t i = 0; i < n / 2; ++i) a[i] = at(from + (static_cast<double>(i) + 0.5) * step);
  transform(a);
  double whole = 0.0, below = 0.0;
  for (std::size_t i = 1; i < n / 2; ++i) whole += std::norm(a[i]);
  for (std::size_t i = 1; i < n / 2; ++i) {
    below += std::norm(a[i]);
    if (below >= kEnergy * whole) return whole > 0.0 ? static_cast<double>(i) / (static_cast<double>(n) * step) : 0.0;
  }
  return 0.0;
}

double frequency_of(const TimeFunction& f) {
  switch (f.shape) {
    case TimeFunction::Shape::constant:
    case TimeFunction::Shape::ramp:
      return 0.0;
    case TimeFunction::Shape::sine:
      return f.frequency;
    case TimeFunction::Shape::half_sine:
      return 0.5 / f.duration;
    case TimeFunction::Shape::sine_squared:
      return 1.0 / f.duration;
    case TimeFunction::Shape::table:
      break;
  }
  if (f.time.size() < 3) return 0.0;
  const double from = f.start + f.time.front(), to = f.start + f.time.back(),
               h = 0.5 * (to - from) / static_cast<double>(4 * f.time.size());
  return bandwidth(from, to, f.time.size(), [&](double t) { return f.value(t + h) - f.value(t - h); });
}

}  // namespace

NumericalDamping numerical_damping(double frequency, double dt) {
  const double radius = spectral_radius(NewmarkTheory().amplification(2.0 * std::numbers::pi * frequency * dt));
  return {frequency, 1.0 - std::pow(radius, 1.0 / dt), 1.0 - std::pow(radius, 1.0 / (frequency * dt))};
}

double step_that_damps(double frequency, double per_second) {
  double low = 0.0, high = 1.0 / frequency;  // the damping grows with the step
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (numerical_damping(frequency, middle).per_second < per_second ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

double driven_frequency(const Model& model, std::span<const char> acts) {
  double most = 0.0;
  const auto counts = [&](std::size_t i) { return acts.empty() || acts[i] != 0; };
  MotionId seen{};  // edges of a base have the same motion
  const auto see_motion = [&](MotionId id) {
    if (!id.valid() || !counts(id.index()) || id == seen) return;
    seen = id;
    const GroundMotion& m = model.motions[id.index()];
    most = std::max(most, bandwidth(m.times().front() + m.setting().start, m.times().back() + m.setting().start,
                                    m.times().size(), [&](double t) { return m.direction().dot(m.acceleration(t)); }));
  };
  for (const BlockSupport& s : model.block_supports) see_motion(s.motion);
  for (const ViscousEdge& e : model.viscous_edges) see_motion(e.motion);
  const auto see = [&](FunctionId f) {
    if (f.valid() && counts(model.motions.size() + f.index()))
      most = std::max(most, frequency_of(model.functions[f.index()]));
  };
  for (const PointLoad& load : model.point_loads) see(load.function);
  std::string_view last;  // motion of a free field: all of its many functions have the band of the motion
  for (const EdgeTraction& load : model.tractions) {
    if (of_free_field(model, load.function)) {
      const std::string& name = model.functions[load.function.index()].name;
      if (name == last) continue;
      last = name;
    }
    see(load.function);
  }
  for (const BodyAcceleration& load : model.body_accelerations) see(load.function);
  return most;
}

bool damps_motion(const Stage& stage) {
  return stage.has_implicit_steps() && stage.dt && !stage.rest && !(stage.dynamics < 1.0) &&
         stage.newmark != NewmarkScheme::trapezoidal;
}

std::optional<StageDamping> stage_damping(const Model& model, const Stage& stage, std::span<const char> acts) {
  if (!damps_motion(stage)) return std::nullopt;
  StageDamping out;
  out.stage = stage.name;
  out.dt = *stage.dt;
  out.divided = stage.integrator == Integrator::partitioned && !stage.partition.explicit_region.empty();
  if (const double f = driven_frequency(model, acts); f > 0.0) out.driven = numerical_damping(f, out.dt);
  double highest = 0.0;
  for (std::size_t i = 0; i < model.blocks.size(); ++i) {
    const BlockId id{static_cast<std::int32_t>(i)};
    if (stage.method != "nmm" || model.support_of(id) != nullptr) continue;
    const double size = model.blocks[i].cover_size > 0.0 ? model.blocks[i].cover_size : stage.cover_size;
    if (!(size > 0.0)) continue;
    highest = std::max(
        highest, std::sqrt(model.elasticity_of(id).p_modulus() / model.material_of(id).density) / (kCovers * size));
  }
  if (highest > 0.0) out.wave = numerical_damping(highest, out.dt);
  if (!out.driven && !out.wave) return std::nullopt;
  return out;
}

bool damps_much(const StageDamping& d) {
  return (d.driven && d.driven->per_second > kDampsMuch) || (d.divided && d.wave && d.wave->per_second > kDampsMuch);
}

std::string text(const StageDamping& d) {
  std::string line = fmt::format("stage '{}': implicit steps of {:.4g} s damp ", d.stage, d.dt);
  const auto loss = [](const NumericalDamping& n) {
    return fmt::format("by {:.3g} % per second, {:.3g} % per period", 100.0 * n.per_second, 100.0 * n.per_period);
  };
  if (d.driven)
    line += fmt::format("the highest driven frequency, {:.3g} Hz, {}{}", d.driven->frequency, loss(*d.driven),
                        d.wave ? "; " : "");
  if (d.wave) line += fmt::format("a wave of ten covers, {:.4g} Hz, {}", d.wave->frequency, loss(*d.wave));
  if (d.driven && d.driven->per_second > kDampsMuch)
    line += fmt::format("; steps of {:.2g} s would damp that frequency by 5 % per second",
                        step_that_damps(d.driven->frequency, kDampsMuch));
  if (d.divided && d.wave && d.wave->per_second > kDampsMuch)
    line += "; a wave that enters the implicit part of the divided block loses that much there";
  return line;
}

}  // namespace scree::coupling
