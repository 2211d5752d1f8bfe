// Which blocks change between the NMM and the DDA during a stage.
#pragma once

#include <string>
#include <vector>

#include "coupling/integrate/time_integrator.h"
#include "coupling/sink.h"

namespace scree::coupling {

/// A block that changes its method, and the reason.
struct MethodChange {
  BlockId block;
  MethodMeasures measures;
};

/// Applies the SwitchRules of a stage to its blocks. Constant between two changes of bodies.
///   NMM -> DDA   the non-affine energies are small, (dT, dU)/(T + |U|) and sqrt(dU/|U|), and no criterion for the way
///                back is met, all for the time `hold`, evaluated at intervals of a tenth of it; and the predicted cost
///                decreases: unknowns, for explicit steps times the number of steps per second by the block's own bound
///                (without contacts)
///   DDA -> NMM   strain rate, stress or the resultant of the contacts is above its bound; evaluated before every step
/// Excluded are blocks that are held or divided, other methods, onefold covers, and blocks that are cut along a crack,
/// which an affine block would close.
/// @source docs/theory/transfer.md, "Switching rules"
class MethodRules {
 public:
  /// @pre stage.change.used; all outlive it
  MethodRules(const Stage& stage, const Methods& methods, const Setup& setup, const State& state);
  /// Blocks that change now, in their order. State::rules stores since when a block has been calm. A second call
  /// at the same instant returns none.
  [[nodiscard]] std::vector<MethodChange> evaluate(State& state, const TimeIntegrator& integrator);

 private:
  [[nodiscard]] MethodMeasures measure(const Body& b, const State& state) const;
  /// True where a block of the DDA must change to the NMM.
  [[nodiscard]] bool strained(const MethodMeasures& m) const;
  [[nodiscard]] bool calm(const MethodMeasures& m) const;
  /// Fills the predicted costs.   @return true if the DDA costs less
  [[nodiscard]] bool cheaper(const Body& b, const State& state, MethodMeasures& m) const;
  void sum_contacts(const State& state, const TimeIntegrator& integrator);

  const Stage* stage_;
  const Methods* methods_;
  const Setup* setup_;
  std::vector<std::size_t> nmm_, dda_;  // bodies that may change, by the method they have
  std::vector<double> force_;           // contact forces, x, y per node [N]
};

/// One line for events.
[[nodiscard]] std::string text(const MethodMeasures& m);

}  // namespace scree::coupling
