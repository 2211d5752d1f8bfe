#include "app/studies/mass_chain.h"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace scree::app {

MassChain::MassChain(const ChainSetting& setting, double h) : setting_(setting), h_(h) {
  for (auto* values : {&u_, &v_, &f_, &d_}) values->assign(static_cast<std::size_t>(setting.n), 0.0);
  no_fixed_part_.make(setting.n, {}, {});
  matrix_.set_pattern(no_fixed_part_);
  forces(0.0);
}

void MassChain::forces(double t) {
  const std::size_t n = u_.size();
  double left = setting_.stiffness * u_[0];  // in the spring to the left of a mass [N]
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const double right = setting_.stiffness * (u_[i + 1] - u_[i]);
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
  forces(time());
  for (std::size_t i = 0; i < u_.size(); ++i) v_[i] += half * f_[i];
}

void MassChain::step_implicit() {
  const auto n = static_cast<std::int32_t>(u_.size());
  const double inertia = 2.0 * setting_.mass / (h_ * h_);
  rows_.clear();
  scale_.clear();
  for (std::int32_t i = 0; i < n; ++i) {
    rows_.begin_row();
    rows_.add(i, 1.0);
    scale_.push_back(inertia + (i == 0 ? setting_.stiffness : 0.0));
    if (i + 1 == n) break;
    rows_.begin_row();
    rows_.add(i, -1.0);
    rows_.add(i + 1, 1.0);
    scale_.push_back(setting_.stiffness);
  }
  if (!matrix_.factorise({}, rows_, scale_)) throw std::runtime_error("the chain's matrix is not positive definite");
  steps_ += 1.0;
  forces(time());  // at u_n, with the load of t_n+1
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
    const double response =
        (std::sin(s.frequency * t) - s.frequency / w * std::sin(w * t)) / (w * w - s.frequency * s.frequency);
    u += 4.0 / size * phi * phi_end * s.force / s.mass * response;
  }
  return u;
}

}  // namespace scree::app
