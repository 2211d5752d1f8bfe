// The server of `scree view`: what it answers, what it refuses, and that it lives on whatever is sent to it. Requests
// are written by hand over plain sockets, so that nothing of what is tested takes part in testing it.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <nlohmann/json.hpp>
#include <random>
#include <thread>

#include "io/serve/pair_site.h"
#include "io/serve/request_rules.h"
#include "io/serve/server.h"
#include "io/serve/stored_site.h"
#include "tests/unit/io/results_run.h"

namespace scree::io::test {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kWords = "some words\n";

/// Two paths, and slots that a test may change while the server runs.
class SmallSite final : public Site {
 public:
  explicit SmallSite(std::size_t slots = 0) : slots_(slots) {}
  std::optional<Resource> find(std::string_view path) override {
    if (path == "/") return Resource{"text/plain", bytes_of(kWords)};
    if (path == "/broken") throw std::runtime_error("the file is damaged");
    return {};
  }
  bool refresh() override {
    ++looks;
    const int wanted = versions;
    if (wanted == shown_) return false;
    shown_ = wanted;
    for (std::size_t i = 0; i < slots_.size(); ++i) {
      slots_[i].version = static_cast<std::uint64_t>(shown_);
      slots_[i].message = bytes_of(std::string(1, static_cast<char>('a' + i)) + std::to_string(shown_) + filling);
      slots_[i].first = i == 0;
      slots_[i].paced = i == 1;
    }
    return true;
  }
  std::span<const Slot> slots() const override { return slots_; }

  std::atomic<int> versions = 0, looks = 0;
  std::string filling;

 private:
  std::vector<Slot> slots_;
  int shown_ = 0;
};

/// A server in a thread of its own.
class Served {
 public:
  explicit Served(Site& site, const ServerLimits& limits = {}) : server_(site, 0, limits) {
    thread_ = std::thread([this] { server_.run([this] { return stop_.load(); }); });
  }
  ~Served() { end(); }
  void end() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }
  [[nodiscard]] std::uint16_t port() const { return server_.port(); }
  /// Ends the server.
  ServerCounts counts() { return end(), server_.counts(); }

 private:
  Server server_;
  std::atomic<bool> stop_ = false;
  std::thread thread_;
};

/// A TCP connection to 127.0.0.1.
class Client {
 public:
  explicit Client(std::uint16_t port, int receive_buffer = 0) : socket_(::socket(AF_INET, SOCK_STREAM, 0)) {
    if (receive_buffer > 0) ::setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &receive_buffer, sizeof receive_buffer);
    sockaddr_in there{};
    there.sin_family = AF_INET;
    there.sin_port = htons(port);
    there.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    connected_ = ::connect(socket_, reinterpret_cast<const sockaddr*>(&there), sizeof there) == 0;
  }
  ~Client() { ::close(socket_); }
  Client(const Client&) = delete;
  Client& operator=(const Client&) = delete;

  [[nodiscard]] bool connected() const { return connected_; }
  bool send(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t n = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
      if (n <= 0) return false;
      text.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
  }
  void finish() const { ::shutdown(socket_, SHUT_WR); }

  /// Takes bytes until `enough` of all that came, the end, or the time is up.
  template <class Enough>
  const std::string& take(Enough&& enough, std::chrono::milliseconds most = 5000ms) {
    const auto end = std::chrono::steady_clock::now() + most;
    while (!enough(got_)) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
      pollfd look{socket_, POLLIN, 0};
      if (left.count() <= 0 || ::poll(&look, 1, static_cast<int>(left.count())) <= 0) break;
      std::array<char, 65536> piece{};
      const ssize_t n = ::recv(socket_, piece.data(), piece.size(), 0);
      ended_ = n <= 0;
      if (n <= 0) break;
      got_.append(piece.data(), static_cast<std::size_t>(n));
    }
    return got_;
  }
  const std::string& take_all(std::chrono::milliseconds most = 5000ms) {
    return take([](const std::string&) { return false; }, most);
  }
  [[nodiscard]] bool ended() const { return ended_; }
  std::string& got() { return got_; }

 private:
  int socket_;
  bool connected_ = false, ended_ = false;
  std::string got_;
};

std::string host(std::uint16_t port) { return "127.0.0.1:" + std::to_string(port); }

std::string get(std::uint16_t port, std::string_view path, std::string_view more = "",
                std::string_view method = "GET") {
  return std::string(method) + " " + std::string(path) + " HTTP/1.1\r\nHost: " + host(port) +
         "\r\nConnection: close\r\n" + std::string(more) + "\r\n";
}

/// What comes for a request on a connection of its own.
std::string reply(std::uint16_t port, std::string_view request) {
  Client client(port);
  EXPECT_TRUE(client.connected());
  client.send(request);
  return client.take_all();
}

int status_of(std::string_view reply) {
  if (!reply.starts_with("HTTP/1.1 ") || reply.size() < 12) return 0;
  return std::stoi(std::string(reply.substr(9, 3)));
}
std::string body_of(const std::string& reply) { return reply.substr(reply.find("\r\n\r\n") + 4); }

TEST(ServeRules, host_and_origin_are_this_server_alone) {
  for (const char* good : {"127.0.0.1:8080", "localhost:8080"}) {
    EXPECT_TRUE(host_is_ours(good, 8080)) << good;
    EXPECT_TRUE(origin_is_ours(std::string("http://") + good, 8080)) << good;
  }
  for (const char* bad :
       {"", "127.0.0.1", "localhost", "127.0.0.1:80", "127.0.0.1:80800", "127.0.0.1:8080 ", "127.0.0.2:8080",
        "evil.example:8080", "127.0.0.1:8080.evil.example", "localhost:8080@evil", "LOCALHOST:8080 x"}) {
    EXPECT_FALSE(host_is_ours(bad, 8080)) << bad;
    EXPECT_FALSE(origin_is_ours(std::string("http://") + bad, 8080)) << bad;
  }
  for (const char* bad : {"null", "", "https://127.0.0.1:8080", "http://127.0.0.1:8080/", "file://", "127.0.0.1:8080"})
    EXPECT_FALSE(origin_is_ours(bad, 8080)) << bad;
}

TEST(ServeRules, number_of_path_takes_plain_numbers) {
  EXPECT_EQ(number_of_path("/frame/0", "/frame/"), 0U);
  EXPECT_EQ(number_of_path("/frame/120", "/frame/"), 120U);
  for (const char* bad :
       {"/frame/", "/frame/00", "/frame/01", "/frame/-1", "/frame/+1", "/frame/1/", "/frame/1?", "/frame/ 1",
        "/frame/1e3", "/frame/0x1", "/frame/9999999999", "/frame/%31", "/mesh/1", "frame/1", "/frame/../1"})
    EXPECT_FALSE(number_of_path(bad, "/frame/")) << bad;
}

TEST(Server, answers_what_the_site_has) {
  SmallSite site;
  Served served(site);
  const std::uint16_t port = served.port();
  const std::string good = reply(port, get(port, "/"));
  EXPECT_EQ(status_of(good), 200);
  EXPECT_EQ(body_of(good), kWords);
  for (const char* header :
       {"Content-Security-Policy: default-src 'none'; script-src 'self'", "X-Content-Type-Options: nosniff",
        "Referrer-Policy: no-referrer", "Cross-Origin-Resource-Policy: same-origin", "Cache-Control: no-store",
        "Content-Type: text/plain", "Content-Length: 11"})
    EXPECT_NE(good.find(header), std::string::npos) << header;
  EXPECT_EQ(good.find("unsafe-inline"), std::string::npos);
  const std::string head = reply(port, get(port, "/", "", "HEAD"));
  EXPECT_EQ(status_of(head), 200);
  EXPECT_NE(head.find("Content-Length: 11"), std::string::npos);
  EXPECT_EQ(body_of(head), "");
  EXPECT_EQ(status_of(reply(port, get(port, "/", "Origin: http://" + host(port) + "\r\n"))), 200);
  EXPECT_EQ(status_of(reply(
                port, "GET / HTTP/1.1\r\nHost: localhost:" + std::to_string(port) + "\r\nConnection: close\r\n\r\n")),
            200);
  EXPECT_EQ(status_of(reply(port, "GET / HTTP/1.0\r\nHost: " + host(port) + "\r\n\r\n")), 200);
  const std::string broken = reply(port, get(port, "/broken"));
  EXPECT_EQ(status_of(broken), 500);
  EXPECT_EQ(body_of(broken), "the file is damaged\n");
}

TEST(Server, one_connection_takes_many_requests) {
  SmallSite site;
  Served served(site);
  Client client(served.port());
  const std::string request = "GET / HTTP/1.1\r\nHost: " + host(served.port()) + "\r\n\r\n";
  client.send(request + request + request);  // at once, which is allowed
  const auto count = [](const std::string& text) {
    std::size_t found = 0;
    for (std::size_t at = 0; (at = text.find(kWords, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  client.take([&](const std::string& text) { return count(text) >= 3; });
  EXPECT_EQ(count(client.got()), 3U);
  EXPECT_FALSE(client.ended());
}

TEST(Server, refuses_what_is_not_meant_for_it) {
  SmallSite site;
  Served served(site);
  const std::uint16_t port = served.port();
  const std::string end = "Connection: close\r\n\r\n", ours = "Host: " + host(port) + "\r\n";
  const auto code = [&](const std::string& request) { return status_of(reply(port, request)); };
  EXPECT_EQ(code("GET / HTTP/1.1\r\nHost: evil.example\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\nHost: evil.example:" + std::to_string(port) + "\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\nHost: 127.0.0.1\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + ours + ours + end), 421);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + ours + "Origin: http://evil.example\r\n" + end), 403);
  EXPECT_EQ(code("GET / HTTP/1.1\r\n" + ours + "Origin: null\r\n" + end), 403);
  for (const char* method : {"POST", "PUT", "DELETE", "OPTIONS", "TRACE", "CONNECT", "PATCH", "PROPFIND", "GETT"})
    EXPECT_EQ(code(get(port, "/", "", method)), 405) << method;
  for (const char* path : {"/..", "/../../etc/passwd", "/%2e%2e/etc/passwd", "/./", "//", "/index.html", "/?", "/#",
                           "*", "/frame/0", "http://127.0.0.1/", "/live"})
    EXPECT_EQ(code(get(port, path)), 404) << path;
  EXPECT_EQ(code(get(port, "/", "Content-Length: 5\r\n") + "hello"), 413);
  EXPECT_EQ(code(get(port, "/", "Content-Length: 99999999999\r\n")), 413);
  EXPECT_EQ(code(get(port, "/", "Transfer-Encoding: chunked\r\n") + "5\r\nhello\r\n0\r\n\r\n"), 413);
  EXPECT_EQ(code(get(port, "/", "X: " + std::string(9000, 'x') + "\r\n")), 431);
  EXPECT_EQ(code(get(port, "/" + std::string(20000, 'x'))), 431);
  std::string many;
  for (int i = 0; i < 2000; ++i) many += "X" + std::to_string(i) + ": y\r\n";
  EXPECT_EQ(code(get(port, "/", many)), 431);
  EXPECT_EQ(code("this is no request\r\n\r\n"), 400);
  EXPECT_EQ(code(get(port, "/", "no colon\r\n")), 400);
  EXPECT_EQ(code(get(port, "/", "Content-Length: -1\r\n")), 400);
  EXPECT_EQ(code(get(port, "/")), 200);
}

TEST(Server, slow_requests_and_too_many_connections_end) {
  SmallSite site;
  ServerLimits limits;
  limits.request = 1s;
  limits.connections = 3;
  Served served(site, limits);
  Client slow(served.port()), idle(served.port()), other(served.port());
  slow.send("GET / HTTP/1.1\r\nHost: ");
  for (int i = 0; i < 5; ++i) {  // byte by byte does not help
    std::this_thread::sleep_for(20ms);
    slow.send("1");
  }
  Client one_too_many(served.port());
  one_too_many.send(get(served.port(), "/"));
  EXPECT_EQ(one_too_many.take_all(), "");
  EXPECT_TRUE(one_too_many.ended());
  slow.take_all();
  idle.take_all();
  EXPECT_TRUE(slow.ended() && idle.ended());
  // The server counts a connection until it has put it away, a moment after the other end has seen it close.
  int status = 0;
  for (int k = 0; k < 100 && status != 200; ++k) {
    if (k > 0) std::this_thread::sleep_for(20ms);
    status = status_of(reply(served.port(), get(served.port(), "/")));
  }
  EXPECT_EQ(status, 200);
}

TEST(Server, listens_on_the_loopback_interface_alone_and_a_port_once) {
  SmallSite site;
  const Server server(site, 0);
  EXPECT_EQ(server.address(), "http://127.0.0.1:" + std::to_string(server.port()) + "/");
  try {
    const Server again(site, server.port());
    FAIL() << "two servers share a port";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find(std::to_string(server.port())), std::string::npos) << e.what();
  }
  std::ifstream table("/proc/net/tcp");
  std::array<char, 16> wanted{};
  std::snprintf(wanted.data(), wanted.size(), ":%04X", server.port());
  std::string line;
  int listening = 0;
  while (std::getline(table, line)) {
    std::istringstream words(line);
    std::string number, local, remote, state;
    words >> number >> local >> remote >> state;
    if (!local.ends_with(wanted.data()) || state != "0A") continue;
    ++listening;
    EXPECT_EQ(local.substr(0, 8), "0100007F");
  }
  EXPECT_EQ(listening, 1);
}

// ---------------------------------------------------------------------------------------------- WebSocket

std::string upgrade(std::uint16_t port, const std::string& origin, const std::string& more = "") {
  return "GET /live HTTP/1.1\r\nHost: " + host(port) + "\r\n" + (origin.empty() ? "" : "Origin: " + origin + "\r\n") +
         "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
         "Sec-WebSocket-Version: 13\r\n" +
         more + "\r\n";
}
std::string own_origin(std::uint16_t port) { return "http://" + host(port); }

/// A masked frame as a browser sends it.
std::string ws_frame(std::string_view text, int opcode = 1) {
  const std::array<char, 4> mask{0x12, 0x34, 0x56, 0x78};
  std::string out(1, static_cast<char>(0x80 | opcode));
  out += static_cast<char>(0x80U | text.size());
  out.append(mask.data(), mask.size());
  for (std::size_t i = 0; i < text.size(); ++i) out += static_cast<char>(text[i] ^ mask[i % 4]);
  return out;
}

/// Payloads of the whole frames at the front of what came; those are taken away.
std::vector<std::string> take_frames(std::string& got) {
  std::vector<std::string> out;
  for (;;) {
    if (got.size() < 2) return out;
    const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(got[i])); };
    std::size_t length = byte(1) & 0x7FU, head = 2;
    const std::size_t wide = length == 126 ? 2 : length == 127 ? 8 : 0;
    if (got.size() < head + wide) return out;
    if (wide > 0) length = 0;
    for (std::size_t i = 0; i < wide; ++i) length = length << 8U | byte(head + i);
    head += wide;
    if (got.size() < head + length) return out;
    out.push_back(got.substr(head, length));
    got.erase(0, head + length);
  }
}

/// A viewer whose handshake is done.
struct LiveClient {
  explicit LiveClient(std::uint16_t port, int receive_buffer = 0) : client(port, receive_buffer) {
    client.send(upgrade(port, own_origin(port)));
    client.take([](const std::string& text) { return text.find("\r\n\r\n") != std::string::npos; });
    good = client.got().starts_with("HTTP/1.1 101 ") &&
           client.got().find("s3pPLMBiTxaQ9kYGzzhZRbK+xOo=") != std::string::npos;  // [RFC6455] section 1.3
    client.got().erase(0, client.got().find("\r\n\r\n") + 4);
  }
  /// The next messages, at least `count` unless the time is up.
  std::vector<std::string> next(std::size_t count, std::chrono::milliseconds most = 5000ms) {
    std::vector<std::string> out;
    const auto end = std::chrono::steady_clock::now() + most;
    while (out.size() < count && std::chrono::steady_clock::now() < end && !client.ended()) {
      const std::size_t before = client.got().size();
      client.take([&](const std::string& text) { return text.size() > before; }, 50ms);
      for (std::string& frame : take_frames(client.got())) out.push_back(std::move(frame));
    }
    return out;
  }
  Client client;
  bool good = false;
};

TEST(Server, a_stream_wants_the_origin_of_its_page) {
  SmallSite site(3);
  Served served(site);
  const std::uint16_t port = served.port();
  EXPECT_EQ(status_of(reply(port, upgrade(port, "http://evil.example"))), 403);
  EXPECT_EQ(status_of(reply(port, upgrade(port, ""))), 403);
  EXPECT_EQ(status_of(reply(port, get(port, "/live"))), 426);
  EXPECT_TRUE(LiveClient(port).good);
}

TEST(Server, a_late_viewer_gets_the_newest_of_each_first_things_first) {
  SmallSite site(3);
  site.versions = 4;
  Served served(site);
  LiveClient late(served.port());
  ASSERT_TRUE(late.good);
  std::vector<std::string> got = late.next(3);
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0], "a4");
  std::sort(got.begin(), got.end());
  EXPECT_EQ(got, (std::vector<std::string>{"a4", "b4", "c4"}));
  site.versions = 5;
  got = late.next(3);
  ASSERT_EQ(got.size(), 3U);
  EXPECT_EQ(got[0], "a5");
}

TEST(Server, a_viewer_that_does_not_take_frames_gets_two_and_later_the_newest) {
  SmallSite site(2);  // "b" is paced
  Served served(site);
  LiveClient slow(served.port()), quick(served.port());
  std::vector<std::string> paced, all;
  for (int version = 1; version <= 6; ++version) {
    site.versions = version;
    for (const std::string& message : slow.next(version <= 2 ? 2 : 1))
      if (message.front() == 'b') paced.push_back(message);
    for (const std::string& message : quick.next(2)) {
      if (message.front() != 'b') continue;
      all.push_back(message);
      quick.client.send(ws_frame("n"));
    }
  }
  EXPECT_EQ(paced, (std::vector<std::string>{"b1", "b2"}));
  EXPECT_EQ(slow.next(1, 150ms), std::vector<std::string>());
  EXPECT_EQ(all, (std::vector<std::string>{"b1", "b2", "b3", "b4", "b5", "b6"}));
  slow.client.send(ws_frame("n"));
  EXPECT_EQ(slow.next(1), std::vector<std::string>{"b6"});
}

TEST(Server, a_viewer_that_reads_nothing_holds_up_nobody) {
  SmallSite site(1);
  site.filling.assign(1 << 20U, 'x');
  Served served(site);
  LiveClient stuck(served.port(), 4096), quick(served.port());
  for (int version = 1; version <= 20; ++version) {
    site.versions = version;
    const std::vector<std::string> got = quick.next(1);
    ASSERT_EQ(got.size(), 1U);
    EXPECT_EQ(got[0].substr(0, got[0].find('x')), "a" + std::to_string(version));
  }
  // What it finds when it reads again: the one that was on its way, then the newest.
  const std::vector<std::string> late = stuck.next(2);
  ASSERT_EQ(late.size(), 2U);
  EXPECT_EQ(late[0].substr(0, 2), "a1");
  EXPECT_EQ(late[1].substr(0, 3), "a20");
}

TEST(Server, wrong_messages_of_a_viewer_end_its_connection) {
  SmallSite site(2);
  site.versions = 1;
  Served served(site);
  const std::string too_long =
      std::string("\x81\xFF\x7F\xFF\xFF\xFF\xFF\xFF\xFF\xFF", 10) + "maskdata";  // 2^63 - 1 bytes
  const std::string over_limit = std::string("\x81\xFE\x20\x00mask", 8) + std::string(8192, 'x');
  const std::vector<std::string> wrong{
      ws_frame("stop"),
      ws_frame(""),
      ws_frame("nn"),
      ws_frame("n") + ws_frame("n") + ws_frame("n"),
      std::string("\x81\x01n", 3),  // not masked
      ws_frame("n", 3),
      ws_frame("n", 11),                                                // codes that nothing has
      std::string("\xF1\x81maskn", 7),                                  // reserved bits
      std::string("\x01\x80mask", 6) + ws_frame("n"),                   // a message within a message
      ws_frame(std::string(126 - 1, 'p'), 9).replace(0, 1, 1, '\x09'),  // a ping in pieces
      ws_frame("\xFF\xFE"),
      too_long,
      over_limit};
  for (std::size_t i = 0; i < wrong.size(); ++i) {
    LiveClient viewer(served.port());
    ASSERT_TRUE(viewer.good) << i;
    viewer.next(2);
    viewer.client.got().clear();
    viewer.client.send(wrong[i]);
    viewer.client.take([](const std::string& text) { return text.size() >= 2; });
    EXPECT_EQ(viewer.client.got().substr(0, 1), "\x88") << i << ": the server does not close";
  }
  LiveClient good(served.port());
  EXPECT_EQ(good.next(2).size(), 2U);
  EXPECT_GE(served.counts().refused, 5);
}

// ------------------------------------------------------------------------------------------------- fuzz

/// A request with some of its bytes changed, doubled, cut or put in.
std::string mutated(std::string text, std::mt19937& random) {
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random()) % std::max<std::size_t>(1, n); };
  static const std::vector<std::string> kPieces{"\r\n",
                                                "\r\n\r\n",
                                                std::string(1, '\0'),
                                                "\xFF\xFE",
                                                ": ",
                                                "Host: x\r\n",
                                                "Content-Length: 7\r\n",
                                                "HTTP/9.9",
                                                "%00",
                                                "../",
                                                "Transfer-Encoding: chunked\r\n",
                                                "Expect: 100-continue\r\n"};
  const std::size_t changes = 1 + below(4);
  for (std::size_t k = 0; k < changes && !text.empty(); ++k) {
    const std::size_t at = below(text.size());
    switch (below(6)) {
      case 0:
        text[at] = static_cast<char>(random() & 0xFFU);
        break;
      case 1:
        text.erase(at, 1 + below(8));
        break;
      case 2:
        text.insert(at, kPieces[below(kPieces.size())]);
        break;
      case 3:
        text.insert(at, text.substr(at, 1 + below(40)));
        break;
      case 4:
        text.resize(at);
        break;
      default:
        text.insert(at, std::string(below(300), static_cast<char>(random() & 0xFFU)));
    }
  }
  return text;
}

TEST(Server, lives_on_after_ten_thousand_damaged_requests) {
  constexpr int kRequests = 10000;
  SmallSite site(2);
  site.versions = 1;
  ServerLimits limits;
  limits.connections = 64;
  Served served(site, limits);
  const std::uint16_t port = served.port();
  std::mt19937 random(20240611);
  const std::vector<std::string> seeds{
      get(port, "/"), get(port, "/frame/1", "Origin: " + own_origin(port) + "\r\n", "HEAD"),
      upgrade(port, own_origin(port)),
      upgrade(port, own_origin(port)) + ws_frame("n") + ws_frame("x", 9) + ws_frame("n")};
  std::map<int, int> codes;
  for (int i = 0; i < kRequests; ++i) {
    const std::string request = mutated(seeds[static_cast<std::size_t>(i) % seeds.size()], random);
    Client client(port);
    ASSERT_TRUE(client.connected()) << i;
    client.send(request);
    client.finish();
    client.take([](const std::string& text) { return text.size() > 12; }, 2000ms);
    const int code = status_of(client.got());
    ++codes[code];
    if (code == 200) {  // what it gives, it gives to those alone who say whom they mean
      EXPECT_NE(request.find(host(port)), std::string::npos) << i;
    }
  }
  EXPECT_GT(codes[200], 0);
  EXPECT_GT(codes[400], 0);
  EXPECT_GT(codes[421], 0);
  EXPECT_GT(codes[404] + codes[405], 0);
  EXPECT_GT(codes[101], 0);
  EXPECT_EQ(status_of(reply(port, get(port, "/"))), 200);
  LiveClient viewer(port);
  EXPECT_EQ(viewer.next(2).size(), 2U);
}

// ------------------------------------------------------------------------------------------------ a run

TEST_F(Results, site_of_a_run_has_every_frame) {
  StoredSite site(run, "1.2.3");
  EXPECT_EQ(site.frames(), 5U);
  const auto bytes = [&](std::string_view path) {
    const auto found = site.find(path);
    return found ? std::string(found->body->begin(), found->body->end()) : std::string();
  };
  const auto page = nlohmann::json::parse(bytes("/run.json"));
  EXPECT_EQ(page["title"], "A \"small\" run\\");
  ASSERT_EQ(page["frames"]["list"].size(), 5U);
  EXPECT_EQ(page["frames"]["meshes"], 2);
  EXPECT_EQ(page["frames"]["list"][2]["mesh"], 0);
  EXPECT_EQ(page["frames"]["list"][3]["mesh"], 1);
  EXPECT_EQ(page["frames"]["list"][3]["stage"], "fall");
  EXPECT_EQ(page["frames"]["list"][3]["integrator"], "implicit");
  EXPECT_DOUBLE_EQ(page["frames"]["list"][4]["time"], 2.0);
  EXPECT_NEAR(page["frames"]["ranges"]["speed"][1], 2.0, 1e-12);
  for (const char* path : {"/mesh/0", "/mesh/1", "/frame/0", "/frame/4", "/history", "/viewer.js", "/viewer.css"})
    EXPECT_FALSE(bytes(path).empty()) << path;
  EXPECT_EQ(bytes("/frame/1"), bytes("/frame/1"));
  EXPECT_NE(bytes("/frame/0"), bytes("/frame/4"));
  for (const char* path :
       {"/mesh/2", "/frame/5", "/frame/-1", "/run.vtkhdf", "/summary.json", "/frame", "", "run.json"})
    EXPECT_FALSE(site.find(path)) << path;
  const std::string html = bytes("/");
  EXPECT_NE(html.find("data-source=\"stored\""), std::string::npos);
  EXPECT_NE(html.find("A &quot;small&quot; run"), std::string::npos);
  // Scripts of the page come from the server; what stands in it is data.
  for (std::size_t at = 0; (at = html.find("<script", at)) != std::string::npos; ++at) {
    const std::string tag = html.substr(at, html.find('>', at) - at);
    EXPECT_TRUE(tag == "<script src=\"viewer.js\"" || tag.find("type=\"text/plain\"") != std::string::npos) << tag;
  }
}

TEST_F(Results, two_runs_stand_side_by_side) {
  StoredSite left(run, "1"), right(run, "1");
  PairSite pair(left, right);
  const auto bytes = [](Site& site, std::string_view path) {
    const auto found = site.find(path);
    return found ? std::string(found->body->begin(), found->body->end()) : std::string();
  };
  const std::string page = bytes(pair, "/");
  EXPECT_NE(page.find("<iframe src=\"left/\" title=\"A &quot;small&quot; run\\\""), std::string::npos) << page;
  EXPECT_EQ(page.find("<script"), std::string::npos);
  for (const char* path : {"/", "/run.json", "/frame/3", "/mesh/1", "/viewer.js"}) {
    EXPECT_EQ(bytes(pair, std::string("/left") + path), bytes(left, path)) << path;
    EXPECT_EQ(bytes(pair, std::string("/right") + path), bytes(right, path)) << path;
  }
  for (const char* path :
       {"/run.json", "/left", "/leftrun.json", "/left/left/", "/middle/", "/left/../right/", "/right/frame/9"})
    EXPECT_FALSE(pair.find(path)) << path;
}

TEST_F(Results, site_of_no_run_is_refused) { EXPECT_THROW(StoredSite(scratch->path() / "nothing", "1"), FileError); }

}  // namespace
}  // namespace scree::io::test
