// A small server of HTTP and WebSocket for programs on this machine: what `scree view` opens.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "io/serve/site.h"

namespace scree::io {

struct ServerLimits {
  std::size_t header_bytes = 8192;            // of a request
  std::size_t message_bytes = 256;            // of a viewer over a WebSocket
  std::size_t connections = 256;              // at a time
  std::chrono::milliseconds request{10'000};  // limit for a request, for its reply, and between both
  std::chrono::milliseconds silence{30'000};  // of a viewer over a WebSocket, which answers pings meanwhile
  std::chrono::milliseconds period{20};       // between two calls of Site::refresh
};

/// Counts so far.
struct ServerCounts {
  std::int64_t requests = 0;  // that were answered with what they requested
  std::int64_t refused = 0;   // requests, connections and WebSocket messages
  std::int64_t viewers = 0;   // over WebSockets, now
  std::int64_t messages = 0;  // sent to them
};

/// Listens on 127.0.0.1 only, answers GET and HEAD without a body, for a Host that is this server and no foreign Origin
/// (request_rules.h); everything else is refused. No path reaches the file system: only the site has resources.
/// Pages may load scripts, styles and data from this server alone, and run no inline script.
/// /live is a WebSocket where the site has slots. One message at a time is sent to a viewer and none is queued: when it
/// has been sent, the newest version of the next slot follows. The viewer sends "n" for each paced message that it has
/// taken; at most two paced messages may be outstanding. Any other message of a viewer that the site does not take ends
/// the connection.
/// Everything happens on the thread that calls run().
class Server {
 public:
  /// @param port  0: a free one   @param site  must outlive the server
  /// @throws std::runtime_error where the port is not available
  Server(Site& site, std::uint16_t port, const ServerLimits& limits = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] std::string address() const;  // http://127.0.0.1:PORT/

  /// Serves until `stop` returns true; `stop` is called every ServerLimits::period.
  void run(const std::function<bool()>& stop);

  /// @pre run() has ended, or it is called inside of `stop`
  [[nodiscard]] ServerCounts counts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
