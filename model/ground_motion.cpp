#include "model/ground_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace scree {

Integrals integrate(const std::vector<double>& time, const std::vector<double>& acceleration, Between between) {
  Integrals out{std::vector<double>(time.size(), 0.0), std::vector<double>(time.size(), 0.0)};
  for (std::size_t i = 1; i < time.size(); ++i) {
    const double h = time[i] - time[i - 1], a0 = acceleration[i - 1];
    const double a1 = between == Between::linear ? acceleration[i] : a0;
    out.displacement[i] = out.displacement[i - 1] + out.velocity[i - 1] * h + (2.0 * a0 + a1) * h * h / 6.0;
    out.velocity[i] = out.velocity[i - 1] + (a0 + a1) * h / 2.0;
  }
  return out;
}

GroundMotion::GroundMotion(std::vector<double> time, std::vector<double> acceleration, const Vec2& direction,
                           Setting setting)
    : time_(std::move(time)), a_(std::move(acceleration)), direction_(direction), setting_(std::move(setting)) {
  if (time_.size() < 2 || time_.size() != a_.size())
    throw std::invalid_argument("GroundMotion: at least two samples, as many accelerations as times");
  for (std::size_t i = 1; i < time_.size(); ++i)
    if (!(time_[i] > time_[i - 1])) throw std::invalid_argument("GroundMotion: times must increase");
  Integrals integrals = integrate(time_, a_, setting_.between);
  v_ = std::move(integrals.velocity);
  d_ = std::move(integrals.displacement);
}

GroundMotion::Scalar GroundMotion::at(double t) const {
  const double u = (t - setting_.start) + time_.front();  // time of the record
  if (u < time_.front()) return {0.0, 0.0, 0.0};
  const double over = u - time_.back();
  if (over > 0.0) return {0.0, v_.back(), d_.back() + v_.back() * over};
  const auto next = std::upper_bound(time_.begin(), time_.end(), u);
  const std::size_t i = next == time_.end() ? time_.size() - 2 : static_cast<std::size_t>(next - time_.begin()) - 1;
  const double s = u - time_[i], h = time_[i + 1] - time_[i];
  const double a = setting_.between == Between::linear ? a_[i] + (a_[i + 1] - a_[i]) * (s / h) : a_[i];
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
  double integral = 0.0;  // of a^2, by the trapezoidal rule where the acceleration is linear (see MotionFacts)
  for (std::size_t i = 1; i < time_.size(); ++i) {
    const double h = time_[i] - time_[i - 1], a0 = a_[i - 1];
    const double a1 = setting_.between == Between::linear ? a_[i] : a0;
    integral += h * (a0 * a0 + a1 * a1) / 2.0;
    // If the acceleration passes zero within a step, the velocity peaks there, by the triangle up to that point.
    if (a0 * a1 < 0.0) f.pgv = std::max(f.pgv, std::abs(v_[i - 1] + a0 * h * (a0 / (a0 - a1)) / 2.0));
  }
  f.arias = std::numbers::pi / (2.0 * kStandardGravity) * integral;
  return f;
}

}  // namespace scree
