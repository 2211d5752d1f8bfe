// Makes the runs of `scree fos`, some at a time, in processes of their own.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "app/fos/fos_folder.h"
#include "app/sweep/run_outcome.h"

namespace scree::app {

/// A requested run.
struct WantedRun {
  std::string name;              // of its folder
  std::vector<std::string> set;  // all --set options
  std::string start_from;        // name of the run that it continues; empty: from the start
};

struct TrialPoolHooks {
  std::function<void(const std::string& name, const RunOutcome&, double seconds)> ended;
  std::function<bool()> stop;  // true: end the runs, start no more
};

/// Makes the runs that have not ended; a run that was killed continues from its checkpoint.
/// @param jobs  at a time   @param threads  per run
/// @return false where it was stopped   @throws FileError, after every run that it started has ended
[[nodiscard]] bool make_trials(const FosFolder& folder, const FosRecord& record, const std::vector<WantedRun>& runs,
                               std::size_t jobs, int threads, const TrialPoolHooks& hooks);

[[nodiscard]] RunOutcome outcome_of(const FosFolder& folder, const FosRecord& record, const WantedRun& run);

}  // namespace scree::app
