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

/// Who is streaming. A name alone will do.
struct LiveRun {
  std::string name = {};       // of the run; in the channels as channel_run(name)
  std::string version = {};    // of the program
  std::string case_hash = {};  // SHA-256 of the case text, or empty
  LiveField field = LiveField::speed;
  std::optional<double> until = {};  // the run stops here, before the end of its plan [s]
};

/// Per frame, the monitors and the ledger are taken at most plan.rate times a second of wall time (0: only the last
/// frame of the run), and frames so seldom that copying them takes at most a hundredth of the time; what is not sent
/// before the next is replaced. Events are all sent; INFO goes out once a second, TOPO with the first frame of a mesh
/// and every second, and with it once more the newest of everything else, so that a viewer may come at any time.
/// Sending has a thread of its own. Messages and channels: io/lcmtypes, channel.h.
class LiveSink final : public coupling::Sink {
 public:
  using Warn = std::function<void(std::string)>;

  /// @param warn  called at most once in the life of the sink, on the thread that runs the simulation, when nothing can
  ///              be sent: no multicast route, or the system refuses. The sink then tries again quietly, every 5 s, but
  ///              for a log file, which it gives up.
  /// @param bus   a connection to share with a reader of the same program (memq); null: opened from plan.url
  /// @throws std::invalid_argument with the text of check_live_url(plan.url)
  LiveSink(const coupling::LivePlan& plan, LiveRun run, Warn warn, std::shared_ptr<LiveBus> bus = nullptr);
  /// Sends what is waiting: at most one mesh and one frame.
  ~LiveSink() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void frame(const coupling::FrameView& frame) override;
  void history(const coupling::HistoryView& history) override;
  void event(const coupling::Event& event) override;
  void step(double time, const coupling::RunStats& stats, const coupling::Ledger& ledger) override;
  /// Sends the last frame and INFO, then ends the thread.
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;

  /// Between steps: frames a second from now on, as plan.rate; viewers hear at once that the run is held or goes on.
  void set_rate(double rate);
  /// Between steps: what frames carry from the next one on.
  void set_field(LiveField field);
  void set_paused(bool paused);

  /// Of the run that has begun: in the header of every message.
  [[nodiscard]] std::int64_t session() const;
  [[nodiscard]] std::int64_t frames_sent() const;
  [[nodiscard]] std::int64_t frames_skipped() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
