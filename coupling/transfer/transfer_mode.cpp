#include "coupling/transfer/transfer_mode.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace scree::coupling {
namespace {

void keep_less(double factor, Release& release) {
  release.kinetic_rest *= factor * factor;
  for (double& w : release.velocity_rest) w *= factor;
}

}  // namespace

double kinetic_of(const ReferenceShape& shape, const AffineMotion& motion) {
  return 0.5 * shape.mass * motion.vc.squaredNorm() +
         0.5 * (motion.Fdot * shape.second * motion.Fdot.transpose()).trace();
}

double limit_release(TransferMode mode, double cap, Release& release) {
  if (mode == TransferMode::reservoir || release.velocity_rest.empty()) return 0.0;  // the affine motion is unchanged
  AffineMotion& motion = release.motion;
  const Mat2 S = motion.F * release.shape.second * motion.F.transpose();
  const Mat2 G = motion.Fdot * motion.F.inverse();
  const double before = kinetic_of(release.shape, motion);
  if (mode == TransferMode::strain_rate) {
    const Mat2 B = G * S;
    const Mat2 spin = (B(1, 0) - B(0, 1)) / S.trace() * quarter_turn();
    const Mat2 Y = B - spin * S;
    const double deforming = 0.5 * (Y * S.inverse() * Y.transpose()).trace(), rest = release.kinetic_rest;
    if (!(deforming > 0.0) || !(rest > 0.0)) return 0.0;
    const double factor = std::min(cap, std::sqrt(1.0 + rest / deforming));
    motion.Fdot = (spin + factor * Y * S.inverse()) * motion.F;
    const double left = rest - (factor * factor - 1.0) * deforming;
    keep_less(std::sqrt(std::max(0.0, left) / rest), release);
    return 0.0;
  }
  const double sign = G(1, 0) - G(0, 1) < 0.0 ? -1.0 : 1.0;
  motion.Fdot = (0.5 * (G + G.transpose()) + sign * std::sqrt(release.spin_squared) * quarter_turn()) * motion.F;
  const double booked = before + release.kinetic_rest - kinetic_of(release.shape, motion);
  keep_less(0.0, release);
  return booked;
}

}  // namespace scree::coupling
