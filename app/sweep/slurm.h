// Runs of a sweep as a job array of Slurm.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace scree::app {

struct Submission {
  int exit_code = 0;   // of sbatch: with `wait`, of the job
  std::string job;     // its number; empty where sbatch gave none
  std::string errors;  // what sbatch printed on standard error
  bool stopped = false;
};

/// Submits a script by sbatch.
/// @param wait  until the whole array has ended
/// @param stop  called while waiting; true: stop waiting, the job continues
/// @param submitted  called with the number of the job as soon as it is known
/// @throws FileError where sbatch cannot be started
[[nodiscard]] Submission submit(const std::filesystem::path& script, bool wait, const std::function<bool()>& stop,
                                const std::function<void(const std::string&)>& submitted);

}  // namespace scree::app
