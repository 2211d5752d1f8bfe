// Processes that run at the same time.
#pragma once

#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace scree::app {

/// The program itself, several times. The processes belong to the group of this one: what ends the group ends them.
class ProcessPool {
 public:
  struct Ended {
    std::size_t run = 0;
    int exit_code = 0;  // 128 + signal where a signal ended it, as a shell counts
  };

  ProcessPool() = default;
  ProcessPool(const ProcessPool&) = delete;
  ProcessPool& operator=(const ProcessPool&) = delete;
  /// Ends what still runs and waits for it.
  ~ProcessPool();

  /// Starts the program with these arguments (its own name is added).
  /// @param log  takes what it prints, in place of what the file had   @throws FileError where it cannot be started
  void start(std::size_t run, const std::vector<std::string>& arguments, const std::filesystem::path& log);
  /// One that has ended since; waits for none.
  [[nodiscard]] std::optional<Ended> poll();
  /// Asks all to end (SIGTERM).
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
