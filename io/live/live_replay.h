// Sends a stored run over LCM as if it were running: the same messages in the same order; viewers need no special case.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "io/live/live_bus.h"

namespace scree::io {

/// Result of a replay.
struct ReplayCounts {
  std::int64_t frames = 0;  // of the run
  std::int64_t sent = 0;    // frames sent; the others would have exceeded the rate of a stream
  bool complete = false;    // false: stopped
};

/// Frames, monitors, ledger, events and progress are read from run.vtkhdf. The balances of transfers are not sent, only
/// their events; rates and the remaining time are those of the replay.
class LiveReplay {
 public:
  static constexpr double kRate = 30.0;  // frames per second, at most

  /// @param name  of the run in the stream; empty: name of its folder
  /// @param bus   connection to use (memq); null: opened from the URL
  /// @throws FileError where the folder is no run, or damaged; std::invalid_argument for a URL that is not accepted
  LiveReplay(const std::filesystem::path& run_folder, const std::string& url, const std::string& name,
             std::shared_ptr<LiveBus> bus = nullptr);
  ~LiveReplay();
  LiveReplay(const LiveReplay&) = delete;
  LiveReplay& operator=(const LiveReplay&) = delete;

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] const std::vector<double>& times() const;  // of the frames [s]

  /// Sends the run once. A viewer that starts late receives everything again within a second, as from a run.
  /// @param speed  simulated seconds per second; 0: as fast as frames can be read and sent
  /// @param stop   called often; true ends the replay
  /// @param warn   called at most once, with the reason why nothing can be sent
  /// @throws FileError where a frame is damaged
  ReplayCounts run(double speed, const std::function<bool()>& stop, const std::function<void(std::string)>& warn);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
