// What came of a step.
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
    refused,       // the scheme cannot do it, whatever the step
    given_up,      // stopped by the controller of the run (Control::give_up_step)
    non_finite     // a position or velocity is not a number
  };
  Status status = Status::ok;
  double suggested = 0.0;     // fraction of the step to try next; 0: the cut factor of the plan
  BodyIndex body;             // where it went wrong
  std::string cause;          // for a status other than ok: what, where, likely cause
  std::int32_t substeps = 1;  // explicit ones in it, that fast bodies have taken (Subcycled)
  // Explicit steps that were made for a partitioned one, which repeats them in every iteration.
  std::int64_t explicit_steps = 0;
  int passes = 0;    // open-close passes
  int switches = 0;  // of contact states in them
  int factorisations = 0;
  int updates = 0;           // rank-1 changes of a factor
  int corrections = 0;       // solutions with the factor of a matrix that is not quite that of the step
  int block_iterations = 0;  // of them those with an incomplete factor of blocks
  int incomplete_factors = 0;
  int local_passes = 0;       // of clusters of bodies
  int fallbacks = 0;          // from it to a complete factor, in the pass
  int iterations = 0;         // of Newton's method
  double residual = 0.0;      // it left, over the largest force
  bool at_round_off = false;  // the residual stands above 1e-11 because the numbers end there
  double left_work = 0.0;     // of what it left, as far as that is round-off, on the step's way [J]
};

}  // namespace scree::coupling
