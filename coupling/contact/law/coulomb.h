// Tangential spring of a contact point with Coulomb's limit: return mapping.
#pragma once

#include <cmath>

namespace scree::coupling {

/// Result of a return mapping of a tangential spring.
struct CoulombStep {
  double stretch = 0.0;     // elongation that remains [m]
  double slip = 0.0;        // displacement of the slider, with the sign of the trial elongation [m]
  double force = 0.0;       // on the corner, along the edge, against the elongation [N]
  double tangent = 0.0;     // -dforce/dtrial at a fixed limit [N/m]
  double dissipated = 0.0;  // |force| |slip|: work of the slider at the force where the step ends [J]
};

/// A spring that slides: e' = sign(e) F/k_t, slip s = e - e'.   @pre limit is finite, at most k_t |trial|
/// Energy identity: k_t e^2/2 = k_t e'^2/2 + F |s| + k_t s^2/2. The last term is energy of the predictor that is
/// neither stored nor dissipated; an integrator that has forces at both ends of its step books friction by their
/// trapezoid instead.
[[nodiscard]] inline CoulombStep sliding(double kt, double trial, double limit) {
  const double kept = std::copysign(limit / kt, trial);
  return {kept, trial - kept, -kt * kept, 0.0, limit * std::abs(trial - kept)};
}

/// Elastic predictor and plastic corrector of an elongation e under the limit F >= 0: it sticks, e' = e, where
/// |k_t e| <= F, and slides else.
/// @param trial  elongation without slip [m]   @param limit  [N], may be infinite   @source [Simo1998] chapter 1
[[nodiscard]] inline CoulombStep return_mapping(double kt, double trial, double limit) {
  if (!(kt * std::abs(trial) > limit)) return {trial, 0.0, -kt * trial, kt, 0.0};
  return sliding(kt, trial, limit);
}

/// Energy of the tangential spring [J].
[[nodiscard]] inline double tangential_spring_energy(double kt, double stretch) { return 0.5 * kt * stretch * stretch; }

}  // namespace scree::coupling
