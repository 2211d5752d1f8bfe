#include "io/live/control_gate.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "io/live/live_field.h"

namespace scree::io {
namespace {

constexpr double kTellAgain = 0.05;  // smallest interval between answers to one command [s]

constexpr std::array<std::string_view, 8> kVerbs{"who",        "pause", "resume", "step",
                                                 "checkpoint", "stop",  "rate",   "field"};

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
  if (verb == ControlVerb::field) {
    if (live_field(value)) return {};
    return fmt::format("field takes the number of a field, 0 to {}", kLiveFields - 1);
  }
  return value == 0.0 ? std::string{} : fmt::format("{} takes no value", name(verb));
}

bool ControlGate::Bucket::take(double now) {
  left = std::min(share * kBurst, left + share * kPerSecond * std::max(0.0, now - at));
  at = now;
  if (left < 1.0) return false;
  left -= 1.0;
  return true;
}

ControlGate::Key ControlGate::key(const ControlCommand& command) {
  return {command.sequence, command.sender, command.verb, command.value};
}

bool ControlGate::too_frequent(std::int64_t sender, double now) {
  const auto known = senders_.find(sender);
  Bucket own = known != senders_.end() ? known->second : Bucket{};
  if (!own.take(now) || !commands_.take(now)) return true;
  senders_[sender] = own;
  return false;
}

void ControlGate::forget(std::int64_t utime, double now) {
  const double oldest = static_cast<double>(utime) - 1e6 * kBehind;
  for (auto it = heard_.begin(); it != heard_.end() && static_cast<double>(std::get<0>(it->first)) < oldest;)
    it = it->second.answer.result == "accepted" ? std::next(it) : heard_.erase(it);
  std::erase_if(senders_, [now](const auto& s) { return now - s.second.at > kBurst / kPerSecond; });
}

ControlGate::Verdict ControlGate::refuse(const ControlCommand& command, std::string reason, double now) {
  if (!refusals_.take(now)) return {};  // a flood of commands does not cause a flood of answers
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
  forget(utime, now);
  if (*verb == ControlVerb::who)
    return too_frequent(command.sender, now) ? Verdict{} : Verdict{{}, ControlAnswer{command, "done", {}}};
  if (message->header.session != session_) {
    ++counts_.other_session;
    return refuse(command, fmt::format("session {} is not that of this run, {}", message->header.session, session_),
                  now);
  }
  if (const auto again = heard_.find(key(command)); again != heard_.end()) {
    ++counts_.replayed;
    if (now - again->second.told < kTellAgain) return {};
    again->second.told = now;
    return {{}, again->second.answer};
  }
  const double age = 1e-6 * (static_cast<double>(utime) - static_cast<double>(command.sequence));
  if (age > kBehind || age < -kAhead) {
    ++counts_.replayed;
    return refuse(command,
                  fmt::format("number {} is dated {:.6g} s {} the clock of the run", command.sequence, std::abs(age),
                              age < 0.0 ? "ahead of" : "behind"),
                  now);
  }
  if (too_frequent(command.sender, now)) {
    ++counts_.too_frequent;
    return refuse(command, fmt::format("more than {} commands a second", kPerSecond), now);
  }
  ++counts_.passed;
  const ControlAnswer accepted{command, "accepted", {}};
  heard_[key(command)] = {accepted, now};
  return {command, accepted};
}

void ControlGate::remember(const ControlAnswer& answer) {
  if (const auto it = heard_.find(key(answer.command)); it != heard_.end()) it->second.answer = answer;
}

}  // namespace scree::io
