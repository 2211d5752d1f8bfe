// Receives what LCM sends over multicast, in place of the library: two forged fragments end a program that lets
// liblcm 1.3.1 receive, and a forged channel or length comes as far as its regular expressions and decoders.
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

/// A datagram of LCM taken apart.
struct LcmDatagram {
  enum class Kind {
    message,   // a whole message ("LC02")
    fragment,  // a piece of a larger one ("LC03"); channel of the first piece only
    garbage
  } kind = Kind::garbage;
  std::string_view channel;
  std::span<const std::uint8_t> data;
};
/// @source [LCM], lcm_udpm.c: two big-endian words (magic, number of the message), then the channel ended by a zero,
///         then the data; a fragment has the size of the whole, its offset, its number and their count (4, 4, 2, 2
///         bytes) in between
[[nodiscard]] LcmDatagram decode_datagram(std::span<const std::uint8_t> datagram);

struct UdpCounts {
  std::int64_t datagrams = 0;
  std::int64_t garbage = 0;  // nothing of LCM, or a fragment on one of our channels: dropped
  std::int64_t foreign = 0;  // of other channels, or of other machines where ttl=0 says that all is local: dropped
  std::int64_t overrun = 0;  // the oldest, dropped because nobody took them in time
};

/// A socket in the multicast group and a thread that drains it, so that what comes in bursts is not lost while somebody
/// is busy with the message before.
/// Fragments are not put together: LCM cuts messages above 65,499 bytes, ours have kMaxMessage at most. What cannot
/// be handled in time goes, the oldest first. With ttl=0 only what comes from an address of this machine is taken
/// (the kernel lets no packet in from outside that claims to: martian sources, ip_route_input_mc).
class UdpReceiver {
 public:
  using Handler = std::function<void(std::string_view channel, std::span<const std::uint8_t> bytes)>;
  static constexpr std::size_t kMaxWaiting = 4000;                 // messages
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 26U;  // of them

  /// @pre url.kind is udpm   @param why  set when the answer is null
  [[nodiscard]] static std::unique_ptr<UdpReceiver> open(const LiveUrl& url, std::string& why);
  ~UdpReceiver();
  UdpReceiver(const UdpReceiver&) = delete;
  UdpReceiver& operator=(const UdpReceiver&) = delete;

  /// Calls `handler` from handle() for channels that match a regular expression as a whole.
  void subscribe(const std::string& pattern, Handler handler);
  /// Waits for a message and handles it.   @return false when none came in time
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
  // Of the thread alone.
  std::vector<std::uint32_t> own_addresses_;
  std::int64_t addresses_at_ = 0;  // when they were looked up [ms]
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

}  // namespace scree::io
