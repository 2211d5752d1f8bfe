// What a run lets through of the commands that reach it. Knows neither networks nor threads nor clocks.
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
/// Whether a verb takes this value: step 1 to kMaxSteps, whole; rate 0 to kMaxFrameRate Hz; field the number of a
/// LiveField; the others none (0).
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
  std::int64_t replayed = 0;       // heard already, or dated outside the window
  std::int64_t too_frequent = 0;
  std::int64_t passed = 0;
};

/// What an ACK says: result is accepted, done, refused, not available or failed.
struct ControlAnswer {
  ControlCommand command;
  std::string result, reason;
};

/// Refuses what is malformed, of another session, heard before, or too frequent, and what is not dated within a window
/// about the present: all that was let through within it is remembered, so nothing is carried out twice. Commands need
/// not be in order: no number that somebody sends shuts out others, whatever sender it names. (To ask for numbers that
/// grow let one forged command, dated ahead, shut out all others until that time.) What comes again just as it was is
/// told again what became of it: its sender may have missed that.
/// A flood under a thousand names of senders can still use up what all of them have together.
class ControlGate {
 public:
  static constexpr int kBurst = 20;                      // commands of one sender at once
  static constexpr double kPerSecond = 20.0;             // of them, in the long run; of refusals that are answered too
  static constexpr double kOfAll = 10.0;                 // times as many of all senders together
  static constexpr double kBehind = 10.0, kAhead = 2.0;  // the window [s]; senders go by the clock of the run (ACK)

  explicit ControlGate(std::int64_t session) : session_(session) {}

  struct Verdict {
    std::optional<ControlCommand> command;  // to be carried out
    std::optional<ControlAnswer> answer;    // to be sent now
  };
  /// @param bytes  of a message on the CTRL channel
  /// @param utime  microseconds since 1970   @param now  a clock that never goes back [s]
  [[nodiscard]] Verdict take(std::span<const std::uint8_t> bytes, std::int64_t utime, double now);

  /// Remembers what became of a command that was let through, should it come again.
  void remember(const ControlAnswer& answer);

  [[nodiscard]] std::int64_t session() const { return session_; }
  [[nodiscard]] const ControlCounts& counts() const { return counts_; }

 private:
  /// So many at once and so many a second.
  struct Bucket {
    double share = 1.0;  // of kBurst and kPerSecond
    double left = share * kBurst, at = 0.0;
    [[nodiscard]] bool take(double now);
  };
  struct Heard {
    ControlAnswer answer;
    double told = 0.0;  // when [s]
  };
  using Key = std::tuple<std::int64_t, std::int64_t, ControlVerb, double>;  // number, sender, verb, value
  [[nodiscard]] static Key key(const ControlCommand& command);
  [[nodiscard]] Verdict refuse(const ControlCommand& command, std::string reason, double now);
  [[nodiscard]] bool too_frequent(std::int64_t sender, double now);
  void forget(std::int64_t utime, double now);

  const std::int64_t session_;
  std::map<Key, Heard> heard_;              // of the window, and what is not done yet
  std::map<std::int64_t, Bucket> senders_;  // those who sent within the last seconds
  Bucket commands_{kOfAll}, refusals_;
  ControlCounts counts_;
};

}  // namespace scree::io
