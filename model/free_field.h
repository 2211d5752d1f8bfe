// The ground beside a model: level, of one material, on a base that a motion shakes. It does not depend on the model.
#pragma once

#include <cmath>

#include "model/elasticity.h"
#include "model/geometry.h"

namespace scree {

/// Level ground from its base to its free surface.
struct FreeField {
  double bottom = 0.0, top = 0.0;  // [m], bottom < top
  bool rigid = false;  // true: the base moves as a motion; false: a wave comes up from more of the same rock
};

/// What goes through the ground at a height: velocity [m/s] and stress beside that at rest [Pa].
struct GroundWave {
  Vec2 velocity{0.0, 0.0};
  Mat2 stress = Mat2::Zero();
};

/// Sum of the waves of one kind that go up and down at a height y above the base, by d'Alembert; H: of the surface.
///   compliant:  v = u(t - y/c) + u(t - (2 H - y)/c),  s/(rho c) = u(t - (2 H - y)/c) - u(t - y/c),  u: the upgoing
///   wave rigid:      the same with u the base's velocity, and + (-1)^k of it, 2 k H/c later, k = 1, 2, ...
/// @param y  [m]      @param speed  c [m/s]      @param age  since u began: it is zero before [s]
/// @param wave  wave(delay) = u(t - delay)
/// @return velocity [m/s], and stress over rho c [m/s]
/// @source docs/theory/seismic-input.md, "Free-field edges"
struct WaveSum {
  double velocity = 0.0, stress = 0.0;
};
template <class Wave>
[[nodiscard]] WaveSum wave_sum(const FreeField& ground, double y, double speed, double age, Wave&& wave) {
  const double height = ground.top - ground.bottom;
  WaveSum sum;
  double sign = 1.0;
  for (double before = 0.0; (before + y) / speed <= age; before += 2.0 * height) {
    const double up = sign * wave((before + y) / speed), down = sign * wave((before + 2.0 * height - y) / speed);
    sum.velocity += up + down;
    sum.stress += down - up;
    if (!ground.rigid) break;
    sign = -sign;
  }
  return sum;
}

/// Velocity and stress at a height: horizontal motion as shear waves, vertical motion as pressure waves.
/// @param at  height, in the model's axes [m], bottom <= at <= top      @param age, wave  as above, wave gives a Vec2
template <class Wave>
[[nodiscard]] GroundWave ground_wave(const FreeField& ground, const Elasticity& law, double density, double at,
                                     double age, Wave&& wave) {
  const double y = at - ground.bottom, c_s = std::sqrt(law.mu / density), c_p = std::sqrt(law.p_modulus() / density);
  const WaveSum shear = wave_sum(ground, y, c_s, age, [&](double delay) { return wave(delay).x(); }),
                pressure = wave_sum(ground, y, c_p, age, [&](double delay) { return wave(delay).y(); });
  const double xy = density * c_s * shear.stress, yy = density * c_p * pressure.stress,
               xx = law.lambda / law.p_modulus() * yy;
  GroundWave out{{shear.velocity, pressure.velocity}, {}};
  out.stress << xx, xy, xy, yy;
  return out;
}

}  // namespace scree
