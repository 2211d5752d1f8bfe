// Commands of a page to the run that streams: every page that has the token may give them.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "io/serve/site.h"

namespace scree::io {

/// 128 random bits as 32 hexadecimal digits.
[[nodiscard]] std::string new_token();

/// Accepts commands in their order of arrival and sends each to the run in a thread of its own, as `scree control`
/// does, so that a run that does not answer delays no viewer.
class ControlBridge {
 public:
  static constexpr std::size_t kMostWaiting = 16;

  /// @param url  of the stream, udpm://
  ControlBridge(std::string url, std::string token);
  /// Ends the thread; waiting commands are dropped.
  ~ControlBridge();
  ControlBridge(const ControlBridge&) = delete;
  ControlBridge& operator=(const ControlBridge&) = delete;

  /// "TOKEN command", "TOKEN command VALUE": pause, resume, step N, checkpoint, stop, rate HZ, field NAME.
  /// @param run  that is shown now; empty: none, and the answer states this
  /// @return false: the token is wrong or the text is no command; nothing has been done
  [[nodiscard]] bool take(std::string_view text, const std::string& run);

  /// The result of the last command, returned once: a message of kind "answer".
  [[nodiscard]] std::optional<SharedBytes> answer();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
