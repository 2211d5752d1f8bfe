// Level ground beside a model, on a base excited by a motion: its action on a side of the model.
#pragma once

#include <vector>

#include "model/model.h"

namespace scree {

/// Level ground from its base to its free surface. Its motion does not depend on the model.
struct FreeField {
  double bottom = 0.0, top = 0.0;  // [m], bottom < top
  MotionId motion;
  bool rigid = false;    // true: the base follows the motion; false: a wave rises from more of the same rock below
  double upgoing = 1.0;  // of the motion's velocity: 1 for the upgoing wave itself or a rigid base, 1/2 for an outcrop
};

/// Velocity and stress in level ground at a height, by d'Alembert: with y from its base, H the height of its surface,
/// u the upgoing wave or the base's velocity, c the speed of shear waves for x and of pressure waves for y
///   compliant:  v = u(t - y/c) + u(t - (2 H - y)/c),  s/(rho c) = u(t - (2 H - y)/c) - u(t - y/c)
///   rigid:      v(t) = the same - v(t - 2 H/c),  and correspondingly for s
/// as tables. Linear interpolation in them is within 1e-4 of the largest velocity (1e-3 for accelerations that jump
/// from sample to sample).
/// @source docs/theory/seismic-input.md, "Free-field edges"
struct GroundHistory {
  std::vector<double> time;      // since the motion's first sample, equal steps [s]
  std::vector<double> velocity;  // along the axis [m/s]
  std::vector<double> stress;    // s_xy of x, s_yy of y, over rho c [m/s]
};
/// @param axis   0: x, 1: y      @param height  in the model's axes, bottom <= height <= top [m]
/// @param until  latest end of the table, since the first sample [s]
/// @return empty: the motion has no velocity along the axis
[[nodiscard]] GroundHistory ground_history(const Model& model, const FreeField& ground, MaterialId material, int axis,
                                           double height, double until);

/// Continues a model beyond its sides by level ground of their material. The ground's traction on them is, n outward,
///   stress n - rho (c_p n n^T + c_s t t^T)(v - v_ground):
/// viscous edges, and dead tractions with time functions that hold the ground's stress and velocity.
/// @param sides  near vertical, of one material, between bottom and top
/// @param until  end of the run, since the motion's first sample [s]
/// @source [Lysmer1969], [Wolf1988]; docs/theory/seismic-input.md, "Free-field edges"
void add_free_field(Model& model, const std::vector<EdgeSpan>& sides, const FreeField& ground, double until);

/// True for functions of tractions that add_free_field() made.
[[nodiscard]] bool of_free_field(const Model& model, FunctionId function);

}  // namespace scree
