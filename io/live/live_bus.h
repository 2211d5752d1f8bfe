// An LCM connection that is owned and closed safely, and never prints or aborts when there is no network.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "io/live/live_url.h"
#include "io/live/udp_receiver.h"
#include "io/live/wire.h"

namespace scree::io {

/// One connection. Two threads may send and receive at the same time.
/// It avoids these defects of LCM 1.3.1: without a route to the multicast group lcm_create prints a dozen lines and
/// fails, so the route is tried first with a socket that sends nothing; a message too long for one datagram is reported
/// as sent although it was not; and received multicast messages can end the program, so our own UdpReceiver receives
/// them, from the first subscription on. The library sends, writes and plays logs, and has the memory queue. (A
/// connection makes the kernel join the multicast group: where the route to it leads out of the machine, the kernel
/// announces that with IGMP even at ttl=0; no message leaves.)
class LiveBus {
 public:
  using Handler = std::function<void(std::string_view channel, std::span<const std::uint8_t> bytes)>;

  /// @param why  set when the result is null
  /// @return null when there is no network for it now (to be tried again later)
  /// @throws std::invalid_argument for a URL that check_live_url refuses
  [[nodiscard]] static std::shared_ptr<LiveBus> open(std::string_view url_text, LiveSide side, std::string& why);
  ~LiveBus();
  LiveBus(const LiveBus&) = delete;
  LiveBus& operator=(const LiveBus&) = delete;

  [[nodiscard]] const LiveUrl& url() const { return url_; }

  /// Sends one message without waiting.
  /// @return false if the system refused it   @pre channel <= kMaxChannel, bytes <= kMaxMessage
  bool publish(const std::string& channel, std::span<const std::uint8_t> bytes);

  /// Calls `handler` from handle() for each message on channels that match a regular expression.
  /// Opens the receiving socket.   @return false when that fails
  bool subscribe(const std::string& pattern, Handler handler);
  /// Ends all subscriptions, and closes the receiving socket.   @pre no thread is in handle()
  void unsubscribe();

  enum class Got { message, nothing, end };
  /// Waits for a message and handles it.   @return end: end of the log, or the connection failed
  Got handle(int milliseconds);

  /// Datagrams received over the network so far, before subscriptions select them; zeros for memq and logs.
  [[nodiscard]] UdpCounts udp_counts() const { return receiver_ ? receiver_->counts() : UdpCounts{}; }

 private:
  struct Connection;
  LiveBus(LiveUrl url, std::unique_ptr<Connection> connection);

  LiveUrl url_;
  std::unique_ptr<Connection> connection_;
  std::vector<std::unique_ptr<Handler>> handlers_;
  std::unique_ptr<UdpReceiver> receiver_;
};

/// Reason why the system cannot send to a group; empty if it can. Sends nothing.
[[nodiscard]] std::string multicast_route_error(const std::string& group, std::uint16_t port);

}  // namespace scree::io
