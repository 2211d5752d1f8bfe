#include "app/studies/mass_chain.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace scree::app {

MassChain::MassChain(const ChainSetting& setting, double h) : setting_(setting), h_(h) {
  for (auto* values : {&u_, &v_, &f_, &d_}) values->assign(static_cast<std::size_t>(setting.n), 0.0);
  no_fixed_part_.make(setting.n, {}, {});
  matrix_.set_pattern(no_fixed_part_);
  forces(0.0, nullptr);
}

void MassChain::forces(double t, const double* v) {
  const std::size_t n = u_.size();
  const double c = v == nullptr ? 0.0 : setting_.dashpot();
  double left = setting_.stiffness * u_[0];  // in spring and dashpot to the left of a mass [N]
  if (c != 0.0) left += c * v[0];
  for (std::size_t i = 0; i + 1 < n; ++i) {
    double right = setting_.stiffness * (u_[i + 1] - u_[i]);
    if (c != 0.0) right += c * (v[i + 1] - v[i]);
    f_[i] = right - left;
    left = right;
  }
  f_[n - 1] = setting_.force * std::sin(setting_.frequency * t) - left;
}

void MassChain::step_explicit() {
  const double half = 0.5 * h_ / setting_.mass;
  for (std::size_t i = 0; i < u_.size(); ++i) {
    v_[i] += half * f_[i];
    u_[i] += h_ * v_[i];
  }
  steps_ += 1.0;
  forces(time(), v_.data());
  for (std::size_t i = 0; i < u_.size(); ++i) v_[i] += half * f_[i];
}

void MassChain::step_implicit() {
  const auto n = static_cast<std::int32_t>(u_.size());
  const double inertia = 2.0 * setting_.mass / (h_ * h_),
               stiffness = setting_.stiffness + 2.0 * setting_.dashpot() / h_;
  rows_.clear();
  scale_.clear();
  for (std::int32_t i = 0; i < n; ++i) {
    rows_.begin_row();
    rows_.add(i, 1.0);
    scale_.push_back(inertia + (i == 0 ? stiffness : 0.0));
    if (i + 1 == n) break;
    rows_.begin_row();
    rows_.add(i, -1.0);
    rows_.add(i + 1, 1.0);
    scale_.push_back(stiffness);
  }
  if (!matrix_.factorise({}, rows_, scale_)) throw std::runtime_error("the chain's matrix is not positive definite");
  steps_ += 1.0;
  for (std::size_t i = 0; i < u_.size(); ++i) d_[i] = -v_[i];
  forces(time(), d_.data());  // at u_n, with the load of t_n+1, and + C v
  for (std::size_t i = 0; i < u_.size(); ++i) f_[i] += 2.0 * setting_.mass / h_ * v_[i];
  matrix_.solve(f_, d_);
  for (std::size_t i = 0; i < u_.size(); ++i) {
    u_[i] += d_[i];
    v_[i] = 2.0 * d_[i] / h_ - v_[i];
  }
}

double MassChain::exact(const ChainSetting& s, int i, double t) {
  constexpr double kPi = std::numbers::pi;
  const double size = 2.0 * s.n + 1.0;
  double u = 0.0;
  for (int j = 1; j <= s.n; ++j) {
    const double angle = (2.0 * j - 1.0) * kPi / size;
    const double w = 2.0 * std::sqrt(s.stiffness / s.mass) * std::sin(0.5 * angle);
    const double phi_end = std::sin(s.n * angle), phi = std::sin((i + 1.0) * angle);
    const double W = s.frequency, z = s.damping * w * std::sqrt(s.mass / s.stiffness);
    // Steady response a sin - b cos, and the free vibration that makes the mode start at rest.
    const double off = w * w - W * W, size2 = off * off + 4.0 * z * z * w * w * W * W;
    const double a = off / size2, b = 2.0 * z * w * W / size2, wd = w * std::sqrt(1.0 - z * z);
    const double response = a * std::sin(W * t) - b * std::cos(W * t) +
                            std::exp(-z * w * t) * (b * std::cos(wd * t) + (z * w * b - W * a) / wd * std::sin(wd * t));
    u += 4.0 / size * phi * phi_end * s.force / s.mass * response;
  }
  return u;
}

}  // namespace scree::app
