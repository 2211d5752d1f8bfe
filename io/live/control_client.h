// The side that sends commands: finds a run that streams, sends it a command, waits for its answers.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "io/live/control_gate.h"
#include "io/live/live_bus.h"

namespace scree::io {

/// Answer of a run to a command.
struct ControlReply {
  enum class Kind {
    answered,  // ack is the final answer
    no_end,    // accepted, but no final answer in time
    silence    // no answer at all
  } kind = Kind::silence;
  ack_v1_t ack{};
};

class ControlClient {
 public:
  /// @param why  set when the result is null   @throws std::invalid_argument for a URL that check_live_url refuses
  [[nodiscard]] static std::unique_ptr<ControlClient> open(const std::string& url, std::string& why);
  /// Uses a connection (memq) that a run in this program uses and handles as well.
  explicit ControlClient(std::shared_ptr<LiveBus> bus);
  ~ControlClient();
  ControlClient(const ControlClient&) = delete;
  ControlClient& operator=(const ControlClient&) = delete;

  /// Names, as in their channels, of the runs that are received within `time`; 1.5 s suffice for every streaming run.
  [[nodiscard]] std::vector<std::string> heard(std::chrono::milliseconds time);

  /// Requests the session of a run (`who`), then sends it the command, again every half second until the final answer.
  /// @param accepted  called once, when the run has received the command but not yet carried it out
  [[nodiscard]] ControlReply ask(const std::string& run, ControlVerb verb, double value, std::chrono::milliseconds most,
                                 const std::function<void()>& accepted = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// A sealed command.   @param sequence  microseconds since 1970
[[nodiscard]] Bytes encode_command(std::int64_t session, const ControlCommand& command);

}  // namespace scree::io
