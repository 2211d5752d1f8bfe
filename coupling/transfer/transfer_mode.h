// Treatment of the non-affine velocity of a body that continues with affine motion only.
#pragma once

#include "coupling/plan.h"
#include "model/pool.h"

namespace scree::coupling {

/// 1/2 m vc^2 + 1/2 tr(F' S F'^T) [J]
[[nodiscard]] double kinetic_of(const ReferenceShape& shape, const AffineMotion& motion);

/// Changes the affine velocity of a release by the mode; kinetic_rest and velocity_rest keep the remainder.
///   reservoir    no change: all of w stays in the reservoir
///   strain_rate  B = G S is split into spin w0 W S, w0 = L / tr S, and Y, symmetric, which is scaled by
///                sqrt(1 + dT / T_def) but at most by the cap: momenta and energy exact
///   rotational   spin from 1/2 sum J_e w_e^2 = 1/2 J w^2, J_e about the block's centre ([Qu2013] eq. 8.2): violates
///                angular momentum, and energy by the returned amount
/// @param cap  largest factor of the strain rates, >= 1
/// @return kinetic energy that is neither in the motion nor in the reservoir [J]
/// @source docs/theory/transfer.md, "Modes"
[[nodiscard]] double limit_release(TransferMode mode, double cap, Release& release);

}  // namespace scree::coupling
