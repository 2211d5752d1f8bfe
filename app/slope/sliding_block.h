// A rigid block on a plane under a record: sliding by double integration.
#pragma once

#include "model/record_processing.h"

namespace scree::app {

struct BlockSlide {
  double displacement = 0.0;   // of the block on the plane at the end [m]
  double peak_velocity = 0.0;  // of the block relative to the plane [m/s]
  int slips = 0;               // phases of sliding
};

/// Sliding of a rigid-plastic block in one direction. The block sticks while the acceleration of the ground is not
/// above its yield acceleration; then the velocity v relative to the plane follows
///   v' = factor (a(t) - a_c)   while v > 0
/// The acceleration is linear between samples, and zero after the last one; beginning and end of each slide, and the
/// displacement, are exact for this input: v is a parabola in each step.
/// @param record  acceleration that drives the block down the plane where it is positive [m/s2]
/// @param yield   yield acceleration a_c [m/s2], above 0
/// @param factor  relative acceleration for each unit of excess: 1 for motion along the plane; for horizontal motion
///                cos(dip) + sin(dip) tan(phi)
/// @throws std::invalid_argument where yield or factor is not above 0
/// @source [Newmark1965]; [Jibson2007] section 2
[[nodiscard]] BlockSlide slide_of(const Samples& record, double yield, double factor = 1.0);

/// The samples with the opposite sign: the ground moves in the opposite direction.
[[nodiscard]] Samples reversed(Samples record);

}  // namespace scree::app
