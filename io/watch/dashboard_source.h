// Sources of a Dashboard: a stream, or a stored run.
#pragma once

#include <chrono>
#include <filesystem>

#include "io/live/live_reader.h"
#include "io/watch/dashboard.h"

namespace scree::io {

/// Updates a dashboard with the data of a reader. Of several runs, it shows the one that started last.
class LiveDashboard {
 public:
  using Clock = std::chrono::steady_clock;
  /// @param start  when the watcher began: waiting and the arrival of the mesh count from there
  LiveDashboard(std::unique_ptr<LiveReader> reader, std::string source, Clock::time_point start = Clock::now());
  /// @return what is known now; valid until the next call
  const Dashboard& refresh();
  /// True when no more messages can arrive: the log is over, or the connection failed.
  [[nodiscard]] bool ended() const { return reader_->ended(); }

 private:
  void take_events(std::int64_t session);

  std::unique_ptr<LiveReader> reader_;
  Dashboard now_;
  std::vector<event_v1_t> events_;  // of the session, by sequence
  std::int64_t session_ = -1;
  Clock::time_point start_, heard_;
};

/// The end of a stored run, or its progress so far.   @throws FileError when the folder is no run or damaged
[[nodiscard]] Dashboard stored_dashboard(const std::filesystem::path& run_folder);

}  // namespace scree::io
