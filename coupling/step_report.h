// Result of a step.
#pragma once

#include <cstdint>
#include <string>

namespace scree::coupling {

/// Result of a step. Non-convergence is a status; the state is then the one before the step.
struct StepReport {
  enum class Status {
    ok,
    too_far,       // a point would move farther than allowed: raise the limit or shorten the step
    no_states,     // open-close iteration found no consistent contact states in the passes allowed
    no_friction,   // friction did not settle with the contact states given
    no_balance,    // Newton's method left a residual force
    not_definite,  // the implicit matrix could not be factorised
    refused,       // the scheme cannot make this step, whatever its length
    given_up,      // stopped by the controller of the run (Control::give_up_step)
    non_finite     // a position or velocity is not a number
  };
  Status status = Status::ok;
  double suggested = 0.0;     // fraction of the step to try next; 0: the cut factor of the plan
  BodyIndex body;             // where the step failed
  std::string cause;          // for a status other than ok: fault, place, likely cause
  std::int32_t substeps = 1;  // explicit substeps of fast bodies in this step (Subcycled)
  // Explicit steps made within a partitioned step, which repeats them in every iteration.
  std::int64_t explicit_steps = 0;
  int passes = 0;    // open-close passes
  int switches = 0;  // switches of contact states in these passes
  int factorisations = 0;
  int updates = 0;           // rank-1 changes of a factor
  int corrections = 0;       // solutions with the factor of a matrix that differs from that of the step
  int block_iterations = 0;  // corrections with an incomplete factor of blocks
  int incomplete_factors = 0;
  int local_passes = 0;       // open-close passes of clusters of bodies
  int fallbacks = 0;          // passes that changed from an incomplete factor to a complete one
  int iterations = 0;         // of Newton's method
  double residual = 0.0;      // of Newton's method, over the largest force
  bool at_round_off = false;  // the residual stays above 1e-11 because of round-off
  double left_work = 0.0;     // work of the residual, as far as it is round-off, on the step's displacement [J]

  /// Adds the counts of work of an earlier trial of the step; `iterations` still says how this one converged.
  void add_work(const StepReport& trial) {
    passes += trial.passes;
    switches += trial.switches;
    factorisations += trial.factorisations;
    updates += trial.updates;
    corrections += trial.corrections;
    block_iterations += trial.block_iterations;
    incomplete_factors += trial.incomplete_factors;
    local_passes += trial.local_passes;
    fallbacks += trial.fallbacks;
  }
};

}  // namespace scree::coupling
