// The audit of blocks that are asleep.
#pragma once

#include <functional>
#include <memory>

#include "coupling/contact/audit/audit.h"
#include "coupling/stages/force_balance.h"

namespace scree::coupling {

/// Evaluates the forces on blocks that are asleep from their positions, the present loads and their contacts, which
/// are found anew, with all other blocks left out, and checks that they balance. Constant while the same blocks are
/// asleep.
class SleepAudit {
 public:
  using Make = std::function<std::unique_ptr<TimeIntegrator>(const Setup&)>;
  /// @param make  makes an integrator, which takes no steps
  SleepAudit(const Setup& whole, const Methods& methods, const State& state, const Make& make);
  /// @param tolerance  Stage::sleep
  void check(Tick time, double tolerance, Audit& audit);

 private:
  Setup setup_;
  State state_;
  std::unique_ptr<TimeIntegrator> integrator_;
  std::unique_ptr<ForceBalance> balance_;
};

}  // namespace scree::coupling
