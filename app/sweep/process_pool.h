// Processes that run at the same time.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// Several processes of this program. They belong to the process group of this one: a signal to the group ends them.
class ProcessPool {
 public:
  struct Ended {
    std::size_t run = 0;
    int exit_code = 0;  // 128 + signal where a signal ended it, as in a shell
  };

  ProcessPool() = default;
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;
  /// Ends the processes that still run and waits for them.
  ~ProcessPool();

  /// Starts the program with these arguments (its own name is added).
  /// @param log  file for its output, replacing earlier contents   @throws FileError where it cannot be started
  void start(std::size_t run, const std::vector<std::string>& arguments, const std::filesystem::path& log);
  /// A process that has ended, if there is one; does not wait.
  [[nodiscard]] std::optional<Ended> poll();
  /// Sends SIGTERM to all processes.
  void terminate() const;
  [[nodiscard]] std::size_t running() const { return processes_.size(); }

 private:
  struct Process {
    pid_t pid;
    std::size_t run;
    std::filesystem::path log;
  };
  std::vector<Process> processes_;
};

/// The file of this program.   @throws FileError
[[nodiscard]] std::filesystem::path this_program();

}  // namespace scree::app
