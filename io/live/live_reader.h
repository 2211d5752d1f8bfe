// Receives a run over LCM: empties the connection in a thread of its own and keeps the newest data of each kind.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "io/live/decode.h"
#include "io/live/live_bus.h"

namespace scree::io {

/// Messages are checked (channel, size, CRC, type, every length and range) before they are decoded; invalid ones are
/// counted and dropped. Of several runs it follows the one that started last. All functions may be called from any
/// thread; the data that they return do not change any more.
class LiveReader {
 public:
  /// Opens a connection and listens.
  /// @param run  name, as given to the sink; empty: any run
  /// @param why  set when the result is null
  /// @return null when there is no network for it
  /// @throws std::invalid_argument for a URL that check_live_url refuses for a receiver
  [[nodiscard]] static std::unique_ptr<LiveReader> open(const std::string& url, const std::string& run,
                                                        std::string& why);
  /// Listens on a connection that a sink of this program uses (memq). To be called before the sink begins: memq keeps
  /// no messages for later subscribers.
  LiveReader(std::shared_ptr<LiveBus> bus, const std::string& run);
  ~LiveReader();
  LiveReader(const LiveReader&) = delete;
  LiveReader& operator=(const LiveReader&) = delete;

  [[nodiscard]] std::optional<info_v1_t> info() const;
  [[nodiscard]] std::optional<energy_v1_t> energy() const;
  [[nodiscard]] std::shared_ptr<const LiveHistory> history() const;
  [[nodiscard]] std::shared_ptr<const LiveMesh> mesh() const;
  [[nodiscard]] std::shared_ptr<const LiveFrame> frame() const;
  [[nodiscard]] std::shared_ptr<const model_v1_t> model() const;
  [[nodiscard]] std::shared_ptr<const LiveDetail> detail() const;
  /// Events since the last call, at most the newest LiveAssembly::kMaxEvents.
  [[nodiscard]] std::vector<event_v1_t> take_events();
  [[nodiscard]] LiveCounts counts() const;
  /// True when no more messages can arrive: end of the log, or the connection failed.
  [[nodiscard]] bool ended() const;

  /// Waits until a message was handled after which the assembly satisfies `enough`, or the time has passed.
  /// @return the last result of `enough`
  bool wait(std::chrono::milliseconds most, const std::function<bool(const LiveAssembly&)>& enough);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
