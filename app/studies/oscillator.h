// One block on a spring at its centre, moved by Scree's own time schemes: an oscillator with one frequency.
#pragma once

#include <vector>

#include "coupling/plan.h"
#include "model/geometry.h"

namespace scree::app {

/// Steps of a square DDA block without weight, tied to a spring at its centre so that w h = Omega, let go from the
/// centre with a velocity. Its strains stay zero exactly: the spring pulls on no node but the centre.
/// @return z = (u, h v) at the start and after every step [m]
[[nodiscard]] std::vector<Vec2> oscillator_steps(coupling::Integrator integrator, double Omega, int steps);

/// What one step does to z, by least squares over all steps: z' = A z.
struct MeasuredStep {
  Mat2 A;
  double misfit = 0.0;  // largest |z' - A z| over |z|
};
[[nodiscard]] MeasuredStep measured_step(const std::vector<Vec2>& z);

}  // namespace scree::app
