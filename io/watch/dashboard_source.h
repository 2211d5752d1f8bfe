// Where a Dashboard comes from: a stream, or a stored run.
#pragma once

#include <chrono>
#include <filesystem>

#include "io/live/live_reader.h"
#include "io/watch/dashboard.h"

namespace scree::io {

/// Brings a dashboard up to date with what a reader has. Several runs: the one that started last.
class LiveDashboard {
 public:
  using Clock = std::chrono::steady_clock;
  /// @param start  when the watcher began: waiting and the arrival of the mesh count from there
  LiveDashboard(std::unique_ptr<LiveReader> reader, std::string source, Clock::time_point start = Clock::now());
  /// @return what is known now; valid until the next call
  const Dashboard& refresh();
  /// True when nothing more will come: the log is over, or the connection failed.
  [[nodiscard]] bool ended() const { return reader_->ended(); }

 private:
  void take_events(std::int64_t session);

  std::unique_ptr<LiveReader> reader_;
  Dashboard now_;
  std::vector<event_v1_t> events_;  // of the session, by sequence
  std::int64_t session_ = -1;
  Clock::time_point start_, heard_;
};

/// The end of a stored run, or how far it has come.   @throws FileError when it is none or damaged
[[nodiscard]] Dashboard stored_dashboard(const std::filesystem::path& run_folder);

}  // namespace scree::io
