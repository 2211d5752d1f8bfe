// A site of two paths, its server in a thread, and clients with plain sockets.
#pragma once

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "io/serve/server.h"

namespace scree::io::test {

using namespace std::chrono_literals;

inline constexpr std::string_view kWords = "some words\n";

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

/// A server in a separate thread.
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

  /// Receives until `enough` holds for all bytes received, the connection ends, or the time is up.
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

inline std::string host(std::uint16_t port) { return "127.0.0.1:" + std::to_string(port); }

inline std::string get(std::uint16_t port, std::string_view path, std::string_view more = "",
                       std::string_view method = "GET") {
  return std::string(method) + " " + std::string(path) + " HTTP/1.1\r\nHost: " + host(port) +
         "\r\nConnection: close\r\n" + std::string(more) + "\r\n";
}

/// The reply to a request on a new connection.
inline std::string reply(std::uint16_t port, std::string_view request) {
  Client client(port);
  EXPECT_TRUE(client.connected());
  client.send(request);
  return client.take_all();
}

inline int status_of(std::string_view reply) {
  if (!reply.starts_with("HTTP/1.1 ") || reply.size() < 12) return 0;
  return std::stoi(std::string(reply.substr(9, 3)));
}
inline std::string body_of(const std::string& reply) { return reply.substr(reply.find("\r\n\r\n") + 4); }

inline std::string upgrade(std::uint16_t port, const std::string& origin, const std::string& more = "") {
  return "GET /live HTTP/1.1\r\nHost: " + host(port) + "\r\n" + (origin.empty() ? "" : "Origin: " + origin + "\r\n") +
         "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n"
         "Sec-WebSocket-Version: 13\r\n" +
         more + "\r\n";
}
inline std::string own_origin(std::uint16_t port) { return "http://" + host(port); }

/// A masked frame as a browser sends it.
inline std::string ws_frame(std::string_view text, int opcode = 1) {
  const std::array<char, 4> mask{0x12, 0x34, 0x56, 0x78};
  std::string out(1, static_cast<char>(0x80 | opcode));
  out += static_cast<char>(0x80U | text.size());
  out.append(mask.data(), mask.size());
  for (std::size_t i = 0; i < text.size(); ++i) out += static_cast<char>(text[i] ^ mask[i % 4]);
  return out;
}

/// Payloads of the complete frames at the front of the bytes received; removes these frames.
inline std::vector<std::string> take_frames(std::string& got) {
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

/// A viewer that has completed its handshake.
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

}  // namespace scree::io::test
