// Progress of a run of a sweep, read from its folder.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace scree::app {

struct RunOutcome {
  enum class State {
    absent,   // never begun, or cleared
    started,  // killed or stopped before its end, or ended without a summary
    done,     // ran to its end
    failed    // its summary states why
  };
  State state = State::absent;
  std::string status = "absent";  // of summary.json; absent, started or failed where there is none
  std::string reason;             // of a run that did not end well

  /// Whether running it again would change nothing.
  [[nodiscard]] bool ended() const { return state == State::done || state == State::failed; }
};

/// @param log        what the run printed: gives the reason where there is no summary
/// @param overrides  --set that the run is to have     @param case_sha256  of the text that it is to have
/// @throws FileError where the folder holds a run of another case or with other parameters
[[nodiscard]] RunOutcome run_outcome(const std::filesystem::path& folder, const std::filesystem::path& log,
                                     const std::vector<std::string>& overrides, const std::string& case_sha256);

/// The first error that a run printed, without "error: "; empty: none.
[[nodiscard]] std::string first_error(const std::filesystem::path& log);

/// Whether a run can continue from a checkpoint.
[[nodiscard]] bool has_checkpoint(const std::filesystem::path& folder);

/// Whether a program is computing in a run folder now.
[[nodiscard]] bool is_busy(const std::filesystem::path& folder);

}  // namespace scree::app
