// The side that asks: finds a run that streams, sends it a command, waits for its answers.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/live/control_gate.h"
#include "io/live/live_bus.h"

namespace scree::io {

/// What a run said to a command.
struct ControlReply {
  enum class Kind {
    answered,  // ack has the last word
    no_end,    // accepted, but nothing more came in time
    silence    // no answer at all
  } kind = Kind::silence;
  ack_v1_t ack{};
};

class ControlClient {
 public:
  /// @param why  set when the answer is null   @throws std::invalid_argument for a URL that check_live_url refuses
  [[nodiscard]] static std::unique_ptr<ControlClient> open(const std::string& url, std::string& why);
  /// On a connection that a run of this program uses (memq), which that run handles too.
  explicit ControlClient(std::shared_ptr<LiveBus> bus);
  ~ControlClient();
  ControlClient(const ControlClient&) = delete;
  ControlClient& operator=(const ControlClient&) = delete;

  /// Names of the runs that are heard in that time, as in their channels: 1.5 s hear every one that streams.
  [[nodiscard]] std::vector<std::string> heard(std::chrono::milliseconds time);

  /// Asks a run who it is, then sends its session the command, again every half second until an answer comes.
  /// @param accepted  called once, when the run has heard but not yet carried out the command
  [[nodiscard]] ControlReply ask(const std::string& run, ControlVerb verb, double value, std::chrono::milliseconds most,
                                 const std::function<void()>& accepted = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A sealed command.   @param sequence  microseconds since 1970
[[nodiscard]] Bytes encode_command(std::int64_t session, const ControlCommand& command);

}  // namespace scree::io
