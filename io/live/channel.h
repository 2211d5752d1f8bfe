// Names of LCM channels: SCREE_<run>_<KIND>.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace scree::io {

enum class LiveKind { info, topo, state, hist, energy, event, model, detail, ctrl, ack };
/// Kinds that a run streams.
inline constexpr std::array kLiveKinds{LiveKind::info,   LiveKind::topo,  LiveKind::state, LiveKind::hist,
                                       LiveKind::energy, LiveKind::event, LiveKind::model, LiveKind::detail};
/// Commands to a run, and its answers.
inline constexpr std::array kControlKinds{LiveKind::ctrl, LiveKind::ack};
[[nodiscard]] std::string_view name(LiveKind kind);  // INFO, TOPO, ...

inline constexpr std::size_t kMaxChannel = 63;  // characters; LCM refuses more
inline constexpr std::size_t kMaxRun = 50;      // that remain for the name of the run beside the longest kind

/// The name of the run as used in a channel: letters, digits, '_' and '-'; anything else becomes '-'. A name of more
/// than kMaxRun characters is cut and ends with the CRC-32 of the whole, so that two long names stay distinct; an empty
/// name becomes "run". The function is idempotent.
[[nodiscard]] std::string channel_run(std::string_view run);

/// Channel of a run and kind, at most kMaxChannel characters.
[[nodiscard]] std::string channel_name(std::string_view run, LiveKind kind);

/// Regular expression that matches the channels on which runs stream.   @param run  empty: any run
[[nodiscard]] std::string channel_pattern(std::string_view run);

/// Kind of the messages on a channel; empty if it is not a channel of Scree.
[[nodiscard]] std::optional<LiveKind> channel_kind(std::string_view channel);

}  // namespace scree::io
