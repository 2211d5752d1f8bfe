#include "io/live/control_gate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace scree::io {
namespace {

constexpr std::array<std::string_view, 7> kVerbs{"who", "pause", "resume", "step", "checkpoint", "stop", "rate"};

}  // namespace

std::string_view name(ControlVerb verb) { return kVerbs[static_cast<std::size_t>(verb)]; }

std::optional<ControlVerb> control_verb(std::string_view name) {
  const auto* const found = std::find(kVerbs.begin(), kVerbs.end(), name);
  if (found == kVerbs.end()) return std::nullopt;
  return static_cast<ControlVerb>(found - kVerbs.begin());
}

std::string control_value_error(ControlVerb verb, double value) {
  if (verb == ControlVerb::step) {
    if (value >= 1.0 && value <= kMaxSteps && value == std::floor(value)) return {};
    return fmt::format("step takes a whole number of steps from 1 to {:g}", kMaxSteps);
  }
  if (verb == ControlVerb::rate) {
    if (value >= 0.0 && value <= kMaxFrameRate) return {};
    return fmt::format("rate takes 0 to {:g} frames a second", kMaxFrameRate);
  }
  return value == 0.0 ? std::string{} : fmt::format("{} takes no value", name(verb));
}

bool ControlGate::Bucket::take(double now) {
  left = std::min<double>(kBurst, left + kPerSecond * std::max(0.0, now - at));
  at = now;
  if (left < 1.0) return false;
  left -= 1.0;
  return true;
}

ControlGate::Verdict ControlGate::refuse(const ControlCommand& command, std::string reason, double now) {
  if (!refusals_.take(now)) return {};  // a flood is not answered with a flood
  return {{}, ControlAnswer{command, "refused", std::move(reason)}};
}

ControlGate::Verdict ControlGate::take(std::span<const std::uint8_t> bytes, std::int64_t utime, double now) {
  ++counts_.received;
  const std::optional<ctrl_v1_t> message = unseal<ctrl_v1_t>(bytes);
  const std::optional<ControlVerb> verb = message ? control_verb(message->command) : std::nullopt;
  if (!verb) {
    ++counts_.malformed;
    return {};
  }
  const ControlCommand command{*verb, message->value, message->header.sequence, message->sender};
  if (std::string wrong = control_value_error(*verb, message->value); !wrong.empty()) {
    ++counts_.malformed;
    return refuse(command, std::move(wrong), now);
  }
  if (*verb == ControlVerb::who)
    return commands_.take(now) ? Verdict{{}, ControlAnswer{command, "done", {}}} : Verdict{};
  if (message->header.session != session_) {
    ++counts_.other_session;
    return refuse(command, fmt::format("session {} is not that of this run, {}", message->header.session, session_),
                  now);
  }
  const std::int64_t sequence = command.sequence;
  if (sequence <= newest_) {
    ++counts_.replayed;
    const bool again = last_ && sequence == last_->command.sequence && command.sender == last_->command.sender &&
                       command.verb == last_->command.verb;
    if (again) return refusals_.take(now) ? Verdict{{}, last_} : Verdict{};
    return refuse(command, fmt::format("number {} is not newer than {}", sequence, newest_), now);
  }
  if (static_cast<double>(sequence) > static_cast<double>(utime) + 1e6 * kAhead) {
    ++counts_.replayed;  // it would shut out every later one
    return refuse(command, fmt::format("number {} is dated ahead of {}", sequence, utime), now);
  }
  if (!commands_.take(now)) {
    ++counts_.too_frequent;
    return refuse(command, fmt::format("more than {} commands a second", kPerSecond), now);
  }
  newest_ = sequence;
  ++counts_.passed;
  last_ = ControlAnswer{command, "accepted", {}};
  return {command, last_};
}

void ControlGate::remember(const ControlAnswer& answer) {
  if (last_ && last_->command.sequence == answer.command.sequence) last_ = answer;
}

}  // namespace scree::io
