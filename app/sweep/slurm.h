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

/// Hands a script to sbatch.
/// @param wait  until the whole array has ended      @param stop  asked meanwhile; true: waits no more, the job goes on
/// @param submitted  told the number of the job as soon as it is known
/// @throws FileError where sbatch cannot be started
[[nodiscard]] Submission submit(const std::filesystem::path& script, bool wait, const std::function<bool()>& stop,
                                const std::function<void(const std::string&)>& submitted);

}  // namespace scree::app
