// The local pool: makes the runs of a sweep that have not ended yet, some at a time.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "app/sweep/run_outcome.h"
#include "app/sweep/sweep_folder.h"

namespace scree::app {

struct PoolSettings {
  std::size_t jobs = 1;  // runs at a time
  int threads = 1;       // per run
};

/// Callbacks of the pool while it works.
struct PoolHooks {
  std::function<void(std::size_t run, const RunOutcome&, double seconds)> ended;  // or tried: see the outcome
  std::function<void(const std::string&)> note;                                   // other messages for the user
  std::function<bool()> stop;                                                     // true: end the runs, start no more
};

struct PoolCounts {
  std::size_t done = 0, failed = 0;  // of all runs asked for, earlier ones included; failed: or refused by `scree run`
  std::size_t without_outcome = 0;   // tried, and ended without a summary
  std::size_t left = 0;              // not ended when the pool was stopped
};

/// Makes runs in processes of their own. A run that has ended is left as it is; a killed run continues from its
/// last checkpoint if one can be used, and begins anew otherwise. Waits for runs that another program is computing.
/// @param runs  numbers, from 1      @throws FileError, after every run that it started has ended
PoolCounts make_runs(const SweepFolder& folder, const SweepRecord& record, std::span<const std::size_t> runs,
                     const PoolSettings& settings, const PoolHooks& hooks);

}  // namespace scree::app
