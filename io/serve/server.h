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
  std::chrono::milliseconds request{10'000};  // in which a request must come, a reply must be taken, and between both
  std::chrono::milliseconds silence{30'000};  // of a viewer over a WebSocket, which answers pings meanwhile
  std::chrono::milliseconds period{20};       // between two calls of Site::refresh
};

/// What came so far.
struct ServerCounts {
  std::int64_t requests = 0;  // that were answered with what was asked for
  std::int64_t refused = 0;   // requests, connections and WebSocket messages
  std::int64_t viewers = 0;   // over WebSockets, now
  std::int64_t messages = 0;  // sent to them
};

/// Listens on 127.0.0.1 only, answers GET and HEAD without a body, for a Host that is this server and no foreign Origin
/// (request_rules.h); everything else is refused. No path reaches the file system: the site alone knows what there is.
/// Pages may load scripts, styles and data from here alone, and run no script that stands in them.
/// /live is a WebSocket where the site has slots. A viewer has one message on its way and none that waits: when that
/// has gone, the newest version of the next slot follows. It sends "n" for each paced message that it has taken; of
/// those, two may be on their way. Any other message of a viewer that the site does not take ends the connection.
/// Everything happens on the thread that calls run().
class Server {
 public:
  /// @param port  0: a free one   @param site  must outlive the server
  /// @throws std::runtime_error where the port cannot be had
  Server(Site& site, std::uint16_t port, const ServerLimits& limits = {});
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  [[nodiscard]] std::uint16_t port() const;
  [[nodiscard]] std::string address() const;  // http://127.0.0.1:PORT/

  /// Serves until `stop` gives true, which is asked every ServerLimits::period.
  void run(const std::function<bool()>& stop);

  /// @pre run() has ended, or it is called inside of `stop`
  [[nodiscard]] ServerCounts counts() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace scree::io
