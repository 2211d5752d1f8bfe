// Friction that falls with the slip rate and follows it over a distance.
#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "coupling/contact/law/friction_laws.h"

namespace scree::coupling {
namespace {

// With v the slip rate, s the slip, and tan phi_v the friction of a steady slide:
//   tan phi_v = tan phi_f + (tan phi_p - tan phi_f) / (1 + v/v_w)
//   d tan phi / d s = -(tan phi - tan phi_v) / D
// integrated exactly over a step of constant v. At rest nothing changes; in a slide that slows, friction recovers.

enum : std::size_t { kFastFriction, kVelocity, kSlip };

double fast(FrictionLaw::Constants c) { return std::tan(c[kFastFriction] * std::numbers::pi / 180.0); }

void evolve(double tan_peak, FrictionLaw::Constants c, double step, std::span<FrictionRow> rows) {
  const double lost = fast(c) - tan_peak;  // change of tan phi as v grows without bound, at most 0
  for (FrictionRow& row : rows) {
    const double faster = row.slip / step / c[kVelocity];  // v / v_w
    const double steady = lost * faster / (1.0 + faster);
    row.change = steady + (row.change - steady) * std::exp(-row.slip / c[kSlip]);
  }
}

double least(double, FrictionLaw::Constants c) { return fast(c); }

std::string fault(double tan_peak, FrictionLaw::Constants c) {
  if (fast(c) <= tan_peak) return {};
  return fmt::format("fast_friction_deg is {:g}, above the friction_deg of the joint, {:g}: friction would grow",
                     c[kFastFriction], std::atan(tan_peak) * 180.0 / std::numbers::pi);
}

}  // namespace

FrictionLaw velocity_weakening() {
  FrictionLaw law;
  law.name = "velocity_weakening";
  law.meaning =
      "Friction that falls with the slip rate v, from friction_deg at rest to fast_friction_deg: its tangent in a "
      "steady "
      "slide loses the part v/(v + velocity) of the way. It follows a change of v over `slip`. Stages to rest do not "
      "change it.";
  law.keys = {
      {"fast_friction_deg", "deg", 0.0, false, 90.0, true,
       "Friction angle that a fast slide tends to, at most friction_deg."},
      {"velocity", "m/s", 0.0, true, std::numeric_limits<double>::infinity(), false,
       "Slip rate at which half of the difference is lost."},
      {"slip", "m", 0.0, true, std::numeric_limits<double>::infinity(), false,
       "Slip over which the tangent of the friction angle comes nearer to its steady value, by a factor of e."}};
  law.evolve = evolve;
  law.least = least;
  law.fault = fault;
  return law;
}

}  // namespace scree::coupling
