// Makes the runs of `scree fos` in separate processes, several at a time.
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
  std::string start_from;        // name of the run that it continues; empty: it begins with the first stage
};

struct TrialPoolHooks {
  std::function<void(const std::string& name, const RunOutcome&, double seconds)> ended;
  std::function<bool()> stop;  // returns true to end the present runs and to start no more
};

/// Makes those of the given runs that have not ended; a run that was killed continues from its last checkpoint.
/// @param jobs  runs at a time   @param threads  per run
/// @return false if it was stopped
/// @throws FileError if a run ends without an outcome; the other runs are ended before
[[nodiscard]] bool make_trials(const FosFolder& folder, const FosRecord& record, const std::vector<WantedRun>& runs,
                               std::size_t jobs, int threads, const TrialPoolHooks& hooks);

/// Outcome of a run, read from its folder and its log.
[[nodiscard]] RunOutcome outcome_of(const FosFolder& folder, const FosRecord& record, const WantedRun& run);

}  // namespace scree::app
