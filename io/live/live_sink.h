// Streams a run over LCM while it computes. It only reads the run, so that streaming changes no result.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "coupling/sink.h"
#include "io/live/live_bus.h"
#include "io/live/live_data.h"
#include "io/live/live_field.h"

namespace scree::io {

/// Identification of the streaming run. Only the name is required.
struct LiveRun {
  std::string name = {};       // of the run; channels contain channel_run(name)
  std::string version = {};    // of the program
  std::string case_hash = {};  // SHA-256 of the case text, or empty
  LiveField field = LiveField::speed;
  std::optional<double> until = {};  // time at which the run stops, before the end of its plan [s]
};

/// Frames, monitors and the ledger are taken at most plan.rate times per second of wall time (0: only the last frame of
/// the run), and frames only so often that copying them takes at most a hundredth of the time. Data not sent before the
/// next of their kind are replaced. All events are sent; INFO is sent once per second, TOPO with the first frame of a
/// mesh and every second, together with the newest data of all other kinds, so that a viewer may start at any time.
/// Sending has a thread of its own. Messages and channels: io/lcmtypes, channel.h.
class LiveSink final : public coupling::Sink {
 public:
  using Warn = std::function<void(std::string)>;

  /// @param warn  called at most once in the life of the sink, on the thread that runs the simulation, when nothing can
  ///              be sent: no multicast route, or the system refuses. The sink then tries again every 5 s without a
  ///              warning, except for a log file, which it does not open again.
  /// @param bus   a connection to share with a reader of the same program (memq); null: opened from plan.url
  /// @throws std::invalid_argument with the text of check_live_url(plan.url)
  LiveSink(const coupling::LivePlan& plan, LiveRun run, Warn warn, std::shared_ptr<LiveBus> bus = nullptr);
  /// Sends the waiting data: at most one mesh and one frame.
  ~LiveSink() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void frame(const coupling::FrameView& frame) override;
  void history(const coupling::HistoryView& history) override;
  void event(const coupling::Event& event) override;
  void step(double time, const coupling::RunStats& stats, const coupling::Ledger& ledger) override;
  /// Sends the last frame and INFO, then ends the thread.
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;

  /// To be called between steps: frames per second from now on, in place of plan.rate.
  void set_rate(double rate);
  /// To be called between steps: scalar of the frames from the next one on.
  void set_field(LiveField field);
  /// To be called between steps: viewers are informed immediately that the run is held or continues.
  void set_paused(bool paused);

  /// Session of the run that has begun, as in the header of every message.
  [[nodiscard]] std::int64_t session() const;
  [[nodiscard]] std::int64_t frames_sent() const;
  [[nodiscard]] std::int64_t frames_skipped() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
