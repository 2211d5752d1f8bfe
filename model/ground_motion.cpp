#include "model/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace scree {

GroundMotion::GroundMotion(std::vector<double> time, std::vector<double> acceleration, Vec2 direction)
    : time_(std::move(time)), a_(std::move(acceleration)), direction_(direction) {
  if (time_.size() < 2 || time_.size() != a_.size())
    throw std::invalid_argument("GroundMotion: at least two samples, as many accelerations as times");
  for (std::size_t i = 1; i < time_.size(); ++i)
    if (!(time_[i] > time_[i - 1])) throw std::invalid_argument("GroundMotion: times must increase");
  integrate();
}

void GroundMotion::integrate() {
  v_.assign(time_.size(), 0.0);
  d_.assign(time_.size(), 0.0);
  for (std::size_t i = 1; i < time_.size(); ++i) {
    const double h = time_[i] - time_[i - 1];
    d_[i] = d_[i - 1] + v_[i - 1] * h + (2.0 * a_[i - 1] + a_[i]) * h * h / 6.0;
    v_[i] = v_[i - 1] + (a_[i - 1] + a_[i]) * h / 2.0;
  }
}

GroundMotion::Scalar GroundMotion::at(double t) const {
  if (t < time_.front()) return {0.0, 0.0, 0.0};
  const double over = t - time_.back();
  if (over > 0.0) return {0.0, v_.back(), d_.back() + v_.back() * over};
  const auto next = std::upper_bound(time_.begin(), time_.end(), t);
  const std::size_t i = next == time_.end() ? time_.size() - 2 : static_cast<std::size_t>(next - time_.begin()) - 1;
  const double s = t - time_[i], h = time_[i + 1] - time_[i];
  const double a = a_[i] + (a_[i + 1] - a_[i]) * (s / h);
  return {a, v_[i] + (a_[i] + a) * s / 2.0, d_[i] + v_[i] * s + (2.0 * a_[i] + a) * s * s / 6.0};
}

Vec2 GroundMotion::displacement(double t) const { return at(t).d * direction_; }
Vec2 GroundMotion::velocity(double t) const { return at(t).v * direction_; }
Vec2 GroundMotion::acceleration(double t) const { return at(t).a * direction_; }

MotionFacts GroundMotion::facts() const {
  MotionFacts f;
  f.duration = time_.back() - time_.front();
  for (double a : a_) f.pga = std::max(f.pga, std::abs(a));
  for (double v : v_) f.pgv = std::max(f.pgv, std::abs(v));
  f.final_velocity = v_.back();
  f.final_displacement = d_.back();
  double integral = 0.0;  // of a^2, exact for linear pieces
  for (std::size_t i = 1; i < time_.size(); ++i)
    integral += (time_[i] - time_[i - 1]) * (a_[i - 1] * a_[i - 1] + a_[i - 1] * a_[i] + a_[i] * a_[i]) / 3.0;
  f.arias = std::numbers::pi / (2.0 * 9.80665) * integral;
  return f;
}

void GroundMotion::correct_baseline() {
  const double shift = v_.back() / (time_.back() - time_.front());
  for (double& a : a_) a -= shift;
  integrate();
}

}  // namespace scree
