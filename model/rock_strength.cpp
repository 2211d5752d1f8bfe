#include "model/rock_strength.h"

#include <algorithm>
#include <cmath>

namespace scree {
namespace {

/// Radius of the circle about a centre, compression positive, that touches the envelope; not above 0: there is none.
double largest_radius(const MohrCoulombStrength& m, double centre) {
  return m.cohesion * std::cos(m.friction) + centre * std::sin(m.friction);
}

double largest_radius(const HoekBrownStrength& h, double centre) {
  // 2 r = ucs (m_b (p - r)/ucs + s)^a: the left side grows with r, the right one falls to zero at p + s ucs/m_b.
  double low = 0.0, high = centre + h.tension();
  if (!(high > 0.0)) return 0.0;
  constexpr int kHalvings = 60;
  for (int i = 0; i < kHalvings; ++i) {
    const double r = 0.5 * (low + high);
    const double right = h.ucs * std::pow(std::max(0.0, h.mb * (centre - r) / h.ucs + h.s), h.a);
    (2.0 * r < right ? low : high) = r;
  }
  return 0.5 * (low + high);
}

double tension_of(const MohrCoulombStrength& m) { return m.tension; }
double tension_of(const HoekBrownStrength& h) { return h.tension(); }

/// Ratio of a part to the whole, at most kMostUtilisation; without a whole, kMostUtilisation.
double over(double part, double whole) {
  if (!(part > 0.0)) return 0.0;
  return whole > 0.0 ? std::min(part / whole, kMostUtilisation) : kMostUtilisation;
}

}  // namespace

HoekBrownStrength HoekBrownStrength::of_rock_mass(double ucs, double gsi, double mi, double d) {
  HoekBrownStrength h;
  h.ucs = ucs;
  h.mb = mi * std::exp((gsi - 100.0) / (28.0 - 14.0 * d));
  h.s = std::exp((gsi - 100.0) / (9.0 - 3.0 * d));
  h.a = 0.5 + (std::exp(-gsi / 15.0) - std::exp(-20.0 / 3.0)) / 6.0;
  return h;
}

double utilisation(const RockStrength& strength, double s1, double s3) {
  return std::visit(
      [&](const auto& law) {
        const double radius = 0.5 * (s1 - s3), centre = -0.5 * (s1 + s3);
        return std::max(over(radius, largest_radius(law, centre)), over(s1, tension_of(law)));
      },
      strength);
}

}  // namespace scree
