// Decides which of the received commands a run carries out. Independent of networks, threads and clocks.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <scree/ack_v1_t.hpp>
#include <scree/ctrl_v1_t.hpp>
#include <span>
#include <string>
#include <string_view>
#include <tuple>

#include "io/live/wire.h"

namespace scree::io {

enum class ControlVerb { who, pause, resume, step, checkpoint, stop, rate, field };
[[nodiscard]] std::string_view name(ControlVerb verb);
[[nodiscard]] std::optional<ControlVerb> control_verb(std::string_view name);
/// Checks the value of a verb: step takes a whole number from 1 to kMaxSteps; rate 0 to kMaxFrameRate Hz; field the
/// number of a LiveField; the others no value (0).
/// @return the error; empty if there is none
[[nodiscard]] std::string control_value_error(ControlVerb verb, double value);
inline constexpr double kMaxSteps = 1e9;
inline constexpr double kMaxFrameRate = 1000.0;

/// A command that is to be carried out.
struct ControlCommand {
  ControlVerb verb = ControlVerb::who;
  double value = 0.0;
  std::int64_t sequence = 0, sender = 0;
};

/// Numbers of messages on the CTRL channel of a run, by result.
struct ControlCounts {
  std::int64_t received = 0;
  std::int64_t malformed = 0;      // size, CRC, type, a length, an unknown command or value
  std::int64_t other_session = 0;  // for an earlier run or another one
  std::int64_t replayed = 0;       // received before, or dated outside the window
  std::int64_t too_frequent = 0;
  std::int64_t passed = 0;
};

/// Content of an ACK: result is accepted, done, refused, not available or failed.
struct ControlAnswer {
  ControlCommand command;
  std::string result, reason;
};

/// Refuses commands that are malformed, of another session, received before, too frequent, or not dated within a window
/// about the present. All commands accepted within the window are remembered, so none is carried out twice. Commands
/// need not be in order, so that no sequence number sent by anybody blocks other commands, for any sender. (When
/// numbers were required to grow, one forged command, dated ahead, blocked all others until that time.) A repeated
/// identical command is answered again with its result: the sender may have missed the answer.
/// A flood under a thousand names of senders can still use up the share of all senders together.
class ControlGate {
 public:
  static constexpr int kBurst = 20;                      // commands of one sender in a burst
  static constexpr double kPerSecond = 20.0;             // of one sender, in the mean; also of answered refusals
  static constexpr double kOfAll = 10.0;                 // factor on both for all senders together
  static constexpr double kBehind = 10.0, kAhead = 2.0;  // the window [s]; senders use the clock of the run (from ACK)

  explicit ControlGate(std::int64_t session) : session_(session) {}

  struct Verdict {
    std::optional<ControlCommand> command;  // to be carried out
    std::optional<ControlAnswer> answer;    // to be sent now
  };
  /// @param bytes  of a message on the CTRL channel
  /// @param utime  microseconds since 1970   @param now  a monotonic clock [s]
  [[nodiscard]] Verdict take(std::span<const std::uint8_t> bytes, std::int64_t utime, double now);

  /// Stores the result of an accepted command, as the answer if the command is received again.
  void remember(const ControlAnswer& answer);

  [[nodiscard]] std::int64_t session() const { return session_; }
  [[nodiscard]] const ControlCounts& counts() const { return counts_; }

 private:
  /// Limit on the number in a burst and on the number per second.
  struct Bucket {
    double share = 1.0;  // of kBurst and kPerSecond
    double left = share * kBurst, at = 0.0;
    [[nodiscard]] bool take(double now);
  };
  struct Heard {
    ControlAnswer answer;
    double told = 0.0;  // time of the last answer [s]
  };
  using Key = std::tuple<std::int64_t, std::int64_t, ControlVerb, double>;  // number, sender, verb, value
  [[nodiscard]] static Key key(const ControlCommand& command);
  [[nodiscard]] Verdict refuse(const ControlCommand& command, std::string reason, double now);
  [[nodiscard]] bool too_frequent(std::int64_t sender, double now);
  void forget(std::int64_t utime, double now);

  const std::int64_t session_;
  std::map<Key, Heard> heard_;              // commands of the window, and those not completed yet
  std::map<std::int64_t, Bucket> senders_;  // senders of the last seconds
  Bucket commands_{kOfAll}, refusals_;
  ControlCounts counts_;
};

}  // namespace scree::io
