// Explicit steps for all bodies, the internal force of some evaluated once in several of them.
#pragma once

#include "coupling/integrate/central_difference.h"
#include "coupling/integrate/step_rollback.h"

namespace scree::coupling {

/// Central difference in substeps of h for every body, H = sum of h the step. Contacts, loads, supports, damping and
/// the internal force of fast bodies act at every instant, the internal force S of slow ones (Ghosts::slow) at the two
/// ends of H alone, as kicks of H/2 each:
///   M a_j = F(x_j) + w_j S(x_j),   w_j = H/h at the ends of H, 0 between
/// It is the central difference with another force, so that its identities of work hold unchanged, and all kicks are
/// in equal and opposite pairs. Order 2 in H; reversible at constant h and H. Where h, and so w_j, changes at an
/// instant, the jump of the acceleration is booked as a change of the step.
/// h is the certified step of the plain scheme: with H w <= 1/2 (slow_step()) the stiffness of slow bodies hardly
/// reduces it. That avoids the strong resonances of the kicks with the faster motion of contacts; weak ones remain, in
/// which the motion grows by some hundredths per step (map in subcycled_test.cpp): watch_energy() reports them.
/// @source docs/theory/explicit-implicit-coupling.md, "Explicit steps of two sizes"
class Subcycled final : public TimeIntegrator {
 public:
  struct Choice {
    ExplicitDamping damping;
    double safety = 0.8;        // fraction of the certified bound that automatic substeps take
    std::int32_t substeps = 0;  // 0: automatic
  };
  /// @param setup  with slow bodies
  Subcycled(const Setup& setup, const StepControl& control, double detection, const Choice& choice);

  double enter(State& state) override;
  void resume(State& state, const IntegratorMemory& memory) override;
  [[nodiscard]] IntegratorMemory lend() override;
  void take_back(IntegratorMemory& memory) override;
  StepReport step(State& state, Tick ticks_of_step) override;
  void leave(State& state) override { fine_.leave(state); }
  void update_ledger(State& state) override { fine_.update_ledger(state); }
  /// Step bound of the substeps.
  double stable_step(const State& state, std::string* binding) override;
  void contact_forces(const State& state, std::span<double> f) const override { fine_.contact_forces(state, f); }
  [[nodiscard]] bool step_still_stable() const override { return fine_.step_still_stable(); }

  /// Substeps of the last step.
  [[nodiscard]] std::int32_t substeps() const { return substeps_; }

 private:
  /// Number of substeps for the rest of a step.
  [[nodiscard]] std::int64_t parts(Tick left) const;

  Choice choice_;
  CentralDifference fine_;
  double bound_ = 0.0;  // certified substep [s]; 0: to be found
  std::int32_t substeps_ = 0;
  StepRollback rollback_;
};

}  // namespace scree::coupling
