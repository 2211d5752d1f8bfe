#include "app/slope/plane_failure.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace scree::app {

double PlaneSlide::factor(double k_h, double k_v) const {
  const double s = std::sin(dip), c = std::cos(dip);
  const double normal = weight * ((1.0 - k_v) * c - k_h * s) - uplift - thrust * s;
  const double driving = weight * ((1.0 - k_v) * s + k_h * c) + thrust * c;
  if (!(driving > 0.0)) return std::numeric_limits<double>::infinity();
  return (cohesion * length + (normal > 0.0 ? normal : 0.0) * std::tan(friction)) / driving;
}

double PlaneSlide::yield(double k_v) const {
  const double s = std::sin(dip), c = std::cos(dip), t = std::tan(friction);
  const double resisting = cohesion * length + (weight * (1.0 - k_v) * c - uplift - thrust * s) * t;
  const double driving = weight * (1.0 - k_v) * s + thrust * c;
  const double k = (resisting - driving) / (weight * (c + s * t));
  const double normal = weight * ((1.0 - k_v) * c - k * s) - uplift - thrust * s;
  return normal >= 0.0 ? k : (cohesion * length - driving) / (weight * c);  // it lifts off first: cohesion alone
}

double PlaneSlide::critical() const { return (factor() - 1.0) * std::sin(dip); }

double PlaneSlide::amplification() const { return std::cos(dip) + std::sin(dip) * std::tan(friction); }

PlaneSlide PlaneSlope::slide() const {
  constexpr double kRight = std::numbers::pi / 2.0;
  if (!(height > 0.0) || !(unit_weight > 0.0)) throw std::invalid_argument("height and unit weight are above 0");
  if (!(dip > 0.0) || !(dip < face) || !(face <= kRight))
    throw std::invalid_argument("the plane dips less than the face, which is 90 degrees at most");
  const double cot_face = 1.0 / std::tan(face);
  const double under_crest = height * (1.0 - std::tan(dip) * cot_face);  // of the plane
  if (!(crack >= 0.0) || crack > under_crest)
    throw std::invalid_argument("the tension crack in the top is at most as deep as the plane under the crest");
  if (!(water >= 0.0) || water > crack) throw std::invalid_argument("water stands within the tension crack");
  const double z = crack / height;
  PlaneSlide s;
  s.dip = dip;
  s.friction = friction;
  s.cohesion = cohesion;
  s.weight = 0.5 * unit_weight * height * height * ((1.0 - z * z) / std::tan(dip) - cot_face);
  s.length = (height - crack) / std::sin(dip);
  s.uplift = 0.5 * water_weight * water * s.length;
  s.thrust = 0.5 * water_weight * water * water;
  return s;
}

}  // namespace scree::app
