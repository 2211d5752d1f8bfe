#include "app/slope/response_spectrum.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace scree::app {
namespace {

struct Motion {
  double u = 0.0, v = 0.0;  // relative to the ground [m], [m/s]
};

/// One exact step of length h of an oscillator under -a, a linear from a0 to a1.
class Step {
 public:
  Step(double w, double z, double h) : w_(w), z_(z), h_(h) {
    const double wd = w * std::sqrt(1.0 - z * z);
    e_cos_ = std::exp(-z * w * h) * std::cos(wd * h);
    e_sin_ = std::exp(-z * w * h) * std::sin(wd * h) / wd;
  }
  /// The particular solution of w^2 u + 2 z w u' + u'' = -(a0 + s t) is c + d t.
  [[nodiscard]] Motion operator()(const Motion& m, double a0, double a1) const {
    const double s = (a1 - a0) / h_, w2 = w_ * w_;
    const double d = -s / w2, c = -a0 / w2 + 2.0 * z_ * s / (w2 * w_);
    const double x0 = m.u - c, y0 = m.v - d;  // of the free part
    const double x = e_cos_ * x0 + e_sin_ * (y0 + z_ * w_ * x0);
    const double y = e_cos_ * y0 - e_sin_ * (w2 * x0 + z_ * w_ * y0);
    return {x + c + d * h_, y + d};
  }

 private:
  double w_, z_, h_, e_cos_ = 0.0, e_sin_ = 0.0;
};

Response response(const Samples& record, double period, double z) {
  const double w = 2.0 * std::numbers::pi / period;
  Response out;
  out.period = period;
  Motion m;
  const auto see = [&] {
    out.displacement = std::max(out.displacement, std::abs(m.u));
    out.velocity = std::max(out.velocity, std::abs(m.v));
    out.acceleration = std::max(out.acceleration, std::abs(2.0 * z * w * m.v + w * w * m.u));
  };
  double last = -1.0;
  int parts = 1;
  Step step(w, z, 1.0);
  const auto pass = [&](double h, double a0, double a1) {
    if (h != last) {
      parts = std::max(1, static_cast<int>(std::ceil(20.0 * h / period)));
      step = Step(w, z, h / parts);
      last = h;
    }
    for (int k = 0; k < parts; ++k) {
      const double from = static_cast<double>(k) / parts, to = static_cast<double>(k + 1) / parts;
      m = step(m, a0 + (a1 - a0) * from, a0 + (a1 - a0) * to);
      see();
    }
  };
  for (std::size_t i = 0; i + 1 < record.time.size(); ++i)
    pass(record.time[i + 1] - record.time[i], record.acceleration[i], record.acceleration[i + 1]);
  pass(0.5 * period, 0.0, 0.0);
  out.pseudo_velocity = w * out.displacement;
  out.pseudo_acceleration = w * w * out.displacement;
  return out;
}

}  // namespace

std::vector<Response> response_spectrum(const Samples& record, const std::vector<double>& periods, double damping) {
  if (!(damping >= 0.0 && damping < 1.0)) throw std::invalid_argument("damping is from 0 to below 1");
  std::vector<Response> out;
  for (const double period : periods) {
    if (!(period > 0.0)) throw std::invalid_argument("periods are above 0");
    out.push_back(response(record, period, damping));
  }
  return out;
}

std::vector<double> spectrum_periods(double first, double last, std::size_t count) {
  std::vector<double> out(count);
  for (std::size_t i = 0; i < count; ++i)
    out[i] = first * std::pow(last / first, static_cast<double>(i) / static_cast<double>(count - 1));
  out.back() = last;
  return out;
}

}  // namespace scree::app
