// The side of a run that takes commands over LCM: pause, resume, step, checkpoint, stop, rate, field. Only a run that
// was asked to (run --control) makes one; without it a run has no socket that receives.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "coupling/sink.h"
#include "io/live/control_gate.h"
#include "io/live/live_bus.h"
#include "io/live/live_field.h"

namespace scree::io {

/// What a server may ask of the rest of the program. All are called on the thread that runs the simulation, between
/// steps; none may change the state of the run.
struct ControlHooks {
  /// Of the stream, known once the run has begun.
  std::function<std::int64_t()> session;
  /// Writes a checkpoint of the present state.   @return what it is called
  /// Whatever it throws is told to the sender, and the run goes on. Empty: checkpoints are not available.
  std::function<std::string()> on_checkpoint;
  std::function<void(double frames_a_second)> on_rate;
  std::function<void(LiveField field)> on_field;
  std::function<void(bool paused)> on_pause;
  /// A line for the log of the run: what was carried out, and at the end what was refused.
  std::function<void(const std::string& text)> note;
  /// At most once: why commands cannot be received.
  std::function<void(const std::string& text)> warn;
};

/// As the control of a driver it is asked before every step, and holds the run there while it is paused; as a sink,
/// which comes after the one that streams, it counts the steps. It only ever decides when the next step is taken, so a
/// run is bitwise the same however it is paused and stepped. Receiving and answering have a thread of their own, which
/// tries again every 5 s where there is no network.
class ControlServer final : public coupling::Control, public coupling::Sink {
 public:
  /// @param run    as the sink that streams was given it   @param inner  asked too: signals; must outlive the server
  /// @param bus    to use (memq); null: one is opened
  /// @throws std::invalid_argument for a URL that nothing can be received from
  ControlServer(const std::string& url, std::string run, coupling::Control& inner, ControlHooks hooks,
                std::shared_ptr<LiveBus> bus = nullptr);
  /// Answers what is still waiting, and ends the thread.
  ~ControlServer() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void frame(const coupling::FrameView& frame) override;
  void step(double time, const coupling::RunStats& stats, const coupling::Ledger& ledger) override;
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;
  /// Carries out what is waiting; returns when the run may make a step, or is to stop.
  bool stop_requested() override;

  [[nodiscard]] ControlCounts counts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// What is wrong with a URL for control: only a network carries commands to another program. Empty if nothing is.
[[nodiscard]] std::string control_url_error(std::string_view url);

}  // namespace scree::io
