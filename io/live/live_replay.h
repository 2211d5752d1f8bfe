// A stored run on LCM as if it were running: the same messages in the same order, so that viewers need not know.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "io/live/live_bus.h"

namespace scree::io {

/// What a replay did.
struct ReplayCounts {
  std::int64_t frames = 0;  // of the run
  std::int64_t sent = 0;    // of them; the others would have come faster than the rate of a stream
  bool complete = false;    // false: stopped
};

/// Frames, monitors, ledger, events and how far the run was come from run.vtkhdf. Its books of each hand-over are not
/// sent, only that it happened; rates and the time left are those of the replay.
class LiveReplay {
 public:
  static constexpr double kRate = 30.0;  // frames a second, at most

  /// @param name  of the run in the stream; empty: of its folder
  /// @param bus   to use (memq); null: opened from the URL
  /// @throws FileError where the folder is no run, or damaged; std::invalid_argument for a URL that is not accepted
  LiveReplay(const std::filesystem::path& run_folder, const std::string& url, const std::string& name,
             std::shared_ptr<LiveBus> bus = nullptr);
  ~LiveReplay();
  LiveReplay(const LiveReplay&) = delete;
  LiveReplay& operator=(const LiveReplay&) = delete;

  [[nodiscard]] const std::string& name() const;
  [[nodiscard]] const std::vector<double>& times() const;  // of the frames [s]

  /// Sends the run once. A viewer that comes late gets everything again within a second, as of a run.
  /// @param speed  simulated seconds a second; 0: as fast as frames can be read and sent
  /// @param stop   asked often; true ends the replay
  /// @param warn   called at most once: why nothing can be sent
  /// @throws FileError where a frame is damaged
  ReplayCounts run(double speed, const std::function<bool()>& stop, const std::function<void(std::string)>& warn);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
