// What becomes of the velocity that a body cannot take along when only affine motion goes on.
#pragma once

#include "coupling/plan.h"
#include "model/pool.h"

namespace scree::coupling {

/// 1/2 m vc^2 + 1/2 tr(F' S F'^T) [J]
[[nodiscard]] double kinetic_of(const ReferenceShape& shape, const AffineMotion& motion);

/// Changes the affine velocity of a release as the mode wants; kinetic_rest and velocity_rest keep what is left over.
///   reservoir    nothing: all of w stays in the reservoir
///   strain_rate  B = G S is split into spin w0 W S, w0 = L / tr S, and Y, symmetric, which is scaled by
///                sqrt(1 + dT / T_def) but at most by the cap: momenta and energy exact
///   rotational   spin from 1/2 sum J_e w_e^2 = 1/2 J w^2, J_e about the block's centre ([Qu2013] eq. 8.2): breaks the
///                angular momentum, and the energy by what is returned
/// @param cap  largest factor of the strain rates, >= 1
/// @return kinetic energy that neither the motion nor the reservoir has [J]
/// @source docs/theory/transfer.md, "Modes"
[[nodiscard]] double limit_release(TransferMode mode, double cap, Release& release);

}  // namespace scree::coupling
