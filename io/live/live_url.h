// What may stand behind --live=: checked before a run, because LCM 1.3.1 aborts, prints or sends elsewhere when it is
// given a URL that it does not like.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace scree::io {

/// Who opens a URL: a run, which sends, or a viewer.
enum class LiveSide { sender, receiver };

/// A URL taken apart.
struct LiveUrl {
  enum class Kind { udpm, memq, file } kind = Kind::memq;
  std::string group;        // udpm: IPv4 multicast address
  std::uint16_t port = 0;   // udpm
  int ttl = 0;              // udpm: 0 stays on this machine, 1 in the local network
  long receive_buffer = 0;  // udpm [bytes]; 0: as large as the system gives
  std::string path;         // file
  std::string lcm;          // what LCM is given: every default spelled out
};

/// Checks a URL. Accepted are
///   udpm://[GROUP:PORT][?ttl=0|1][&recv_buf_size=N]   GROUP in 224.0.0.0/4; ttl=0, the default, stays on this machine
///   memq://                                           within one program
///   file://PATH                                       an LCM log: a sender writes it anew, a receiver plays it
/// A file that a sender would overwrite must be empty, or an LCM log, and its folder must exist; a receiver's must
/// exist.
/// @return what is wrong and what is accepted, in one line; empty if nothing is
[[nodiscard]] std::optional<std::string> check_live_url(std::string_view url, LiveSide side = LiveSide::sender);

/// @throws std::invalid_argument with the text of check_live_url
[[nodiscard]] LiveUrl parse_live_url(std::string_view url, LiveSide side);

}  // namespace scree::io
