// Receives LCM messages over multicast, in place of the library: two forged fragments end a program in which
// liblcm 1.3.1 receives, and its regular expressions and decoders process forged channels and lengths.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <regex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "io/live/live_url.h"
#include "io/live/wire.h"

namespace scree::io {

/// The parts of a datagram of LCM.
struct LcmDatagram {
  enum class Kind {
    message,   // a complete message ("LC02")
    fragment,  // a piece of a larger message ("LC03"); only the first piece has a channel
    garbage
  } kind = Kind::garbage;
  std::string_view channel;
  std::span<const std::uint8_t> data;
};
/// @source [LCM], lcm_udpm.c: two big-endian words (magic, number of the message), then the channel ended by a zero,
///         then the data; a fragment has, after the two words, the size of the whole message, its offset, its number
///         and the number of fragments (4, 4, 2, 2 bytes)
[[nodiscard]] LcmDatagram decode_datagram(std::span<const std::uint8_t> datagram);

struct UdpCounts {
  std::int64_t datagrams = 0;
  std::int64_t garbage = 0;  // not of LCM, or a fragment on one of our channels: dropped
  std::int64_t foreign = 0;  // of other channels, or with ttl=0 (all is local) of other machines: dropped
  std::int64_t overrun = 0;  // oldest messages, dropped because they were not handled in time
};

/// A socket in the multicast group and a thread that empties it, so that messages in bursts are not lost while an
/// earlier message is being handled.
/// Fragments are not assembled: LCM cuts messages above 65,499 bytes, ours have at most kMaxMessage. Messages that
/// cannot be handled in time are dropped, the oldest first. With ttl=0 only datagrams from an address of this machine
/// are taken (the kernel rejects packets from outside with such an address: martian sources, ip_route_input_mc).
class UdpReceiver {
 public:
  using Handler = std::function<void(std::string_view channel, std::span<const std::uint8_t> bytes)>;
  static constexpr std::size_t kMaxWaiting = 4000;                 // messages
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 26U;  // bytes of these messages

  /// @pre url.kind is udpm   @param why  set when the result is null
  [[nodiscard]] static std::unique_ptr<UdpReceiver> open(const LiveUrl& url, std::string& why);
  ~UdpReceiver();
  UdpReceiver(const UdpReceiver&) = delete;
  UdpReceiver& operator=(const UdpReceiver&) = delete;

  /// Calls `handler` from handle() for channels that match a regular expression as a whole.
  void subscribe(const std::string& pattern, Handler handler);
  /// Waits for a message and handles it.   @return false if none arrived in time
  bool handle(int milliseconds);
  [[nodiscard]] UdpCounts counts() const;

 private:
  struct Subscription {
    std::regex pattern;
    Handler handler;
  };
  struct Message {
    std::string channel;
    Bytes bytes;
  };
  explicit UdpReceiver(bool local_only) : local_only_(local_only) {}
  [[nodiscard]] bool wanted(std::string_view channel) const;  // under the lock
  [[nodiscard]] bool from_here(std::uint32_t address);
  void take(std::span<const std::uint8_t> datagram, std::uint32_t from);
  void run();

  const bool local_only_;
  int socket_ = -1, wake_ = -1;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::vector<std::shared_ptr<const Subscription>> subscriptions_;  // guarded
  std::deque<Message> waiting_;                                     // guarded
  std::size_t waiting_bytes_ = 0;                                   // guarded
  UdpCounts counts_;                                                // guarded
  // Used by the thread only.
  std::vector<std::uint32_t> own_addresses_;
  std::int64_t addresses_at_ = 0;  // time at which they were determined [ms]
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace scree::io
