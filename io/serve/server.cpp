#include "io/serve/server.h"

#include <fcntl.h>

#include <algorithm>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <set>
#include <stdexcept>

#include "io/serve/request_rules.h"

namespace scree::io {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace websocket = beast::websocket;
using Tcp = asio::ip::tcp;
using Failure = beast::error_code;

constexpr std::string_view kLivePath = "/live";
constexpr std::string_view kPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src data: blob:; connect-src 'self'; frame-src "
    "'self'; "
    "base-uri 'none'; form-action 'none'; frame-ancestors 'self'";
constexpr int kViewerBuffer = 256 * 1024;  // bytes that the system keeps for a viewer: data waiting there get old
constexpr int kAhead = 2;                  // paced messages that a viewer need not have taken yet

std::string_view view(beast::string_view text) { return {text.data(), text.size()}; }

class Viewer;

/// What all connections have in common.
struct Shared {
  Site& site;
  ServerLimits limits;
  std::uint16_t port = 0;
  ServerCounts counts;
  std::size_t connections = 0;
  std::set<Viewer*> viewers;
};

/// Counts a connection as long as it lives, whatever ends it.
class Counted {
 public:
  explicit Counted(Shared& shared) : shared_(&shared) { ++shared_->connections; }
  ~Counted() { --shared_->connections; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;

 private:
  Shared* shared_;
};

using Request = http::request<http::empty_body>;

/// Why a request is refused: a status and a line.
struct Refusal {
  http::status status;
  std::string why;
};

std::optional<Refusal> refusal_of(const Request& request, const Shared& shared) {
  const auto count = [&](http::field name) { return request.count(name); };
  if (count(http::field::host) != 1 || !host_is_ours(view(request[http::field::host]), shared.port))
    return Refusal{http::status::misdirected_request, "the Host of the request is not this server"};
  const bool foreign =
      count(http::field::origin) > 1 ||
      (count(http::field::origin) == 1 && !origin_is_ours(view(request[http::field::origin]), shared.port));
  if (foreign) return Refusal{http::status::forbidden, "the request comes from the page of another server"};
  if (request.method() != http::verb::get && request.method() != http::verb::head)
    return Refusal{http::status::method_not_allowed, "only GET and HEAD are answered"};
  return {};
}

/// Headers of everything that is sent.
template <class Message>
void protect(Message& message) {
  message.set(http::field::server, "scree");
  message.set(http::field::cache_control, "no-store");
  message.set("Content-Security-Policy", beast::string_view(kPolicy.data(), kPolicy.size()));
  message.set("Cross-Origin-Opener-Policy", "same-origin");
  message.set("Cross-Origin-Resource-Policy", "same-origin");
  message.set("Referrer-Policy", "no-referrer");
  message.set("X-Content-Type-Options", "nosniff");
}

/// A viewer over a WebSocket.
class Viewer : public std::enable_shared_from_this<Viewer> {
 public:
  Viewer(beast::tcp_stream stream, Shared& shared)
      : counted_(shared), socket_(std::move(stream)), shared_(&shared), known_(shared.site.slots().size(), 0) {}
  ~Viewer() { shared_->viewers.erase(this); }
  Viewer(const Viewer&) = delete;
  Viewer& operator=(const Viewer&) = delete;

  void start(const Request& request) {
    Failure ignored;  // the size of the buffer is not essential
    beast::get_lowest_layer(socket_).socket().set_option(asio::socket_base::send_buffer_size(kViewerBuffer), ignored);
    beast::get_lowest_layer(socket_).expires_never();
    socket_.set_option(websocket::stream_base::timeout{shared_->limits.request, shared_->limits.silence, true});
    socket_.read_message_max(shared_->limits.message_bytes);
    socket_.auto_fragment(false);
    socket_.binary(true);
    socket_.async_accept(request, [self = shared_from_this()](Failure error) {
      if (error) return;
      self->shared_->viewers.insert(self.get());
      self->read();
      self->send();
    });
  }

  /// Sends the next message, unless one is being sent.
  void send() {
    if (sending_) return;
    const std::optional<std::size_t> next = choose();
    if (!next) return;
    const Slot& slot = shared_->site.slots()[*next];
    known_[*next] = slot.version;
    if (slot.paced) ++ahead_;
    last_ = *next;
    sending_ = true;
    message_ = slot.message;
    ++shared_->counts.messages;
    socket_.async_write(asio::buffer(*message_), [self = shared_from_this()](Failure error, std::size_t) {
      self->sending_ = false;
      self->message_.reset();
      if (!error) self->send();
    });
  }

 private:
  /// The first slot with news among those marked `first`; else the others in turn, so that none waits for ever.
  [[nodiscard]] std::optional<std::size_t> choose() const {
    const std::span<const Slot> slots = shared_->site.slots();
    const auto is_news = [&](std::size_t i) {
      return slots[i].version > known_[i] && (!slots[i].paced || ahead_ < kAhead);
    };
    for (std::size_t i = 0; i < slots.size(); ++i)
      if (slots[i].first && is_news(i)) return i;
    for (std::size_t k = 1; k <= slots.size(); ++k)
      if (const std::size_t i = (last_ + k) % slots.size(); is_news(i)) return i;
    return {};
  }

  void read() {
    socket_.async_read(buffer_, [self = shared_from_this()](Failure error, std::size_t) { self->take(error); });
  }

  void take(Failure error) {
    if (error) {
      if (error == websocket::error::closed || error == asio::error::eof || error == asio::error::connection_reset)
        return;
      ++shared_->counts.refused;
      return;
    }
    const std::string text = beast::buffers_to_string(buffer_.data());
    buffer_.consume(buffer_.size());
    if (text != "n" && shared_->site.take(text)) return read();
    if (text != "n" || ahead_ == 0) {
      ++shared_->counts.refused;
      socket_.async_close(websocket::close_code::policy_error, [self = shared_from_this()](Failure) {});
      return;
    }
    --ahead_;
    read();
    send();
  }

  Counted counted_;
  websocket::stream<beast::tcp_stream> socket_;
  Shared* shared_;
  beast::flat_buffer buffer_;
  std::vector<std::uint64_t> known_;  // version of each slot that was sent last
  std::size_t last_ = 0;              // slot that was sent last
  int ahead_ = 0;                     // paced messages that the viewer has not taken yet
  bool sending_ = false;
  SharedBytes message_;  // being sent
};

/// A connection of HTTP: one request after the other.
class Connection : public std::enable_shared_from_this<Connection> {
 public:
  Connection(Tcp::socket socket, Shared& shared)
      : counted_(shared), stream_(std::move(socket)), shared_(&shared), buffer_(2 * shared.limits.header_bytes) {}

  void read() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(shared_->limits.header_bytes));
    parser_->body_limit(0);
    stream_.expires_after(shared_->limits.request);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](Failure error, std::size_t) { self->take(error); });
  }

 private:
  void take(Failure error) {
    if (error == http::error::end_of_stream || error == beast::error::timeout) return close();
    if (error == http::error::header_limit || error == http::error::buffer_overflow)
      return refuse({http::status::request_header_fields_too_large, "the header of the request is too large"});
    if (error == http::error::body_limit || (!error && !parser_->is_done()))
      return refuse({http::status::payload_too_large, "a request has no body here"});
    if (error) {
      const bool malformed = error.category() == http::make_error_code(http::error::bad_line_ending).category();
      return malformed ? refuse({http::status::bad_request, "this is no request of HTTP"}) : close();
    }
    const Request& request = parser_->get();
    head_ = request.method() == http::verb::head;
    keep_ = request.keep_alive();
    if (const auto refusal = refusal_of(request, *shared_)) return refuse(*refusal);
    const std::string_view path = view(request.target());
    if (path == kLivePath && !shared_->site.slots().empty()) return hand_over(request);
    std::optional<Resource> found;
    try {
      found = shared_->site.find(path);
    } catch (const std::exception& e) {
      return refuse({http::status::internal_server_error, e.what()});
    }
    if (!found) return refuse({http::status::not_found, "there is no such page"});
    ++shared_->counts.requests;
    answer(http::status::ok, std::move(*found));
  }

  /// The connection becomes that of a viewer.
  void hand_over(const Request& request) {
    if (!websocket::is_upgrade(request)) return refuse({http::status::upgrade_required, "this path is a WebSocket"});
    if (request.count(http::field::origin) != 1)
      return refuse({http::status::forbidden, "a WebSocket needs the Origin of its page"});
    ++shared_->counts.requests;
    std::make_shared<Viewer>(std::move(stream_), *shared_)->start(request);
  }

  /// Sends the reason, and closes.
  void refuse(const Refusal& refusal) {
    ++shared_->counts.refused;
    keep_ = false;
    answer(refusal.status, {"text/plain; charset=utf-8", bytes_of(refusal.why + "\n")});
  }

  void answer(http::status status, Resource resource) {
    body_ = std::move(resource.body);
    response_ = {};
    response_.version(11);
    response_.result(status);
    response_.body() = {body_->data(), body_->size()};
    protect(response_);
    response_.set(http::field::content_type, resource.type);
    if (status == http::status::method_not_allowed) response_.set(http::field::allow, "GET, HEAD");
    if (status == http::status::upgrade_required) response_.set(http::field::upgrade, "websocket");
    response_.keep_alive(keep_);
    response_.content_length(body_->size());
    serializer_.emplace(response_);
    stream_.expires_after(shared_->limits.request);
    const auto done = [self = shared_from_this()](Failure error, std::size_t) { self->sent(error); };
    if (head_) {
      serializer_->split(true);
      http::async_write_header(stream_, *serializer_, done);
    } else {
      http::async_write(stream_, *serializer_, done);
    }
  }

  void sent(Failure error) {
    serializer_.reset();
    body_.reset();
    if (error || !keep_) return close();
    read();
  }

  void close() {
    Failure ignored;  // the other side may have closed already
    stream_.socket().shutdown(Tcp::socket::shutdown_send, ignored);
    if (drained_) return;
    // If closed with bytes unread, the connection would be reset, and the reply with the reason would be lost.
    drained_ = true;
    buffer_.consume(buffer_.size());
    stream_.expires_after(std::chrono::seconds(1));
    drain();
  }
  void drain() {
    stream_.async_read_some(buffer_.prepare(shared_->limits.header_bytes),
                            [self = shared_from_this()](Failure error, std::size_t) {
                              if (!error) self->drain();
                            });
  }

  Counted counted_;
  beast::tcp_stream stream_;
  Shared* shared_;
  beast::flat_buffer buffer_;
  std::optional<http::request_parser<http::empty_body>> parser_;
  http::response<http::span_body<const std::uint8_t>> response_;
  std::optional<http::response_serializer<http::span_body<const std::uint8_t>>> serializer_;
  SharedBytes body_;
  bool head_ = false, keep_ = false, drained_ = false;
};

}  // namespace

SharedBytes bytes_of(std::string_view text) {
  return std::make_shared<const std::vector<std::uint8_t>>(text.begin(), text.end());
}

struct Server::Impl {
  Impl(Site& site, const ServerLimits& limits) : shared{site, limits, 0, {}, 0, {}} {}

  void listen(std::uint16_t port) {
    const Tcp::endpoint here(asio::ip::address_v4::loopback(), port);
    Failure error;
    acceptor.open(here.protocol(), error);
    if (!error) acceptor.set_option(asio::socket_base::reuse_address(true), error);
    if (!error) acceptor.bind(here, error);
    if (!error) acceptor.listen(asio::socket_base::max_listen_connections, error);
    if (error) throw std::runtime_error("port " + std::to_string(port) + " of 127.0.0.1: " + error.message());
    ::fcntl(acceptor.native_handle(), F_SETFD, FD_CLOEXEC);
    shared.port = acceptor.local_endpoint().port();
  }

  void accept() {
    accepting = true;
    acceptor.async_accept([this](Failure error, Tcp::socket socket) {
      accepting = false;
      if (error) return;  // no file descriptors left, for example: the timer tries again
      if (shared.connections >= shared.limits.connections) {
        ++shared.counts.refused;
      } else {
        ::fcntl(socket.native_handle(), F_SETFD, FD_CLOEXEC);
        socket.set_option(Tcp::no_delay(true), error);
        std::make_shared<Connection>(std::move(socket), shared)->read();
      }
      accept();
    });
  }

  void tick(const std::function<bool()>& stop) {
    timer.expires_after(shared.limits.period);
    timer.async_wait([this, &stop](Failure error) {
      if (error) return;
      if (stop()) return context.stop();
      if (!accepting) accept();
      if (shared.site.refresh())
        for (Viewer* viewer : shared.viewers) viewer->send();
      tick(stop);
    });
  }

  Shared shared;
  asio::io_context context{1};
  Tcp::acceptor acceptor{context};
  asio::steady_timer timer{context};
  bool accepting = false;
};

Server::Server(Site& site, std::uint16_t port, const ServerLimits& limits)
    : impl_(std::make_unique<Impl>(site, limits)) {
  impl_->listen(port);
}

Server::~Server() = default;

std::uint16_t Server::port() const { return impl_->shared.port; }
std::string Server::address() const { return "http://127.0.0.1:" + std::to_string(port()) + "/"; }

void Server::run(const std::function<bool()>& stop) {
  impl_->context.restart();
  if (!impl_->accepting) impl_->accept();
  impl_->tick(stop);
  impl_->context.run();
}

ServerCounts Server::counts() const {
  ServerCounts counts = impl_->shared.counts;
  counts.viewers = static_cast<std::int64_t>(impl_->shared.viewers.size());
  return counts;
}

}  // namespace scree::io
