// What a run lets through of the commands that reach it. Knows neither networks nor threads nor clocks.
#pragma once

#include <cstdint>
#include <optional>
#include <scree/ack_v1_t.hpp>
#include <scree/ctrl_v1_t.hpp>
#include <span>
#include <string>
#include <string_view>

#include "io/live/wire.h"

namespace scree::io {

enum class ControlVerb { who, pause, resume, step, checkpoint, stop, rate };
[[nodiscard]] std::string_view name(ControlVerb verb);
[[nodiscard]] std::optional<ControlVerb> control_verb(std::string_view name);
/// Whether a verb takes this value: step 1 to kMaxSteps, whole; rate 0 to kMaxFrameRate Hz; the others none (0).
/// @return what is wrong; empty if nothing is
[[nodiscard]] std::string control_value_error(ControlVerb verb, double value);
inline constexpr double kMaxSteps = 1e9;
inline constexpr double kMaxFrameRate = 1000.0;

/// A command that is to be carried out.
struct ControlCommand {
  ControlVerb verb = ControlVerb::who;
  double value = 0.0;
  std::int64_t sequence = 0, sender = 0;
};

/// What became of the messages on a run's CTRL channel.
struct ControlCounts {
  std::int64_t received = 0;
  std::int64_t malformed = 0;      // size, CRC, type, a length, an unknown command or value
  std::int64_t other_session = 0;  // meant for an earlier or another run
  std::int64_t replayed = 0;       // not newer than the last one, or dated ahead
  std::int64_t too_frequent = 0;
  std::int64_t passed = 0;
};

/// What an ACK says: result is accepted, done, refused, not available or failed.
struct ControlAnswer {
  ControlCommand command;
  std::string result, reason;
};

/// Refuses what is malformed, of another session, not newer than what it let through before, or too frequent. A command
/// that comes again under the number and from the sender that it had is not carried out again, but told again what
/// became of it: its sender may have missed that.
class ControlGate {
 public:
  static constexpr int kBurst = 20;           // commands at once
  static constexpr double kPerSecond = 20.0;  // of them, in the long run; of refusals that are answered too
  static constexpr double kAhead = 60.0;      // s; a number may be dated ahead by so much: clocks of two machines

  explicit ControlGate(std::int64_t session) : session_(session) {}

  struct Verdict {
    std::optional<ControlCommand> command;  // to be carried out
    std::optional<ControlAnswer> answer;    // to be sent now
  };
  /// @param bytes  of a message on the CTRL channel
  /// @param utime  microseconds since 1970   @param now  a clock that never goes back [s]
  [[nodiscard]] Verdict take(std::span<const std::uint8_t> bytes, std::int64_t utime, double now);

  /// Remembers what became of the command let through last, should it come again.
  void remember(const ControlAnswer& answer);

  [[nodiscard]] std::int64_t session() const { return session_; }
  [[nodiscard]] const ControlCounts& counts() const { return counts_; }

 private:
  /// So many at once and so many a second.
  struct Bucket {
    double left = kBurst, at = 0.0;
    [[nodiscard]] bool take(double now);
  };
  [[nodiscard]] Verdict refuse(const ControlCommand& command, std::string reason, double now);

  const std::int64_t session_;
  std::int64_t newest_ = 0;  // number of the last one let through
  std::optional<ControlAnswer> last_;
  Bucket commands_, refusals_;
  ControlCounts counts_;
};

}  // namespace scree::io
