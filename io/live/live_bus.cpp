#include "io/live/live_bus.h"

#include <arpa/inet.h>
#include <fmt/format.h>
#include <lcm/lcm.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#include "io/live/channel.h"
#include "model/check.h"

namespace scree::io {

struct LiveBus::Connection {
  struct Close {
    void operator()(lcm_t* connection) const { lcm_destroy(connection); }
  };
  std::unique_ptr<lcm_t, Close> lcm;
  std::vector<lcm_subscription_t*> subscriptions;  // the library owns them
};

std::string multicast_route_error(const std::string& group, std::uint16_t port) {
  sockaddr_in to{};
  to.sin_family = AF_INET;
  to.sin_port = htons(port);
  inet_pton(AF_INET, group.c_str(), &to.sin_addr);
  const int probe = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (probe < 0) return std::strerror(errno);
  // For UDP connect() only determines the route.
  const bool reachable = connect(probe, reinterpret_cast<const sockaddr*>(&to), sizeof to) == 0;
  const int reason = errno;
  close(probe);
  return reachable ? std::string{} : fmt::format("no multicast route to {} ({})", group, std::strerror(reason));
}

std::shared_ptr<LiveBus> LiveBus::open(std::string_view url_text, LiveSide side, std::string& why) {
  LiveUrl url = parse_live_url(url_text, side);
  if (url.kind == LiveUrl::Kind::udpm) {
    why = multicast_route_error(url.group, url.port);
    if (!why.empty()) return nullptr;
  }
  auto connection = std::make_unique<Connection>();
  connection->lcm.reset(lcm_create(url.lcm.c_str()));
  if (connection->lcm == nullptr) {
    why = fmt::format("LCM cannot open {}", url.lcm);
    return nullptr;
  }
  return std::shared_ptr<LiveBus>(new LiveBus(std::move(url), std::move(connection)));
}

LiveBus::LiveBus(LiveUrl url, std::unique_ptr<Connection> connection)
    : url_(std::move(url)), connection_(std::move(connection)) {}

LiveBus::~LiveBus() = default;

bool LiveBus::publish(const std::string& channel, std::span<const std::uint8_t> bytes) {
  SCREE_ASSERT(channel.size() <= kMaxChannel && bytes.size() <= kMaxMessage);
  return lcm_publish(connection_->lcm.get(), channel.c_str(), bytes.data(), static_cast<unsigned>(bytes.size())) == 0;
}

bool LiveBus::subscribe(const std::string& pattern, Handler handler) {
  if (url_.kind == LiveUrl::Kind::udpm) {
    std::string why;
    if (!receiver_) receiver_ = UdpReceiver::open(url_, why);
    if (receiver_) receiver_->subscribe(pattern, std::move(handler));
    return receiver_ != nullptr;
  }
  constexpr int kQueue = 1000;  // messages; the default of the library, 30, is less than one frame of a large mesh
  handlers_.push_back(std::make_unique<Handler>(std::move(handler)));
  const auto call = [](const lcm_recv_buf_t* message, const char* channel, void* user) {
    (*static_cast<const Handler*>(user))(channel,
                                         {static_cast<const std::uint8_t*>(message->data), message->data_size});
  };
  lcm_subscription_t* subscription =
      lcm_subscribe(connection_->lcm.get(), pattern.c_str(), call, handlers_.back().get());
  if (subscription == nullptr) return false;
  lcm_subscription_set_queue_capacity(subscription, kQueue);
  connection_->subscriptions.push_back(subscription);
  return true;
}

void LiveBus::unsubscribe() {
  for (lcm_subscription_t* subscription : connection_->subscriptions)
    lcm_unsubscribe(connection_->lcm.get(), subscription);
  connection_->subscriptions.clear();
  handlers_.clear();
  receiver_ = nullptr;
}

LiveBus::Got LiveBus::handle(int milliseconds) {
  if (receiver_) return receiver_->handle(milliseconds) ? Got::message : Got::nothing;
  const int got = lcm_handle_timeout(connection_->lcm.get(), milliseconds);
  return got > 0 ? Got::message : got == 0 ? Got::nothing : Got::end;
}

}  // namespace scree::io
