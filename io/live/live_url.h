// The URL of the option --live=. It is checked before a run, because LCM 1.3.1 aborts, prints or sends elsewhere when
// it is given a URL that it does not accept.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scree::io {

/// Side that opens a URL: a run, which sends, or a viewer.
enum class LiveSide { sender, receiver };

/// The parts of a URL.
struct LiveUrl {
  enum class Kind { udpm, memq, file } kind = Kind::memq;
  std::string group;        // udpm: IPv4 multicast address
  std::uint16_t port = 0;   // udpm
  int ttl = 0;              // udpm: 0 stays on this machine, 1 in the local network
  long receive_buffer = 0;  // udpm [bytes]; 0: as large as the system permits
  std::string path;         // file
  std::string lcm;          // URL passed to LCM, with all defaults written out
};

/// Checks a URL. Accepted are
///   udpm://[GROUP:PORT][?ttl=0|1][&recv_buf_size=N]   GROUP in 224.0.0.0/4; ttl=0, the default, stays on this machine
///   memq://                                           within one program
///   file://PATH                                       an LCM log: a sender overwrites it, a receiver plays it
/// A file that a sender would overwrite must be empty or an LCM log, and its folder must exist; the file of a receiver
/// must exist.
/// @return the error and the accepted URLs, in one line; empty if there is no error
[[nodiscard]] std::optional<std::string> check_live_url(std::string_view url, LiveSide side = LiveSide::sender);

/// @throws std::invalid_argument with the text of check_live_url
[[nodiscard]] LiveUrl parse_live_url(std::string_view url, LiveSide side);

}  // namespace scree::io
