#include "io/live/channel.h"

#include <fmt/format.h>

#include <span>

#include "io/live/crc32.h"

namespace scree::io {
namespace {

constexpr std::string_view kPrefix = "SCREE_";

bool allowed(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
}

}  // namespace

std::string_view name(LiveKind kind) {
  constexpr std::array<std::string_view, kLiveKinds.size() + kControlKinds.size()> names{
      "INFO", "TOPO", "STATE", "HIST", "ENERGY", "EVENT", "MODEL", "DETAIL", "CTRL", "ACK"};
  return names[static_cast<std::size_t>(kind)];
}

std::string channel_run(std::string_view run) {
  if (run.empty()) return "run";
  std::string text(run);
  for (char& c : text)
    if (!allowed(c)) c = '-';
  if (text.size() <= kMaxRun) return text;
  const std::string mark =
      fmt::format("-{:08x}", crc32({reinterpret_cast<const std::uint8_t*>(run.data()), run.size()}));
  return text.substr(0, kMaxRun - mark.size()) + mark;
}

std::string channel_name(std::string_view run, LiveKind kind) {
  return fmt::format("{}{}_{}", kPrefix, channel_run(run), name(kind));
}

std::string channel_pattern(std::string_view run) {
  std::string kinds;
  for (const LiveKind kind : kLiveKinds) kinds += fmt::format("{}{}", kinds.empty() ? "" : "|", name(kind));
  return fmt::format("{}{}_({})", kPrefix, run.empty() ? "[A-Za-z0-9_-]+" : channel_run(run), kinds);
}

std::optional<LiveKind> channel_kind(std::string_view channel) {
  if (channel.size() > kMaxChannel || !channel.starts_with(kPrefix)) return std::nullopt;
  const std::string_view last = channel.substr(channel.rfind('_') + 1);
  for (const LiveKind kind : kLiveKinds)
    if (last == name(kind)) return kind;
  for (const LiveKind kind : kControlKinds)
    if (last == name(kind)) return kind;
  return std::nullopt;
}

}  // namespace scree::io
