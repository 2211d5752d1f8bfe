#include "io/live/udp_receiver.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <ifaddrs.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>

#include "io/live/channel.h"
#include "io/live/signals_blocked.h"

namespace scree::io {
namespace {

std::uint32_t word(std::span<const std::uint8_t> b) {
  return std::uint32_t{b[0]} << 24U | std::uint32_t{b[1]} << 16U | std::uint32_t{b[2]} << 8U | std::uint32_t{b[3]};
}

/// Reads a channel ended by a zero; the rest is the data. False if no zero ends it within the length that LCM allows.
bool take_channel(std::span<const std::uint8_t> rest, LcmDatagram& out) {
  const auto end =
      std::find(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(std::min(rest.size(), kMaxChannel + 1)), 0);
  const auto size = static_cast<std::size_t>(end - rest.begin());
  if (size == rest.size() || size > kMaxChannel) return false;
  out.channel = {reinterpret_cast<const char*>(rest.data()), size};
  out.data = rest.subspan(size + 1);
  return true;
}

std::vector<std::uint32_t> addresses_of_this_machine() {
  std::vector<std::uint32_t> found;
  ifaddrs* list = nullptr;
  if (getifaddrs(&list) != 0) return found;
  for (const ifaddrs* i = list; i != nullptr; i = i->ifa_next)
    if (i->ifa_addr != nullptr && i->ifa_addr->sa_family == AF_INET) {
      sockaddr_in address{};
      std::memcpy(&address, i->ifa_addr, sizeof address);
      found.push_back(ntohl(address.sin_addr.s_addr));
    }
  freeifaddrs(list);
  return found;
}

std::int64_t milliseconds_now() {
  return std::chrono::duration_cast<std::chrono::milliseconds>(std::chrono::steady_clock::now().time_since_epoch())
      .count();
}

}  // namespace

LcmDatagram decode_datagram(std::span<const std::uint8_t> datagram) {
  constexpr std::uint32_t kWhole = 0x4C433032, kFragment = 0x4C433033;
  constexpr std::size_t kHead = 8, kFragmentHead = 20, kFragmentNumber = 16;
  LcmDatagram out;
  if (datagram.size() < kHead) return out;
  const std::uint32_t magic = word(datagram);
  if (magic == kWhole) {
    if (take_channel(datagram.subspan(kHead), out)) out.kind = LcmDatagram::Kind::message;
  } else if (magic == kFragment && datagram.size() >= kFragmentHead) {
    const bool first = datagram[kFragmentNumber] == 0 && datagram[kFragmentNumber + 1] == 0;
    if (!first || take_channel(datagram.subspan(kFragmentHead), out)) out.kind = LcmDatagram::Kind::fragment;
  }
  return out;
}

std::unique_ptr<UdpReceiver> UdpReceiver::open(const LiveUrl& url, std::string& why) {
  std::unique_ptr<UdpReceiver> receiver(new UdpReceiver(url.ttl == 0));
  const auto failed = [&](const char* what) {
    why = fmt::format("cannot listen to {}:{}: {}: {}", url.group, url.port, what, std::strerror(errno));
    return nullptr;
  };
  receiver->socket_ = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
  if (receiver->socket_ < 0) return failed("socket");
  const int fd = receiver->socket_, yes = 1, no = 0;
  if (setsockopt(fd, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes) != 0) return failed("SO_REUSEADDR");
  // As much as the system permits; the queue of the thread holds the rest.
  const int buffer = url.receive_buffer > 0 ? static_cast<int>(url.receive_buffer) : 1 << 22;
  (void)setsockopt(fd, SOL_SOCKET, SO_RCVBUF, &buffer, sizeof buffer);
  sockaddr_in group{};
  group.sin_family = AF_INET;
  group.sin_port = htons(url.port);
  inet_pton(AF_INET, url.group.c_str(), &group.sin_addr);
  // Bound to the group, not to any address: unicast datagrams to this machine are not received.
  if (bind(fd, reinterpret_cast<const sockaddr*>(&group), sizeof group) != 0) return failed("bind");
  ip_mreq membership{};
  membership.imr_multiaddr = group.sin_addr;
  membership.imr_interface.s_addr = htonl(INADDR_ANY);
  if (setsockopt(fd, IPPROTO_IP, IP_ADD_MEMBERSHIP, &membership, sizeof membership) != 0)
    return failed("IP_ADD_MEMBERSHIP");
  (void)setsockopt(fd, IPPROTO_IP, IP_MULTICAST_ALL, &no, sizeof no);  // only of interfaces on which we joined
  receiver->wake_ = eventfd(0, EFD_CLOEXEC);
  if (receiver->wake_ < 0) return failed("eventfd");
  const SignalsBlocked inherited_by_the_thread;
  receiver->thread_ = std::thread([r = receiver.get()] { r->run(); });
  return receiver;
}

UdpReceiver::~UdpReceiver() {
  stop_ = true;
  if (thread_.joinable()) {
    const std::uint64_t one = 1;
    while (write(wake_, &one, sizeof one) < 0 && errno == EINTR) {
    }
    thread_.join();
  }
  if (socket_ >= 0) close(socket_);
  if (wake_ >= 0) close(wake_);
}

void UdpReceiver::subscribe(const std::string& pattern, Handler handler) {
  auto subscription = std::make_shared<const Subscription>(Subscription{std::regex(pattern), std::move(handler)});
  const std::lock_guard lock(mutex_);
  subscriptions_.push_back(std::move(subscription));
}

bool UdpReceiver::handle(int milliseconds) {
  Message message;
  std::vector<std::shared_ptr<const Subscription>> subscriptions;
  {
    std::unique_lock lock(mutex_);
    if (!news_.wait_for(lock, std::chrono::milliseconds(milliseconds), [this] { return !waiting_.empty(); }))
      return false;
    message = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= message.bytes.size();
    subscriptions = subscriptions_;
  }
  for (const auto& s : subscriptions)
    if (std::regex_match(message.channel, s->pattern)) s->handler(message.channel, message.bytes);
  return true;
}

UdpCounts UdpReceiver::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

// --- the thread ---------------------------------------------------------------------------------------------------

bool UdpReceiver::wanted(std::string_view channel) const {
  return std::any_of(subscriptions_.begin(), subscriptions_.end(),
                     [&](const auto& s) { return std::regex_match(channel.begin(), channel.end(), s->pattern); });
}

bool UdpReceiver::from_here(std::uint32_t address) {
  // 0.0.0.0 denotes this machine if no interface except the loopback has an address.
  if (address == 0 || address >> 24U == 127) return true;
  const auto known = [&] {
    return std::find(own_addresses_.begin(), own_addresses_.end(), address) != own_addresses_.end();
  };
  if (known()) return true;
  // Addresses may change, but a flood of foreign datagrams must not cause a query for each of them.
  constexpr std::int64_t kAgain = 1000;  // ms
  const std::int64_t now = milliseconds_now();
  if (!own_addresses_.empty() && now - addresses_at_ < kAgain) return false;
  addresses_at_ = now;
  own_addresses_ = addresses_of_this_machine();
  return known();
}

void UdpReceiver::take(std::span<const std::uint8_t> datagram, std::uint32_t from) {
  const LcmDatagram d = decode_datagram(datagram);
  const bool here = !local_only_ || from_here(from);
  const std::lock_guard lock(mutex_);
  ++counts_.datagrams;
  const bool ours = here && (d.kind == LcmDatagram::Kind::garbage || wanted(d.channel));
  if (!ours) {
    ++counts_.foreign;
  } else if (d.kind != LcmDatagram::Kind::message) {
    ++counts_.garbage;
  } else {
    while (!waiting_.empty() && (waiting_.size() >= kMaxWaiting || waiting_bytes_ + d.data.size() > kMaxBytes)) {
      waiting_bytes_ -= waiting_.front().bytes.size();
      waiting_.pop_front();
      ++counts_.overrun;
    }
    waiting_.push_back({std::string(d.channel), Bytes(d.data.begin(), d.data.end())});
    waiting_bytes_ += d.data.size();
    news_.notify_one();
  }
}

void UdpReceiver::run() {
  std::array<std::uint8_t, 65536> buffer{};  // a datagram has 65,507 bytes at most
  std::array<pollfd, 2> sources{{{socket_, POLLIN, 0}, {wake_, POLLIN, 0}}};
  while (!stop_) {
    if (poll(sources.data(), sources.size(), -1) < 0 && errno != EINTR) return;
    while (!stop_) {
      sockaddr_in from{};
      socklen_t size = sizeof from;
      const ssize_t got = recvfrom(socket_, buffer.data(), buffer.size(), 0, reinterpret_cast<sockaddr*>(&from), &size);
      if (got < 0) break;  // no more datagrams; errors of a receiving socket are transient
      take(std::span(buffer).first(static_cast<std::size_t>(got)), ntohl(from.sin_addr.s_addr));
    }
  }
}

}  // namespace scree::io
