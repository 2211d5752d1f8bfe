// The side of a run that receives commands over LCM: pause, resume, step, checkpoint, stop, rate, field. Only a run
// with the option --control makes a server; a run without it has no receiving socket.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "coupling/sink.h"
#include "io/live/control_gate.h"
#include "io/live/live_bus.h"
#include "io/live/live_field.h"

namespace scree::io {

/// Functions of the rest of the program that a server calls. All are called on the thread that runs the simulation,
/// between steps; none may change the state of the run.
struct ControlHooks {
  /// Session of the stream, defined once the run has begun.
  std::function<std::int64_t()> session;
  /// Writes a checkpoint of the present state.   @return its name
  /// The text of an exception is sent to the sender, and the run goes on. Empty: checkpoints are not available.
  std::function<std::string()> on_checkpoint;
  std::function<void(double frames_a_second)> on_rate;
  std::function<void(LiveField field)> on_field;
  std::function<void(bool paused)> on_pause;
  /// Writes a line to the log of the run: commands carried out, and at the end the numbers of refused ones.
  std::function<void(const std::string& text)> note;
  /// Called at most once, with the reason why commands cannot be received.
  std::function<void(const std::string& text)> warn;
};

/// As the control of a driver it is called before every step, and holds the run there while it is paused; as a sink,
/// placed after the one that streams, it counts the steps. It only decides when the next step is made, so pausing and
/// stepping do not change a bit of the results. Receiving and answering have a thread of their own, which tries again
/// every 5 s when there is no network.
class ControlServer final : public coupling::Control, public coupling::Sink {
 public:
  /// @param run    name, the same as for the streaming sink   @param inner  also evaluated: signals; must outlive the
  ///               server   @param bus    connection to use (memq); null: one is opened
  /// @throws std::invalid_argument for a URL from which nothing can be received
  ControlServer(const std::string& url, std::string run, coupling::Control& inner, ControlHooks hooks,
                std::shared_ptr<LiveBus> bus = nullptr);
  /// Answers the commands that are still waiting, and ends the thread.
  ~ControlServer() override;

  void begin(const Model& model, const coupling::Plan& plan) override;
  void frame(const coupling::FrameView& frame) override;
  void step(double time, const coupling::RunStats& stats, const coupling::Ledger& ledger) override;
  void end(const coupling::RunEnd& end, const coupling::FrameView& last) override;
  /// Carries out the waiting commands; returns when the run may make a step, or has to stop.
  bool stop_requested() override;

  [[nodiscard]] ControlCounts counts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Error of a URL for control; empty if there is none. Only a network transmits commands to another program.
[[nodiscard]] std::string control_url_error(std::string_view url);

}  // namespace scree::io
